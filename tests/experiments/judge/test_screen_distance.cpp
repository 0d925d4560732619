// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "experiments/judge/match.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("screen distance: squares side by side, one in the other, and nothing") {
  const std::vector<ScreenPoint> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const std::vector<ScreenPoint> aside = {{3, 0}, {13, 0}, {13, 10}, {3, 10}};
  const std::vector<ScreenPoint> inner = {{2, 2}, {8, 2}, {8, 8}, {2, 8}};
  CHECK(screen_distance(square, square) == 0);
  CHECK(screen_distance(square, aside) == Approx(3));
  CHECK(screen_distance(square, inner) == Approx(std::sqrt(8.0)));
  CHECK(screen_distance(inner, square) == Approx(std::sqrt(8.0)));
  CHECK(screen_distance(square, {}) == Approx(std::sqrt(200.0)));
  CHECK(screen_distance({}, {}) == 0);
}

TEST_CASE("screen distance: one vertex more on an edge changes nothing") {
  const std::vector<ScreenPoint> triangle = {{0, 0}, {10, 0}, {0, 10}};
  const std::vector<ScreenPoint> with_one_more = {{0, 0}, {5, 0}, {10, 0}, {0, 10}};
  CHECK(screen_distance(triangle, with_one_more) == Approx(0).margin(1e-12));
}
