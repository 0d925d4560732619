// SPDX-License-Identifier: GPL-3.0-or-later
//
// What bounding volumes enclose, against exact arithmetic.
#include <cmath>
#include <vector>

#include "spaces/bounds/enclose.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/volumes.hpp"

using namespace clipscope;
using namespace clipscope::reference;

namespace {

template <class T>
std::vector<Vec3<T>> random_points(Random& random) {
  const int count = 1 + static_cast<int>(random() % 12);
  const double size = std::pow(10, uniform(random, -6, 6));
  const double away = random() % 2 == 0 ? 0 : size * std::pow(10, uniform(random, -1, 5));
  const int flat = static_cast<int>(random() % 5);  // along one axis there is no extent
  std::vector<Vec3<T>> r;
  for (int n = 0; n < count; ++n) {
    Vec3<T> p;
    for (int i = 0; i < 3; ++i) {
      const double spread = i == flat ? 0 : uniform(random, -1, 1) * size;
      p[i] = static_cast<T>(away + (random() % 4 == 0 ? std::copysign(size, spread) : spread));
    }
    r.push_back(p);
  }
  return r;
}

template <class T>
bool contains(const Sphere<T>& sphere, const Vec3<T>& p) {
  Dyadic square = 0;
  for (int i = 0; i < 3; ++i) {
    const Dyadic d = Dyadic(double{p[i]}) - Dyadic(double{sphere.centre[i]});
    square += d * d;
  }
  const Dyadic r(double{sphere.radius});
  return square <= r * r;
}

// Cramer's rule: t_i det(axes) = the determinant with p - centre for axis i.
template <class T>
bool contains(const OrientedBox<T>& box, const Vec3<T>& p) {
  using Column = std::array<Dyadic, 3>;
  const auto column = [](const Vec3<T>& v) {
    return Column{double{v[0]}, double{v[1]}, double{v[2]}};
  };
  const auto determinant = [](const std::array<Column, 3>& m) {
    Dyadic r = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      r +=
          m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
    }
    return r;
  };
  const std::array<Column, 3> axes = {column(box.axes[0]), column(box.axes[1]),
                                      column(box.axes[2])};
  Column d = column(p);
  for (std::size_t i = 0; i < 3; ++i) d[i] -= Dyadic(double{box.centre[static_cast<int>(i)]});
  const Dyadic whole = determinant(axes);
  if (whole.is_zero()) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Column, 3> m = axes;
    m[i] = d;
    const Dyadic share = determinant(m), half(double{box.half[static_cast<int>(i)]});
    if (share * share > half * half * whole * whole) return false;
  }
  return true;
}

}  // namespace

TEMPLATE_TEST_CASE("bounds: spheres and oriented boxes contain all points that they enclose", "",
                   float, double) {
  using T = TestType;
  Random random(9);
  long outside = 0, loose = 0;
  for (int n = 0; n < 5000; ++n) {
    const std::vector<Vec3<T>> points = random_points<T>(random);
    const AxisBox<T> box = bounding_box<T>(points);
    const Sphere<T> sphere = bounding_sphere<T>(points);
    const OrientedBox<T> oriented = bounding_oriented_box<T>(points);
    std::array<Vec3<T>, 3> skew = oriented.axes;
    for (auto& axis : skew) axis[1] += static_cast<T>(uniform(random, -0.01, 0.01));
    const OrientedBox<T> skewed = bounding_oriented_box<T>(points, skew);
    loose += skewed.axes == skew ? 0 : 1;
    const OrientedBox<T> along = bounding_oriented_box<T>(points, OrientedBox<T>{}.axes);
    for (const Vec3<T>& p : points) {
      outside += contains(sphere, p) ? 0 : 1;
      outside += contains(oriented, p) ? 0 : 1;
      outside += contains(along, p) ? 0 : 1;
      outside += contains(skewed, p) ? 0 : 1;
    }
    // Half the diagonal of the box is a sphere that contains all.
    const T half = length_above(Vec3<T>(T(0.5) * box.upper - T(0.5) * box.lower));
    loose += sphere.radius > T(1.01) * half +
                                 T(8) * std::numeric_limits<T>::epsilon() * length_above(box.upper)
                 ? 1
                 : 0;
  }
  CHECK(outside == 0);
  CHECK(loose == 0);
}
