// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clippers of spaces/ behind plain C functions, for a page that runs them as WebAssembly.
//
// Numbers travel as doubles through two blocks of memory, which hold a float exactly. A call reads
// the frustum and volume set last and the triangle in numbers(), and writes to results(). Where
// is_double is 0, each number is rounded to float first; the caller gives floats, so that nothing
// is lost. Where from_clip_space is 0, the triangle is in view space.
#pragma once

#include <cstdint>

namespace clipscope::explorer {

inline constexpr int kAttributes = 4;
inline constexpr int kVertexNumbers = 4 + kAttributes;

}  // namespace clipscope::explorer

extern "C" {

// Three vertices: x y z w and four attributes each. In view space w is not read.
double* clipscope_numbers();
double* clipscope_results();

// The clippers as JSON, in the order of their numbers.
const char* clipscope_clippers();
int clipscope_clipper_count();

// depth: the number of a DepthRange.
void clipscope_set_frustum(int parallel, double left, double right, double bottom, double top,
                           double near, double far, int infinite_far, double shear_x,
                           double shear_y, int depth);
// open_sides: bit 0 left, 1 right, 2 bottom, 3 top. clip_distances: at most kAttributes.
void clipscope_set_volume(int clamp_near, int clamp_far, int clip_distances, int open_sides);

// The number of vertices in results() (x y z 1/w and attributes), or -1 where the clipper does not
// take such a question, and of view space where the frustum encloses no volume.
int clipscope_clip(int clipper, int is_double, int from_clip_space);

// The three vertices of a view-space triangle in clip space.
void clipscope_project(int is_double);

// For each vertex its distances to all planes of the volume, 14 numbers, and its outcode.
void clipscope_distances(int is_double, int from_clip_space);

// The polygon in clip space before the first and after each of `count` planes, by their numbers:
// its number of vertices, then these.
void clipscope_steps(int is_double, int from_clip_space, const std::uint8_t* planes, int count);
}
