// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two polygons are the same to the bit: -0 is not 0, and a NaN is itself.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "experiments/contestants/answers.hpp"

namespace clipscope::experiments {

// In formats whose numbers are doubles. Where one of them has no answer the other one must have
// none for the same reason.
inline bool has_same_bits(const PolygonView& a, const PolygonView& b) {
  const Failure *of_a = a.failure(), *of_b = b.failure();
  if (of_a != nullptr && of_b != nullptr) return of_a->kind == of_b->kind;
  if (of_a != nullptr || of_b != nullptr) return false;
  return std::ranges::equal(a, b, [](const VertexView& u, const VertexView& v) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      const auto bits = [i](const VertexView& w) {
        return std::bit_cast<std::uint64_t>(w[i].value);
      };
      if (bits(u) != bits(v)) return false;
    }
    return true;
  });
}

}  // namespace clipscope::experiments
