// SPDX-License-Identifier: GPL-3.0-or-later
//
// Screen rectangles of spheres, and of what the near plane leaves: by hand and against exact
// arithmetic.
#include "spaces/bounds/sphere_rectangle.hpp"

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "reference/exact_clip.hpp"
#include "reference/overlap.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/volumes.hpp"

using namespace clipscope;
using namespace clipscope::reference;

namespace {

template <class T>
using Rows = MatrixRows<T>;
using Real = long double;
using Point = std::array<Real, 3>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
std::array<T, 4> members(const ScreenRectangle<T>& r) {
  return {r.left, r.bottom, r.right, r.top};
}

// x = X / W within [-1, 1] at 45 degrees; near 1, far 10.
Rows<double> unit_rows() { return rows_of(Projection<double>(Frustum<double>{})); }

ScreenRectangle<double> beyond_near(const Sphere<double>& sphere) {
  return projected_bounds_beyond_near(DepthRange::minus_one_to_one, unit_rows(), sphere);
}

template <class T>
Dyadic exact_row(const Vec4<T>& row, const ExactPoint& p) {
  Dyadic r = double{row[3]};
  for (int i = 0; i < 3; ++i) r += Dyadic(double{row[i]}) * p[static_cast<std::size_t>(i)];
  return r;
}

// A sphere under a matrix, and the largest quotients of exact points of it.
template <class T>
struct Setting {
  DepthRange depth;
  Rows<T> rows;
  Sphere<T> sphere;
  bool with_near;

  // Takes note of the point as doubles if exactly in the sphere and visible; false if it lies
  // outside of the rectangle.
  bool note(const Point& at, const ScreenRectangle<T>& r, std::array<double, 4>& seen) const {
    const ExactPoint p = exact_point(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                     static_cast<double>(at[2]));
    Dyadic square = 0;
    for (int i = 0; i < 3; ++i) {
      const Dyadic d = p[static_cast<std::size_t>(i)] - Dyadic(double{sphere.centre[i]});
      square += d * d;
    }
    const Dyadic radius = double{sphere.radius}, w = exact_row(rows[3], p);
    if (square > radius * radius || w.sign() <= 0) return true;
    if (with_near && near_value(p).sign() < 0) return true;
    bool within = !r.empty();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Dyadic x = exact_row(rows[axis], p);
      const double low = members(r)[axis], high = members(r)[axis + 2];
      within = within && (std::isinf(low) || x >= Dyadic(low) * w) &&
               (std::isinf(high) || x <= Dyadic(high) * w);
      const double s = approximate(Fraction{x, w});
      seen[axis] = std::min(seen[axis], s);
      seen[axis + 2] = std::max(seen[axis + 2], s);
    }
    return within;
  }

  Dyadic near_value(const ExactPoint& p) const {
    const Dyadic z = exact_row(rows[2], p), w = exact_row(rows[3], p);
    if (depth == DepthRange::zero_to_one) return z;
    return depth == DepthRange::reversed ? Dyadic(w - z) : Dyadic(z + w);
  }
};

Real dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point plus(const Point& a, Real factor, const Point& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

template <class T>
Point normal(const Vec4<T>& row) {
  return {row[0], row[1], row[2]};
}

// Points of the sphere, or of its disc in the near plane, next to where X - s W = 0 touches.
template <class T>
std::vector<Point> contacts(const Setting<T>& setting, std::size_t axis, Real s) {
  const Point centre = {setting.sphere.centre[0], setting.sphere.centre[1],
                        setting.sphere.centre[2]};
  const Point n = plus(normal(setting.rows[axis]), -s, normal(setting.rows[3]));
  const Vec4<T>&z = setting.rows[2], &w = setting.rows[3];
  const Vec4<T> near_row = setting.depth == DepthRange::zero_to_one ? z
                           : setting.depth == DepthRange::reversed  ? w - z
                                                                    : w + z;
  const Point m = normal(near_row);
  const Real radius = setting.sphere.radius, mm = dot(m, m);
  const Real at = dot(m, centre) + near_row[3];
  const Point foot = plus(centre, -at / mm, m), in_plane = plus(n, -dot(n, m) / mm, m);
  const Real disc = std::sqrt(std::max(radius * radius - at * at / mm, Real(0)));
  std::vector<Point> r;
  for (const Real inwards : {0.0, 1e-15, 1e-12, 1e-9, 1e-7}) {
    const Point beyond = plus(foot, inwards * radius / std::sqrt(mm), m);
    for (const Real side : {inwards - 1, 1 - inwards}) {
      r.push_back(plus(centre, side * radius / std::sqrt(dot(n, n)), n));
      r.push_back(plus(beyond, side * disc / std::sqrt(dot(in_plane, in_plane)), in_plane));
    }
  }
  return r;
}

struct Tally {
  long spheres = 0, wrong = 0, finite = 0, tight = 0;
};

template <class T>
void hold(const Setting<T>& setting, Random& random, Tally& tally) {
  const ScreenRectangle<T> r =
      setting.with_near ? projected_bounds_beyond_near(setting.depth, setting.rows, setting.sphere)
                        : projected_bounds(setting.rows, setting.sphere);
  std::array<double, 4> seen = {kInfinity, kInfinity, -kInfinity, -kInfinity};
  ++tally.spheres;
  const auto& c = setting.sphere.centre;
  for (int i = 0; i < 20; ++i) {
    Point p = {c[0], c[1], c[2]};
    for (Real& v : p) v += setting.sphere.radius * uniform(random, -0.7, 0.7);
    tally.wrong += setting.note(p, r, seen) ? 0 : 1;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double bound = members(r)[i];
    if (!std::isfinite(bound)) continue;
    for (const Point& p : contacts(setting, i % 2, bound)) {
      tally.wrong += setting.note(p, r, seen) ? 0 : 1;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double bound = members(r)[i];
    if (!std::isfinite(bound) || !std::isfinite(seen[i])) continue;
    ++tally.finite;
    tally.tight += std::abs(bound - seen[i]) <= 1e-5 * (1 + std::abs(bound)) ? 1 : 0;
  }
}

template <class T>
Tally tally_of(std::uint64_t seed, bool with_near) {
  Random random(seed);
  Tally tally;
  for (int n = 0; n < 200; ++n) {
    const Frustum<T> f = random_frustum<T>(random);
    const Rows<T> rows = rows_of(Projection<T>(f));
    for (int i = 0; i < 20; ++i) {
      const Place<T> place = random_place(random, culling_planes(f), f);
      const auto sphere = make(random, place, static_cast<Sphere<T>*>(nullptr));
      hold(Setting<T>{f.depth, rows, sphere, with_near}, random, tally);
    }
  }
  return tally;
}

}  // namespace

TEMPLATE_TEST_CASE("sphere rectangle: no visible point is outside of it, and it is tight", "",
                   float, double) {
  for (const bool with_near : {false, true}) {
    const Tally tally = tally_of<TestType>(1, with_near);
    INFO(tally.spheres << " spheres, " << tally.finite << " finite bounds, " << tally.tight
                       << " tight" << (with_near ? ", beyond near" : ""));
    CHECK(tally.wrong == 0);
    CHECK(tally.finite > 5000);
    CHECK(tally.tight * 100 > tally.finite * 97);
  }
}

TEST_CASE("sphere rectangle: the tangents from the eye to a sphere before it") {
  // 4 away with radius 2: the tangents are at 30 degrees.
  const auto r = projected_bounds(unit_rows(), Sphere<double>{Vec3<double>(0, 0, -4), 2});
  const double tangent = 1 / std::sqrt(3.0);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(members(r)[i] == Approx(i < 2 ? -tangent : tangent).epsilon(1e-14));
    CHECK(std::abs(members(r)[i]) >= tangent);
  }
}

TEST_CASE("sphere rectangle: behind the eye nothing, around it everything") {
  CHECK(projected_bounds(unit_rows(), Sphere<double>{Vec3<double>(0, 0, 4), 2}).empty());
  CHECK(projected_bounds(unit_rows(), Sphere<double>{Vec3<double>(0, 0, 0), 2}) ==
        ScreenRectangle<double>::everything());
  CHECK(projected_bounds(unit_rows(), Sphere<double>{}).empty());
  CHECK(projected_bounds(unit_rows(), Sphere<double>{Vec3<double>(std::nan(""), 0, 0), 1}) ==
        ScreenRectangle<double>::everything());
}

TEST_CASE("sphere rectangle: one beside the eye, across w = 0, is bounded on the side to the eye") {
  // In the plane of x and z: centre (4, 0) and radius 2 again, turned by 90 degrees.
  const auto r = projected_bounds(unit_rows(), Sphere<double>{Vec3<double>(4, 0, 0), 2});
  CHECK(r.left == Approx(std::sqrt(3.0)).epsilon(1e-14));
  CHECK(r.left <= std::sqrt(3.0));
  CHECK(r.right == kInfinity);
  CHECK(r.bottom == -kInfinity);
  CHECK(r.top == kInfinity);
}

TEST_CASE("sphere rectangle: the near plane bounds what reaches the eye") {
  // Around the eye with radius 2: at z = -1 a disc of radius sqrt 3.
  const auto around = beyond_near({Vec3<double>(0, 0, 0), 2});
  CHECK(around.right == Approx(std::sqrt(3.0)).epsilon(1e-14));
  CHECK(around.left == Approx(-std::sqrt(3.0)).epsilon(1e-14));
  CHECK(around.top >= std::sqrt(3.0));
  CHECK(beyond_near({Vec3<double>(0, 0, 0), 0.99}).empty());
  // The near plane is before it, and changes nothing.
  const Sphere<double> before{Vec3<double>(0, 0, -4), 2};
  CHECK(beyond_near(before) == projected_bounds(unit_rows(), before));
}

TEST_CASE("sphere rectangle: a point, and a parallel projection") {
  const auto point = beyond_near({Vec3<double>(1, -1, -2), 0});
  CHECK(point.left <= 0.5);
  CHECK(point.right >= 0.5);
  CHECK(point.right - point.left < 1e-14);
  Frustum<double> f;
  f.kind = ProjectionKind::parallel;
  f.left = f.bottom = -4;
  f.right = f.top = 4;
  const auto r =
      projected_bounds(rows_of(Projection<double>(f)), Sphere<double>{Vec3<double>(1, 0, 30), 2});
  CHECK(r.left == Approx(-0.25).epsilon(1e-14));
  CHECK(r.right == Approx(0.75).epsilon(1e-14));
  CHECK(r.top == Approx(0.5).epsilon(1e-14));
}

namespace {

// A triangle in clip space by x, y, w and the near plane's value d, exactly: small multiples of
// 1/8.
struct NearTriangle {
  std::array<std::array<double, 4>, 3> corners;

  explicit NearTriangle(Random& random, bool before_eye) {
    for (auto& c : corners) {
      for (double& v : c) v = (static_cast<int>(random() % 65) - 32) / 8.0;
      if (before_eye) c[2] = std::abs(c[2]) + 0.125;
    }
  }

  std::vector<Vec4<float>> vertices(DepthRange depth) const {
    std::vector<Vec4<float>> r;
    for (const auto& [x, y, w, d] : corners) {
      const double z = depth == DepthRange::zero_to_one ? d
                       : depth == DepthRange::reversed  ? w - d
                                                        : d - w;
      r.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
                     static_cast<float>(w));
    }
    return r;
  }

  // Left, bottom, right, top of what is left by w > 0 and d >= 0, nothing else being cut: x, y and
  // d are made so small that no other plane does.
  std::optional<std::array<double, 4>> exact() const {
    constexpr double kSmall = 0x1p-40;
    InputTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [x, y, w, d] = corners[i];
      triangle.vertices[i].position = {x * kSmall, y * kSmall, d * kSmall, w};
    }
    std::optional<std::array<double, 4>> r;
    for (const ExactVertex& v : clip(Truth::of_clip(DepthRange::zero_to_one), triangle).vertices) {
      const double x = approximate(v.x) / kSmall, y = approximate(v.y) / kSmall;
      if (!r) r = {x, y, x, y};
      r = {std::min((*r)[0], x), std::min((*r)[1], y), std::max((*r)[2], x), std::max((*r)[3], y)};
    }
    return r;
  }
};

}  // namespace

TEST_CASE("near cut: the rectangle of what the near plane leaves of a triangle, exactly bounded") {
  Random random(5);
  long visible = 0, tight = 0, bounds = 0;
  for (int n = 0; n < 6000; ++n) {
    const bool before_eye = n % 3 != 0;
    const NearTriangle triangle(random, before_eye);
    const auto exact = triangle.exact();
    const auto depth = static_cast<DepthRange>(n % 3);
    const auto r = projected_bounds_beyond_near<float>(depth, triangle.vertices(depth));
    INFO(n << (exact ? ", visible" : ", invisible"));
    if (!exact) {
      if (before_eye) CHECK(r.empty());
      continue;
    }
    ++visible;
    for (std::size_t i = 0; i < 4; ++i) {
      const double bound = members(r)[i], slack = 1e-14 * std::abs((*exact)[i]);
      const double outwards = i < 2 ? (*exact)[i] - bound : bound - (*exact)[i];
      const double allowed = before_eye ? slack : 1e6;
      CHECK(outwards >= -allowed);
      bounds += before_eye ? 1 : 0;
      tight += before_eye && outwards <= 1e-6 * (1 + std::abs(bound)) ? 1 : 0;
    }
  }
  CHECK(visible > 3000);
  CHECK(tight == bounds);
}

TEST_CASE("near cut: a box around the near plane is bounded though it reaches behind the eye") {
  const Projection<float> p(Frustum<float>{});
  BoxCorners<float> box;
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3<float> at((i & 1) != 0 ? 1.0f : -1.0f, (i & 2) != 0 ? 0.5f : 0.0f,
                         (i & 4) != 0 ? 4.0f : -4.0f);
    box.points[i] = to_clip(p, at);
  }
  CHECK(projected_bounds(box).right == std::numeric_limits<float>::infinity());
  const auto r = projected_bounds_beyond_near(DepthRange::minus_one_to_one, box);
  CHECK(r.left == Approx(-1).epsilon(1e-6));
  CHECK(r.right == Approx(1).epsilon(1e-6));
  CHECK(r.bottom == Approx(0).margin(1e-6));
  CHECK(r.top == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("near cut: where the near plane lets w <= 0 through, w > 0 is what bounds") {
  // All z are 1, beyond the near plane z >= 0 with either sign of w.
  const std::vector<Vec4<float>> triangle = {{1, 0, 1, 1}, {2, 1, 1, -1}, {1, 2, 1, 1}};
  CHECK(projected_bounds_beyond_near<float>(DepthRange::zero_to_one, triangle) ==
        projected_bounds<float>(triangle, Rounding::outward));
  CHECK(projected_bounds_beyond_near(DepthRange::zero_to_one, std::span<const Vec4<float>>())
            .empty());
}
