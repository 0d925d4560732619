// SPDX-License-Identifier: GPL-3.0-or-later
//
// The teapot against what is known of it, and against Newell's numbers where they can be read off.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using Point = std::array<float, 3>;

bool has_vertex(const Mesh& mesh, const Point& wanted) {
  return std::ranges::any_of(mesh.positions, [&](const Point& p) {
    return std::abs(p[0] - wanted[0]) < 1e-6f && std::abs(p[1] - wanted[1]) < 1e-6f &&
           std::abs(p[2] - wanted[2]) < 1e-6f;
  });
}

// Edges by position that have a triangle on one side only.
std::vector<std::pair<Point, Point>> border_edges(const Mesh& mesh) {
  std::map<std::pair<Point, Point>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++edges[{mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]}];
  }
  std::vector<std::pair<Point, Point>> border;
  for (const auto& [edge, count] : edges) {
    CHECK(count == 1);
    if (!edges.contains({edge.second, edge.first})) border.push_back(edge);
  }
  return border;
}

double signed_volume(const Mesh& mesh) {
  double six_volumes = 0;
  for (const auto& t : mesh.triangles) {
    const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    six_volumes += a[0] * (double{b[1]} * c[2] - double{b[2]} * c[1]) -
                   a[1] * (double{b[0]} * c[2] - double{b[2]} * c[0]) +
                   a[2] * (double{b[0]} * c[1] - double{b[1]} * c[0]);
  }
  return six_volumes / 6;
}

TEST_CASE("teapot: 32 patches of n x n quads, less the 8 n triangles that collapse at the poles") {
  const int n = GENERATE(1, 2, 5, 10);
  CHECK(teapot_mesh(n).triangles.size() == static_cast<std::size_t>(32 * 2 * n * n - 8 * n));
}

TEST_CASE("teapot: handle to spout, height and width are Newell's") {
  const Box box = bounding_box(teapot_mesh(10));
  // The spout's lip bulges a little over its control points' 3.43 towards 3.525.
  CHECK(box.lo.x == -3.0);
  CHECK(std::abs(box.hi.x - 3.434) < 1e-3);
  CHECK(box.lo.y == 0.0);
  CHECK(box.hi.y == double{3.15f});
  CHECK(box.lo.z == -2.0);
  CHECK(box.hi.z == 2.0);
}

TEST_CASE("teapot: corners of the patches are points of the published table") {
  const Mesh mesh = teapot_mesh(4);
  // Newell's (x, y, z) is our (x, z, -y).
  const auto newell = [](float x, float y, float z) { return Point{x, z, -y}; };
  const Point corner = GENERATE_COPY(
      newell(1.4f, 0, 2.4f), newell(0, -1.4f, 2.4f), newell(-1.5f, 0, 2.4f), newell(0, 2, 0.9f),
      newell(1.5f, 0, 0.15f), newell(0, 0, 3.15f), newell(0.2f, 0, 2.7f), newell(0, 1.3f, 2.4f),
      newell(0, 0, 0), newell(-1.6f, 0, 2.025f), newell(-1.5f, 0, 2.25f), newell(-3, 0, 1.8f),
      newell(-1.9f, 0, 0.6f), newell(1.7f, 0, 0.6f), newell(2.7f, 0, 2.4f), newell(3.2f, 0, 2.4f));
  CHECK(has_vertex(mesh, corner));
}

TEST_CASE("teapot: patches meet bit for bit, and only the six open rims are borders") {
  const int n = 6;
  const auto border = border_edges(teapot_mesh(n));
  // Rim and lid: a full circle of 4 n edges each; both ends of handle and spout: 2 n edges each.
  CHECK(border.size() == static_cast<std::size_t>(2 * 4 * n + 4 * 2 * n));
}

TEST_CASE("teapot: the outside is in front, so the volume is positive") {
  const double volume = signed_volume(teapot_mesh(10));
  CHECK((25 < volume && volume < 26.5));
}

TEST_CASE("teapot: normals are unit vectors on the side of the triangle's winding") {
  const Mesh mesh = teapot_mesh(10);
  for (const auto& t : mesh.triangles) {
    const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const std::array<float, 3> p = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const std::array<float, 3> q = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const double nx = p[1] * q[2] - p[2] * q[1], ny = p[2] * q[0] - p[0] * q[2];
    const double nz = p[0] * q[1] - p[1] * q[0];
    const auto& attributes = mesh.attributes[t[0]];
    const double along = nx * attributes[2] + ny * attributes[3];
    const double rest =
        1 - double{attributes[2]} * attributes[2] - double{attributes[3]} * attributes[3];
    CHECK(rest > -1e-6);
    // The attributes hold the normal's x and y; its z has either sign.
    CHECK(along + std::abs(nz) * std::sqrt(std::max(rest, 0.0)) > 0);
  }
}

}  // namespace
}  // namespace clipscope::experiments
