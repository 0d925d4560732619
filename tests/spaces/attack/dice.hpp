// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random choices that are the same for a seed on every machine and under every library.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace clipscope::attack {

inline constexpr float kLargestFloat = std::numeric_limits<float>::max();
inline constexpr float kLeastFloat = std::numeric_limits<float>::denorm_min();

// SplitMix64: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t word() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
  }
  // 0 to count - 1, for small counts.
  int below(int count) {
    return static_cast<int>((word() >> 32) * static_cast<std::uint64_t>(count) >> 32);
  }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int count) { return below(count) == 0; }
  // From 0 to 1.
  double fraction() { return static_cast<double>(word() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * fraction(); }
  float sign() { return one_in(2) ? 1.0f : -1.0f; }

  template <class T>
  T any_of(std::initializer_list<T> choices) {
    return choices.begin()[below(static_cast<int>(choices.size()))];
  }

  // 24 random bits times 2^low to 2^high, positive or of either sign. Subnormal floats lose bits.
  float sized(int low, int high) {
    const float size = significand();
    return std::ldexp(size, between(low, high));
  }
  float over_powers(int low, int high) {
    const float size = sized(low, high);
    return sign() * size;
  }
  // -x or x.
  float turned(float x) { return sign() * x; }
  // From 1 to 2.
  float significand() {
    return std::bit_cast<float>(static_cast<std::uint32_t>(word() >> 41) | 0x3f800000u);
  }
  // Some floats up or down, -count to count.
  float nudged(float x, int count) {
    const int steps = between(-count, count);
    const float towards = steps < 0 ? -kLargestFloat : kLargestFloat;
    for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, towards);
    return x;
  }

 private:
  std::uint64_t state_;
};

}  // namespace clipscope::attack
