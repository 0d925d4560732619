// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scalar that remembers the quotient it came from: it computes as T does, bit for bit, and a value that
// was just divided still knows what was divided by what. Of a clipper whose last step is the divide it
// gives the polygon before that step.
#pragma once

#include <concepts>
#include <limits>

#include "experiments/measure/computes_as.hpp"

namespace clipscope::experiments {

template <std::floating_point T>
class Traced : public ComputesAs<Traced<T>, T> {
 public:
  constexpr Traced() = default;
  constexpr explicit Traced(double value) : Traced(of(static_cast<T>(value))) {}

  constexpr T value() const { return value_; }
  // value() is numerator() / denominator(), rounded; the denominator is 1 unless the value is a quotient.
  constexpr T numerator() const { return numerator_; }
  constexpr T denominator() const { return denominator_; }

  static constexpr Traced of(T value) {
    Traced r;
    r.value_ = r.numerator_ = value;
    return r;
  }
  static constexpr Traced quotient(const Traced& a, const Traced& b) {
    Traced r = of(a.value_ / b.value_);
    r.numerator_ = a.value_;
    r.denominator_ = b.value_;
    return r;
  }

 private:
  T value_{}, numerator_{}, denominator_ = T(1);
};

}  // namespace clipscope::experiments

template <class T>
struct std::numeric_limits<clipscope::experiments::Traced<T>> : std::numeric_limits<T> {};
