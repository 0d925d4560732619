// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/scalars.hpp"
#include "experiments/judge/distance.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

using Point = Lifted<Exact>;

Point point(int x, int y, int z, int w = 0) { return {Exact(x), Exact(y), Exact(z), Exact(w)}; }

const Point kA = point(0, 0, 0), kB = point(4, 0, 0), kC = point(0, 4, 0);

Exact to_triangle(const Point& p) { return squared_distance_to_triangle(p, kA, kB, kC); }

}  // namespace

TEST_CASE("distance: nearest to the inside, an edge, a corner of a triangle") {
  CHECK(to_triangle(point(1, 1, 0)) == Exact(0));
  CHECK(to_triangle(point(1, 1, 3)) == Exact(9));
  CHECK(to_triangle(point(1, 1, 0, -2)) == Exact(4));  // the fourth dimension counts
  CHECK(to_triangle(point(2, -3, 0)) == Exact(9));
  CHECK(to_triangle(point(3, 3, 0)) == Exact(2));  // to the hypotenuse
  CHECK(to_triangle(point(7, -4, 0)) == Exact(25));
}

TEST_CASE("distance: a degenerate triangle is its edges") {
  const Point middle = point(2, 0, 0);
  CHECK(squared_distance_to_triangle(point(1, 2, 0), kA, middle, kB) == Exact(4));
  CHECK(squared_distance_to_triangle(point(6, 0, 0), kA, middle, kB) == Exact(4));
  CHECK(squared_distance_to_triangle(point(0, 3, 0), kA, kA, kA) == Exact(9));
}

TEST_CASE("distance: a polygon is its fan") {
  const std::vector<Point> square = {kA, kB, point(4, 4, 0), kC};
  CHECK(squared_distance_to_polygon(point(3, 3, 1), square) == Exact(1));
  CHECK(squared_distance_to_polygon(point(5, 2, 0), square) == Exact(1));
}

TEST_CASE("distance: a quad-double holds a rational to 200 bits") {
  for (const Exact& x : {Exact(1, 3), Exact(-2, 7), Exact(Exact(1) + Exact(0x1p-150)), Exact(0)}) {
    const qd_real q = distance_number<qd_real>(x);
    Exact held(0);
    for (int i = 0; i < 4; ++i) held += Exact(q[i]);
    CHECK(abs(held - x) <= abs(x) * Exact(0x1p-200));
  }
}

TEST_CASE("distance: quad-double sees what double-double does not") {
  const auto off_by = [](auto zero, const Exact& height) {
    using N = decltype(zero);
    const auto lifted = [](const Exact& x, const Exact& y, const Exact& z) {
      return Lifted<N>{distance_number<N>(x), distance_number<N>(y), distance_number<N>(z)};
    };
    const Exact third(1, 3);
    return nearest_double(squared_distance_to_triangle(
        lifted(third, third, Exact(third + height)), lifted(Exact(0), Exact(0), third),
        lifted(Exact(1), Exact(0), third), lifted(Exact(0), Exact(1), third)));
  };
  const Exact height(0x1p-110);  // lost beside 1/3 in the 106 bits of a double-double
  CHECK(off_by(qd_real(0), height) == Approx(0x1p-220).epsilon(1e-12));
  CHECK(off_by(Exact(0), height) == Approx(0x1p-220).epsilon(1e-12));
  CHECK(off_by(dd_real(0), height) != Approx(0x1p-220).epsilon(1e-2));
}
