// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/spoken.hpp"

#include <map>

#include "experiments/contestants/contestant.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

bool is_spoken(const std::string& words) {
  return !words.empty() && words.find_first_of("_/") == words.npos;
}

}  // namespace

TEST_CASE("spoken names: every clipper has its own, in words") {
  std::map<std::string, std::string_view> clippers;
  for (const Contestant& c : all_contestants()) {
    const std::string words = spoken_clipper(c.clipper);
    INFO(c.clipper);
    CHECK(is_spoken(words));
    CHECK(clippers.emplace(words, c.clipper).first->second == c.clipper);
  }
}

TEST_CASE("spoken names: those that findings speak of are the spaces") {
  CHECK(spoken_clipper("view/sutherland_hodgman") == "view space");
  CHECK(spoken_clipper("homogeneous/sutherland_hodgman") == "clip space");
  CHECK(spoken_clipper("cvv/perspective") == "dividing first");
  CHECK(spoken_clipper("barycentric/distance_matrix") == "the distance matrix");
}

TEST_CASE("spoken names: a clipper without an entry is called by its method and place") {
  CHECK(spoken_clipper("homogeneous/all_planes") == "all planes in clip space");
  CHECK(spoken_clipper("window/cohen_sutherland") == "Cohen-Sutherland in the window");
  CHECK(spoken_clipper("convex/cyrus_beck") == "Cyrus-Beck");
  CHECK(spoken_clipper("my_clipper") == "my clipper");
}

TEST_CASE("spoken names: the scalar is named where there are several") {
  CHECK(spoken_contestant("homogeneous/sutherland_hodgman", "exact") ==
        "clip space in exact arithmetic");
  CHECK(spoken_contestant("cvv/near_first", "double_double") ==
        "dividing behind a near cut in double-double");
  CHECK(spoken_contestant("homogeneous/batch", "float") == "the clip-space batch clipper");
  CHECK(spoken_contestant("all_planes", "float") == "all planes in float");
}

TEST_CASE("spoken names: every built-in scene has one, a file keeps its own") {
  for (const SceneInfo& scene : builtin_scenes()) CHECK(is_spoken(spoken_set(scene.name)));
  CHECK(spoken_set("soup") == "the game-like mix");
  CHECK(spoken_set("bunny.obj") == "bunny.obj");
}
