// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments in clip space: those of the plane that papers on two-dimensional clipping draw at
// random, and hard sets, on which methods differ in what they get wrong.
//
// The window and the volume are the canonical ones: -1 <= x, y, z <= 1 for w = 1. Segments of the
// plane lie between (x, y, 0, 1).
//
// Guarantees: the same bits for the same name, seed and size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/contestants/batch.hpp"

namespace clipscope::experiments::segments {

struct ClipSegments {
  std::string name;
  bool in_plane = true;             // every end is (x, y, 0, 1)
  std::vector<float> numbers = {};  // x y z w of each end, segment after segment

  std::size_t size() const { return numbers.size() / 8; }
  Batch batch() const {
    return {.space = Space::clip, .vertices = 2, .numbers = std::span<const float>(numbers)};
  }
};

// At most `limit` of them, evenly spaced.
ClipSegments thinned(const ClipSegments& segments, std::size_t limit);

// Random segments of the plane. box_K: both ends uniform in a square whose side is K times the
// window's, as papers choose them; the other mixes hold what exact arithmetic says of their
// segments: both ends inside; both beyond the same side; past a corner, invisible without sharing a
// side; one end out; both out and visible.
std::vector<std::string> plane_mixes();
// Errors: UsageError for an unknown name.
ClipSegments make_plane_mix(std::string_view name, std::size_t size, std::uint64_t seed);

// borders     ends on sides and corners of the window, beyond them and between, all combinations:
//             segments along a side, through corners, of no length
// neighbours  ends on the floats next to the sides, all combinations
// corners     lines that pass within rounding of a corner
// grazing     lines that leave a side by a few ulps
// far         ends so far away that differences overflow
// subnormal   ends as near to an axis as floats can be, and segments of that length
// w_sign      ends on planes and corners of the volume, w of any sign and 0, all combinations
// w_scale     ends inside and outside whose w is a huge or a tiny power of two
std::vector<std::string> hard_sets();
// About `size` segments of those that there are. Errors: UsageError for an unknown name.
ClipSegments make_hard_set(std::string_view name, std::size_t size, std::uint64_t seed);

}  // namespace clipscope::experiments::segments
