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

#include "reference/rational.hpp"
#include "spaces/clipper.hpp"
#include "spaces/counting.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

using Exact = reference::Rational;
using Counted = Counting<float>;

using AllScalars = TypeList<float, double, dd_real, Exact, Counted>;

// What a format must be known by where its type is not: of a contestant, of its answers.
struct Format {
  std::string_view name;     // as selected by --scalar
  std::string_view summary;  // one line
  int precision = 0;         // significant bits; 0 for exact arithmetic
  int min_exponent = 0;      // of the smallest normal number, as std::ilogb gives it

  bool is_exact() const { return precision == 0; }
  bool is_float() const { return precision == 24; }  // its numbers are floats
  // Half of the distance from 1 to the next number: 2^-precision; 0 for exact arithmetic.
  double unit_roundoff() const;
  // One unit in the last place at |x|; 0 for exact arithmetic. Below the smallest normal number it
  // is that of the subnormals.
  double ulp_at(double x) const;
  // The largest finite number.
  double largest() const;
  // The smallest positive number; 0 for exact arithmetic.
  double smallest() const;
};

template <class T>
inline constexpr Format kFormat;
template <>
inline constexpr Format kFormat<float>{"float", "IEEE binary32, each operation rounded to nearest",
                                       24, -126};
template <>
inline constexpr Format kFormat<double>{
    "double", "IEEE binary64, each operation rounded to nearest", 53, -1022};
template <>
inline constexpr Format kFormat<dd_real>{
    "double_double", "unevaluated sum of two doubles (QD), about 104 bits", 104, -1022 + 53};
template <>
inline constexpr Format kFormat<Exact>{"exact", "rational numbers (mpq_class of GMP), no rounding",
                                       0, 0};
template <>
inline constexpr Format kFormat<Counted>{"counting", "float that tallies its operations by kind",
                                         24, -126};

// The nearest value of T to a double (the same value wherever T can hold it).
template <class T>
T scalar_from(double value) {
  if constexpr (std::same_as<T, Counted>) {
    return Counted(static_cast<float>(value));
  } else {
    return T(value);
  }
}

// The projection of a frustum whose numbers are given as doubles: they are converted to T (exactly
// where T can hold them), then the matrix is computed in T.
template <class T>
Projection<T> projection_from(const Frustum<double>& f) {
  return Projection<T>(Frustum<T>{
      f.kind, scalar_from<T>(f.left), scalar_from<T>(f.right), scalar_from<T>(f.bottom),
      scalar_from<T>(f.top), scalar_from<T>(f.near), scalar_from<T>(f.infinite_far ? 0.0 : f.far),
      f.infinite_far, scalar_from<T>(f.shear_x), scalar_from<T>(f.shear_y), f.depth});
}

// A matrix whose entries are rounded to T once.
template <class T>
MatrixRows<T> matrix_from(const MatrixRows<double>& rows) {
  MatrixRows<T> r;
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) r[i][k] = scalar_from<T>(rows[i][k]);
  }
  return r;
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

// The nearest double, ties to even: the value itself of float, double and counting.
inline double nearest_double(float x) { return x; }
inline double nearest_double(double x) { return x; }
inline double nearest_double(const dd_real& x) { return x.x[0] + x.x[1]; }
double nearest_double(const Exact& x);
inline double nearest_double(const Counted& x) { return x.value(); }

// value + rest, each the nearest double to what is there to hold: an error of at most 2^-106 of the
// value, where nothing over- or underflows.
inline dd_real nearest_double_double(const Exact& x) {
  const double value = nearest_double(x);
  if (!std::isfinite(value)) return {value, 0};
  return {value, nearest_double(Exact(x - Exact(value)))};
}

// The value as a rational, exactly. Pre-condition: is_finite(x).
inline Exact to_exact(float x) { return Exact(x); }
inline Exact to_exact(double x) { return Exact(x); }
inline Exact to_exact(const dd_real& x) { return Exact(Exact(x.x[0]) + Exact(x.x[1])); }
inline Exact to_exact(const Exact& x) { return x; }
inline Exact to_exact(const Counted& x) { return Exact(x.value()); }

// Calls f.template operator()<T>() for the scalar of the format.
template <class F>
decltype(auto) with_scalar(const Format& format, F&& f) {
  if (&format == &kFormat<float>) return f.template operator()<float>();
  if (&format == &kFormat<double>) return f.template operator()<double>();
  if (&format == &kFormat<dd_real>) return f.template operator()<dd_real>();
  if (&format == &kFormat<Counted>) return f.template operator()<Counted>();
  return f.template operator()<Exact>();
}

}  // namespace clipscope::experiments
