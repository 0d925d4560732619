// SPDX-License-Identifier: GPL-3.0-or-later
//
// What published variants of Sutherland-Hodgman in clip space have beside the contract.
#include <cmath>

#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;

namespace {

constexpr auto kDepths = {DepthRange::minus_one_to_one, DepthRange::zero_to_one,
                          DepthRange::reversed};

// The edge from corner 0 to corner 1 goes from y = 2^20 to 0.22, just beyond the right plane.
const Corners kUneven = {
    {{0, 0x1p20, 0, 0x1p21}, {0.5 + 0x1p-20, 0.21875 + 0x1p-10, 0, 0.5}, {0, 0, 0, 0.5}}};

// How far y is from where it should be, where the edge from corner 0 is cut, just before corner 1.
template <class C>
double error_at_the_cut() {
  double error = 0x1p20;
  const auto triangle = clip_triangle<float>(kUneven);
  for (const ClipVertex<float, K>& v : C::cut({}, triangle)) {
    if (v.attributes[1] > 0.5f && v.attributes[2] == 0) {
      const double share = (0x1p21 / (0x1p21 + 0x1p-20));
      const double exact = 0x1p20 + share * (kUneven[1][1] - 0x1p20);
      error = std::abs(v.position[1] - exact);
    }
  }
  return error;
}

}  // namespace

// Corners anywhere, on a lattice of planes, and an ulp beside it.
Corners some_corners(std::mt19937_64& random, int n) {
  if (n % 3 == 0) return random_corners(random, 3);
  Corners corners = lattice_corners(random);
  if (n % 3 == 2) {
    for (auto& corner : corners) {
      for (double& x : corner) {
        x = std::nextafter(static_cast<float>(x), random() % 2 == 0 ? 9.0f : -9.0f);
      }
    }
  }
  return corners;
}

TEST_CASE("mcguire: register-only clipping has the bits of Sutherland-Hodgman") {
  std::mt19937_64 random(61);
  int largest = 0;
  for (int n = 0; n < 60000; ++n) {
    const auto triangle = clip_triangle<float>(some_corners(random, n));
    for (const DepthRange depth : kDepths) {
      const auto expected = clip<HomogeneousSutherlandHodgman>(triangle, ClipVolume{depth});
      const auto found = clip<HomogeneousMcGuire>(triangle, ClipVolume{depth});
      if (!same_cycle(found, expected)) FAIL("triangle " << n);
      largest = std::max(largest, expected.size());
    }
  }
  CHECK(largest >= 7);
}

TEST_CASE("mcguire: a vertex on the plane makes no second copy of itself") {
  const Corners touching = {{{1, 0, 0, 1}, {2, 0.5, 0, 1}, {0, 0.5, 0, 1}}};
  const Corners only_touching = {{{1, 0, 0, 1}, {2, 0.5, 0, 1}, {2, -0.5, 0, 1}}};
  CHECK(clip<HomogeneousMcGuire>(clip_triangle<double>(touching)).size() == 3);
  CHECK(clip<HomogeneousMcGuire>(clip_triangle<double>(only_touching)).empty());
}

TEST_CASE("nearer end: a cut next to the outside end has what that end has") {
  CHECK(error_at_the_cut<HomogeneousSutherlandHodgman>() < 0x1p-20);
  CHECK(error_at_the_cut<HomogeneousFromOutside>() < 0x1p-20);
  CHECK(error_at_the_cut<HomogeneousFromInside>() > 0x1p-6);
}

TEST_CASE("nearer end: a cut next to the inside end is made from that end") {
  const Corners corners = {{{0.75, 0.3, 0.1, 1}, {4, -0.7, 0.2, 1.5}, {0.5, -0.3, 0.7, 0.9}}};
  const auto triangle = clip_triangle<float>(corners);
  CHECK(same_polygon(clip<HomogeneousSutherlandHodgman>(triangle),
                     clip<HomogeneousFromInside>(triangle)));
  CHECK_FALSE(same_polygon(clip<HomogeneousFromOutside>(triangle),
                           clip<HomogeneousSutherlandHodgman>(triangle)));
}

TEST_CASE("weighted ends: where a product of two coordinates overflows the polygon is the same") {
  const Corners corners = {{{0, 0, 0, 1}, {3, 0, 0, 1}, {0, 0.5, 0, 1}}};
  const auto expected = clip<HomogeneousWeightedEnds>(clip_triangle<float>(corners));
  REQUIRE(expected.size() == 4);
  for (const double scale : {0x1p70, 0x1p-120}) {
    Corners scaled = corners;
    for (auto& corner : scaled) {
      for (double& x : corner) x *= scale;
    }
    const auto found = clip<HomogeneousWeightedEnds>(clip_triangle<float>(scaled));
    REQUIRE(found.size() == 4);
    for (int i = 0; i < 4; ++i) {
      for (int c = 0; c < 3; ++c) CHECK(found[i].position[c] == expected[i].position[c]);
    }
  }
}

TEST_CASE("opposite planes: both cuts of an edge are made from its own ends") {
  // The lower edge goes from beyond the left plane to beyond the right one, and so does its
  // attribute 0 from 1 to 0: it meets them at 3/4 and 1/4.
  const Corners across = {{{-2, -0.5, 0, 1}, {2, -0.5, 0, 1}, {0, 0.5, 0, 1}}};
  const auto out = clip<HomogeneousOppositePlanes>(clip_triangle<double>(across));
  REQUIRE(out.size() == 5);
  CHECK(out[1].attributes[0] == 0.75);
  CHECK(out[2].attributes[0] == 0.25);
}

TEST_CASE("opposite planes: a triangle around the eye is cut by w before two planes at once") {
  // w is negative at one vertex and left and right are both crossed: between them lies w = 0.
  const Corners corners = {{{-3, 0.5, 0, 1}, {3, 0.5, 0, 1}, {0.25, -0.5, 0.25, -1}}};
  const auto out = clip<HomogeneousOppositePlanes>(clip_triangle<double>(corners));
  const auto expected = clip<HomogeneousSutherlandHodgman>(clip_triangle<double>(corners));
  REQUIRE(out.size() == expected.size());
  for (const auto& v : out) CHECK(v.position[3] > 0);
}
