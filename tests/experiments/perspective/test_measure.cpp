// SPDX-License-Identifier: GPL-3.0-or-later
//
// What scenes' triangles need, and the attributes of vertices that clipping makes after the divide.
#include <algorithm>

#include "experiments/perspective/affine_error.hpp"
#include "experiments/perspective/measure.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::perspective {

TEST_CASE("scene need: a polygon at one distance needs no correction") {
  const std::array<TextureCorner, 4> square = {{{3, 0, 0}, {3, 1, 0}, {3, 1, 1}, {3, 0, 1}}};
  const PolygonNeed need = need_of(square);
  CHECK(need.ratio == 1);
  CHECK(need.error == 0);
  CHECK(need.error_split == 0);
}

TEST_CASE("scene need: the worst edge counts, in u or in v, and splitting shortens it") {
  const bool in_v = GENERATE(false, true);
  const TextureCorner far = in_v ? TextureCorner{4, 0, 1} : TextureCorner{4, 1, 0};
  const std::array<TextureCorner, 3> triangle = {{{1, 0, 0}, far, {1, 0, 0}}};
  const PolygonNeed need = need_of(triangle);
  CHECK(need.ratio == 4);
  CHECK(need.error == Approx(1.0 / 3));
  // The nearest of its four parts is the worst: from w = 1 to 1.75 over a quarter of the texture.
  CHECK(need.error_split == Approx(0.25 * affine_bound(1, 1.75)));
}

TEST_CASE("scene need: a diagonal of the fan counts as an edge") {
  // Along all four sides either w or the texture stays the same; from corner 0 to corner 2 both
  // change.
  const std::array<TextureCorner, 4> square = {{{1, 0, 0}, {1, 1, 0}, {9, 1, 0}, {9, 0, 0}}};
  CHECK(need_of(square).error == Approx(0.5));
}

TEST_CASE("scene need: a row has the quantiles of r, and the share of triangles half a texel off") {
  // Half a texel: 0.00195 of 256, 0.00049 of 1024, 0.00012 of 4096.
  const std::vector<PolygonNeed> needs = {
      {4, 0.1, 0.001}, {1, 0, 0}, {2, 0.001, 0.0001}, {3, 0.0002, 0}};
  const SceneRow row = scene_row("four", needs);
  CHECK(row.triangles == 4);
  CHECK(row.ratio_median == 2);
  CHECK(row.ratio_p99 == 3);
  CHECK(row.ratio_max == 4);
  CHECK(row.above_256 == 25);
  CHECK(row.above_1024 == 50);
  CHECK(row.above_4096 == 75);
  CHECK(row.split_above_1024 == 25);
}

TEST_CASE("thresholds: each is the closed form's, found again by search and exact in rationals") {
  const std::vector<ThresholdRow> rows = threshold_rows();
  REQUIRE(rows.size() == 9);
  for (const ThresholdRow& row : rows) {
    CHECK(row.exact);
    CHECK(row.above_one() == Approx(row.measured_above_one).epsilon(1e-9));
  }
  CHECK(find_row(rows, &ThresholdRow::texels, 1024)->error == 0.5 / 1024);
}

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
  const CutRow naive = measure_cut(find_contestant("cvv/naive", "exact"), ratio, triangles);
  CHECK(naive.triangles == 60);
  CHECK(naive.bound == affine_bound(ratio, 1));
  CHECK(naive.max_error <= naive.bound);
  CHECK(naive.max_error > naive.bound / 4);
  CHECK_FALSE(naive.worst.empty());
}

TEST_CASE("cut after the divide: perspective-correct attributes are exact in exact arithmetic") {
  const auto triangles = cut_triangles(256, 60, 7);
  const CutRow cut = measure_cut(find_contestant("cvv/perspective", "exact"), 256, triangles);
  CHECK(cut.triangles == 60);
  CHECK(cut.max_error == 0);
  CHECK(cut.worst.empty());
}

}  // namespace clipscope::experiments::perspective
