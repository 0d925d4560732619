// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/ulp_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("ulp grid: moving by ulps is nextafter, again and again") {
  const float start = GENERATE(1.0f, -1.0f, 0.0f, 1e-45f, -1e6f, 0.1f);
  float up = start, down = start;
  for (int n = 1; n <= 200; ++n) {
    up = std::nextafter(up, std::numeric_limits<float>::infinity());
    down = std::nextafter(down, -std::numeric_limits<float>::infinity());
    REQUIRE(moved_by_ulps(start, n) == up);
    REQUIRE(moved_by_ulps(start, -n) == down);
  }
  CHECK(moved_by_ulps(-0.0f, 1) == std::numeric_limits<float>::denorm_min());
}

// x = w in clip space: w - x is exact near the plane, and the ulps of x and w are the same, so that
// the diagonal of the grid is on the plane.
TEST_CASE("ulp grid: the plane x = w is the diagonal, by hand") {
  const PlaneGrid plane = plane_grids().back();
  const UlpGrid& grid = plane.grid;
  REQUIRE(grid.name == "right_in_clip_space");
  const SignMap exact = sign_map(grid, grid.exact);
  for (int j = 0; j < grid.size; ++j) {
    for (int i = 0; i < grid.size; ++i) REQUIRE(exact.at(i, j) == (i < j ? 1 : (i > j ? -1 : 0)));
  }
}

TEST_CASE("ulp grid: the exact signs are those of the plane's form in rationals") {
  for (const PlaneGrid& plane : plane_grids()) {
    CAPTURE(plane.grid.name);
    for (int i = 0; i < plane.grid.size; i += 17) {
      for (int j = 0; j < plane.grid.size; j += 5) {
        const GridPoint p = grid_point(plane.grid, i, j);
        REQUIRE(plane.grid.exact(p) ==
                plane_sign<reference::Rational>(plane.setting, Route::own_form, p));
        REQUIRE(plane.grid.exact(p) ==
                plane_sign<reference::Rational>(plane.setting, Route::divide, p));
      }
    }
  }
}

TEST_CASE("ulp grid: both ways to decide about the edge are one in rationals") {
  const EdgeGrid edge = edge_grid();
  for (int i = 0; i < edge.grid.size; i += 13) {
    for (int j = 0; j < edge.grid.size; j += 7) {
      const GridPoint p = grid_point(edge.grid, i, j);
      REQUIRE(edge_sign_by_cut<reference::Rational>(edge.end, p) == edge.grid.exact(p));
    }
  }
}

SignCounts counts_of(const UlpGrid& grid, const std::string& title) {
  for (const Predicate& predicate : grid.predicates) {
    if (predicate.title == title) {
      return compare(sign_map(grid, predicate.sign_of), sign_map(grid, grid.exact));
    }
  }
  FAIL("no predicate " << title);
  return {};
}

TEST_CASE("ulp grid: every grid has points on both sides") {
  std::vector<UlpGrid> grids = {edge_grid().grid};
  for (const PlaneGrid& plane : plane_grids()) grids.push_back(plane.grid);
  for (const UlpGrid& grid : grids) {
    CAPTURE(grid.name);
    const SignMap exact = sign_map(grid, grid.exact);
    CHECK(exact.signs.size() == 256 * 256);
    CHECK(std::ranges::count(exact.signs, 1) > 10000);
    CHECK(std::ranges::count(exact.signs, -1) > 10000);
  }
}

// A product of two floats is exact in double, and so is the sign of one rounded sum.
TEST_CASE("ulp grid: the own form of a perspective or clip-space plane is right in double") {
  for (const PlaneGrid& plane : plane_grids()) {
    if (plane.setting.frustum.kind == ProjectionKind::perspective) {
      CAPTURE(plane.grid.name);
      CHECK(counts_of(plane.grid, "double, own form").wrong() == 0);
    }
  }
}

// w - x of floats is 0 exactly if they are equal.
TEST_CASE("ulp grid: the own form is right in float where it is one difference") {
  for (const PlaneGrid& plane : plane_grids()) {
    const bool is_difference =
        plane.setting.space == Space::clip || plane.setting.plane == Plane::far;
    CAPTURE(plane.grid.name);
    CHECK((counts_of(plane.grid, "float, own form").wrong() == 0) == is_difference);
  }
}

TEST_CASE("ulp grid: with far/near = 1e7 all is on the far plane of a float matrix") {
  const UlpGrid grid = plane_grids().at(1).grid;
  REQUIRE(grid.name == "far_of_deep_frustum");
  CHECK(counts_of(grid, "float, after the matrix").false_zero == 255 * 256);
}

// Distances of floats of similar size are exact in double, and so is the sign of their minor.
TEST_CASE(
    "ulp grid: at an edge of the volume the minor is right in double, the cut in float isn't") {
  const UlpGrid grid = edge_grid().grid;
  CHECK(counts_of(grid, "double, minor").wrong() == 0);
  const SignCounts at_cut = counts_of(grid, "float, at the cut");
  CHECK(at_cut.opposite > 100);
  CHECK(at_cut.wrong() > 10 * counts_of(grid, "float, minor").wrong());
}

TEST_CASE("ulp grid: fates tell what is wrong") {
  CHECK(sign_fate(1, 1) == SignFate::right);
  CHECK(sign_fate(-1, 1) == SignFate::opposite);
  CHECK(sign_fate(0, -1) == SignFate::false_zero);
  CHECK(sign_fate(1, 0) == SignFate::missed_zero);
}

}  // namespace
}  // namespace clipscope::experiments
