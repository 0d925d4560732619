// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/recentre.hpp"

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

// A box of 0.3 by 0.3 by 0.4 m in map coordinates, without its bottom.
constexpr const char* kFarBox =
    "v 12958095.1 4865499.8 10\nv 12958095.4 4865499.8 10\nv 12958095.4 4865500.1 10\n"
    "v 12958095.1 4865500.1 10\nv 12958095.1 4865499.8 10.4\nv 12958095.4 4865499.8 10.4\n"
    "v 12958095.4 4865500.1 10.4\nv 12958095.1 4865500.1 10.4\n"
    "f 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

Scene far_box(const CameraOptions& camera = {}) {
  const FolderOfFiles folder;
  return load_scene(folder.write("box.obj", kFarBox).string(), {}, camera);
}

TEST_CASE("detail: positions that fall together in float are counted, with the ulp there") {
  const LostDetail detail = lost_detail(far_box().mesh);
  CHECK(detail.positions == 8);
  CHECK(detail.fallen == 6);
  CHECK(detail.ulp == 1);
  CHECK(detail.largest == 12958095);
  const std::string text = describe(detail, "box.obj");
  CHECK(contains(
      text,
      "box.obj: in float 6 of 8 positions fall together with others, 10 of 10 triangles have an edge that changes by more than 1 %: neighbouring floats are 1 apart at 12958095"));
  CHECK(contains(text, "--recentre"));
}

TEST_CASE("detail: a mesh of floats loses nothing, and one near the origin neither") {
  CHECK(describe(lost_detail(make_builtin_scene("floor", {}).mesh), "floor").empty());
  const FolderOfFiles folder;
  const Scene scene = load_scene(
      folder.write("a.obj", replaced(sample_obj(), "0.5 0.5", "0.1 0.2")).string(), {}, {});
  CHECK_FALSE(scene.mesh.double_positions.empty());
  CHECK(lost_detail(scene.mesh).fallen == 0);
}

TEST_CASE("detail: positions that stay apart may still bend the triangles") {
  const FolderOfFiles folder;
  const Scene scene = load_scene(
      folder.write("a.obj", "v 12958095.12 0 0\nv 12958095.52 0 0\nv 12958095.12 9 0\nf 1 2 3\n")
          .string(),
      {}, {});
  const LostDetail detail = lost_detail(scene.mesh);
  CHECK(detail.fallen == 0);
  CHECK(detail.bent == 1);
  CHECK(contains(describe(detail, "a.obj"),
                 "1 of 1 triangles has an edge that changes by more than 1 %"));
}

TEST_CASE("recentre: the detail of a mesh far from the origin survives in float") {
  Scene scene = far_box();
  const glm::dvec3 origin = recentre(scene);
  // Half of the longest side is 0.2, so that the origin is a multiple of 1/8.
  CHECK(origin == glm::dvec3(12958095.25, 4865500, 10.25));
  CHECK(lost_detail(scene.mesh).fallen == 0);
  CHECK(scene.mesh.positions[0][0] == static_cast<float>(12958095.1 - 12958095.25));
}

TEST_CASE("recentre: a camera in the file's coordinates sees the mesh where it was") {
  CameraOptions camera;
  camera.eye = glm::dvec3(12958095.25, 4865499.95, 12);
  camera.up = glm::dvec3(0, 1, 0);
  Scene scene = far_box(camera);
  recentre(scene);
  SceneTriangle triangle;
  view_triangles(scene, scene.views[0], 0, {&triangle, 1});
  // The top lies 1.6 below the eye, 0.15 to each side. Two roundings to float are off by up to
  // 2^-27 each there (2^-24 in depth), and those of the map coordinates, of the eye and of the
  // origin in double by 2^-30 each.
  for (const auto& corner : triangle) {
    CHECK(std::abs(std::abs(double{corner.position[0]}) - 0.15) < 2 * 0x1p-27 + 4 * 0x1p-30);
    CHECK(std::abs(std::abs(double{corner.position[1]}) - 0.15) < 2 * 0x1p-27 + 4 * 0x1p-30);
    CHECK(std::abs(double{corner.position[2]} + 1.6) < 2 * 0x1p-24);
  }
}

TEST_CASE("recentre: the walk of the automatic camera sees all of a mesh far from the origin") {
  Scene scene = far_box();
  recentre(scene);
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  view_triangles(scene, scene.views[0], 0, triangles);
  for (const SceneTriangle& triangle : triangles) {
    for (const auto& corner : triangle) {
      CHECK(corner.position[2] < -scene.views[0].frustum.near);
      CHECK(corner.position[2] > -scene.views[0].frustum.far);
    }
  }
}

}  // namespace
}  // namespace clipscope::experiments
