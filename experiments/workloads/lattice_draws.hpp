// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draw calls whose coordinates are small numbers: what breaks a clipper is seldom a long mantissa,
// and a small number is what people can follow by hand.
//
// They are drawn at random from strata, in turns: primitive x signs of w x kind of numbers x
// setting. Of eight tries for a stratum the first is taken that has something visible, if any; of
// points, half of which are taken as they come, also a centre outside may show a part of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

enum class WSigns : std::uint8_t {
  in_front,       // w > 0
  one_on,         // of one vertex w = 0
  one_behind,     // of one vertex w < 0
  two_behind,     // triangles
  on_and_behind,  // of one vertex w = 0, of one w < 0; triangles
  none_in_front
};
constexpr std::array<std::string_view, 6> names_of(WSigns) {
  return {"in_front", "one_on", "one_behind", "two_behind", "on_and_behind", "none_in_front"};
}

enum class LatticeNumbers : std::uint8_t {
  small,       // x, y, z in -2 ... 2, w in -3 ... 3
  larger,      // x, y, z in -9 ... 9, w in -5 ... 5; or multiples of 1/2 and 1/4
  scaled,      // one vertex times 2^-12 ... 2^12, or all times 2^-60 ... 2^28
  far_vertex,  // x, y or z of one vertex times 2^10 ... 2^24
  small_w,     // w of one vertex times 2^-24 ... 2^-4: far away, too, and beside the eye
  // Two vertices 2^-12 ... 2^-3 apart in one coordinate, alike in all or in w alone: slivers,
  // short segments, edges nearly level or upright.
  close_vertices
};
constexpr std::array<std::string_view, 6> names_of(LatticeNumbers) {
  return {"small", "larger", "scaled", "far_vertex", "small_w", "close_vertices"};
}

enum class LatticeSetting : std::uint8_t {
  plain,
  strip,            // two primitives with a common edge or end, a strip where there is one
  other_provoking,  // indexed, the vertices in another order
  depth_clamp,
  clip_distances,
  large_viewport,
  quantity_alone  // one of them
};
constexpr std::array<std::string_view, 7> names_of(LatticeSetting) {
  return {"plain",          "strip",          "other_provoking", "depth_clamp",
          "clip_distances", "large_viewport", "quantity_alone"};
}

struct LatticeStratum {
  std::size_t primitive = 3;  // vertices: 1, 2 or 3
  WSigns signs = WSigns::in_front;
  LatticeNumbers numbers = LatticeNumbers::small;
  LatticeSetting setting = LatticeSetting::plain;

  friend bool operator==(const LatticeStratum&, const LatticeStratum&) = default;
};

// Draw calls of so many consecutive numbers are of all strata: of triangles 6 signs, of segments 4
// and of points 2; all numbers; and all settings, but for points without the two of order.
inline constexpr std::size_t kLatticeStrata = (6 + 4) * 6 * 7 + 2 * 6 * 5;

// Of the draw call of that number.
LatticeStratum lattice_stratum(std::size_t number);

// Its name tells number and stratum: "lattice/17 (triangle, one_behind, halves, strip)".
DrawCall lattice_draw(std::uint64_t seed, std::size_t number, const DriverInfo& info);

}  // namespace clipscope::experiments
