// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scalars that the program runs clippers in, and what it must know of each.
//
// Double-double: Hida, Li and Bailey, "Library for Double-Double and Quad-Double Arithmetic", 2007.
#pragma once

#include <qd/dd_real.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "reference/exact_clip.hpp"
#include "spaces/clipper.hpp"
#include "spaces/counting.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

using Exact = reference::Rational;
using Counted = Counting<float>;

using AllScalars = TypeList<float, double, dd_real, Exact, Counted>;

// name         as selected by --scalar
// precision    significant bits of the format; 0 for exact arithmetic
// min_exponent of the smallest normal number, as std::ilogb gives it
template <class T>
struct ScalarTraits;

template <>
struct ScalarTraits<float> {
  static constexpr std::string_view name = "float";
  static constexpr std::string_view summary = "IEEE binary32, each operation rounded to nearest";
  static constexpr int precision = 24;
  static constexpr int min_exponent = -126;
};

template <>
struct ScalarTraits<double> {
  static constexpr std::string_view name = "double";
  static constexpr std::string_view summary = "IEEE binary64, each operation rounded to nearest";
  static constexpr int precision = 53;
  static constexpr int min_exponent = -1022;
};

template <>
struct ScalarTraits<dd_real> {
  static constexpr std::string_view name = "double_double";
  static constexpr std::string_view summary = "unevaluated sum of two doubles (QD), about 104 bits";
  static constexpr int precision = 104;
  static constexpr int min_exponent = -1022 + 53;
};

template <>
struct ScalarTraits<Exact> {
  static constexpr std::string_view name = "exact";
  static constexpr std::string_view summary = "rational numbers (mpq_class of GMP), no rounding";
  static constexpr int precision = 0;
  static constexpr int min_exponent = 0;
};

template <>
struct ScalarTraits<Counted> {
  static constexpr std::string_view name = "counting";
  static constexpr std::string_view summary = "float that tallies its operations by kind";
  static constexpr int precision = 24;
  static constexpr int min_exponent = -126;
};

// The scalar's unit roundoff u: 2^-precision; 0 for exact arithmetic.
template <class T>
double unit_roundoff() {
  return ScalarTraits<T>::precision == 0 ? 0.0 : std::ldexp(1.0, -ScalarTraits<T>::precision);
}

// One unit in the last place of the scalar's format at |x|; 0 for exact arithmetic. Below the
// smallest normal number it is that of the subnormals.
template <class T>
double ulp_at(double x) {
  if constexpr (ScalarTraits<T>::precision == 0) {
    return 0.0;
  } else {
    const int lowest = ScalarTraits<T>::min_exponent;
    const int exponent = x == 0.0 ? lowest : std::max(std::ilogb(x), lowest);
    return std::ldexp(1.0, exponent - ScalarTraits<T>::precision + 1);
  }
}

// The nearest value of T to a double (the same value wherever T can hold it).
template <class T>
T scalar_from(double value) {
  if constexpr (std::same_as<T, Counted>) {
    return Counted(static_cast<float>(value));
  } else {
    return T(value);
  }
}

// The projection of a frustum whose numbers are given as doubles: they are converted to T (exactly where T
// can hold them), then the matrix is computed in T.
template <class T>
Projection<T> projection_from(const Frustum<double>& f) {
  return Projection<T>(Frustum<T>{
      f.kind, scalar_from<T>(f.left), scalar_from<T>(f.right), scalar_from<T>(f.bottom),
      scalar_from<T>(f.top), scalar_from<T>(f.near), scalar_from<T>(f.infinite_far ? 0.0 : f.far),
      f.infinite_far, scalar_from<T>(f.shear_x), scalar_from<T>(f.shear_y), f.depth});
}

using clipscope::for_each_type;
using clipscope::is_finite;

// Whether every coordinate and attribute is neither NaN nor infinite.
template <class T, int K>
bool is_finite(const NdcVertex<T, K>& v) {
  for (int i = 0; i < 4; ++i) {
    if (!is_finite(v.position[i])) return false;
  }
  for (int k = 0; k < v.attributes.size(); ++k) {
    if (!is_finite(v.attributes[k])) return false;
  }
  return true;
}

// The value as a double: exactly for float, double and counting, else the nearest or next to it.
inline double nearest_double(float x) { return x; }
inline double nearest_double(double x) { return x; }
inline double nearest_double(const dd_real& x) { return x.x[0] + x.x[1]; }
inline double nearest_double(const Exact& x) { return CGAL::to_double(x); }
inline double nearest_double(const Counted& x) { return x.value(); }

// The value as a rational, exactly. Pre-condition: is_finite(x).
inline Exact to_exact(float x) { return Exact(x); }
inline Exact to_exact(double x) { return Exact(x); }
inline Exact to_exact(const dd_real& x) { return Exact(Exact(x.x[0]) + Exact(x.x[1])); }
inline Exact to_exact(const Exact& x) { return x; }
inline Exact to_exact(const Counted& x) { return Exact(x.value()); }

}  // namespace clipscope::experiments
