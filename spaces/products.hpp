// SPDX-License-Identifier: MIT
//
// a b + c d with a small relative error, and hence with the right sign.
//
// float: the products are exact in double, so one rounding of their sum and one to float remain.
// double: Kahan's algorithm with fused multiply-adds, error below 1.5 units in the last place:
// Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for the accurate computation
// of 2 x 2 determinants", Mathematics of Computation 82, 2013. Exact number types need no care.
// Double-double has none: without a fused operation its two products and a sum can cancel to
// nothing. Does not guarantee: anything where a product over- or underflows.
#pragma once

#include <cmath>
#include <concepts>

#include "spaces/rounding.hpp"
#include "spaces/scalar.hpp"

namespace clipscope {

inline float sum_of_products(const float& a, const float& b, const float& c, const float& d) {
  return rounded_to_float(static_cast<double>(a) * b + static_cast<double>(c) * d);
}

inline double sum_of_products(const double& a, const double& b, const double& c, const double& d) {
  const double product = c * d;
  const double error = std::fma(c, d, -product);
  const double sum = std::fma(a, b, product);
  return sum + error;
}

template <Scalar T>
requires(!kHasInfinity<T>) T sum_of_products(const T& a, const T& b, const T& c, const T& d) {
  return a * b + c * d;
}

// Formats that have it.
template <class T>
concept HasSumOfProducts = requires(const T& a) {
  { sum_of_products(a, a, a, a) } -> std::convertible_to<T>;
};

}  // namespace clipscope
