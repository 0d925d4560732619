// SPDX-License-Identifier: GPL-3.0-or-later
//
// A textbook clipper over rational numbers, and the same with one of the bugs known from real
// clippers: to test the tests. Without a bug it equals the fast reference (a third opinion beside
// gold); with one it must differ on some case, or the cases would not notice that bug.
//
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974, on the homogeneous clip
// positions, plane after plane, each vertex from the one before. Seeding faults: DeMillo, Lipton
// and Sayward, "Hints on Test Data Selection", 1978. It shares no code with `clip`.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "reference/exact_clip.hpp"

namespace clipscope::reference {

enum class Bug {
  none,
  epsilon_in_denominator,
  absolute_w,
  w_sign_ignored,
  w_plane_left_out,
  w_plane_epsilon,
  plane_epsilon,
  open_volume,
  far_end_weighted,
  nearer_end_swapped,
  near_side_flipped,
  attributes_in_ndc,
  attribute_axis_of_clip_space,
  inv_w_linear,
  depth_from_zero,
  rejects_without_common_plane,
  drops_whole,
  last_edge_left_out,
  eight_vertices,
  closed_sides,
  opposite_sides_open,
  skips_left,
  skips_right,
  skips_bottom,
  skips_top,
  skips_near,
  skips_far
};

struct BugInfo {
  Bug bug;
  std::string_view name;     // as in Bug
  std::string_view summary;  // what the clipper does wrong
};

// All bugs, without `none`.
std::span<const BugInfo> all_bugs();

// The clipper's polygon, its vertices in order, each place once. Pre-conditions: those of `clip`.
std::vector<RationalVertex> textbook_polygon(Bug bug, const Truth& truth,
                                             std::span<const InputVertex> vertices,
                                             int attribute_count);

// Its vertices sorted, as vertex_set gives the reference's.
std::vector<RationalVertex> textbook(Bug bug, const Truth& truth,
                                     std::span<const InputVertex> vertices, int attribute_count);
std::vector<RationalVertex> textbook(Bug bug, const Truth& truth, const InputTriangle& triangle);

// Whether the case tells the clipper with the bug from the reference.
bool catches(Bug bug, const Truth& truth, std::span<const InputVertex> vertices,
             int attribute_count);

}  // namespace clipscope::reference
