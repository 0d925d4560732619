// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/shrink.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/shrink/simpler_cases.hpp"
#include "experiments/survey/verdicts.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Long numbers, attributes and options of every kind.
HardCase long_case() {
  HardCase c;
  c.name = "test/long";
  c.source = c.why = "a test";
  c.volume = {
      .depth = DepthRange::reversed, .depth_clamp = true, .clip_distances = 1, .open_sides = true};
  c.frustum.depth = DepthRange::reversed;
  c.vertices.resize(3);
  c.attribute_count = 6;
  float x = 1.1f;
  for (auto& v : c.vertices) {
    for (double& number : v.position) number = x *= -1.3f;
    v.position[3] = std::abs(v.position[3]);
    for (int k = 0; k < 6; ++k) v.attributes[static_cast<std::size_t>(k)] = x *= 0.9f;
  }
  return c;
}

// A class made of a property of a case, instead of what somebody answers.
template <class Excess>
Failing by_property(const Excess& excess) {
  return [excess](std::span<const HardCase> cases) {
    std::vector<double> all;
    for (const HardCase& c : cases) all.push_back(excess(c));
    return all;
  };
}

double largest(const HardCase& c) {
  double largest = 0;
  for (const auto& v : c.vertices) {
    for (const double x : v.position) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

}  // namespace

TEST_CASE("shrink: what always fails ends in a triangle of ones in the standard volume") {
  const Shrunk shrunk = shrink(long_case(), by_property([](const HardCase&) { return kInfinity; }));
  const HardCase& c = shrunk.hard_case;
  CHECK(c.attribute_count == 0);
  CHECK(c.volume == ClipVolume{});
  std::size_t ones = 0;
  for (const auto& v : c.vertices) {
    for (const double x : v.position) {
      CHECK((x == 0 || x == 1));
      ones += x == 1;
    }
  }
  CHECK(ones == 3);  // with fewer it has no area
}

TEST_CASE("shrink: what has no area may lose all of its numbers") {
  HardCase flat = long_case();
  flat.vertices[2] = flat.vertices[1];
  const HardCase c = shrink(flat, by_property([](const HardCase&) { return kInfinity; })).hard_case;
  for (const auto& v : c.vertices) CHECK(v.position == std::array<double, 4>{0, 0, 0, 0});
}

TEST_CASE("shrink: what is beyond a threshold does not become what has none") {
  const auto excess = [](const HardCase& c) {
    return c.attribute_count == 0 ? kInfinity : largest(c);
  };
  const Shrunk shrunk = shrink(long_case(), by_property(excess));
  CHECK(std::isfinite(shrunk.excess));
  CHECK(shrunk.hard_case.attribute_count == 1);
}

TEST_CASE("shrink: a case keeps a distance of 2 from the threshold, or its own") {
  const auto size_beyond = [](double threshold) {
    return by_property([=](const HardCase& c) { return largest(c) / threshold; });
  };
  const double size = largest(long_case());
  const Shrunk far = shrink(long_case(), size_beyond(size / 100));
  CHECK(far.excess >= kComfortableExcess);
  CHECK(far.excess < 100);
  CHECK(significant_bits(far.hard_case) == 1);
  const Shrunk near = shrink(long_case(), size_beyond(size / 1.5));
  CHECK(near.excess >= 1.5);
}

TEST_CASE("shrink: what does not fail when asked again stays as it is") {
  const Shrunk shrunk = shrink(long_case(), by_property([](const HardCase&) { return 0; }));
  CHECK(shrunk.excess == 0);
  CHECK(shrunk.hard_case.vertices[0].position == long_case().vertices[0].position);
}

TEST_CASE("shrink: the limits bound how many cases are asked, in a round and in all") {
  std::size_t most = 0, all = 0;
  const Failing counting = [&](std::span<const HardCase> cases) {
    most = std::max(most, cases.size());
    all += cases.size();
    return std::vector<double>(cases.size(), kInfinity);
  };
  const Shrunk shrunk = shrink(long_case(), counting, kCostlyFailures);
  CHECK(shrunk.rounds <= kCostlyFailures.rounds);
  CHECK(most <= kCostlyFailures.at_once);
  CHECK(all <= kCostlyFailures.asked + kCostlyFailures.at_once);
  CHECK(cost_of(shrunk.hard_case) < cost_of(long_case()));
}

TEST_CASE("shrink: the same case shrinks to the same bits") {
  const Contestant& contestant = find_contestant("seeded/skips_right", "float");
  const HardCase& given = find_case(builtin_catalogue(), "from_the_field/skia_12335_1");
  const Outcome outcome = judge_case(contestant, given, truth_polygon(given)).outcome;
  REQUIRE(is_failure(outcome));
  const Failing failing = failing_with(contestant, outcome);
  CHECK(case_text(shrink(given, failing).hard_case) == case_text(shrink(given, failing).hard_case));
}

TEST_CASE("shrink: a case of view space ends in the standard frustum, or in clip space") {
  const Contestant& contestant = find_contestant("seeded/skips_near", "float");
  HardCase c = long_case();
  c.space = Space::view;
  c.frustum = {.left = -1.25, .near = 0.75};
  c.volume = {};
  c.vertices[0].position = {0.1f, 0.2f, -0.3f, 1};
  c.vertices[1].position = {0.5f, 0.2f, -4.3f, 1};
  c.vertices[2].position = {0.1f, 0.9f, -5.3f, 1};
  const Failing failing = failing_with(contestant, Outcome::vertex_count);
  REQUIRE(failing(std::span(&c, 1)).front() > 0);
  const HardCase shrunk = shrink(c, failing).hard_case;
  CHECK((shrunk.space == Space::clip || shrunk.frustum == Frustum<double>{}));
  CHECK(significant_bits(shrunk) <= 3);
}
