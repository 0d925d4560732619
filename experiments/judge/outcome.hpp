// SPDX-License-Identifier: GPL-3.0-or-later
//
// What became of one triangle: a category, never folded into a number.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string_view>

namespace clipscope::experiments {

enum class Outcome : std::uint8_t {
  exact,          // the right vertices, each coordinate within half an ulp: the nearest there is
  faithful,       // the right vertices, each coordinate within one ulp
  subpixel,       // the right vertices, each less than 1/256 px off
  visible,        // the right vertices, some 1/256 px off or more
  vertex_count,   // another number of vertices
  missing,        // nothing, where something is visible
  extra,          // something, where nothing is visible
  flipped,        // the winding is reversed
  not_finite,     // some coordinate is NaN or infinite
  crashed,        // of guests: no answer, see Failure in contestants/answers.hpp
  timed_out,      // likewise
  malformed,      // likewise
  not_applicable  // the method does not take such input
};

inline constexpr int kOutcomes = 13;
inline constexpr std::array<std::string_view, kOutcomes> kOutcomeNames = {
    "exact",   "faithful",   "subpixel", "visible",   "vertex_count", "missing",       "extra",
    "flipped", "not_finite", "crashed",  "timed_out", "malformed",    "not_applicable"};

// The outcomes of primitives in view space, which every clipper takes.
inline constexpr int kViewOutcomes = kOutcomes - 1;
inline constexpr auto kViewOutcomeNames = [] {
  std::array<std::string_view, kViewOutcomes> names;
  std::copy_n(kOutcomeNames.begin(), kViewOutcomes, names.begin());
  return names;
}();

// How many primitives had each outcome.
using OutcomeCounts = std::array<std::int64_t, kOutcomes>;
constexpr std::array<std::int64_t, kViewOutcomes> view_outcomes(const OutcomeCounts& counts) {
  std::array<std::int64_t, kViewOutcomes> result{};
  std::copy_n(counts.begin(), kViewOutcomes, result.begin());
  return result;
}

inline std::int64_t sum_of(const OutcomeCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

// Whether the answer is wrong for somebody who looks at it: anything but the right vertices within
// a small part of a pixel.
constexpr bool is_failure(Outcome outcome) {
  return outcome > Outcome::subpixel && outcome != Outcome::not_applicable;
}

constexpr const auto& names_of(Outcome) { return kOutcomeNames; }

// The screen that pixels are counted on.
inline constexpr double kScreenWidth = 3840.0;
inline constexpr double kScreenHeight = 2160.0;
inline constexpr double kSubpixel = 1.0 / 256.0;  // px

}  // namespace clipscope::experiments
