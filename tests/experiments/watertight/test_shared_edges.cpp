// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which edges triangles share, and which of them clipping touches.
#include "experiments/scenes/builtin.hpp"
#include "experiments/watertight/shared_edges.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::watertight {
namespace {

// Two triangles in view space with corners 0 1 2 and 1 0 3, as seen by the identity view with the
// sides |x| <= |z|, |y| <= |z|, near 1, far 100.
Scene quad(const std::array<std::array<float, 3>, 4>& corners) {
  Scene scene;
  for (const auto& p : corners) add_vertex(scene.mesh, {p[0], p[1], p[2]}, {});
  scene.mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  View view = identity_view();
  view.frustum.left = view.frustum.bottom = -1;
  view.frustum.right = view.frustum.top = view.frustum.near = 1;
  view.frustum.far = 100;
  scene.views = {view};
  return scene;
}

std::vector<CutEdge> cut_in(const Scene& scene) {
  return cut_edges(scene, scene.views.front(), shared_edges(scene.mesh), 0);
}

}  // namespace

TEST_CASE("shared edges: a quad has one, opposite to the corners that are not shared") {
  const auto edges = shared_edges(quad({{{0, 0, -2}, {1, 0, -2}, {0, 1, -2}, {0, -1, -2}}}).mesh);
  REQUIRE(edges.size() == 1);
  CHECK(edges[0].triangles == std::array<std::uint32_t, 2>{0, 1});
  CHECK(edges[0].opposite == std::array{2, 2});
}

TEST_CASE("shared edges: equal positions are shared whatever their indices, zeros of either sign") {
  Scene scene = quad({{{0, 0, -2}, {1, 0, -2}, {0, 1, -2}, {0, -1, -2}}});
  const std::uint32_t a = add_vertex(scene.mesh, {-0.0, 0, -2}, {1, 1, 1, 1});
  const std::uint32_t b = add_vertex(scene.mesh, {1, 0, -2}, {1, 1, 1, 1});
  scene.mesh.triangles[1] = {b, a, 3};
  CHECK(shared_edges(scene.mesh).size() == 1);
  scene.mesh.positions[b][0] = 1.0000001f;
  CHECK(shared_edges(scene.mesh).empty());
}

TEST_CASE(
    "shared edges: an edge without length is none; a third triangle is paired with the first") {
  Scene scene = quad({{{0, 0, -2}, {1, 0, -2}, {0, 1, -2}, {0, -1, -2}}});
  scene.mesh.triangles.push_back({0, 0, 1});
  scene.mesh.triangles.push_back({0, 1, 3});
  for (const SharedEdge& e : shared_edges(scene.mesh)) CHECK(e.triangles[0] != e.triangles[1]);
  scene.mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 3}};
  const auto edges = shared_edges(scene.mesh);
  CHECK(edges[0].triangles[0] == 0);
}

TEST_CASE("shared edges: a closed mesh has one and a half per triangle") {
  // A tetrahedron: 4 triangles, 6 edges.
  Mesh mesh;
  for (const glm::dvec3 p : {glm::dvec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    add_vertex(mesh, p, {});
  }
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  CHECK(shared_edges(mesh).size() == 6);
}

TEST_CASE("cut edges: nothing is cut of what is all inside or all outside one plane") {
  CHECK(cut_in(quad({{{0, 0, -2}, {1, 0, -2}, {0, 1, -2}, {0, -1, -2}}})).empty());
  CHECK(cut_in(quad({{{5, 0, -2}, {6, 0, -2}, {0, 1, -2}, {0, -1, -2}}})).empty());
}

TEST_CASE("cut edges: the planes that cut an edge are those that its ends are outside of") {
  const auto cut = cut_in(quad({{{0, 0, -2}, {5, 0, -2}, {0, 1, -2}, {0, -1, -2}}}));
  REQUIRE(cut.size() == 1);
  CHECK(cut[0].planes == bit(Plane::right));
  CHECK_FALSE(cut[0].different_neighbours);
  // One neighbour also reaches through the top.
  const auto more = cut_in(quad({{{0, 0, -2}, {5, 0, -2}, {0, 9, -2}, {0, -1, -2}}}));
  REQUIRE(more.size() == 1);
  CHECK(more[0].planes == bit(Plane::right));
  CHECK(more[0].different_neighbours);
}

TEST_CASE("cut edges: an edge inside counts if a neighbour is cut") {
  const auto cut = cut_in(quad({{{0, 0, -2}, {1, 0, -2}, {0, 9, -2}, {0, -1, -2}}}));
  REQUIRE(cut.size() == 1);
  CHECK(cut[0].planes == 0);
}

TEST_CASE("cut edges: an edge in a plane, or visible in one point only, does not count") {
  CHECK(cut_in(quad({{{2, 0, -2}, {2, 1, -2}, {9, 0, -2}, {0, 0, -2}}})).empty());
  CHECK(cut_in(quad({{{2, 0, -2}, {9, 1, -2}, {0, 5, -2}, {0, -5, -2}}})).empty());
}

TEST_CASE("cut edges: the width beside an edge is that of the visible part, in px") {
  // At a depth of 2 the window is 4 units, 3840 px wide and 2160 px high.
  const auto cut = cut_in(quad({{{0, 0, -2}, {5, 0, -2}, {0, 1, -2}, {0, -9, -2}}}));
  REQUIRE(cut.size() == 1);
  CHECK(cut[0].width_px[0] == Approx(540));
  CHECK(cut[0].width_px[1] == Approx(1080));
}

TEST_CASE("cut edges: at most so many remain, evenly spaced from the first on; 0 leaves all") {
  const std::vector<int> items = {0, 1, 2, 3, 4, 5, 6};
  CHECK(at_most(0, items) == items);
  CHECK(at_most(3, items) == std::vector<int>{0, 3, 6});
}

}  // namespace clipscope::experiments::watertight
