// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("random: the first numbers of seed 1 are those of mt19937_64 on every platform") {
  // The generator's first output for seed 1 is 2469588189546311528; its upper 53 bits are used.
  Random random(1);
  CHECK(random.uniform() == double(2469588189546311528u >> 11) * 0x1p-53);
}

TEST_CASE("random: below(n) reaches every number below n and no other") {
  Random random(7);
  std::array<int, 5> hits = {};
  for (int i = 0; i < 1000; ++i) ++hits.at(random.below(hits.size()));
  CHECK(std::ranges::all_of(hits, [](int n) { return 150 < n && n < 250; }));
}

TEST_CASE("random: across_magnitudes stays in its range and spreads over its binades") {
  Random random(3);
  int small = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = random.across_magnitudes(0.1, 1000);
    CHECK((0.1 <= x && x <= 1000));
    small += x < 10;
  }
  // 10 is halfway between 0.1 and 1000 in magnitude.
  CHECK((400 < small && small < 600));
  CHECK(random.across_magnitudes(0.3, 0.3) == 0.3);
}

TEST_CASE("random: directions have length 1 and point every way") {
  Random random(5);
  std::array<bool, 8> octants = {};
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 d = random.direction();
    CHECK(std::abs(d.x * d.x + d.y * d.y + d.z * d.z - 1) < 1e-15);
    octants[(d.x > 0) + 2 * (d.y > 0) + 4 * (d.z > 0)] = true;
  }
  CHECK(std::ranges::all_of(octants, [](bool hit) { return hit; }));
}

TEST_CASE("random: shuffle keeps every element and moves them") {
  Random random(11);
  std::array<int, 100> values;
  std::iota(values.begin(), values.end(), 0);
  const std::array<int, 100> before = values;
  random.shuffle(std::span<int>(values));
  CHECK(values != before);
  std::ranges::sort(values);
  CHECK(values == before);
}

}  // namespace
}  // namespace clipscope::experiments
