// SPDX-License-Identifier: GPL-3.0-or-later
#include "spaces/counting.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Counted;

TEST_CASE("counting: each operation is tallied by its kind") {
  const Counted a(3.0f), b(2.0f);
  operation_counts() = {};
  const Counted r = (a + b) * (a - b) / b;
  CHECK(a > b);
  CHECK(r.value() == 2.5f);
  CHECK(operation_counts() == OperationCounts{2, 1, 1, 1, 0});
}

TEST_CASE("counting: a triangle inside costs its divide and no interpolation") {
  const auto inside = clip_triangle<Counted>({{{0, 0, 0, 1}, {0.5, 0, 0, 1}, {0, 0.5, 0, 1}}});
  NdcPolygon<Counted, K> out;
  operation_counts() = {};
  HomogeneousSutherlandHodgman{}(ClipVolume{}, inside, out);
  CHECK(out.size() == 3);
  CHECK(operation_counts().divisions == 3 * 4);
  CHECK(operation_counts().multiplications == 0);
  CHECK(operation_counts().additions == 0);
}

TEST_CASE("counting: a triangle outside one plane is rejected by comparisons alone") {
  const auto outside = clip_triangle<Counted>({{{2, 0, 0, 1}, {3, 0, 0, 1}, {2, 1, 0, 1}}});
  NdcPolygon<Counted, K> out;
  operation_counts() = {};
  HomogeneousSutherlandHodgman{}(ClipVolume{}, outside, out);
  CHECK(out.empty());
  CHECK(operation_counts().divisions + operation_counts().multiplications +
            operation_counts().additions ==
        0);
  CHECK(operation_counts().comparisons > 0);
}
