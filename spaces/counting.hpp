// SPDX-License-Identifier: MIT
//
// Counting<T>: computes as T does and tallies each operation by kind.
//
// Run a clipper with Counting<float> and read operation_counts() to learn what it costs in
// operations, machine and compiler aside. The tally belongs to the thread.
#pragma once

#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>

#include "spaces/products.hpp"
#include "spaces/scalar.hpp"

namespace clipscope {

// Operations since the last reset, by kind. A negation costs nothing that matters and is not
// counted.
struct OperationCounts {
  std::uint64_t additions = 0;  // and subtractions
  std::uint64_t multiplications = 0;
  std::uint64_t divisions = 0;
  std::uint64_t comparisons = 0;
  std::uint64_t square_roots = 0;

  friend constexpr bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

// The calling thread's tally: read it, or assign {} to reset it.
inline OperationCounts& operation_counts() {
  thread_local OperationCounts counts;
  return counts;
}

template <class T>
class Counting {
 public:
  constexpr Counting() = default;
  constexpr Counting(const T& value) : value_(value) {}  // NOLINT: as implicit as T itself
  constexpr explicit Counting(int value) requires(!std::same_as<T, int>) : value_(T(value)) {}

  constexpr const T& value() const { return value_; }

  friend Counting operator-(const Counting& a) { return Counting(T(-a.value_)); }
  friend Counting operator+(const Counting& a, const Counting& b) {
    ++operation_counts().additions;
    return Counting(T(a.value_ + b.value_));
  }
  friend Counting operator-(const Counting& a, const Counting& b) {
    ++operation_counts().additions;
    return Counting(T(a.value_ - b.value_));
  }
  friend Counting operator*(const Counting& a, const Counting& b) {
    ++operation_counts().multiplications;
    return Counting(T(a.value_ * b.value_));
  }
  friend Counting operator/(const Counting& a, const Counting& b) {
    ++operation_counts().divisions;
    return Counting(T(a.value_ / b.value_));
  }
  friend Counting sqrt(const Counting& a) requires(std::floating_point<T>) {
    ++operation_counts().square_roots;
    return Counting(T(std::sqrt(a.value_)));
  }
  friend Counting sum_of_products(const Counting& a, const Counting& b, const Counting& c,
                                  const Counting& d) requires(HasSumOfProducts<T>) {
    operation_counts().multiplications += 2;
    ++operation_counts().additions;
    return Counting(sum_of_products(a.value_, b.value_, c.value_, d.value_));
  }
  Counting& operator+=(const Counting& b) { return *this = *this + b; }
  Counting& operator-=(const Counting& b) { return *this = *this - b; }
  Counting& operator*=(const Counting& b) { return *this = *this * b; }
  Counting& operator/=(const Counting& b) { return *this = *this / b; }

  friend bool operator==(const Counting& a, const Counting& b) {
    ++operation_counts().comparisons;
    return a.value_ == b.value_;
  }
  friend auto operator<=>(const Counting& a, const Counting& b) {
    ++operation_counts().comparisons;
    return a.value_ <=> b.value_;
  }

 private:
  T value_{};
};

// Asking is not computing: it is not counted.
template <class T>
constexpr bool is_finite(const Counting<T>& a) {
  return is_finite(a.value());
}
template <class T>
constexpr bool is_nan(const Counting<T>& a) {
  return is_nan(a.value());
}

}  // namespace clipscope

template <class T>
struct std::numeric_limits<clipscope::Counting<T>> : std::numeric_limits<T> {};
