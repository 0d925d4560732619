// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a hunt looks for the worst of.
//
//   px           position error on a screen of 3840 x 2160, where the vertices are the right ones
//   ulp          position error over x, y, z and 1/w in the scalar's ulp at the exact value,
//                likewise; next to 0 an ulp is tiny, so that the worst is where the exact value is
//                0
//   depth        error of z, in the scalar's ulp at 1, likewise
//   attribute    error of an attribute over the largest attribute of the triangle, likewise
//   containment  how far x, y or z lies beyond its bound, in NDC (judge/containment.hpp)
//   crack        two triangles that share an edge: the largest distance in px between the vertices
//                that they have for the same point of that edge, where the vertices of both are the
//                right ones
//   crash        1 where there is no answer, or an x, y or z that is NaN or infinite; else 0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/containment.hpp"

namespace clipscope::experiments::hunt {

enum class Measure : std::uint8_t { px, ulp, depth, attribute, containment, crack, crash };

constexpr std::array<std::string_view, 7> names_of(Measure) {
  return {"px", "ulp", "depth", "attribute", "containment", "crack", "crash"};
}
inline std::string_view name_of(Measure measure) {
  return names_of(measure)[static_cast<std::size_t>(measure)];
}

// The largest attribute of a primitive in magnitude; 1 where all are 0 or there is none.
double largest_attribute(const HardCase& hard_case);

// What px, ulp, depth and attribute are taken from.
struct Errors {
  Comparison comparison;
  double depth_ulp = 0;  // of z, in ulp at 1
  double largest_attribute = 1;
};

// Of an answer against the exact one. The primitive is the case.
Errors errors_of(const HardCase& hard_case, const PolygonView& polygon, const TruthPolygon& truth);

// Of px, ulp, depth and attribute; 0 where the vertices are not the right ones.
double value_of(Measure measure, const Errors& errors);

// Of crash.
bool is_crash(const PolygonView& polygon);

}  // namespace clipscope::experiments::hunt
