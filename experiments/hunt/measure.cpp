// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/measure.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/judge/depth_error.hpp"

namespace clipscope::experiments::hunt {

double largest_attribute(const HardCase& hard_case) {
  double largest = 0;
  for (const reference::InputVertex& v : hard_case.vertices) {
    for (int k = 0; k < hard_case.attribute_count; ++k) {
      largest = std::max(largest, std::abs(v.attributes[static_cast<std::size_t>(k)]));
    }
  }
  return largest == 0 ? 1 : largest;
}

Errors errors_of(const HardCase& hard_case, const PolygonView& polygon, const TruthPolygon& truth) {
  Errors errors{compare(polygon, truth), 0, largest_attribute(hard_case)};
  if (errors.comparison.outcome > Outcome::visible) return errors;
  errors.depth_ulp = largest_depth_error(polygon, truth) / polygon.format().ulp_at(1);
  return errors;
}

double value_of(Measure measure, const Errors& errors) {
  const Comparison& comparison = errors.comparison;
  if (comparison.outcome > Outcome::visible) return 0;
  switch (measure) {
    case Measure::px: return comparison.position_px;
    case Measure::ulp: return comparison.position_ulp;
    case Measure::depth: return errors.depth_ulp;
    case Measure::attribute: return comparison.attribute / errors.largest_attribute;
    default: return 0;
  }
}

bool is_crash(const PolygonView& polygon) {
  if (polygon.failure() != nullptr) return true;
  return std::ranges::any_of(polygon, [](const VertexView& v) {
    return !is_finite(v[0]) || !is_finite(v[1]) || !is_finite(v[2]);
  });
}

}  // namespace clipscope::experiments::hunt
