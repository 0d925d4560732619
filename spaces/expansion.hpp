// SPDX-License-Identifier: MIT
//
// Expansions: exact sums and products of doubles, and the exact sign of them.
//
// An expansion is a sum of doubles that do not overlap, ordered by growing magnitude, without
// zeros; its sign is that of the last one. Source: Shewchuk, "Adaptive Precision Floating-Point
// Arithmetic and Fast Robust Geometric Predicates", Discrete & Computational Geometry 18, 1997:
// Fast-Expansion-Sum (figure 8), Scale-Expansion (figure 13) and Compress (figure 15), zeros left
// out as he does, and TwoSum where his FastTwoSum would do. With rounding to nearest even, sums and
// products of strongly nonoverlapping expansions are strongly nonoverlapping, and what is
// compressed is nonadjacent, which is more.
//
// Sizes are counted at compile time, in doubles: a sum of N and M has N + M, a product 2 N M.
// `push` asserts that they suffice.
// Guarantees: exact, as long as nothing overflows and every number that occurs is a multiple of the
// smallest subnormal, errors of products included. No allocation.
// Does not guarantee: anything in other rounding modes, with subnormals flushed to zero, or where
// the compiler reorders floating-point arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "spaces/bounds/enclosure.hpp"

namespace clipscope {

// The exact value of at most N doubles.
template <int N>
class Expansion {
 public:
  Expansion() = default;  // 0
  // head + tail. Pre-condition: tail is the rounding error of a sum or product that gave head.
  Expansion(double head, double tail) {
    push(tail);
    push(head);
  }
  // Copies what is there, not what could be. Pre-condition: other.size() <= N.
  Expansion(const Expansion& other) { *this = other; }
  Expansion& operator=(const Expansion& other) { return assign(other); }
  template <int M>
  Expansion& assign(const Expansion<M>& other) {
    std::copy(other.begin(), other.end(), components_.begin());
    size_ = other.size();
    return *this;
  }

  int size() const { return size_; }
  double operator[](int i) const { return components_[i]; }
  const double* begin() const { return components_.data(); }
  const double* end() const { return components_.data() + size_; }

  // Appends a component of larger magnitude than all others that does not overlap them; 0 is left
  // out. Pre-condition: there is room for it.
  void push(double component) {
    if (component == 0) return;
    assert(size_ < N && "an Expansion has room for so many components");
    components_[size_++] = component;
  }

  double largest() const { return size_ == 0 ? 0.0 : components_[size_ - 1]; }
  int sign() const { return (largest() > 0) - (largest() < 0); }

  Expansion operator-() const {
    Expansion r;
    for (const double c : *this) r.push(-c);
    return r;
  }

 private:
  std::array<double, N> components_;
  int size_ = 0;
};

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> r;
  double rounded = 0;
  for (int i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool from_a = j == b.size() || (i < a.size() && std::abs(a[i]) < std::abs(b[j]));
    const auto [sum, error] = bounds::two_sum(rounded, from_a ? a[i++] : b[j++]);
    r.push(error);
    rounded = sum;
  }
  r.push(rounded);
  return r;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + -b;
}

template <int N>
Expansion<2 * N> operator*(const Expansion<N>& a, double b) {
  Expansion<2 * N> r;
  double rounded = 0;
  for (const double c : a) {
    const double product = c * b;
    const auto [low, lowest] = bounds::two_sum(rounded, std::fma(c, b, -product));
    const auto [high, middle] = bounds::two_sum(product, low);
    r.push(lowest);
    r.push(middle);
    rounded = high;
  }
  r.push(rounded);
  return r;
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<2 * N * M> r;
  for (const double c : b) r.assign(r + a * c);
  return r;
}

// The same value in few components, the largest of which is within one unit in its last place of
// it.
//
// Lemma: a value whose components are multiples of 2^low and less than 2^high in magnitude is left
// with at most (high - low) / 52 + 2 components. Proof: in the downward pass q, the rounding error
// of `sum`, is at most half a unit in the last place of sum, a multiple of all that is left over,
// and larger than the rest below it; the next component is therefore at most one such unit, 2^-52
// of sum or less. The upward pass only makes fewer of them.
// Pre-condition: N is at least that.
template <int N, int M>
Expansion<N> compressed(const Expansion<M>& value) {
  std::array<double, M> down;
  int count = 0;
  double sum = value.largest();
  for (int i = value.size() - 2; i >= 0; --i) {
    const auto [rounded, error] = bounds::two_sum(sum, value[i]);
    sum = rounded;
    if (error != 0) {
      down[count++] = rounded;
      sum = error;
    }
  }
  Expansion<N> r;
  while (count > 0) {
    const auto [rounded, error] = bounds::two_sum(down[--count], sum);
    r.push(error);
    sum = rounded;
  }
  r.push(sum);
  return r;
}

}  // namespace clipscope
