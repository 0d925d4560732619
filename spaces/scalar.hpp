// SPDX-License-Identifier: MIT
//
// Scalar: the number types that a clipper can compute in.
//
// Every clipper is written once, as a template over its scalar. The concept asks for field
// arithmetic and an order, and nothing else: no square root, no rounding mode, no literals but small
// integers. float, double, QD's dd_real, CGAL::Exact_rational and Counting<T> all model it.
//
// Exact number types are often expression templates: write `const T t = a * b;`, never `auto`, and
// never `condition ? a * b : c`.
#pragma once

#include <concepts>
#include <limits>

namespace clipscope {

template <class T>
concept Scalar = std::regular<T> && requires(const T a, const T b, T& r) {
  T(0);
  T(-1);
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

// |a|.
template <Scalar T>
constexpr T magnitude(const T& a) {
  if (a < T(0)) {
    return T(-a);
  }
  return a;
}

}  // namespace clipscope
