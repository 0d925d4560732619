// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes whose shared edges are cut in every way.
#include "experiments/scenes/builtin.hpp"
#include "experiments/watertight/scenes.hpp"
#include "experiments/watertight/shared_edges.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::watertight {

TEST_CASE("views by plane: each plane alone, several, and none cut edges of the teapot") {
  const Scene scene = cut_by_every_plane(make_builtin_scene("teapot", {.quick = true}));
  CHECK(scene.views.size() == 28);
  const auto edges = shared_edges(scene.mesh);
  std::array<int, 64> seen{};
  for (const View& view : scene.views) {
    for (const CutEdge& e : cut_edges(scene, view, edges, 200)) ++seen[e.planes];
  }
  for (const Plane plane : kAllPlanes) CHECK(seen[bit(plane)] > 20);
  CHECK(seen[0] > 20);
  CHECK(seen[bit(Plane::left) | bit(Plane::right)] == 0);  // it is not that large
}

TEST_CASE("grazing: only one neighbour crosses the plane that the edge lies by") {
  const Scene scene = make_grazing_scene(500, 3);
  int different = 0, all = 0;
  for (const CutEdge& e : cut_edges(scene, scene.views.front(), shared_edges(scene.mesh), 0)) {
    ++all;
    different += e.different_neighbours;
  }
  CHECK(all > 100);
  CHECK(different > all / 2);
  CHECK(make_grazing_scene(500, 3).mesh.positions == scene.mesh.positions);
  CHECK(make_grazing_scene(500, 4).mesh.positions != scene.mesh.positions);
}

}  // namespace clipscope::experiments::watertight
