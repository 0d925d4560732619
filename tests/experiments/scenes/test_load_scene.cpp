// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("load_scene: a built-in name gives that scene with its own views") {
  const Scene scene = load_scene("floor", {}, {});
  CHECK(scene.name == "floor");
  CHECK(scene.views[0].label == "standing");
}

TEST_CASE("load_scene: a path gives the file's mesh and a walk through it") {
  const FolderOfFiles folder;
  const Scene scene = load_scene(folder.write("pyramid.ply", sample_ply_text()).string(), {}, {});
  CHECK(scene.name == "pyramid.ply");
  CHECK(scene.mesh.triangles.size() == 6);
  CHECK(scene.views.size() == 6);
}

TEST_CASE("load_scene: what is neither a scene nor looks like a file is an unknown scene") {
  const std::string message = message_of<UsageError>([] { load_scene("teapod", {}, {}); });
  CHECK(contains(message, "'teapod'"));
  CHECK(contains(message, "teapot"));
}

TEST_CASE("load_scene: what looks like a file and is none is a missing file") {
  CHECK(contains(message_of<InputError>([] { load_scene("./nowhere/a.obj", {}, {}); }),
                 "./nowhere/a.obj: no such file"));
}

TEST_CASE("load_scene: a camera option replaces the views of a built-in scene") {
  CameraOptions camera;
  camera.eye = glm::dvec3(0, 5, 0.5);
  camera.near = 0.25;
  const Scene scene = load_scene("floor", {}, camera);
  REQUIRE(scene.views.size() == 1);
  CHECK(scene.views[0].frustum.near == 0.25f);
}

TEST_CASE("load_scene: the depth convention holds for every view and replaces none") {
  CameraOptions camera;
  camera.depth = DepthRange::zero_to_one;
  const std::string name = GENERATE("floor", "soup");
  const Scene scene = load_scene(name, {.quick = true}, camera);
  CHECK(scene.views.size() == make_builtin_scene(name, {.quick = true}).views.size());
  CHECK(std::ranges::all_of(
      scene.views, [](const View& view) { return view.frustum.depth == DepthRange::zero_to_one; }));
}

TEST_CASE("load_scene: a scene made in view space has no camera to move") {
  CameraOptions camera;
  camera.far = 10.0;
  CHECK(contains(message_of<UsageError>([&] { load_scene("slivers", {.quick = true}, camera); }),
                 "'slivers' is given in view space"));
}

}  // namespace
}  // namespace clipscope::experiments
