// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cameras as people have them: poses, quaternions, intrinsics, matrices, glTF cameras.
#include <cmath>
#include <glm/geometric.hpp>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/gltf_camera.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<double, 16> kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

glm::dvec3 moved(const glm::dmat4& m, const glm::dvec3& p) {
  return glm::dvec3(m * glm::dvec4(p, 1));
}

Mesh triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.attributes.resize(3);
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST_CASE("pose: world from camera by rows or by columns puts the eye at the origin") {
  CameraOptions options;
  options.pose = kIdentity;
  (*options.pose)[3] = 7;  // x of the eye
  CHECK(moved(make_views(triangle(), options).front().view_from_world, {7, 0, -2}) ==
        glm::dvec3(0, 0, -2));
  options.pose = kIdentity;
  (*options.pose)[12] = 7;
  options.by_columns = true;
  CHECK(moved(make_views(triangle(), options).front().view_from_world, {7, 0, -2}) ==
        glm::dvec3(0, 0, -2));
}

TEST_CASE("pose: axes of OpenCV look down +z with y down") {
  CameraOptions options;
  options.pose = kIdentity;
  options.axes = CameraAxes::cv;
  CHECK(moved(make_views(triangle(), options).front().view_from_world, {1, 2, 5}) ==
        glm::dvec3(1, -2, -5));
}

TEST_CASE("pose: a quaternion of any length turns the camera about the eye") {
  CameraOptions options;
  options.eye = glm::dvec3(0, 0, 4);
  options.orientation = {0, 2, 0, 2};  // a quarter turn about y: it looks down -x
  const glm::dvec3 ahead =
      moved(make_views(triangle(), options).front().view_from_world, {-3, 1, 4});
  CHECK(glm::length(ahead - glm::dvec3(0, 1, -3)) < 4e-15);
}

TEST_CASE("pose: one that flattens, is projective or said twice is refused") {
  const auto refused = [](auto change) {
    CameraOptions options;
    options.pose = kIdentity;
    change(options);
    return message_of<UsageError>([&] { make_views(triangle(), options); });
  };
  using O = CameraOptions;
  CHECK(contains(refused([](O& o) { (*o.pose)[0] = 0; }), "can't be inverted"));
  CHECK(contains(refused([](O& o) { (*o.pose)[14] = 1; }), "last row 0 0 0 1"));
  CHECK(contains(refused([](O& o) { (*o.pose)[0] = NAN; }), "finite"));
  CHECK(contains(refused([](O& o) { o.eye = glm::dvec3(1); }),
                 "--pose: it does not go together with --eye"));
  CHECK(contains(refused([](O& o) {
                   o.pose.reset(), o.orientation = {0, 0, 0, 1};
                 }),
                 "--orientation"));
  CHECK(contains(refused([](O& o) {
                   o.pose.reset(), o.eye = glm::dvec3(1), o.orientation = {0, 0, 0, 0};
                 }),
                 "is no rotation"));
}

TEST_CASE(
    "lens: intrinsics are an off-centre frustum whose pixels have their centres at integers") {
  const Frustum<double> f = intrinsics_frustum({100, 200, 0, 3, 4, 8}, 2, HUGE_VAL);
  CHECK(f.infinite_far);
  CHECK(f.left == 2 * -0.5 / 100);
  CHECK(f.right == 2 * 3.5 / 100);
  CHECK(f.top == 2 * 3.5 / 200);
  CHECK(f.bottom == 2 * -4.5 / 200);
  CHECK(contains(message_of<UsageError>([] {
                   intrinsics_frustum({0, 1, 0, 0, 1, 1}, 1, 2);
                 }),
                 "FX is 0"));
  CHECK(contains(message_of<UsageError>([] {
                   intrinsics_frustum({1, 1, 0, 0, 1, 1}, 3, 2);
                 }),
                 "--near: 3"));
}

TEST_CASE("lens: a far plane at infinity is taken by angles of view and by frusta") {
  CHECK(perspective_frustum(60, 1, 1, HUGE_VAL).infinite_far);
  CameraOptions options;
  options.eye = glm::dvec3(0, 0, 4);
  options.far = HUGE_VAL;
  CHECK(make_views(triangle(), options).front().frustum.infinite_far);
  options.far.reset();
  options.frustum = Frustum<double>{ProjectionKind::parallel, -1, 2, -3, 4, 0, 9};
  CHECK(make_views(triangle(), options).front().frustum.right == 2);
  options.eye.reset();
  CHECK(contains(message_of<UsageError>([&] { make_views(triangle(), options); }),
                 "give --eye or --pose"));
}

TEST_CASE("matrix: a view takes it as given, of the world unless the camera stands somewhere") {
  CameraOptions options;
  options.matrix = kIdentity;
  (*options.matrix)[3] = 0.1;
  const View world = make_views(triangle(), options).front();
  REQUIRE(world.matrix);
  CHECK((*world.matrix)[0][3] == 0.1f);
  CHECK(world.view_from_world == glm::dmat4(1));
  CHECK(world.label == "matrix as given");
  options.eye = glm::dvec3(0, 0, 4);
  CHECK(moved(make_views(triangle(), options).front().view_from_world, {0, 0, 4}) == glm::dvec3(0));
  options.near = 1.0;
  CHECK(contains(message_of<UsageError>([&] { make_views(triangle(), options); }),
                 "--matrix: it does not go together with --near"));
  (*options.matrix)[3] = 1e300;
  options.near.reset();
  CHECK(contains(message_of<UsageError>([&] { make_views(triangle(), options); }), "in float"));
}

TEST_CASE("gltf camera: options may change its depths and its picture, near keeps the angle") {
  GltfCamera camera;
  camera.fovy = 1;
  camera.aspect = 2.0;
  camera.near = 0.5;
  const Frustum<double> f = frustum_of(camera, {});
  CHECK(f.infinite_far);
  CHECK(f.top == Approx(0.5 * std::tan(0.5)));
  CHECK(f.right == Approx(2 * f.top));
  CameraOptions options;
  options.near = 1.0;
  options.far = 9.0;
  options.aspect = 1;
  const Frustum<double> other = frustum_of(camera, options);
  CHECK(other.top == Approx(2 * f.top));
  CHECK(other.right == other.top);
  CHECK(other.far == 9);
}

}  // namespace
}  // namespace clipscope::experiments
