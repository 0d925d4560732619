// SPDX-License-Identifier: MIT
//
// Clips one triangle with the installed clippers and checks the polygon by hand.
#include <cstdio>
#include <spaces/clippers.hpp>

int main() {
  using namespace clipscope;
  // Field of view 90 degrees: at z = -2 the volume reaches from -2 to 2.
  const Projection<float> projection(Frustum<float>{});
  // The right end of the triangle is cut off by x <= 2, halfway along both edges.
  const ViewTriangle<float, 1> triangle = {{{{0, -1, -2}, {{0}}},  //
                                            {{4, 0, -2}, {{1}}},   //
                                            {{0, 1, -2}, {{0}}}}};
  NdcPolygon<float, 1> polygon;
  HomogeneousSutherlandHodgman{}(projection, triangle, polygon);

  const float expected[4][2] = {{0, -0.5f}, {1, -0.25f}, {1, 0.25f}, {0, 0.5f}};
  int matches = 0;
  for (const NdcVertex<float, 1>& v : polygon) {
    for (const auto& e : expected) {
      const bool right_attribute = v.attributes[0] == (e[0] == 1 ? 0.5f : 0.0f);
      matches += v.position[0] == e[0] && v.position[1] == e[1] && v.position[3] == 0.5f &&
                 right_attribute;
    }
  }
  std::printf("%d vertices, %d as expected\n", polygon.size(), matches);
  return polygon.size() == 4 && matches == 4 ? 0 : 1;
}
