// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures without perspective correction.
#include <filesystem>

#include "experiments/perspective/measure.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::perspective {
namespace {

constexpr PictureSize kSize{256, 144};
constexpr double kTexels = 1024;

// One triangle that fills most of the screen, its texture once along it, from w = 2 to w = 2 ratio.
Scene triangle_scene(double ratio) {
  Scene scene;
  scene.name = "triangle";
  scene.views = {identity_view()};
  const double far = 2 * ratio;
  add_vertex(scene.mesh, {-0.9 * 2, -0.5 * 2, -2}, {0, 0, 0, 0});
  add_vertex(scene.mesh, {0.9 * far, -0.5 * far, -far}, {1, 0, 0, 0});
  add_vertex(scene.mesh, {0, 0.5 * 2, -2}, {0, 0, 0, 0});
  scene.mesh.triangles = {{0, 1, 2}};
  return scene;
}

AffinePicture draw(const Scene& scene, Pieces pieces) {
  return draw(scene, scene.views.front(), pieces, kSize);
}

}  // namespace

TEST_CASE("affine picture: a triangle at one distance needs no correction") {
  const Pieces pieces = GENERATE(Pieces::near_cut, Pieces::clipped, Pieces::split);
  const AffinePicture picture = draw(triangle_scene(1), pieces);
  CHECK(picture.error.counts.compared() > 1000);
  // What is left is the rounding of u in double.
  CHECK(picture.error.counts.max_error < 1e-9);
}

TEST_CASE("affine picture: pixels of a triangle come close to the bound and never pass it") {
  const AffinePicture picture = draw(triangle_scene(4), Pieces::clipped);
  CHECK(picture.error.counts.max_error < kTexels / 3);
  CHECK(picture.error.counts.max_error > 0.98 * kTexels / 3);
}

TEST_CASE("affine picture: the correct one does not depend on the pieces, the affine one does") {
  const Scene scene = make_builtin_scene("floor", {.quick = true});
  const AffinePicture near_cut = draw(scene, Pieces::near_cut);
  const AffinePicture clipped = draw(scene, Pieces::clipped);
  const AffinePicture split = draw(scene, Pieces::split);
  for (const AffinePicture* other : {&clipped, &split}) {
    // Rounding of texture coordinates of up to 2000 tiles, seen through pixels at the horizon.
    CHECK(compare(other->correct, near_cut.correct).counts.median_error < 1e-6);
  }
  CHECK(clipped.error.counts.median_error < near_cut.error.counts.median_error);
  CHECK(split.error.counts.median_error < clipped.error.counts.median_error / 10);
  CHECK(split.error.counts.share_above_one > 0.5);
}

TEST_CASE("affine picture: it is written under the scene's name and the pieces'") {
  const Scene scene = triangle_scene(4);
  const auto folder = std::filesystem::temp_directory_path();
  const AffinePicture picture = draw(scene, scene.views.front(), Pieces::near_cut, {320, 180});
  const Picture written = write_picture(folder, scene, Pieces::near_cut, picture);
  CHECK(written.file == "perspective-triangle-near_cut.png");
  CHECK(written.caption.ends_with(
      ": affine, each triangle cut by the near plane only, and its error"));
  CHECK(std::filesystem::file_size(folder / written.file) > 1000);
  std::filesystem::remove(folder / written.file);
}

}  // namespace clipscope::experiments::perspective
