// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many numbers of an answer are the nearest to the exact ones that its format has.
//
// Right is the float or double nearest to the exact value, ties to even; 0 and -0 are the same.
// Vertices are matched in the order of the polygon, at the rotation that makes most numbers right.
// An answer with other vertices than the exact polygon has all of its numbers wrong, unless the
// exact one, rounded once, has vertices that fall together: then these count as one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "experiments/judge/compare.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

struct RoundingCount {
  std::int64_t coordinates = 0, misrounded = 0;            // x, y, z and 1/w of the exact vertices
  std::int64_t attributes = 0, misrounded_attributes = 0;  // of these vertices

  RoundingCount& operator+=(const RoundingCount& other) {
    coordinates += other.coordinates;
    misrounded += other.misrounded;
    attributes += other.attributes;
    misrounded_attributes += other.misrounded_attributes;
    return *this;
  }
  friend bool operator==(const RoundingCount&, const RoundingCount&) = default;

  static constexpr auto columns() {
    using R = RoundingCount;
    return std::tuple(column("coordinates", &R::coordinates), column("misrounded", &R::misrounded),
                      column("attributes", &R::attributes),
                      column("misrounded_attributes", "misr. attr", &R::misrounded_attributes));
  }
};

// The exact polygon, and its numbers rounded to the formats that answers come in. For one thread.
class NearestPolygon {
 public:
  // The truth outlives it.
  explicit NearestPolygon(const TruthPolygon& truth) : truth_(truth) {}

  // Nothing of what is visible in neither. Pre-condition: an answer in float or double.
  RoundingCount count(const PolygonView& polygon);

 private:
  using Numbers = std::vector<double>;  // of a vertex: x, y, z, 1/w, then attributes
  const std::vector<Numbers>& nearest_in(const Format& format);

  const TruthPolygon& truth_;
  std::array<std::vector<Numbers>, 2> nearest_;  // in float, in double; empty until asked for
};

}  // namespace clipscope::experiments
