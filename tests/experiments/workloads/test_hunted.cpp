// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "experiments/workloads/hunted.hpp"
#include "experiments/workloads/lattice_draws.hpp"
#include "experiments/workloads/plain_call.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/workloads/drivers.hpp"

namespace clipscope::experiments {
namespace {

std::vector<DrawCall> some_draws(std::size_t count) {
  std::vector<DrawCall> calls;
  for (std::size_t i = 0; i < count; ++i) calls.push_back(lattice_draw(1, i, able_driver()));
  return calls;
}

// A driver whose error grows with the ratio of the largest and the smallest w.
double spread_of_w(const DrawCall& call) {
  float least = INFINITY, most = 0;
  for (const DrawVertex& v : call.vertices) {
    if (v.position[3] <= 0) return 0;
    least = std::min(least, v.position[3]);
    most = std::max(most, v.position[3]);
  }
  return std::log2(most / least);
}

}  // namespace

TEST_CASE("hunted: finds worse draw calls than those that it begins with") {
  const std::vector<DrawCall> beginnings = some_draws(24);
  double before = 0;
  for (const DrawCall& call : beginnings) before = std::max(before, spread_of_w(call));
  const auto found = hunted_draws(beginnings, spread_of_w, {.evaluations = 2000});
  CHECK(found.front().error > before + 8);
  CHECK(found.front().error == spread_of_w(found.front().call));
  CHECK_FALSE(found.front().is_beginning);
  CHECK(std::ranges::is_sorted(
      found, [](const HuntedDraw& a, const HuntedDraw& b) { return a.error > b.error; }));
}

TEST_CASE("hunted: the same seed finds the same") {
  const std::vector<DrawCall> beginnings = some_draws(8);
  const auto hunt_with = [&](std::uint64_t seed) {
    return hunted_draws(beginnings, spread_of_w, {.evaluations = 300, .seed = seed});
  };
  CHECK(hunt_with(1) == hunt_with(1));
  CHECK(hunt_with(1) != hunt_with(2));
}

TEST_CASE(
    "hunted: no more draw calls are asked than are allowed, none with numbers that are none") {
  std::size_t asked = 0;
  const auto counts = [&](const DrawCall& call) {
    ++asked;
    CHECK(is_finite(call));
    return spread_of_w(call);
  };
  CHECK(hunted_draws(some_draws(20), counts, {.evaluations = 12}).size() == 12);
  CHECK(asked == 12);
  asked = 0;
  hunted_draws(some_draws(20), counts, {.evaluations = 100});
  CHECK(asked <= 100);
  CHECK(asked >= 95);  // now and then a change is none
  CHECK(hunted_draws({}, counts, {}).empty());
}

TEST_CASE("hunted: what nothing makes worse stays as it was") {
  const std::vector<DrawCall> beginnings = some_draws(5);
  const auto found =
      hunted_draws(beginnings, [](const DrawCall&) { return 1; }, {.evaluations = 200});
  REQUIRE(found.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(found[i].is_beginning);
    CHECK(found[i].call == beginnings[i]);
  }
}

}  // namespace clipscope::experiments
