// SPDX-License-Identifier: MIT
//
// Differences, products, squares and roots of numbers between two bounds, and bounds rounded to a
// narrower format. Guarantees and pre-conditions are those of enclosure.hpp.
#pragma once

#include "spaces/bounds/enclosure.hpp"

namespace clipscope {

// What may be any number: the result of an overflow.
template <std::floating_point T>
constexpr Enclosure<T> kAnyNumber = {-std::numeric_limits<T>::infinity(),
                                     std::numeric_limits<T>::infinity()};

template <std::floating_point T>
Enclosure<T> operator-(const Enclosure<T>& a, const Enclosure<T>& b) {
  return a + -b;
}

// Of any signs. Any number where infinity meets 0.
template <std::floating_point T>
Enclosure<T> operator*(const Enclosure<T>& a, const Enclosure<T>& b) {
  Enclosure<T> r = bounds::product(a.low, b.low);
  for (const Enclosure<T>& p : {bounds::product(a.low, b.high), bounds::product(a.high, b.low),
                                bounds::product(a.high, b.high)}) {
    if (p.is_nan() || r.is_nan()) return kAnyNumber<T>;
    r = {std::min(r.low, p.low), std::max(r.high, p.high)};
  }
  return r.is_nan() ? kAnyNumber<T> : r;
}

// Of one factor that is the same number both times: never negative.
template <std::floating_point T>
Enclosure<T> square(const Enclosure<T>& a) {
  const Enclosure<T> r = a * a;
  return a.low <= T(0) && T(0) <= a.high ? Enclosure<T>(T(0), r.high)
                                         : Enclosure<T>(std::max(r.low, T(0)), r.high);
}

// Of the part that is not negative. A root is correctly rounded: the next numbers contain it.
template <std::floating_point T>
Enclosure<T> square_root(const Enclosure<T>& a) {
  const T low = std::sqrt(std::max(a.low, T(0))), high = std::sqrt(std::max(a.high, T(0)));
  return {std::max(bounds::next_below(low), T(0)), high > T(0) ? bounds::next_above(high) : high};
}

namespace bounds {

// A double as T: nearest, or if outward the nearest that isn't above (below) it.
template <std::floating_point T>
T nearest(double v) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  constexpr double most = std::numeric_limits<T>::max();
  return v > most ? infinity : (v < -most ? -infinity : static_cast<T>(v));
}
template <std::floating_point T>
T rounded_down(double v, Rounding rounding) {
  const T r = nearest<T>(v);
  return rounding == Rounding::outward && r > v ? next_below(r) : r;
}
template <std::floating_point T>
T rounded_up(double v, Rounding rounding) {
  return -rounded_down<T>(-v, rounding);
}

}  // namespace bounds

}  // namespace clipscope
