// SPDX-License-Identifier: MIT
//
// Numbers between two bounds, and exact comparisons of products: what the bounds of projected
// primitives are computed with.
//
// Every operation rounds to nearest, finds the exact rounding error by an error-free
// transformation, and moves the bound outwards by one unit in the last place only if the error says
// so. Source: Ogita, Rump and Oishi, "Accurate Sum and Dot Product", SIAM J. Sci. Comput. 26(6),
// 2005 (TwoSum, TwoProductFMA, and the remainder of a division).
//
// Guarantees: the exact result lies within the bounds, and an exactly representable one is kept
// exactly, for round-to-nearest with gradual underflow. Where a result is so small that its error
// may underflow, or it overflows, both bounds move outwards.
// Does not guarantee: anything in other rounding modes or with subnormals flushed to zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>

namespace clipscope {

// How a result is given: nearest to the exact value as computed, or moved outwards to contain it.
enum class Rounding : std::uint8_t { nearest, outward };

template <std::floating_point T>
struct Enclosure {
  T low = T(0), high = T(0);

  constexpr Enclosure() = default;
  constexpr Enclosure(T value) : low(value), high(value) {}
  constexpr Enclosure(T l, T h) : low(l), high(h) {}

  constexpr bool is_nan() const { return !(low <= high); }
  constexpr Enclosure operator-() const { return {-high, -low}; }
};

template <std::floating_point T>
constexpr T middle(const Enclosure<T>& e) {
  return e.low < e.high ? e.low + T(0.5) * (e.high - e.low) : e.low;
}

namespace bounds {

template <std::floating_point T>
T next_below(T v) {
  return std::nextafter(v, -std::numeric_limits<T>::infinity());
}
template <std::floating_point T>
T next_above(T v) {
  return std::nextafter(v, std::numeric_limits<T>::infinity());
}

// Below this magnitude the error of a product or the remainder of a quotient may underflow.
template <std::floating_point T>
inline constexpr T kSafe = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon() /
                           std::numeric_limits<T>::epsilon();

// The exact value is rounded + error. An unknown error is NaN: both comparisons are false then.
template <std::floating_point T>
Enclosure<T> enclose(T rounded, T error) {
  return {error >= T(0) ? rounded : next_below(rounded),
          error <= T(0) ? rounded : next_above(rounded)};
}

// sum = fl(a + b), a + b = sum + error exactly: TwoSum.
template <std::floating_point T>
std::pair<T, T> two_sum(T a, T b) {
  const T sum = a + b;
  const T b_part = sum - a;
  const T a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

template <std::floating_point T>
Enclosure<T> sum(T a, T b) {
  const auto [rounded, error] = two_sum(a, b);
  return enclose(rounded, error);
}

template <std::floating_point T>
Enclosure<T> product(T a, T b) {
  const T p = a * b;
  if (a == T(0) || b == T(0)) return Enclosure<T>(p);
  const bool safe = std::abs(p) >= kSafe<T>;
  return enclose(p, safe ? std::fma(a, b, -p) : std::numeric_limits<T>::quiet_NaN());
}

// Pre-condition: b > 0.
template <std::floating_point T>
Enclosure<T> quotient(T a, T b) {
  const T q = a / b;
  if (a == T(0)) return Enclosure<T>(q);
  const bool safe = std::abs(a) >= kSafe<T> && std::abs(q) >= kSafe<T> && std::isfinite(q);
  return enclose(q, safe ? std::fma(-q, b, a) : std::numeric_limits<T>::quiet_NaN());
}

}  // namespace bounds

template <std::floating_point T>
Enclosure<T> operator+(const Enclosure<T>& a, const Enclosure<T>& b) {
  return {bounds::sum(a.low, b.low).low, bounds::sum(a.high, b.high).high};
}

// Pre-condition: weight >= 0.
template <std::floating_point T>
Enclosure<T> scaled(const Enclosure<T>& weight, T v) {
  const T least = v < T(0) ? weight.high : weight.low;
  const T most = v < T(0) ? weight.low : weight.high;
  return {bounds::product(least, v).low, bounds::product(most, v).high};
}

// Pre-condition: b > 0.
template <std::floating_point T>
Enclosure<T> operator/(const Enclosure<T>& a, const Enclosure<T>& b) {
  const T least = a.low < T(0) ? b.low : b.high;
  const T most = a.high < T(0) ? b.high : b.low;
  return {bounds::quotient(a.low, least).low, bounds::quotient(a.high, most).high};
}

namespace bounds {

// |a b| as (significand + error) 2^exponent with 1/2 <= significand < 1, a and b not 0. The
// significands' product is formed away from underflow, so that the error is exact.
struct ExactProduct {
  int exponent;
  double significand, error;

  ExactProduct(double a, double b) {
    int exponent_a, exponent_b;
    const double m = std::abs(std::frexp(a, &exponent_a)), n = std::abs(std::frexp(b, &exponent_b));
    significand = m * n;
    error = std::fma(m, n, -significand);
    exponent = exponent_a + exponent_b;
    if (significand < 0.5) {
      significand *= 2;
      error *= 2;
      --exponent;
    }
  }

  // Rounding keeps order, so the rounded values decide unless they are equal.
  friend auto operator<=>(const ExactProduct&, const ExactProduct&) = default;
};

constexpr int sign(double v) { return v < 0 ? -1 : (v > 0 ? 1 : 0); }

}  // namespace bounds

// The sign of a b - c d, exactly. Pre-condition: finite numbers.
inline int compare_products(float a, float b, float c, float d) {
  const double p = double{a} * b,
               q = double{c} * d;  // exact: 48 bits, exponents far from the limits
  return p < q ? -1 : (q < p ? 1 : 0);
}

inline int compare_products(double a, double b, double c, double d) {
  const int left = bounds::sign(a) * bounds::sign(b), right = bounds::sign(c) * bounds::sign(d);
  if (left != right || left == 0) return left < right ? -1 : (right < left ? 1 : 0);
  const bounds::ExactProduct p(a, b), q(c, d);
  return p < q ? -left : (q < p ? left : 0);
}

}  // namespace clipscope
