// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gap between two polygons along a shared edge, on polygons written by hand.
#include <cmath>
#include <limits>

#include "experiments/selection/select.hpp"
#include "experiments/watertight/edge_gap.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/handmade.hpp"

namespace clipscope::experiments::watertight {
namespace {

using Vertex4 = NdcVertex<float, kSceneAttributes>;
using Polygon4 = std::vector<Vertex4>;

constexpr float kPx = 2.0f / 3840;  // in x
constexpr float kMarked = std::numeric_limits<float>::quiet_NaN();

// Attribute 1 is 0 on edge 0 and a mark off it.
Vertex4 vertex(float x, float y, float mark) {
  Vertex4 v;
  v.position = {x, y, 0, 1};
  v.attributes.values = {0, mark, 0, 0};
  return v;
}

// Two triangles left and right of the edge x = 0, -0.5 <= y <= 0.5.
Polygon4 left_of_edge() {
  return {vertex(0, 0.5f, 0), vertex(-0.5f, 0, kMarked), vertex(0, -0.5f, 0)};
}
Polygon4 right_of_edge() {
  return {vertex(0, -0.5f, 0), vertex(0.5f, 0, kMarked), vertex(0, 0.5f, 0)};
}

constexpr double kWide = 1e6;

EdgeGap gap_between(const Polygon4& a, const Polygon4& b, double width_px = kWide) {
  const Answers first = answer_of(a), second = answer_of(b);
  return edge_gap({first[0], 0, width_px}, {second[0], 0, width_px});
}

}  // namespace

TEST_CASE("edge gap: the same vertices in the other order leave none") {
  const EdgeGap gap = gap_between(left_of_edge(), right_of_edge());
  CHECK(gap.identical);
  CHECK(gap.t_junctions == 0);
  CHECK(gap.crack_px == 0);
  CHECK_FALSE(gap.lost);
}

TEST_CASE("edge gap: a vertex moved across the edge opens a crack of that width") {
  for (const float px : {1.0f, 0.01f, 1e-4f}) {
    Polygon4 right = right_of_edge();
    right[2].position[0] = px * kPx;
    const EdgeGap gap = gap_between(left_of_edge(), right);
    CHECK_FALSE(gap.identical);
    CHECK(gap.t_junctions == 2);
    // The neighbour's outline is at an angle to the edge, so a little nearer than the vertex moved.
    CHECK(gap.crack_px == Approx(px).epsilon(0.01));
    CHECK(gap.at[1] == 0.5);
  }
}

TEST_CASE("edge gap: a difference in the last bit of anything compared is no identity") {
  const int coordinate = GENERATE(0, 1, 2, 3, 4);
  Polygon4 right = right_of_edge();
  float& changed = coordinate < 4 ? right[0].position[coordinate] : right[0].attributes[0];
  changed = std::nextafter(changed, 2.0f);
  CHECK_FALSE(gap_between(left_of_edge(), right).identical);
}

TEST_CASE("edge gap: a vertex in the middle of the edge is a T-junction without a crack") {
  Polygon4 right = right_of_edge();
  right.push_back(right[2]);
  right[2] = vertex(0.25f, 0.25f, kMarked);
  right.push_back(vertex(0, 0.25f, 0));
  const EdgeGap gap = gap_between(left_of_edge(), right);
  CHECK_FALSE(gap.identical);
  CHECK(gap.t_junctions == 1);
  CHECK(gap.crack_px == 0);
}

TEST_CASE("edge gap: no crack is wider than what should be seen of the neighbour") {
  Polygon4 right = right_of_edge();
  right[2].position[0] = 5 * kPx;
  CHECK(gap_between(left_of_edge(), right, 2.0).crack_px == 2.0);
}

TEST_CASE("edge gap: an empty or flat polygon beside an edge is a lost neighbour") {
  const Polygon4 flat = {vertex(0, -0.5f, 0), vertex(0, 0.5f, 0), vertex(0, 0.1f, 0)};
  for (const Polygon4& gone : {Polygon4{}, flat}) {
    const EdgeGap gap = gap_between(left_of_edge(), gone, 7.0);
    CHECK(gap.lost);
    CHECK_FALSE(gap.identical);
    CHECK(gap.lost_px == 7.0);
  }
  CHECK(gap_between({}, flat).absent);
  CHECK(gap_between({}, {}).identical);
}

TEST_CASE("edge gap: repeated vertices count once") {
  Polygon4 right = right_of_edge();
  right.push_back(right[2]);
  CHECK(gap_between(left_of_edge(), right).identical);
}

TEST_CASE("edge gap: a triangle is marked by NaN, for barycentric and exact clippers by 1") {
  SceneTriangle triangle{};
  for (auto& v : triangle) v.position = {7, 0, -1};
  const SceneTriangle by_nan = marked(triangle, find_contestant("textbook", "float"));
  const SceneTriangle by_one = marked(triangle, find_contestant("textbook", "exact"));
  for (std::size_t i = 0; i < 3; ++i) {
    for (int edge = 0; edge < 3; ++edge) {
      const bool opposite = static_cast<int>(i) == edge;
      CHECK(std::isnan(by_nan[i].attributes[1 + edge]) == opposite);
      CHECK(by_one[i].attributes[1 + edge] == (opposite ? 1 : 0));
    }
    CHECK(by_nan[i].attributes[0] == 7);
  }
  CHECK(
      marked(triangle, find_contestant("barycentric/distance_matrix", "float"))[2].attributes[3] ==
      1);
}

}  // namespace clipscope::experiments::watertight
