// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bounds of projected polygons and boxes against those of exactly clipped triangles.
//
// The reference clips to |x| <= w and |y| <= w; z is 0, so that near and far leave w >= 0. Other
// rectangles are scaled and shifted onto that one, by numbers that keep doubles exact.
#include <cmath>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "reference/exact_clip.hpp"
#include "spaces/bounds/projected_bounds.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::reference;

namespace {

using Random = std::mt19937_64;
using Point = std::array<double, 3>;  // x, y, w

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

// v rounded to T. Volatile, since GCC 12 at -O2 drops the rounding of two neighbouring conversions
// from double to float and back when it vectorizes them.
template <class T>
double rounded(double v) {
  const volatile T r = static_cast<T>(v);
  return static_cast<double>(r);
}

bool less(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator < b.numerator * a.denominator;
}

Fraction fraction(double v) { return {Dyadic(v), Dyadic(1)}; }

// Left, bottom, right and top; absent if nothing is visible.
using ExactBounds = std::optional<std::array<Fraction, 4>>;

// The bounds of the part within |x| <= w, |y| <= w, all triangles together.
ExactBounds exact_bounds(const std::vector<std::array<Point, 3>>& triangles) {
  static const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  ExactBounds r;
  for (const auto& points : triangles) {
    InputTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.vertices[i].position = {points[i][0], points[i][1], 0, points[i][2]};
    }
    for (const ExactVertex& v : clip(truth, triangle).vertices) {
      if (!r) r = {v.x, v.y, v.x, v.y};
      if (less(v.x, (*r)[0])) (*r)[0] = v.x;
      if (less(v.y, (*r)[1])) (*r)[1] = v.y;
      if (less((*r)[2], v.x)) (*r)[2] = v.x;
      if (less((*r)[3], v.y)) (*r)[3] = v.y;
    }
  }
  return r;
}

// A primitive: its points, and the triangles that it or its surface is made of.
struct Primitive {
  std::vector<Point> points;
  bool is_box = false;

  std::vector<std::array<Point, 3>> triangles() const {
    std::vector<std::array<Point, 3>> r;
    if (!is_box) {
      for (std::size_t i = 2; i < points.size(); ++i) {
        r.push_back({points[0], points[i - 1], points[i]});
      }
      return r;
    }
    constexpr std::size_t kQuads[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    for (const auto& q : kQuads) {
      r.push_back({points[q[0]], points[q[1]], points[q[2]]});
      r.push_back({points[q[0]], points[q[2]], points[q[3]]});
    }
    return r;
  }

  template <class T>
  std::vector<Vec4<T>> vertices() const {
    std::vector<Vec4<T>> r;
    for (const Point& p : points) {
      r.emplace_back(static_cast<T>(p[0]), static_cast<T>(p[1]), T(0), static_cast<T>(p[2]));
    }
    return r;
  }

  template <class T>
  ScreenRectangle<T> bounds(Rounding rounding) const {
    return is_box ? projected_bounds(box<T>(), rounding)
                  : projected_bounds<T>(vertices<T>(), rounding);
  }
  template <class T>
  ScreenRectangle<T> bounds(const ScreenRectangle<T>& within, Rounding rounding) const {
    return is_box ? projected_bounds_within(within, box<T>(), rounding)
                  : projected_bounds_within<T>(within, vertices<T>(), rounding);
  }

 private:
  template <class T>
  BoxCorners<T> box() const {
    BoxCorners<T> r;
    const auto v = vertices<T>();
    std::copy(v.begin(), v.end(), r.points.begin());
    return r;
  }
};

Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// Multiples of 1/4 in [-size, size]: many coincidences with sides, w = 0 and the origin.
Point lattice_point(Random& random, int size) {
  const auto n = [&] {
    return (static_cast<int>(random() % static_cast<unsigned>(8 * size + 1)) - 4 * size) / 4.0;
  };
  return {n(), n(), n()};
}

// A triangle, a parallelogram or a parallelepiped.
Primitive lattice_primitive(Random& random) {
  const Point p = lattice_point(random, 3), a = lattice_point(random, 3),
              b = lattice_point(random, 3);
  switch (random() % 3) {
    case 0: return {{p, plus(p, a), plus(p, b)}};
    case 1: return {{p, plus(p, a), plus(plus(p, a), b), plus(p, b)}};
    default: break;
  }
  const Point c = lattice_point(random, 3);
  Primitive r{{}, true};
  for (int i = 0; i < 8; ++i) {
    Point q = p;
    if ((i & 1) != 0) q = plus(q, a);
    if ((i & 2) != 0) q = plus(q, b);
    if ((i & 4) != 0) q = plus(q, c);
    r.points.push_back(q);
  }
  return r;
}

// Triangles of full significands: about the rectangle; over magnitudes; with vertices within ulps
// of the rectangle's sides or of w = 0.
enum class Kind { about, magnitudes, grazing };

template <class T>
Primitive random_triangle(Random& random, Kind kind) {
  Primitive r{{{}, {}, {}}};
  for (Point& p : r.points) {
    for (double& v : p) {
      v = uniform(random, -2, 2);
      if (kind == Kind::magnitudes) v = std::copysign(std::pow(10, uniform(random, -6, 6)), v);
      v = rounded<T>(v);
    }
    if (kind == Kind::grazing && random() % 2 == 0) {
      const T w = static_cast<T>(p[2]);
      const T ulps =
          static_cast<T>(static_cast<int>(random() % 5) - 2) * std::numeric_limits<T>::epsilon();
      if (random() % 4 == 0) {
        p[2] = static_cast<double>(ulps);
      } else {
        p[random() % 2] = static_cast<double>((random() % 2 == 0 ? w : -w) * (T(1) + ulps));
      }
    }
  }
  return r;
}

template <class T>
T directed(const Fraction& bound, bool down) {
  const T r = round_to<T>(bound);
  const double error = error_of(static_cast<double>(r), bound);
  if (down && error > 0) return std::nextafter(r, -std::numeric_limits<T>::infinity());
  if (!down && error < 0) return std::nextafter(r, std::numeric_limits<T>::infinity());
  return r;
}

struct Tally {
  long primitives = 0, visible = 0, bounds = 0;
  long lost = 0;      // outward bounds that don't contain the exact ones
  long spurious = 0;  // not empty, but should be
  long nearest = 0;   // bounds that are the exact ones, rounded to nearest
  long tightest = 0;  // outward bounds next to the exact ones
  long close = 0;     // nearest bounds within four units in the last place of 1 from the exact ones
};

std::string report(const Tally& t) {
  std::ostringstream out;
  out << t.primitives << " primitives, " << t.visible << " visible, " << t.spurious
      << " not empty but should be; of " << t.bounds << " bounds " << t.nearest << " nearest, "
      << t.close << " close, " << t.tightest << " tightest outwards";
  return out.str();
}

template <class T>
std::array<T, 4> members(const ScreenRectangle<T>& r) {
  return {r.left, r.bottom, r.right, r.top};
}

template <class T>
void hold(const ExactBounds& exact, const ScreenRectangle<T>& nearest,
          const ScreenRectangle<T>& outward, Tally& tally) {
  ++tally.primitives;
  if (!exact) {
    tally.spurious += outward.empty() ? 0 : 1;
    return;
  }
  ++tally.visible;
  if (outward.empty()) {
    ++tally.lost;
    return;
  }
  const auto out = members(outward), near = members(nearest);
  for (std::size_t i = 0; i < 4; ++i) {
    const Fraction& bound = (*exact)[i];
    const Fraction given = fraction(static_cast<double>(out[i]));
    ++tally.bounds;
    tally.lost += (i < 2 ? less(bound, given) : less(given, bound)) ? 1 : 0;
    tally.tightest += out[i] == directed<T>(bound, i < 2) ? 1 : 0;
    tally.nearest += near[i] == round_to<T>(bound) ? 1 : 0;
    const bool is_close =
        !nearest.empty() && std::abs(error_of(static_cast<double>(near[i]), bound)) <=
                                4 * std::numeric_limits<T>::epsilon();
    tally.close += is_close ? 1 : 0;
  }
}

template <class T>
constexpr ScreenRectangle<T> kUnit{T(-1), T(-1), T(1), T(1)};

template <class T>
Tally tally_of_triangles(std::uint64_t seed, Kind kind, int count) {
  Random random(seed);
  Tally tally;
  for (int n = 0; n < count; ++n) {
    const Primitive primitive = random_triangle<T>(random, kind);
    hold(exact_bounds(primitive.triangles()), primitive.bounds<T>(kUnit<T>, Rounding::nearest),
         primitive.bounds<T>(kUnit<T>, Rounding::outward), tally);
  }
  return tally;
}

}  // namespace

TEMPLATE_TEST_CASE("projected bounds: unclipped, each bound is the exact one rounded once", "",
                   float, double) {
  using T = TestType;
  constexpr double kInfinite = 0x1p60;  // finite quotients of these primitives are far below
  constexpr T infinity = std::numeric_limits<T>::infinity();
  Random random(1);
  long wrong = 0, visible = 0, infinite = 0;
  for (int n = 0; n < 20000; ++n) {
    Primitive primitive =
        n % 2 == 0 ? random_triangle<T>(random, Kind::about) : lattice_primitive(random);
    if (n % 4 == 0) {
      // The next vertex lies beyond the origin, give or take a rounding: x/w and y/w barely change.
      const double factor = -uniform(random, 0.5, 2);
      for (std::size_t c = 0; c < 3; ++c) {
        primitive.points[1][c] = rounded<T>(factor * primitive.points[0][c]);
      }
    }
    const auto near = members(primitive.bounds<T>(Rounding::nearest));
    const auto out = members(primitive.bounds<T>(Rounding::outward));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      // Along the axis what goes to infinity ends at kInfinite, and across it nothing ends before.
      Primitive scaled = primitive;
      for (Point& p : scaled.points) {
        p[axis] /= kInfinite;
        p[1 - axis] /= kInfinite * kInfinite * kInfinite;
      }
      const ExactBounds exact = exact_bounds(scaled.triangles());
      visible += exact ? 1 : 0;
      if (!exact) {
        wrong += near[axis] <= near[axis + 2] || out[axis] <= out[axis + 2] ? 1 : 0;
        continue;
      }
      for (const bool down : {true, false}) {
        const std::size_t i = down ? axis : axis + 2;
        const Fraction bound{(*exact)[i].numerator * Dyadic(kInfinite), (*exact)[i].denominator};
        const bool is_infinite = bound == fraction(down ? -kInfinite : kInfinite);
        infinite += is_infinite ? 1 : 0;
        const T expected = is_infinite ? (down ? -infinity : infinity) : round_to<T>(bound);
        const T expected_out = is_infinite ? expected : directed<T>(bound, down);
        wrong += near[i] != expected || out[i] != expected_out ? 1 : 0;
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(visible > 20000);
  CHECK(infinite > 10000);
}

TEMPLATE_TEST_CASE("projected bounds: within a rectangle, nothing is lost and little added", "",
                   float, double) {
  const Tally tally = tally_of_triangles<TestType>(2, Kind::about, 30000);
  INFO(report(tally));
  CHECK(tally.lost == 0);
  CHECK(tally.spurious == 0);
  CHECK(tally.visible > 10000);
  CHECK(tally.close * 1000 > tally.bounds * 999);
}

TEMPLATE_TEST_CASE("projected bounds: within a rectangle, nothing is lost over magnitudes", "",
                   float, double) {
  const Tally tally = tally_of_triangles<TestType>(3, Kind::magnitudes, 30000);
  INFO(report(tally));
  CHECK(tally.lost == 0);
  CHECK(tally.visible > 5000);
}

TEMPLATE_TEST_CASE("projected bounds: within a rectangle, nothing is lost within ulps of its sides",
                   "", float, double) {
  const Tally tally = tally_of_triangles<TestType>(4, Kind::grazing, 60000);
  INFO(report(tally));
  CHECK(tally.lost == 0);
  CHECK(tally.visible > 10000);
}

TEMPLATE_TEST_CASE("projected bounds: within rectangles, coincidences on a lattice", "", float,
                   double) {
  using T = TestType;
  Random random(3);
  Tally tally;
  for (int n = 0; n < 60000; ++n) {
    const Primitive primitive = lattice_primitive(random);
    const double left = lattice_point(random, 1)[0], bottom = lattice_point(random, 1)[1];
    const double width = std::ldexp(1, static_cast<int>(random() % 4) - 2);
    const double height = std::ldexp(1, static_cast<int>(random() % 4) - 2);
    const ScreenRectangle<T> within{static_cast<T>(left), static_cast<T>(bottom),
                                    static_cast<T>(left + width), static_cast<T>(bottom + height)};
    Primitive moved = primitive;
    for (Point& p : moved.points) {
      p[0] = (2 * p[0] - (2 * left + width) * p[2]) / width;
      p[1] = (2 * p[1] - (2 * bottom + height) * p[2]) / height;
    }
    ExactBounds exact = exact_bounds(moved.triangles());
    for (std::size_t i = 0; exact && i < 4; ++i) {
      Fraction& bound = (*exact)[i];
      const double size = i % 2 == 0 ? width : height, low = i % 2 == 0 ? left : bottom;
      bound = {bound.numerator * Dyadic(size) + bound.denominator * Dyadic(2 * low + size),
               bound.denominator * Dyadic(2)};
    }
    hold(exact, primitive.bounds<T>(within, Rounding::nearest),
         primitive.bounds<T>(within, Rounding::outward), tally);
  }
  INFO(report(tally));
  CHECK(tally.lost == 0);
  CHECK(tally.visible > 5000);
  // What is added: planes through the eye, which are seen as a line, cut next to the eye itself.
  CHECK(tally.spurious * 1000 < tally.primitives);
  CHECK(tally.nearest == tally.bounds);
}
