// SPDX-License-Identifier: GPL-3.0-or-later
//
// What inputs reach, counted on the exact answer: a kind of input that claims to be hard in some
// way has to show it here.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace clipscope::attack {

enum class Fact : std::uint8_t {
  cut,              // polygons with a new vertex
  two_planes,       // vertices on two planes
  tie_to_low,       // floats half way between two, the lower one in magnitude being even
  tie_to_high,      // the higher one
  next_to_tie,      // less than 2^-26 of a unit in the last place from half way, but not there
  subnormal,        // floats that are subnormal, not 0
  rounded_to_zero,  // floats that are not 0, rounded to +0
  rounded_to_minus_zero,
  largest_inverse,    // 1/w that is the largest float
  infinite_inverse,   // 1/w that rounds to infinity
  through_corner,     // new vertices with a third line exactly through them
  next_to_corner,     // lines that miss one by less than 2^-48 of the terms of the determinant
  vertex_on_plane,    // vertices of a cut triangle on a plane
  beside_plane,       // the same by a distance of less than 2^-20 of its terms, but not on it
  without_w,          // corners with w = 0, which are left out
  behind,             // vertices with w < 0 of triangles that are cut
  flat,               // polygons without area in NDC
  sliver,             // the same with less than 2^-20 of the product of their longest sides
  cancelled,          // floats whose sum is below 2^-24 of its terms, but not 0
  cancelled_to_zero,  // the same, exactly 0
  kept_minus_zero,    // -0 of a vertex that comes out of the stage as it is
  lost_minus_zero,    // -0 of a vertex that is +0 in NDC
  overflowed_z,       // polygons that are dropped since z rounds to infinity
  outside_depth,      // depths outside of the range, as a clamp leaves them
  by_clip_distance,   // vertices on a clip distance's plane
  huge,               // floats above 2^120
  in_open_side        // polygons that no one but an open side keeps from being drawn
};
inline constexpr int kFacts = 27;

inline constexpr std::array<std::string_view, kFacts> kFactNames = {"cut",
                                                                    "two_planes",
                                                                    "tie_to_low",
                                                                    "tie_to_high",
                                                                    "next_to_tie",
                                                                    "subnormal",
                                                                    "rounded_to_zero",
                                                                    "rounded_to_minus_zero",
                                                                    "largest_inverse",
                                                                    "infinite_inverse",
                                                                    "through_corner",
                                                                    "next_to_corner",
                                                                    "vertex_on_plane",
                                                                    "beside_plane",
                                                                    "without_w",
                                                                    "behind",
                                                                    "flat",
                                                                    "sliver",
                                                                    "cancelled",
                                                                    "cancelled_to_zero",
                                                                    "kept_minus_zero",
                                                                    "lost_minus_zero",
                                                                    "overflowed_z",
                                                                    "outside_depth",
                                                                    "by_clip_distance",
                                                                    "huge",
                                                                    "in_open_side"};

struct Facts {
  std::array<std::int64_t, kFacts> counts{};

  void note(Fact fact, bool holds = true) { counts[static_cast<std::size_t>(fact)] += holds; }
  std::int64_t operator[](Fact fact) const { return counts[static_cast<std::size_t>(fact)]; }
  Facts& operator+=(const Facts& other) {
    for (std::size_t i = 0; i < kFacts; ++i) counts[i] += other.counts[i];
    return *this;
  }
};

}  // namespace clipscope::attack
