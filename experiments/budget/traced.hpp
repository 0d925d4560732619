// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scalar that remembers the quotient it came from: it computes as T does, bit for bit, and a value that
// was just divided still knows what was divided by what. Of a clipper whose last step is the divide it
// gives the polygon before that step.
#pragma once

#include <concepts>
#include <limits>

#include "spaces/products.hpp"

namespace clipscope::experiments {

template <std::floating_point T>
class Traced {
 public:
  constexpr Traced() = default;
  constexpr explicit Traced(double value) : Traced(of(static_cast<T>(value))) {}

  constexpr T value() const { return value_; }
  // value() is numerator() / denominator(), rounded; the denominator is 1 unless the value is a quotient.
  constexpr T numerator() const { return numerator_; }
  constexpr T denominator() const { return denominator_; }

  friend constexpr Traced operator-(const Traced& a) { return of(-a.value_); }
  friend constexpr Traced operator+(const Traced& a, const Traced& b) {
    return of(a.value_ + b.value_);
  }
  friend constexpr Traced operator-(const Traced& a, const Traced& b) {
    return of(a.value_ - b.value_);
  }
  friend constexpr Traced operator*(const Traced& a, const Traced& b) {
    return of(a.value_ * b.value_);
  }
  friend constexpr Traced operator/(const Traced& a, const Traced& b) {
    Traced r = of(a.value_ / b.value_);
    r.numerator_ = a.value_;
    r.denominator_ = b.value_;
    return r;
  }
  constexpr Traced& operator+=(const Traced& b) { return *this = *this + b; }
  constexpr Traced& operator-=(const Traced& b) { return *this = *this - b; }
  constexpr Traced& operator*=(const Traced& b) { return *this = *this * b; }
  constexpr Traced& operator/=(const Traced& b) { return *this = *this / b; }

  friend constexpr bool operator==(const Traced& a, const Traced& b) {
    return a.value_ == b.value_;
  }
  friend constexpr bool operator<(const Traced& a, const Traced& b) { return a.value_ < b.value_; }
  friend constexpr bool operator<=(const Traced& a, const Traced& b) {
    return a.value_ <= b.value_;
  }

  friend Traced sum_of_products(const Traced& a, const Traced& b, const Traced& c,
                                const Traced& d) {
    return of(clipscope::sum_of_products(a.value_, b.value_, c.value_, d.value_));
  }

 private:
  static constexpr Traced of(T value) {
    Traced r;
    r.value_ = r.numerator_ = value;
    return r;
  }

  T value_{}, numerator_{}, denominator_ = T(1);
};

}  // namespace clipscope::experiments

template <class T>
struct std::numeric_limits<clipscope::experiments::Traced<T>> : std::numeric_limits<T> {};
