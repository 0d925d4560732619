// SPDX-License-Identifier: GPL-3.0-or-later
//
// DrawCall: what a driver is asked to draw, and Pixels: what it drew.
//
// The vertices are given in clip coordinates, so that nothing but the driver's own clipping,
// division, rasterisation and interpolation lies between them and the pixels.
//
// Rows count upwards in y_ndc: pixel (i, j) of the target has its centre at
// x_ndc = 2 (i + 1/2 - viewport.x) / viewport.width - 1, y_ndc likewise with j, under every API:
// row 0 is the lowest one of OpenGL and the topmost one of Vulkan.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "spaces/volume.hpp"

namespace clipscope::experiments {

enum class Topology : std::uint8_t {
  points,
  lines,
  line_strip,
  triangles,
  triangle_strip,
  triangle_fan
};
constexpr std::array<std::string_view, 6> names_of(Topology) {
  return {"points", "lines", "line_strip", "triangles", "triangle_strip", "triangle_fan"};
}

// Which vertex of a primitive its flat values come from.
enum class ProvokingVertex : std::uint8_t { first, last };
constexpr std::array<std::string_view, 2> names_of(ProvokingVertex) { return {"first", "last"}; }

// What is read back of every pixel; the number of floats that it has there is channels(quantity).
// Pixels without a fragment have 0, but primitive_id -1 and depth kNoDepth.
enum class Quantity : std::uint8_t {
  covered,         // 1 where the shader ran, 0 elsewhere
  hits,            // how many fragments there were, and how many of them were front-facing
  smooth,          // the varying, interpolated with perspective
  noperspective,   // the varying, interpolated linearly in the window
  flat,            // the varying of the provoking vertex
  frag_coord,      // gl_FragCoord: x and y in px of the target, depth 0 to 1, 1 / w_clip
  facing,          // 1 front-facing, -1 back-facing
  primitive_id,    // gl_PrimitiveID
  clip_distances,  // gl_ClipDistance as the fragment shader reads it
  depth            // what is in the depth buffer, 32-bit float, cleared to kNoDepth
};
constexpr std::array<std::string_view, 10> names_of(Quantity) {
  return {"covered",    "hits",   "smooth",       "noperspective",  "flat",
          "frag_coord", "facing", "primitive_id", "clip_distances", "depth"};
}
inline constexpr std::size_t kQuantities = names_of(Quantity{}).size();
constexpr std::size_t channels(Quantity quantity) {
  constexpr std::array<std::size_t, kQuantities> kChannels = {1, 2, 4, 4, 4, 4, 1, 1, 8, 1};
  return kChannels[static_cast<std::size_t>(quantity)];
}
inline constexpr float kNoDepth = 0.5f;  // no test decides by it: all fragments pass

using Quantities = std::bitset<kQuantities>;
constexpr std::size_t bit(Quantity quantity) { return static_cast<std::size_t>(quantity); }

struct DrawVertex {
  std::array<float, 4> position = {0, 0, 0, 1};  // clip coordinates
  // The smooth, the noperspective and the flat output of the vertex shader have the same values.
  std::array<float, 4> varying = {};
  std::array<float, kMaxClipDistances> clip_distances = {};  // those beyond the volume's are 0

  friend bool operator==(const DrawVertex&, const DrawVertex&) = default;
};

struct Viewport {
  int x = 0, y = 0, width = 0, height = 0;  // px; may reach beyond the target

  friend bool operator==(const Viewport&, const Viewport&) = default;
};

struct DrawCall {
  std::string name = {};  // what it was made from: "homogeneous/behind_the_eye (strip)"
  Topology topology = Topology::triangles;
  std::vector<DrawVertex> vertices = {};
  std::vector<std::uint32_t> indices = {};  // empty: the vertices in their order
  // Depth range minus_one_to_one or zero_to_one; depth clamp of both planes or of none; all sides
  // closed. One-sided front faces: nothing is culled.
  ClipVolume volume = {};
  ProvokingVertex provoking = ProvokingVertex::last;
  float point_size = 1;         // px
  int width = 32, height = 32;  // of the target, px
  Viewport viewport = {0, 0, 32, 32};
  // Asked for; `covered` and `hits` always are. The shader reads no more than it needs for them.
  Quantities quantities = {};

  friend bool operator==(const DrawCall&, const DrawCall&) = default;
};

// The topology that lists the same kind of primitives one by one: points, lines or triangles.
Topology list_of(Topology topology);

inline bool has_whole_viewport(const DrawCall& call) {
  return call.viewport == Viewport{0, 0, call.width, call.height};
}

// The vertices of each primitive, by number into DrawCall::vertices, in the order of the API: 1, 2
// or 3 of them. The second, fourth, ... triangle of a strip has its first two exchanged, so that
// all face the same way; the provoking vertex is apart, see provoking_vertex.
std::vector<std::vector<std::uint32_t>> primitives_of(const DrawCall& call);

// The vertex, by number into DrawCall::vertices, that primitive `number` has its flat values from:
// OpenGL 4.6 core, table 13.2; Vulkan 1.3, sections 21.1.1 to 21.1.6.
std::uint32_t provoking_vertex(const DrawCall& call, std::size_t number);

struct Pixels {
  int width = 0, height = 0;
  // By Quantity: width * height * channels floats, row by row from row 0; empty if not asked for.
  std::array<std::vector<float>, kQuantities> values = {};

  const std::vector<float>& of(Quantity quantity) const { return values[bit(quantity)]; }
  float at(Quantity quantity, int x, int y, std::size_t channel = 0) const {
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    return of(quantity)[pixel * channels(quantity) + channel];
  }

  friend bool operator==(const Pixels&, const Pixels&) = default;
};

}  // namespace clipscope::experiments
