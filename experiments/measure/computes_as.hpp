// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arithmetic of a scalar that wraps a floating-point number, computes as it does, bit for bit, and
// knows something besides.
#pragma once

#include <concepts>

#include "spaces/products.hpp"

namespace clipscope::experiments {

// Self has value(), the number; the static of(T), a Self without that knowledge; and the static
// quotient(a, b), the result of a / b.
template <class Self, std::floating_point T>
struct ComputesAs {
  friend constexpr Self operator-(const Self& a) { return Self::of(-a.value()); }
  friend constexpr Self operator+(const Self& a, const Self& b) {
    return Self::of(a.value() + b.value());
  }
  friend constexpr Self operator-(const Self& a, const Self& b) {
    return Self::of(a.value() - b.value());
  }
  friend constexpr Self operator*(const Self& a, const Self& b) {
    return Self::of(a.value() * b.value());
  }
  friend constexpr Self operator/(const Self& a, const Self& b) { return Self::quotient(a, b); }
  friend constexpr Self& operator+=(Self& a, const Self& b) { return a = a + b; }
  friend constexpr Self& operator-=(Self& a, const Self& b) { return a = a - b; }
  friend constexpr Self& operator*=(Self& a, const Self& b) { return a = a * b; }
  friend constexpr Self& operator/=(Self& a, const Self& b) { return a = a / b; }

  friend constexpr bool operator==(const Self& a, const Self& b) { return a.value() == b.value(); }
  friend constexpr bool operator<(const Self& a, const Self& b) { return a.value() < b.value(); }
  friend constexpr bool operator<=(const Self& a, const Self& b) { return a.value() <= b.value(); }

  friend Self sum_of_products(const Self& a, const Self& b, const Self& c, const Self& d) {
    return Self::of(clipscope::sum_of_products(a.value(), b.value(), c.value(), d.value()));
  }
};

}  // namespace clipscope::experiments
