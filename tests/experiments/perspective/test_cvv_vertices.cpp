// SPDX-License-Identifier: GPL-3.0-or-later
//
// Attributes of vertices that clipping makes after the divide.
#include "experiments/perspective/affine_error.hpp"
#include "experiments/perspective/cvv_vertices.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("cut after the divide: triangles have the ratio of w that was asked for, to the bit") {
  const float ratio = GENERATE(1.015625f, 16.0f, 4096.0f);
  const auto triangles = cut_triangles(ratio, 20, 5);
  REQUIRE(triangles.size() == 20);
  for (const SceneTriangle& t : triangles) {
    const auto [low, high] = std::minmax({-t[0].position[2], -t[1].position[2], -t[2].position[2]});
    CHECK(high == low * ratio);
    CHECK(low > cut_frustum().near);
  }
}

TEST_CASE("cut after the divide: in exact arithmetic affine attributes keep to the bound") {
  const float ratio = GENERATE(1.25f, 16.0f, 256.0f);
  const auto triangles = cut_triangles(ratio, 60, 7);
  const CutError naive = attribute_error_of_cut(find_contestant("cvv/naive", "exact"), triangles);
  CHECK(naive.triangles == 60);
  CHECK(naive.max <= affine_bound(ratio, 1));
  CHECK(naive.max > affine_bound(ratio, 1) / 4);
  CHECK_FALSE(naive.worst.empty());
}

TEST_CASE("cut after the divide: perspective-correct attributes are exact in exact arithmetic") {
  const auto triangles = cut_triangles(256, 60, 7);
  const CutError error =
      attribute_error_of_cut(find_contestant("cvv/perspective", "exact"), triangles);
  CHECK(error.triangles == 60);
  CHECK(error.max == 0);
  CHECK(error.worst.empty());
}
