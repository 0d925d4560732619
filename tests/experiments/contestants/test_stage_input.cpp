// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage's inputs: three layouts of the same clip-space triangles.
#include <map>
#include <vector>

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

TEST_CASE("stage input: draws have the triangles of the mesh, and a vertex once each") {
  const Scene scene = terrain_of_levels(3, 1);
  const StageInput mesh = mesh_input(scene, scene.views.front());
  const StageInput draws = in_draws(mesh, 48);  // of 128 triangles
  REQUIRE(draws.draw_begins.size() == 3);
  REQUIRE(draws.size(Contract::indexed) == mesh.size(Contract::indexed));
  for (std::size_t t = 0; t < mesh.size(Contract::indexed); ++t) {
    for (std::size_t v = 0; v < 3; ++v) {
      const float* vertex = draws.vertex(Contract::indexed, t, v);
      CHECK(std::equal(vertex, vertex + mesh.stride(), mesh.vertex(Contract::indexed, t, v)));
    }
  }
  // Three rows of 8 quads have 4 rows of 9 vertices.
  CHECK(draws.mesh(0, 48).vertices.count == 36);
  CHECK(draws.mesh(96 + 5, 3).vertices.count == 27);
  CHECK(draws.mesh_vertices.size() == (36 + 36 + 27) * mesh.stride());
}

TEST_CASE("stage input: copies have each triangle equally often, in other orders") {
  const StageInput soup = small_soup(50), copies = shuffled_copies(soup, 120, 1);
  REQUIRE(copies.array_size() == 150);
  const auto triangle = [](const StageInput& input, std::size_t t) {
    const float* vertex = input.vertex(Contract::copy, t, 0);
    return std::vector<float>(vertex, vertex + 3 * input.stride());
  };
  std::map<std::vector<float>, int> seen;
  int at_home = 0;
  for (std::size_t t = 0; t < 150; ++t) {
    ++seen[triangle(copies, t)];
    at_home += triangle(copies, t) == triangle(soup, t % 50);
  }
  CHECK(seen.size() == 50);
  for (const auto& [floats, times] : seen) CHECK(times == 3);
  CHECK(at_home < 30);
  CHECK(copies.size(Contract::number) == 150);
}

TEST_CASE("stage input: cut triangles are counted by the planes that they cross") {
  // x y z w of three vertices each: inside, beyond right, beyond right and top, behind the eye.
  const StageInput input = soup_input("four", {}, 0, {0, 0, 0, 1, 0.5, 0, 0, 1,  0, 0.5, 0, 1,  //
                                                      0, 0, 0, 1, 2,   0, 0, 1,  0, 0.5, 0, 1,  //
                                                      0, 0, 0, 1, 2,   0, 0, 1,  0, 2,   0, 1,  //
                                                      0, 0, 0, 1, 0,   0, 0, -1, 0, 0.5, 0, 1});
  const StageShares shares = shares_of(input, Contract::copy);
  CHECK(shares.inside == 25);
  CHECK(shares.straddling == 75);
  CHECK(shares.one_plane == Approx(100.0 / 3));
  CHECK(shares.two_planes == Approx(100.0 / 3));
  CHECK(shares.more_planes == Approx(100.0 / 3));  // behind the eye it is outside of all
  CHECK(shares.behind_eye == Approx(100.0 / 3));
}
