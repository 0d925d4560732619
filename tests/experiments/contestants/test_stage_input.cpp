// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage's inputs: three layouts of the same clip-space triangles.
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/stage_inputs.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

// A soup's classes are those of view space: the float transform brings some vertices across the far
// plane, where clip coordinates tell depths apart no more.
TEST_CASE("stage input: a soup has about the shares that were asked for") {
  const StageShares shares = shares_of(small_soup(1000), Contract::copy);
  CHECK(shares.inside == Approx(40).margin(0.5));
  CHECK(shares.outside == Approx(30).margin(0.5));
  CHECK(shares.straddling == Approx(30).margin(0.5));
}

TEST_CASE("stage input: streams and array hold the same floats, whatever the block") {
  const StageInput input = small_soup(50);
  const std::size_t first = 7, count = 11;
  const batch::VertexArray array = input.array(first, count);
  const batch::TriangleStreams streams = input.streams(first, count);
  REQUIRE(array.count == 3 * count);
  REQUIRE(streams.count == count);
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t v = 0; v < 3; ++v) {
      const float* vertex = array.data + (3 * t + v) * array.stride();
      for (std::size_t c = 0; c < 4; ++c) CHECK(streams.positions[v][c][t] == vertex[c]);
      for (std::size_t k = 0; k < 4; ++k) {
        CHECK(streams.attributes[(3 * t + v) * 4 + k] == vertex[4 + k]);
      }
    }
  }
}

TEST_CASE("stage input: attributes beyond the scene's four repeat them") {
  const StageInput input = random_input("soup", {.inside = 1}, 3, 8, 1);
  REQUIRE(input.stride() == 12);
  const float* vertex = input.vertex(Contract::copy, 2, 1);
  for (int k = 0; k < 4; ++k) CHECK(vertex[4 + k] == vertex[8 + k]);
}

TEST_CASE("stage input: a mesh has one vertex for all triangles that share it") {
  const Scene scene = terrain_of_levels(3, 1);
  const StageInput input = mesh_input(scene, scene.views.front());
  const std::size_t triangles = input.size(Contract::indexed);
  CHECK(triangles == 2 * 8 * 8);
  CHECK(input.size(Contract::copy) == 0);
  CHECK(input.array_size() == triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t v = 0; v < 3; ++v) {
      const float* shared = input.vertex(Contract::indexed, t, v);
      const float* own = input.vertex(Contract::copy, t, v);
      CHECK(std::equal(shared, shared + input.stride(), own));
    }
  }
}

TEST_CASE("stage input: a scene's views all take part, evenly spaced") {
  const Scene scene = make_builtin_scene("teapot", {.seed = 1, .quick = true});
  const StageInput input = scene_input(scene, 500);
  CHECK(input.array_size() > 400);
  CHECK(input.array_size() <= 500 + scene.views.size());
  CHECK(input.name == "teapot");
}
