// SPDX-License-Identifier: GPL-3.0-or-later
#include "spaces/cut.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;

namespace {

ClipPolygon<double, K> cut_x_positive(const Corners& corners) {
  ClipPolygon<double, K> in, out;
  in.assign(clip_triangle<double>(corners));
  cut(in, out, [](const ClipVertex<double, K>& v) { return v.position[0]; });
  return out;
}

}  // namespace

TEST_CASE("cut: one vertex outside leaves four, in order") {
  const auto out = cut_x_positive({{{-1, 0, 0, 1}, {1, 0, 0, 1}, {1, 2, 0, 1}}});
  REQUIRE(out.size() == 4);
  // The edge from vertex 2 to vertex 0 crosses at its middle, the edge from 0 to 1 as well.
  CHECK(out[0].position == Vec4<double>(0, 1, 0, 1));
  CHECK(out[1].position == Vec4<double>(0, 0, 0, 1));
  CHECK(out[2].position == Vec4<double>(1, 0, 0, 1));
  CHECK(out[3].position == Vec4<double>(1, 2, 0, 1));
  CHECK(out[0].attributes.values == std::array<double, 3>{0.5, 0, 0.5});
}

TEST_CASE("cut: two vertices outside leave three") {
  CHECK(cut_x_positive({{{-1, 0, 0, 1}, {1, 0, 0, 1}, {-1, 2, 0, 1}}}).size() == 3);
}

TEST_CASE("cut: a vertex on the plane is kept once, and makes no new vertex") {
  CHECK(cut_x_positive({{{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 2, 0, 1}}}).size() == 3);
  CHECK(cut_x_positive({{{0, 0, 0, 1}, {-1, 0, 0, 1}, {-1, 2, 0, 1}}}).size() == 1);
  CHECK(cut_x_positive({{{0, 0, 0, 1}, {0, 3, 0, 1}, {-1, 2, 0, 1}}}).size() == 2);
  CHECK(cut_x_positive({{{0, 0, 0, 1}, {1, 0, 0, 1}, {-1, 2, 0, 1}}}).size() == 3);
}

TEST_CASE("cut: neighbours of a shared edge compute the same bits") {
  const std::array<double, 4> a = {-0.3, 0.7, 0.1, 1}, b = {0.9, -0.2, 0.6, 1.7};
  const auto one = cut_x_positive({{a, b, {0.5, 3, 0, 1}}});
  const auto other = cut_x_positive({{b, a, {-0.5, -3, 0, 1}}});
  int shared = 0;
  for (const auto& v : one) {
    for (const auto& w : other) shared += v.position == w.position ? 1 : 0;
  }
  CHECK(shared == 2);  // b, and the new vertex
}

TEST_CASE("cut: a polygon that runs full drops vertices and says so") {
  ClipPolygon<double, K> polygon;
  const auto triangle = clip_triangle<double>({{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}});
  for (int i = 0; i < kMaxPolygonVertices; ++i) polygon.push_back(triangle[0]);
  CHECK_FALSE(polygon.overflowed());
  polygon.push_back(triangle[0]);
  CHECK(polygon.overflowed());
  CHECK(polygon.size() == kMaxPolygonVertices);
}
