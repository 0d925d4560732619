// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random numbers that are the same on every platform for a seed.
//
// The generator is the Mersenne twister of the C++ standard (Matsumoto and Nishimura, "Mersenne
// Twister", ACM TOMACS 8(1), 1998), whose output is fixed; the distributions are our own, since
// those of the standard differ between libraries. They use exact scaling and IEEE arithmetic only:
// no exp, log, sin or cos.
//
// Draw one number per statement: C++ leaves the order within an expression to the compiler.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <span>
#include <utility>

namespace clipscope::experiments {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  // Uniform multiples of 2^-53 in [0, 1).
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  // Pre-condition: lo <= hi.
  double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }

  // Uniform in [0, n), by rejection, hence unbiased. Pre-condition: n > 0.
  std::uint64_t below(std::uint64_t n) {
    const std::uint64_t rest = (0 - n) % n;  // 2^64 mod n
    std::uint64_t r = bits_();
    while (r < rest) r = bits_();
    return r % n;
  }

  bool chance(double probability) { return uniform() < probability; }
  double sign() { return bits_() & 1 ? 1.0 : -1.0; }

  // In [lo, hi]: every binade equally likely, uniform within what the range has of it; much like
  // log-uniform. Pre-condition: 0 < lo <= hi.
  double across_magnitudes(double lo, double hi) {
    const int first = std::ilogb(lo), last = std::ilogb(hi);
    const int exponent =
        first + static_cast<int>(below(static_cast<std::uint64_t>(last - first) + 1));
    return uniform(std::fmax(lo, std::ldexp(1, exponent)),
                   std::fmin(hi, std::ldexp(1, exponent + 1)));
  }

  // Uniform in the cube [-1, 1]^3.
  glm::dvec3 in_cube() {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return {x, y, z};
  }

  // Uniform on the unit sphere, up to rounding.
  glm::dvec3 direction() {
    while (true) {
      const glm::dvec3 p = in_cube();
      const double square = p.x * p.x + p.y * p.y + p.z * p.z;
      if (0.01 <= square && square <= 1) return p / std::sqrt(square);
    }
  }

  // Fisher and Yates: every order equally likely.
  template <class T>
  void shuffle(std::span<T> values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace clipscope::experiments
