// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "experiments/machine/errors.hpp"
#include "spaces/planes.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"

namespace clipscope::experiments {
namespace {

glm::dvec3 transformed(const glm::dmat4& m, const glm::dvec3& p) {
  return glm::dvec3(m * glm::dvec4(p, 1));
}

// A cube from -1 to 1 of 12 triangles.
Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
  }
  mesh.attributes.resize(8);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Mesh one_triangle(std::array<std::array<float, 3>, 3> corners) {
  Mesh mesh;
  mesh.positions.assign(corners.begin(), corners.end());
  mesh.attributes.resize(3);
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

struct CrossingCounts {
  int near = 0, far = 0, sides = 0, w0 = 0;
};

CrossingCounts count_crossings(const Mesh& mesh, const View& view) {
  Scene scene;
  scene.mesh = mesh;
  std::vector<SceneTriangle> triangles(mesh.triangles.size());
  view_triangles(scene, view, 0, triangles);
  CrossingCounts found;
  for (const SceneTriangle& t : triangles) {
    const auto code = [&](std::size_t i) { return view_outcode(view.frustum, t[i].position); };
    const OutcodeSummary both = summarize_outcodes(ClipVolume{}, t, code);
    const Outcode crossed = both.any & ~both.all;
    found.near += (crossed & bit(Plane::near)) != 0;
    found.far += (crossed & bit(Plane::far)) != 0;
    found.sides += (crossed & 0xf) != 0;
    const auto behind = [&](int i) { return t[i].position[2] > 0; };
    found.w0 += behind(0) + behind(1) + behind(2) == 1 || behind(0) + behind(1) + behind(2) == 2;
  }
  return found;
}

TEST_CASE("look_at: from (3, 4, 5) towards +x, z goes to minus view x and x to minus view z") {
  const glm::dmat4 m = look_at({3, 4, 5}, {10, 4, 5}, {0, 1, 0});
  CHECK(transformed(m, {3, 4, 5}) == glm::dvec3(0, 0, 0));
  CHECK(transformed(m, {5, 4, 5}) == glm::dvec3(0, 0, -2));
  CHECK(transformed(m, {3, 4, 6}) == glm::dvec3(1, 0, 0));
  CHECK(transformed(m, {3, 7, 5}) == glm::dvec3(0, 3, 0));
}

TEST_CASE("look_at: a slanted view is a rotation and a shift, up stays in the upper half plane") {
  const glm::dvec3 eye(1, -2, 0.5), target(-3, 1, 7), up(0.2, 1, -0.3);
  const glm::dmat4 m = look_at(eye, target, up);
  const glm::dvec3 seen = transformed(m, target);
  CHECK(std::abs(seen.x) < 1e-14);
  CHECK(std::abs(seen.y) < 1e-14);
  CHECK(std::abs(seen.z + glm::length(target - eye)) < 1e-14);
  const glm::dvec3 upwards = transformed(m, eye + up);
  CHECK(std::abs(upwards.x) < 1e-14);
  CHECK(upwards.y > 0);
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  CHECK(std::abs(glm::dot(glm::cross(x, y), z) - 1) < 1e-14);
}

TEST_CASE("perspective_frustum: 90 degrees at near 2 reach 2 up and aspect times 2 right") {
  const Frustum<float> f = perspective_frustum(90, 1.5, 2, 50);
  CHECK(std::abs(f.top - 2) <= 2 * 0x1p-23f);
  CHECK(std::abs(f.right - 3) <= 4 * 0x1p-23f);
  CHECK(f.left == -f.right);
  CHECK(f.bottom == -f.top);
  CHECK(f.near == 2);
  CHECK(f.far == 50);
}

TEST_CASE("perspective_frustum: values that enclose no volume are refused by the option's name") {
  const auto refused = [](double fovy, double aspect, double near, double far) {
    return message_of<UsageError>([=] { perspective_frustum(fovy, aspect, near, far); });
  };
  CHECK(contains(refused(0, 1, 1, 2), "--fovy: 0 "));
  CHECK(contains(refused(180, 1, 1, 2), "--fovy: 180 "));
  CHECK(contains(refused(NAN, 1, 1, 2), "--fovy: nan "));
  CHECK(contains(refused(60, 0, 1, 2), "--aspect: 0 "));
  CHECK(contains(refused(60, 1, 0, 2), "--near: 0 "));
  CHECK(contains(refused(60, 1, -1, 2), "--near: -1 "));
  CHECK(contains(refused(60, 1, 3, 2), "--near: 3 given; it must be less than far, which is 2"));
  CHECK(contains(refused(60, 1, 2, 2), "--near: 2 "));
  CHECK(contains(refused(60, 1, INFINITY, INFINITY), "--near: inf "));
  CHECK(contains(refused(60, 1, 1, 1 + 1e-12), "rounded to float"));
  CHECK(contains(refused(60, 1, 1, 1e300), "rounded to float"));
  CHECK(contains(refused(60, 1, 1e-60, 1), "rounded to float"));
}

TEST_CASE(
    "make_views: an eye gives that one view, of the mesh's centre, with all of it before far") {
  CameraOptions options;
  options.eye = glm::dvec3(0, 0, 10);
  options.depth = DepthRange::reversed;
  const std::vector<View> views = make_views(cube(), options);
  REQUIRE(views.size() == 1);
  CHECK(transformed(views[0].view_from_world, {0, 0, 0}) == glm::dvec3(0, 0, -10));
  CHECK(views[0].frustum.far > 11);
  CHECK(views[0].frustum.near < 0.1);
  CHECK(views[0].frustum.depth == DepthRange::reversed);
}

TEST_CASE("make_views: an eye far away gets near and far of a ratio that depth can bear") {
  CameraOptions options;
  options.eye = glm::dvec3(0, 0, 1e9);
  const Frustum<float> f = make_views(cube(), options).front().frustum;
  CHECK(f.far > 1e9f);
  CHECK(f.far / f.near < 1.1e5f);
}

TEST_CASE("make_views: an eye straight above the centre needs no up") {
  CameraOptions options;
  options.eye = glm::dvec3(0, 10, 0);
  CHECK(make_views(cube(), options).size() == 1);
}

TEST_CASE("make_views: the walk sees all from outside, then cuts sides, near, far and w = 0") {
  const std::vector<View> views = make_views(cube(), {});
  REQUIRE(views.size() == 6);
  const auto crossings = [&](int i) { return count_crossings(cube(), views[i]); };
  for (const int outside : {0, 1}) {
    const CrossingCounts c = crossings(outside);
    CHECK(c.near + c.far + c.sides + c.w0 == 0);
  }
  CHECK(crossings(2).sides > 0);
  CHECK(crossings(3).near > 0);
  CHECK(crossings(4).w0 > 0);
  CHECK(crossings(5).near > 0);
  CHECK(crossings(5).far > 0);
}

TEST_CASE("make_views: a walk through any mesh has valid frusta and finite matrices") {
  const Mesh mesh = GENERATE(cube(), one_triangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
                             one_triangle({{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}}),
                             one_triangle({{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}}),
                             one_triangle({{{1e6f, 0, 0}, {1e6f, 1e-3f, 0}, {1e6f, 0, 1e-3f}}}),
                             one_triangle({{{0, -1e8f, 0}, {1e8f, 0, 0}, {0, 0, 1e8f}}}));
  CameraOptions options;
  options.walk = 25;
  const std::vector<View> views = make_views(mesh, options);
  CHECK(views.size() == 25);
  for (const View& view : views) {
    INFO(view.label);
    CHECK(is_valid(view.frustum));
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) CHECK(std::isfinite(view.view_from_world[column][row]));
    }
  }
}

TEST_CASE("make_views: near and far that are given are kept, and the other one fits") {
  CameraOptions options;
  options.near = 50.0;
  for (const View& view : make_views(cube(), options)) CHECK(view.frustum.near == 50);
  options.near.reset();
  options.far = 1e-3;
  for (const View& view : make_views(cube(), options)) CHECK(view.frustum.far == 1e-3f);
}

TEST_CASE("make_views: options that make no view are refused by their names") {
  const auto refused = [](auto change) {
    CameraOptions options;
    change(options);
    return message_of<UsageError>([&] { make_views(cube(), options); });
  };
  using O = CameraOptions;
  const glm::dvec3 p(1, 2, 3);
  CHECK(contains(refused([&](O& o) { o.eye = o.target = p; }), "--target: (1, 2, 3)"));
  CHECK(contains(refused([&](O& o) { o.eye = glm::dvec3(0); }), "--eye: (0, 0, 0)"));
  CHECK(contains(refused([&](O& o) { o.eye = glm::dvec3(0, 9, 0), o.up = glm::dvec3(0, 2, 0); }),
                 "--up: (0, 2, 0)"));
  CHECK(contains(refused([&](O& o) { o.up = glm::dvec3(0); }), "--up: (0, 0, 0)"));
  CHECK(contains(refused([&](O& o) { o.eye = glm::dvec3(NAN, 0, 0); }), "--eye: (nan, 0, 0)"));
  CHECK(contains(refused([&](O& o) { o.near = 0.0; }), "--near: 0 "));
  CHECK(contains(refused([&](O& o) { o.near = 2.0, o.far = 1.0; }), "--near: 2 "));
  CHECK(contains(refused([&](O& o) { o.far = -1.0; }), "--far: -1 "));
  CHECK(contains(refused([&](O& o) { o.fovy_degrees = 181; }), "--fovy: 181 "));
  CHECK(contains(refused([&](O& o) { o.walk = 0; }), "--walk: 0 "));
}

}  // namespace
}  // namespace clipscope::experiments
