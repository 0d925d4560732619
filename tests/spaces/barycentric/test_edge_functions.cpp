// SPDX-License-Identifier: GPL-3.0-or-later
#include "spaces/barycentric/edge_functions.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Exact;

namespace {

// The point of the triangle with the weights l0 : l1 : l2.
Vec4<Exact> point(const ClipTriangle<Exact, K>& t, const std::array<int, 3>& weights) {
  Vec4<Exact> p(Exact(0), Exact(0), Exact(0), Exact(0));
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 4; ++c) {
      const Exact sum = p[c] + Exact(weights[i]) * t[i].position[c];
      p[c] = sum;
    }
  }
  return p;
}

}  // namespace

TEST_CASE("edge functions: at the picture of a point they are its weights over w") {
  std::mt19937_64 random(1);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const auto t = clip_triangle<Exact>(lattice_corners(random));
    const auto e = edge_functions(t[0].position, t[1].position, t[2].position);
    const std::array<int, 3> weights = {1, 2, 4};
    const Vec4<Exact> p = point(t, weights);
    const bool has_area =
        !(e.edges[0].c == Exact(0) && e.edges[1].c == Exact(0) && e.edges[2].c == Exact(0) &&
          e.edges[0].a == Exact(0) && e.edges[1].a == Exact(0) && e.edges[2].a == Exact(0));
    if (p[3] == Exact(0) || !has_area) continue;
    ++tried;
    const Exact x = p[0] / p[3], y = p[1] / p[3], inv_w = Exact(1) / p[3], z = p[2] / p[3];
    for (std::size_t v = 0; v < 3; ++v) CHECK(e.edges[v].at(x, y) == Exact(weights[v]) / p[3]);
    // 1/w is that of the point sum l_i v_i over sum l_i = 7.
    CHECK(e.over_w(Exact(1), Exact(1), Exact(1)).at(x, y) == Exact(7) * inv_w);
    CHECK(e.over_w(t[0].position[2], t[1].position[2], t[2].position[2]).at(x, y) == z);
  }
  CHECK(tried > 150);
}

TEST_CASE("edge functions: a triangle without area on the screen has none") {
  const Vec4<float> a(0, 0, 0, 1), b(1, 1, 0, 1), c(2, 2, 0, 1);
  for (const auto& edge : edge_functions(a, b, c).edges) CHECK(edge.at(0.5f, 0.5f) == 0);
}

TEST_CASE("edge functions: a vertex behind the eye does not cover its mirror image") {
  // The third vertex would be seen at (0, -1) if it were divided.
  const Vec4<float> a(-1, 0, 0, 1), b(1, 0, 0, 1), c(0, 1, 0, -1);
  const auto e = edge_functions(a, b, c);
  const auto covers = [&](float x, float y) {
    const auto& [e0, e1, e2] = e.edges;
    return e0.at(x, y) >= 0 && e1.at(x, y) >= 0 && e2.at(x, y) >= 0;
  };
  CHECK_FALSE(covers(0, -0.5f));
  CHECK(covers(0, 0.5f));
}
