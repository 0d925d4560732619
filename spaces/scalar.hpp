// SPDX-License-Identifier: MIT
//
// Scalar: the number types that a clipper can compute in.
//
// Every clipper is written once, as a template over its scalar. The concept asks for field
// arithmetic and an order, and nothing else: no square root, no rounding mode, no literals but
// small integers and floats. float, double, QD's dd_real, GMP's mpq_class and Counting<T> all model
// it.
//
// Exact number types are often expression templates: write `const T t = a * b;`, never `auto`, and
// never `condition ? a * b : c`.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

namespace clipscope {

template <class T>
concept Scalar = std::regular<T> && requires(const T a, const T b, T& r) {
  T(0);
  T(-1);
  T(0.5f);
  r = a + b;
  r = a - b;
  r = a * b;
  r = a / b;
  r = -a;
  { a < b } -> std::convertible_to<bool>;
  { a <= b } -> std::convertible_to<bool>;
};

// True where a division by zero yields an infinity (IEEE formats and double-double). Exact number
// types have none: there a clipper must ask before it divides.
template <Scalar T>
inline constexpr bool kHasInfinity = std::numeric_limits<T>::has_infinity;

// Whether a / b can be formed at all.
template <Scalar T>
constexpr bool can_divide_by(const T& b) {
  if constexpr (kHasInfinity<T>) {
    return true;
  } else {
    return b != T(0);
  }
}

// The larger of two values; a where they are unordered.
template <Scalar T>
constexpr T larger(const T& a, const T& b) {
  return a < b ? b : a;
}

// Formats with a square root: those of the standard library, and types that bring their own `sqrt`.
using std::sqrt;
template <class T>
concept HasSquareRoot = requires(const T& a) {
  { sqrt(a) } -> std::convertible_to<T>;
};

// Whether a is neither NaN nor infinite: always so where T has no infinity.
template <Scalar T>
constexpr bool is_finite(const T& a) {
  if constexpr (kHasInfinity<T>) {
    const T zero = a - a;
    return zero == T(0);
  } else {
    return true;
  }
}

// Whether a is a NaN: never where T has none.
template <Scalar T>
constexpr bool is_nan(const T& a) {
  if constexpr (kHasInfinity<T>) {
    return !(a == a);
  } else {
    return false;
  }
}

}  // namespace clipscope
