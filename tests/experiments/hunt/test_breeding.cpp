// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/breeding.hpp"

#include <cmath>
#include <set>

#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::hunt;

namespace {

bool is_finite(const Prey& prey) {
  for (std::size_t v = 0; v < Prey::kVertices; ++v) {
    for (const float x : prey.position[v]) {
      if (!std::isfinite(x)) return false;
    }
    for (const float x : prey.attributes[v]) {
      if (!std::isfinite(x)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("breeding: all prey is finite, and in view space w is 1") {
  Random random(3);
  const Contestant& contestant = find_contestant("homogeneous/sutherland_hodgman", "float");
  for (int i = 0; i < 2000; ++i) {
    const Setting setting = random_setting(contestant, Prey::kAttributes, {}, random);
    Prey prey = random_prey(setting, random);
    for (int k = 0; k < 20; ++k) {
      REQUIRE(is_finite(prey));
      if (setting.space == Space::view) REQUIRE(prey.position[1][3] == 1);
      prey = mutated(setting, prey, Prey::kAttributes, random);
    }
    REQUIRE(is_finite(crossed(prey, random_prey(setting, random), random)));
  }
}

TEST_CASE("breeding: settings are what the contestant takes, of each kind of its own") {
  Random random(4);
  const Contestant& view = find_contestant("view/sutherland_hodgman", "float");
  Contestant narrow = find_contestant("homogeneous/sutherland_hodgman", "float");
  narrow.depths = {false, true, false};
  narrow.promise.depth_clamp = false;
  narrow.most_attributes = 0;
  std::set<bool> clamped, distances, spaces;
  for (int i = 0; i < 500; ++i) {
    CHECK(random_setting(view, 4, {}, random).space == Space::view);
    const Setting s = random_setting(narrow, 0, {}, random);
    CHECK(s.volume.depth == DepthRange::zero_to_one);
    CHECK_FALSE(bool{s.volume.depth_clamp});
    CHECK(s.volume.clip_distances == 0);
    const Setting any =
        random_setting(find_contestant("homogeneous/sutherland_hodgman", "float"), 4, {}, random);
    clamped.insert(bool{any.volume.depth_clamp});
    distances.insert(any.volume.clip_distances > 0);
    spaces.insert(any.space == Space::view);
  }
  CHECK(clamped.size() == 2);
  CHECK(distances.size() == 2);
  CHECK(spaces.size() == 2);
}

TEST_CASE("breeding: settings keep to their limits") {
  Random random(6);
  const Contestant& contestant = find_contestant("homogeneous/sutherland_hodgman", "float");
  const SettingLimits limits{.space = Space::view, .is_plain = true};
  for (int i = 0; i < 200; ++i) {
    const Setting setting = random_setting(contestant, 4, limits, random);
    CHECK(setting.space == Space::view);
    CHECK(is_plain(setting.volume));
    CHECK(limits.allow(setting));
  }
  CHECK_FALSE(limits.allow({.space = Space::clip}));
  CHECK_FALSE(limits.allow({.space = Space::view, .volume = {.depth_clamp = true}}));
}

TEST_CASE("breeding: a change changes something nearly always, and may be of one ulp") {
  Random random(5);
  const Setting setting;
  const Prey prey = random_prey(setting, random);
  int changed = 0, by_an_ulp = 0;
  for (int i = 0; i < 2000; ++i) {
    const Prey next = mutated(setting, prey, 0, random);
    CHECK(next.attributes == prey.attributes);
    if (next.position != prey.position) ++changed;
    for (std::size_t v = 0; v < Prey::kVertices; ++v) {
      for (std::size_t c = 0; c < 4; ++c) {
        const float before = prey.position[v][c], after = next.position[v][c];
        if (after == before) continue;
        if (std::nextafter(before, after) == after) ++by_an_ulp;
      }
    }
  }
  CHECK(changed > 1500);
  CHECK(by_an_ulp > 20);
}
