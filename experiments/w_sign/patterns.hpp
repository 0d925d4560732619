// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clip-space triangles by the sign of w at their vertices: every combination of five kinds, 35 patterns.
//
// A vertex's x, y, z are of the size of its w, so that it lies in or near the volume, or of size 1, which
// for a tiny w is nearly a direction; with w = 0 it is one, or in one of eight the point 0 0 0 0.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/measure/sweep.hpp"

namespace clipscope::experiments {

// tiny: from the smallest normal float to 1e-5, every power of two equally often. positive, negative:
// magnitudes 0.1 to 10.
enum class WKind : std::uint8_t { negative, minus_zero, zero, tiny, positive };

// In ascending order; the order of the vertices is random.
using WPattern = std::array<WKind, 3>;

std::vector<WPattern> all_patterns();

std::string pattern_name(const WPattern& pattern);  // "- +0 tiny"

// So many random triangles of the pattern; of the volume [-1, 1]. The same for the same seed.
SweepChunk pattern_chunk(const WPattern& pattern, std::size_t triangles, std::uint64_t seed);

}  // namespace clipscope::experiments
