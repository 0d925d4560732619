// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons as rows of floats, those of clippers and exact ones rounded once, compared bit by bit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reference/exact_clip.hpp"
#include "spaces/polygon.hpp"
#include "tests/reference/clip_cases.hpp"

namespace clipscope::reference {

using Row = std::array<float, 4 + kAttributes>;  // the position, the attributes
using Rows = std::vector<Row>;

template <Space S>
Rows rows(const Polygon<S, float, kAttributes>& polygon) {
  Rows r;
  for (const auto& v : polygon) {
    Row& row = r.emplace_back();
    for (int c = 0; c < 4; ++c) row[c] = v.position[c];
    for (int k = 0; k < kAttributes; ++k) row[4 + k] = v.attributes[k];
  }
  return r;
}

// What a clipper has to yield: no polygon of fewer than three vertices, no infinite z.
inline Rows rounded(const ExactPolygon& exact) {
  Rows r;
  if (exact.vertices.size() < 3) return r;
  for (const ExactVertex& v : exact.vertices) {
    Row& row = r.emplace_back(Row{round_to<float>(v.x), round_to<float>(v.y), round_to<float>(v.z),
                                  round_to<float>(v.inv_w)});
    for (int k = 0; k < kAttributes; ++k) row[4 + k] = round_to<float>(v.attributes[k]);
    if (std::isinf(row[2])) return {};
  }
  return r;
}

inline bool same_bits(const Row& a, const Row& b) {
  using Bits = std::array<std::uint32_t, 4 + kAttributes>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

inline bool same_bits(const Rows& a, const Rows& b) {
  return std::ranges::equal(a, b, [](const Row& x, const Row& y) { return same_bits(x, y); });
}

// The same polygon, from whichever vertex on.
inline bool same_cycle(const Rows& a, Rows b) {
  if (a.empty() || b.empty()) return a.empty() && b.empty();
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (same_bits(a, b)) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

}  // namespace clipscope::reference
