// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the time of the stage contract grows: with the number of triangles, of attributes, of planes that a
// triangle crosses, and with threads.
//
//   triangles   the first n of a game-like soup; beyond its size it streams through again and again
//   attributes  game-like soups with so many floats beside the position
//   planes      every triangle is cut by exactly n planes
//   threads     a game-like soup in n parts, one per thread; the time is that of the clock on the wall
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/measure/stage_timing.hpp"

namespace clipscope::experiments {

enum class Growing : std::uint8_t { triangles, attributes, planes, threads };
inline constexpr std::array kGrowing = {Growing::triangles, Growing::attributes, Growing::planes,
                                        Growing::threads};
std::string_view growing_name(Growing growing);  // "triangles" and so on

struct GrowthPoint {
  Growing growing = Growing::triangles;
  std::int64_t n = 0;
  std::string clipper = {}, scalar = {}, build = {}, contract = {};
  double triangles = 0;  // clipped in one run
  Timing timing = {};    // speedup: against textbook where that is timed
};

struct GrowthOptions {
  std::uint64_t seed = 1;
  std::size_t soup = 1'000'000;    // triangles
  std::size_t most = 100'000'000;  // triangles streamed
  std::size_t attribute_soup = 200'000;
  std::size_t crossing = 2048;  // different triangles by number of planes; each comes several times
  StageTimingOptions timing = {};
};

std::vector<GrowthPoint> measure_growth(Growing growing, const GrowthOptions& options);

// Clip-space triangles that cross exactly so many planes: some vertex is outside of each of these, none is
// outside of another, and each is an edge of what is left. Each of `different` triangles comes `times` times,
// in random order. Pre-condition: 1 <= planes <= 6.
StageInput crossing_input(int planes, std::size_t different, std::size_t times, std::uint64_t seed);

}  // namespace clipscope::experiments
