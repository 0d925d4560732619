// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/draw/panel.hpp"

#include <cmath>

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;

ExactPosition position(Rational x, Rational y) {
  return {std::move(x), std::move(y), Rational(0), Rational(1)};
}

TEST_CASE("panel: a window holds what it must, and of the rest what is not too far") {
  PanelAxis x{.coordinate = 0}, y{.coordinate = 1};
  fit_window(
      {.must = {position(0, 0), position(1, 0)}, .may = {position(0, 10), position(0, 1e37)}}, x,
      y);
  CHECK(y.high > 10);
  CHECK(y.high < 20);
  CHECK(x.size() == Approx(y.size()));
  for (const double size : {1e-320, 1e-45, 1.0, 1e38, 1e300}) {
    INFO(size);
    fit_window({.must = {position(0, 0)}, .may = {position(size, size), position(size, 0)}}, x, y);
    CHECK(x.low < x.high);
    CHECK(std::isfinite(x.size()));
    CHECK(x.low < size);
  }
  fit_window({}, x, y);
  CHECK(x.low < x.high);
}

TEST_CASE("panel: an edge between vertices at 1e37 passes where it should") {
  VectorPage page(PageFormat::svg, 300, 300, "");
  const Panel panel(page, {100, 100, 100, 100}, {.coordinate = 0}, {.coordinate = 1});
  // y = x / 2 + 1/4, far beyond the precision of doubles.
  const Rational big(0x1p123);
  const ExactShape edge = {position(-big, -big / 2 + Rational(0.25)),
                           position(big, big / 2 + Rational(0.25))};
  const Spot middle = panel.middle_of(edge);
  CHECK(middle.x == Approx(150));
  CHECK(middle.y == Approx(150 - 0.25 * 50));
  CHECK(panel.is_thin(edge));
}

}  // namespace
}  // namespace clipscope::experiments
