// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fast reference against gold on the catalogue of hard cases.
#include <stdexcept>

#include "experiments/catalogue/catalogue.hpp"
#include "reference/gold.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

std::vector<reference::RationalVertex> gold(const HardCase& hard_case) {
  const reference::InputTriangle triangle = triangle_of(hard_case);
  if (hard_case.space == Space::view) {
    return reference::gold_of_frustum(hard_case.frustum, hard_case.volume, triangle);
  }
  return reference::gold_of_clip(hard_case.volume, triangle);
}

TEST_CASE("reference: equals gold on every triangle of the catalogue that has an area") {
  int compared = 0, without_area = 0;
  for (const HardCase& hard_case : builtin_catalogue()) {
    if (hard_case.primitive != Primitive::triangle) continue;
    std::vector<reference::RationalVertex> expected;
    try {
      expected = gold(hard_case);
    } catch (const std::invalid_argument&) {
      ++without_area;
      continue;
    }
    CAPTURE(hard_case.name);
    CHECK(expected == vertex_set(exact_polygon(hard_case)));
    ++compared;
  }
  CHECK(compared > 150);
  CHECK(without_area < 20);
}

}  // namespace
}  // namespace clipscope::experiments
