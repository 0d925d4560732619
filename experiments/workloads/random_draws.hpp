// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draw calls of chance: what a hunt begins with (random_prey in experiments/hunt/breeding.hpp), and
// meshes whose triangles meet at edges and around vertices, so that each pixel within is hit once.
//
// A mesh lies in a plane: its vertices are A + u B + v C in clip coordinates, rounded to float, and
// no two of its triangles overlap in (u, v). So they do not in the picture, wherever w > 0; often
// the plane passes through the eye's plane w = 0, and vertices lie behind it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

// In turns.
enum class RandomKind : std::uint8_t {
  triangle,
  edge_pair,  // two triangles with a common edge
  fan_mesh,   // triangles all around a vertex
  segment,
  strip_mesh,  // a triangle strip
  neighbour,   // of a triangle of small numbers: some ulps, exponents and signs away
  point,
  grid_mesh  // indexed triangles
};
constexpr std::array<std::string_view, 8> names_of(RandomKind) {
  return {"triangle",   "edge_pair", "fan_mesh", "segment",
          "strip_mesh", "neighbour", "point",    "grid_mesh"};
}
constexpr RandomKind random_kind(std::size_t number) {
  return static_cast<RandomKind>(number % names_of(RandomKind{}).size());
}

// "random/17 (edge_pair)".
DrawCall random_draw(std::uint64_t seed, std::size_t number, const DriverInfo& info);

}  // namespace clipscope::experiments
