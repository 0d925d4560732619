// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hard set: clip-space triangles of floats that rounding may lose. A quarter each are slivers,
// reach to 1e6, have vertices within 1e-6 of planes, or are all of that.
#pragma once

#include <array>
#include <cmath>
#include <random>

namespace clipscope::tests {

using HardTriangle = std::array<std::array<float, 4>, 3>;  // x y z w

class HardSet {
 public:
  explicit HardSet(std::uint64_t seed) : random_(seed) {}

  HardTriangle next() {
    const auto kind = random_() % 4;
    HardTriangle t = kind == 1 ? far_reaching() : about_the_volume(kind == 0 ? 1.5 : 1.3);
    if (kind == 0 && chance(0.5)) t[0][3] = -t[0][3];
    if (kind == 3) scale(t, power_of_ten(0, 6));
    if (kind >= 2) put_on_planes(t, 0.8);
    if (kind == 0 || kind == 3) flatten(t);
    if (kind == 3) put_on_planes(t, 0.3);
    return t;
  }

 private:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double sign() { return 2 * unit() - 1; }
  bool chance(double share) { return unit() < share; }
  double power_of_ten(double low, double high) { return std::pow(10, low + (high - low) * unit()); }

  HardTriangle far_reaching() {
    HardTriangle t;
    for (auto& v : t) {
      const double reach = power_of_ten(0, 6);
      for (float& x : v) x = static_cast<float>(sign() * reach);
      if (chance(0.8)) v[3] = std::abs(v[3]);
    }
    return t;
  }

  HardTriangle about_the_volume(double reach) {
    HardTriangle t;
    for (auto& v : t) {
      const double w = 0.1 + 10 * unit();
      v[3] = static_cast<float>(w);
      for (std::size_t c = 0; c < 3; ++c) v[c] = static_cast<float>(sign() * reach * w);
    }
    return t;
  }

  static void scale(HardTriangle& t, double factor) {
    for (auto& v : t) {
      for (float& x : v) x = static_cast<float>(x * factor);
    }
  }

  // Vertices on a plane of -w <= x, y, z <= w, or up to 1e-6 beside it.
  void put_on_planes(HardTriangle& t, double share) {
    for (auto& v : t) {
      if (!chance(share)) continue;
      const double beside = chance(0.15) ? 0 : sign() * power_of_ten(-8, -6);
      const double bound = v[3] * (1 + beside);
      v[random_() % 3] = static_cast<float>(random_() % 2 == 0 ? bound : -bound);
    }
  }

  // Puts the third vertex next to the line through the others.
  void flatten(HardTriangle& t) {
    const double s = chance(0.5) ? 2 * sign() : unit(), width = power_of_ten(-8, -2);
    for (std::size_t c = 0; c < 4; ++c) {
      const double a = t[0][c], b = t[1][c];
      const double off = width * sign() * (std::abs(a) + std::abs(b));
      t[2][c] = static_cast<float>(a + s * (b - a) + off);
    }
  }

  std::mt19937_64 random_;
};

}  // namespace clipscope::tests
