// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

// Two triangles that share an edge; attribute values name their vertex.
Scene two_triangles() {
  Scene scene;
  scene.mesh.positions = {{1, 0, -0.0f}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
  scene.mesh.attributes = {{0, 0, 0, 0}, {1, 1, 1, 1}, {2, 2, 2, 2}, {3, 3, 3, 3}};
  scene.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.views.resize(1);
  return scene;
}

TEST_CASE("view_triangles: the identity view keeps every bit, a negative zero's too") {
  const Scene scene = two_triangles();
  std::vector<SceneTriangle> out(2);
  view_triangles(scene, scene.views[0], 0, out);
  CHECK(out[0][0].position == Vec3<float>(1, 0, 0));
  CHECK(std::signbit(out[0][0].position[2]));
  CHECK(out[1][2].position == Vec3<float>(1, 1, 0));
  CHECK(out[1][2].attributes.values == std::array{3.0f, 3.0f, 3.0f, 3.0f});
}

TEST_CASE("view_triangles: a range of triangles can be asked for") {
  const Scene scene = two_triangles();
  std::vector<SceneTriangle> out(1);
  view_triangles(scene, scene.views[0], 1, out);
  CHECK(out[0][1].attributes[0] == 2);
}

TEST_CASE(
    "view_triangles: an eye at (1, 0, 5) that looks down -z sees x = 2 at 1 and z = 0 at -5") {
  const Scene scene = two_triangles();
  const View view{"", look_at({1, 0, 5}, {1, 0, 0}, {0, 1, 0}), {}};
  std::vector<SceneTriangle> out(2);
  view_triangles(scene, view, 0, out);
  CHECK(out[0][0].position == Vec3<float>(0, 0, -5));
  CHECK(out[0][2].position == Vec3<float>(1, 1, -5));
}

TEST_CASE("view_triangles: a coordinate is the exact sum rounded to float once") {
  // 1 + 2^-25 rounds to 1 in float, and the sum that follows would lose it; double keeps it.
  Scene scene = two_triangles();
  scene.mesh.positions[0] = {1, 0x1p-25f, -1};
  View view;
  view.view_from_world[0][0] = 1;
  view.view_from_world[1][0] = 1;
  view.view_from_world[2][0] = 1;
  std::vector<SceneTriangle> out(1);
  view_triangles(scene, view, 0, out);
  CHECK(out[0][0].position[0] == 0x1p-25f);
}

TEST_CASE(
    "view_triangles: in double a position is what the file has, moved without a rounding to float") {
  Scene scene = two_triangles();
  scene.mesh.double_positions.resize(scene.mesh.positions.size());
  scene.mesh.double_positions[scene.mesh.triangles[0][0]] = {0.1, 12958095.1, -1};
  std::vector<DoubleSceneTriangle> out(1);
  view_triangles(scene, View{}, 0, out);
  CHECK(out[0][0].position == Vec3<double>(0.1, 12958095.1, -1));
  View view;
  view.view_from_world[3] = {0, -12958095, 0, 1};
  view_triangles(scene, view, 0, out);
  CHECK(out[0][0].position == Vec3<double>(0.1, 12958095.1 - 12958095.0, -1));
}

TEST_CASE("bounding_box: spans all vertices, and no more") {
  const Box box = bounding_box(two_triangles().mesh);
  CHECK(box.lo == glm::dvec3(1, 0, 0));
  CHECK(box.hi == glm::dvec3(2, 1, 0));
  CHECK(box.centre() == glm::dvec3(1.5, 0.5, 0));
}

}  // namespace
}  // namespace clipscope::experiments
