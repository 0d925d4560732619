// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/hard_case.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

using reference::Verdict;

void fill_attributes(HardCase& hard_case, int given) {
  const bool polygon = hard_case.primitive == Primitive::polygon;
  hard_case.attribute_count = std::max(given, kSceneAttributes);
  for (std::size_t i = 0; i < hard_case.vertices.size(); ++i) {
    reference::InputVertex& v = hard_case.vertices[i];
    std::array<double, 4> filling = polygon ? v.position : std::array<double, 4>{0, 0, 0, 1};
    if (!polygon) filling[i] = 1;
    for (int k = given; k < kSceneAttributes; ++k) {
      v.attributes[static_cast<std::size_t>(k)] = filling[static_cast<std::size_t>(k - given)];
    }
  }
}

reference::Truth truth_of(const HardCase& hard_case) { return reference::truth_of(hard_case); }

reference::ExactPolygon exact_polygon(const HardCase& hard_case) {
  return reference::clip(truth_of(hard_case), hard_case.vertices, hard_case.attribute_count);
}

ExactOutcome exact_outcome(const HardCase& hard_case) {
  const reference::ExactPolygon polygon = exact_polygon(hard_case);
  return {polygon.verdict, polygon.vertices.size()};
}

reference::InputTriangle triangle_of(const HardCase& hard_case) {
  assert(hard_case.primitive == Primitive::triangle && hard_case.vertices.size() == 3);
  reference::InputTriangle triangle;
  std::ranges::copy(hard_case.vertices, triangle.vertices.begin());
  triangle.attribute_count = hard_case.attribute_count;
  return triangle;
}

std::string to_string(const ExactOutcome& outcome) {
  if (outcome.verdict == Verdict::rejected) return "rejected";
  return fmt::format("{} {}", outcome.verdict == Verdict::accepted ? "accepted" : "clipped",
                     outcome.vertices);
}

}  // namespace clipscope::experiments
