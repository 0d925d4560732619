// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random frusta and bounding volumes, many of them made to graze a plane, and the exact sides of
// volumes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "reference/truth.hpp"
#include "spaces/bounds/visibility.hpp"

namespace clipscope::reference {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

inline double sign_of(Random& random) { return (random() & 1) != 0 ? 1 : -1; }

// 10^low to 10^high, either sign.
template <class T>
T over_magnitudes(Random& random, double low, double high) {
  return static_cast<T>(sign_of(random) * std::pow(10, uniform(random, low, high)));
}

// Perspective (off-centre, narrow, deep, infinite), orthographic and oblique parallel.
template <class T>
Frustum<T> random_frustum(Random& random) {
  Frustum<T> f;
  f.kind = random() % 3 == 0 ? ProjectionKind::parallel : ProjectionKind::perspective;
  f.depth = static_cast<DepthRange>(random() % 3);
  const double width = std::pow(10, uniform(random, -2, 1));
  const double x = random() % 2 == 0 ? 0 : uniform(random, -2, 2) * width;
  const double y = random() % 2 == 0 ? 0 : uniform(random, -2, 2) * width;
  f.left = static_cast<T>(x - width);
  f.right = static_cast<T>(x + width);
  f.bottom = static_cast<T>(y - width);
  f.top = static_cast<T>(y + width);
  f.near = static_cast<T>(std::pow(10, uniform(random, -2, 2)));
  f.far = static_cast<T>(f.near * std::pow(10, uniform(random, 0.1, 4)));
  if (f.kind == ProjectionKind::perspective) {
    f.infinite_far = random() % 4 == 0;
  } else {
    f.near *= static_cast<T>(sign_of(random));
    f.far = std::abs(f.far);
    f.shear_x = random() % 2 == 0 ? T(0) : static_cast<T>(uniform(random, -1, 1));
    f.shear_y = random() % 2 == 0 ? T(0) : static_cast<T>(uniform(random, -1, 1));
  }
  return f;
}

// Where a volume is put: a point, a direction out of the view volume there, and a size.
template <class T>
struct Place {
  Vec3<T> point;
  Vec3<T> outwards;  // one of the planes' normals, of length about 1
  T size;
  bool grazing;  // the volume is to touch `point` from one side, give or take some ulps
};

template <class T>
Place<T> random_place(Random& random, const CullingPlanes<T>& planes, const Frustum<T>& f) {
  const auto& plane = planes.planes[random() % static_cast<std::size_t>(planes.count)];
  const Vec3<double> normal(plane.normal);
  const double square = bounds::dot(normal, normal);
  Place<T> r;
  r.outwards = Vec3<T>(-normal / std::sqrt(square));
  r.grazing = random() % 2 == 0;
  if (!r.grazing && random() % 4 == 0) {
    for (int i = 0; i < 3; ++i) r.point[i] = over_magnitudes<T>(random, -8, 8);
    r.size = std::abs(over_magnitudes<T>(random, -8, 8));
    return r;
  }
  const double far = f.infinite_far ? 100 * f.near : f.far;
  const double z = -uniform(random, f.near, far);
  const double widening = f.kind == ProjectionKind::perspective ? -z / f.near : 1;
  const double width = widening * (f.right - f.left), height = widening * (f.top - f.bottom);
  r.point = Vec3<T>(
      static_cast<T>(uniform(random, f.left * widening - width, f.right * widening + width)),
      static_cast<T>(uniform(random, f.bottom * widening - height, f.top * widening + height)),
      static_cast<T>(z));
  r.size = static_cast<T>(width * std::pow(10, uniform(random, -4, 1)));
  if (r.grazing) {
    // Onto the plane, as well as T can say it.
    const Vec3<double> point(r.point);
    const double d = bounds::dot(normal, point) + plane.offset;
    r.point = Vec3<T>(point - d / square * normal);
  }
  return r;
}

template <class T>
T some_ulps(Random& random, T v) {
  return v + v * static_cast<T>(static_cast<int>(random() % 5) - 2) *
                 std::numeric_limits<T>::epsilon() / 2;
}

template <class T>
AxisBox<T> make(Random& random, const Place<T>& place, AxisBox<T>*) {
  const bool from_outside = random() % 2 == 0;
  AxisBox<T> r;
  for (int i = 0; i < 3; ++i) {
    const T side = place.size * static_cast<T>(uniform(random, 0, 2));
    const bool up = place.grazing ? (place.outwards[i] > T(0)) == from_outside : random() % 2 == 0;
    const T corner = place.grazing ? some_ulps(random, place.point[i]) : place.point[i];
    r.lower[i] = up ? corner : corner - side;
    r.upper[i] = up ? corner + side : corner;
  }
  return r;
}

template <class T>
Sphere<T> make(Random& random, const Place<T>& place, Sphere<T>*) {
  const T side = place.grazing ? static_cast<T>(sign_of(random)) : T(0);
  return {place.point + side * place.size * place.outwards, some_ulps(random, place.size)};
}

template <class T>
OrientedBox<T> make(Random& random, const Place<T>& place, OrientedBox<T>*) {
  const T side = static_cast<T>(sign_of(random));
  OrientedBox<T> r;
  for (auto& axis : r.axes) {
    for (int i = 0; i < 3; ++i) axis[i] = static_cast<T>(uniform(random, -1, 1));
  }
  r.axes[0] /= length_above(r.axes[0]);
  r.axes[1] = bounds::cross(r.axes[0], r.axes[1]);
  r.axes[1] /= length_above(r.axes[1]);
  r.axes[2] = bounds::cross(r.axes[0], r.axes[1]);
  r.centre = place.point;
  for (int i = 0; i < 3; ++i) {
    r.half[i] = place.size * static_cast<T>(uniform(random, 0, 1));
    const Vec3<T>& axis = r.axes[static_cast<std::size_t>(i)];
    if (place.grazing) {
      const T away = bounds::dot(axis, place.outwards) > T(0) ? side : -side;
      r.centre += away * some_ulps(random, r.half[i]) * axis;
    }
  }
  return r;
}

// The sign of the least and of the greatest value of a form over a volume, exactly.
struct Signs {
  int least, greatest;
};

template <class T>
InputVertex input(const Vec3<T>& p) {
  InputVertex r;
  for (int i = 0; i < 3; ++i) r.position[static_cast<std::size_t>(i)] = p[i];
  return r;
}

// All eight corners, so that no choice of a corner is trusted.
template <class T>
Signs signs_over(const LinearForm& form, const AxisBox<T>& box) {
  Signs r{1, -1};
  for (int i = 0; i < 8; ++i) {
    const Vec3<T> corner((i & 1) != 0 ? box.upper[0] : box.lower[0],
                         (i & 2) != 0 ? box.upper[1] : box.lower[1],
                         (i & 4) != 0 ? box.upper[2] : box.lower[2]);
    const int s = sign(form, input(corner));
    r.least = std::min(r.least, s);
    r.greatest = std::max(r.greatest, s);
  }
  return r;
}

inline int sign_of(const Dyadic& v) { return static_cast<int>(v.sign()); }

// The form without its constant at a direction.
template <class T>
Dyadic along(const LinearForm& form, const Vec3<T>& direction) {
  Dyadic r = 0;
  for (const Term& term : form) {
    if (term.coordinate != kOne) {
      r += Dyadic(term.coefficient) * Dyadic(double{direction[term.coordinate]});
    }
  }
  return r;
}

// What a form is at a point, and by how much it may differ in long double.
struct Estimate {
  long double value = 0, magnitude = 0;
};
template <class T>
Estimate estimate(const LinearForm& form, const Vec3<T>& p, bool with_constant) {
  Estimate r;
  for (const Term& term : form) {
    const long double factor =
        term.coordinate == kOne ? (with_constant ? 1 : 0) : p[term.coordinate];
    r.value += term.coefficient * factor;
    r.magnitude += std::abs(term.coefficient * factor);
  }
  return r;
}

// Settled by long double where 64 roundings can't change it: then no exact number is formed.
inline constexpr long double kSlack = 64 * std::numeric_limits<long double>::epsilon();

inline int sign_of_sum(const Dyadic& d, const Dyadic& extent) {
  return sign_of(Dyadic(d + extent));
}

template <class T>
Signs signs_over(const LinearForm& form, const Sphere<T>& sphere) {
  const Estimate at = estimate(form, sphere.centre, true);
  long double square = 0;
  for (const Term& term : form) {
    if (term.coordinate != kOne) {
      square += static_cast<long double>(term.coefficient) * term.coefficient;
    }
  }
  const long double extent = sphere.radius * std::sqrt(square);
  const long double slack =
      kSlack * (at.magnitude + extent) + 64 * std::numeric_limits<long double>::min();
  if (std::abs(at.value + extent) > slack && std::abs(at.value - extent) > slack) {
    return {at.value - extent > 0 ? 1 : -1, at.value + extent > 0 ? 1 : -1};
  }
  // d - r |n| and d + r |n|: the sign of d, unless (r |n|)^2 is larger than d^2.
  const Dyadic d = value(form, input(sphere.centre));
  Dyadic norm = 0;
  for (const Term& term : form) {
    if (term.coordinate != kOne) norm += Dyadic(term.coefficient) * Dyadic(term.coefficient);
  }
  const Dyadic r(double{sphere.radius});
  const int larger = sign_of(Dyadic(d * d - r * r * norm));
  const int s = sign_of(d);
  return {larger > 0 ? s : (larger == 0 ? std::min(s, 0) : -1),
          larger > 0 ? s : (larger == 0 ? std::max(s, 0) : 1)};
}

template <class T>
Signs signs_over(const LinearForm& form, const OrientedBox<T>& box) {
  const Estimate at = estimate(form, box.centre, true);
  long double extent = 0, magnitude = at.magnitude;
  for (int i = 0; i < 3; ++i) {
    const Estimate axis = estimate(form, box.axes[static_cast<std::size_t>(i)], false);
    extent += box.half[i] * std::abs(axis.value);
    magnitude += box.half[i] * axis.magnitude;
  }
  const long double slack = kSlack * magnitude + 64 * std::numeric_limits<long double>::min();
  if (std::abs(at.value + extent) > slack && std::abs(at.value - extent) > slack) {
    return {at.value - extent > 0 ? 1 : -1, at.value + extent > 0 ? 1 : -1};
  }
  const Dyadic d = value(form, input(box.centre));
  Dyadic exact_extent = 0;
  for (int i = 0; i < 3; ++i) {
    const Dyadic a = along(form, box.axes[static_cast<std::size_t>(i)]);
    const Dyadic share = Dyadic(double{box.half[i]}) * a;
    if (a.sign() > 0) exact_extent += share;
    if (a.sign() < 0) exact_extent -= share;
  }
  return {sign_of_sum(d, Dyadic(-exact_extent)), sign_of_sum(d, exact_extent)};
}

// What exact arithmetic says about the same planes.
template <class Volume>
Visibility exact_answer(const Truth& truth, const Volume& volume) {
  bool inside = true;
  for (const Truth::HalfSpace& half_space : truth.half_spaces()) {
    const Signs signs = signs_over(half_space.form, volume);
    if (signs.greatest < 0) return Visibility::rejected;
    inside = inside && signs.least >= 0;
  }
  return inside ? Visibility::accepted : Visibility::look_closer;
}

}  // namespace clipscope::reference
