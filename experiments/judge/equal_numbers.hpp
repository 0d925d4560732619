// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many numbers of an answer are the ones wanted.
//
// Vertices are matched in the order of the polygon, at the rotation that makes most numbers equal:
// places on screen (match.hpp) do not tell the vertices of a polygon apart that is smaller there
// than a float.
#pragma once

#include <cstddef>
#include <vector>

namespace clipscope::experiments {

// Numbers of `found[(i + rotation) % n]` that equal those of `wanted[i]`, by value. Pre-condition:
// as many vertices in both, none of `found` with more numbers.
template <class Wanted, class Found>
std::size_t equal_numbers(const std::vector<Wanted>& wanted, const std::vector<Found>& found,
                          std::size_t rotation) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Found& vertex = found[(i + rotation) % found.size()];
    for (std::size_t k = 0; k < vertex.size(); ++k) {
      if (vertex[k] == wanted[i][k]) ++count;
    }
  }
  return count;
}

// The first rotation with the most equal numbers.
template <class Wanted, class Found>
std::size_t most_equal_rotation(const std::vector<Wanted>& wanted,
                                const std::vector<Found>& found) {
  std::size_t best = 0, most = 0;
  for (std::size_t rotation = 0; rotation < wanted.size(); ++rotation) {
    const std::size_t count = equal_numbers(wanted, found, rotation);
    if (count <= most) continue;
    most = count;
    best = rotation;
  }
  return best;
}

}  // namespace clipscope::experiments
