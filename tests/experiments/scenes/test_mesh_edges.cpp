// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with the edges of a mesh before anybody clips, on meshes made by hand.
#include <cmath>

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/mesh_edges.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

Mesh mesh_of(const std::vector<glm::dvec3>& positions,
             std::vector<std::array<std::uint32_t, 3>> triangles) {
  Mesh mesh;
  for (const glm::dvec3& p : positions) add_vertex(mesh, p, {});
  mesh.triangles = std::move(triangles);
  return mesh;
}

// A triangle below the x axis whose upper edge is 0 to 3, and two above it that meet at `middle`.
Mesh t_junction(const glm::dvec3& middle) {
  return mesh_of({{0, 0, 0}, {3, 0, 0}, {1, -1, 0}, middle, {0, 1, 0}, {3, 1, 0}},
                 {{1, 0, 2}, {0, 3, 4}, {3, 1, 5}});
}

}  // namespace

TEST_CASE("mesh edges: a closed mesh has none that may crack") {
  const MeshEdges edges = edges_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  CHECK(edges.edges == 6);
  CHECK(edges.open == 0);
  CHECK_FALSE(edges.may_crack());
  CHECK(crack_text(edges).empty());
}

TEST_CASE("mesh edges: a vertex within another triangle's edge is a T-junction") {
  const MeshEdges exact = edges_of(t_junction({1, 0, 0}));
  CHECK(exact.t_junctions == 1);
  CHECK(exact.t_distance == 0);
  CHECK(crack_text(exact) == "1 T-junction, up to 0 off the edge");
}

TEST_CASE("mesh edges: rounding may take a T-junction off its edge, but no farther") {
  const double r = std::sqrt(3.0) * 0x1p-23 * 3;
  const MeshEdges rounded = edges_of(t_junction({1, 0.9 * r, 0}));
  CHECK(rounded.t_junctions == 1);
  CHECK(rounded.t_distance == Approx(0.9 * r));
  CHECK(edges_of(t_junction({1, 1.1 * r, 0})).t_junctions == 0);
}

TEST_CASE("mesh edges: the ends of an edge are no T-junctions of it") {
  CHECK(edges_of(t_junction({0, 0, 0})).t_junctions == 0);
  CHECK(edges_of(t_junction({3, 0x1p-24, 0})).t_junctions == 0);
}

TEST_CASE("mesh edges: seams of attributes are none, vertices moved by an ulp split the edge") {
  Mesh quad = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                      {{0, 1, 2}, {3, 5, 4}});
  CHECK(edges_of(quad).edges == 5);
  CHECK_FALSE(edges_of(quad).may_crack());
  quad.positions[4][0] = std::nextafter(1.0f, 2.0f);
  const MeshEdges split = edges_of(quad);
  CHECK(split.edges == 6);
  CHECK(split.split == 2);
  CHECK(crack_text(split) == "2 open edges beside another one that is the same but for rounding");
}

TEST_CASE("mesh edges: a third triangle at an edge, and a triangle given again, are counted") {
  const MeshEdges edges = edges_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 0, 1}}));
  CHECK(edges.crowded == 1);
  CHECK(edges.repeated_triangles == 1);
  CHECK(crack_text(edges) == "1 edge of more than two triangles; 1 triangle given again");
}

TEST_CASE("mesh edges: a mesh of more vertices than are sorted at once is counted whole") {
  constexpr std::uint32_t n = 600;  // squares a side
  std::vector<glm::dvec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
    positions.emplace_back(i % (n + 1), i / (n + 1), 0);
    if (i % (n + 1) == n || i / (n + 1) == n) continue;
    triangles.push_back({i, i + 1, i + n + 2});
    triangles.push_back({i, i + n + 2, i + n + 1});
  }
  const MeshEdges edges = edges_of(mesh_of(positions, triangles));
  CHECK(edges.edges == 3 * n * n + 2 * n);
  CHECK(edges.open == 4 * n);
  CHECK_FALSE(edges.may_crack());
}

TEST_CASE("mesh edges: a mesh without triangles has none") { CHECK(edges_of({}).edges == 0); }

}  // namespace clipscope::experiments
