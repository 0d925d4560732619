// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons of any size against the volume.
#include <cmath>
#include <limits>
#include <vector>

#include "spaces/homogeneous/polygon.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::AllScalars;
using experiments::Exact;
using experiments::for_each_type;

namespace {

const std::vector<ClipVolume> kVolumes = {
    {DepthRange::minus_one_to_one, false, 0},
    {DepthRange::reversed, false, 2},
    {DepthRange::zero_to_one, true, 0},
    {.open_sides = true},
};

// A planar convex polygon: points of a parabola's arc, in a plane through clip space.
std::vector<ClipVertex<Exact, K>> arc(int n, std::mt19937_64& random) {
  const auto base = clip_triangle<Exact>(random_corners(random, 2));
  std::vector<ClipVertex<Exact, K>> polygon;
  for (int i = 0; i < n; ++i) {
    const Exact s = Exact(2 * i) / Exact(n - 1) - Exact(1);
    const auto on_edge = interpolate<Space::clip, Exact, K>(base[0], base[1], s);
    ClipVertex<Exact, K> v = on_edge;
    for (int c = 0; c < 4; ++c) {
      v.position[c] = on_edge.position[c] + s * s * (base[2].position[c] - base[0].position[c]);
    }
    polygon.push_back(v);
  }
  return polygon;
}

template <class P>
Exact twice_area(const P& polygon) {
  Exact area(0);
  const auto n = polygon.size();
  for (decltype(polygon.size()) i = 0; i < n; ++i) {
    const auto& a = polygon[i].position;
    const auto& b = polygon[(i + 1) % n].position;
    area = area + Exact(a[0] * b[1]) - Exact(a[1] * b[0]);
  }
  return area;
}

}  // namespace

TEST_CASE("polygons: three vertices give the bits of the triangle clipper") {
  std::mt19937_64 random(71);
  for_each_type(AllScalars{}, [&]<class T>() {
    INFO(experiments::kFormat<T>.name);
    HomogeneousPolygonClipper<T, K> clip;
    for (int n = 0; n < 400; ++n) {
      const auto triangle =
          clip_triangle<T>(n % 2 == 0 ? lattice_corners(random) : random_corners(random, 3));
      for (const ClipVolume& volume : kVolumes) {
        NdcPolygon<T, K> expected;
        HomogeneousSutherlandHodgman{}(volume, triangle, expected);
        CHECK(same_polygon<T>(clip(volume, triangle), vertices(expected)));
      }
    }
  });
}

TEST_CASE(
    "polygons: three vertices give the bits of the triangle clipper for extreme numbers, too") {
  using Limits = std::numeric_limits<float>;
  const std::array<double, 11> specials = {0.0f,
                                           -0.0f,
                                           1.0f,
                                           -1.0f,
                                           Limits::denorm_min(),
                                           Limits::min(),
                                           Limits::max(),
                                           -Limits::max(),
                                           Limits::infinity(),
                                           -Limits::infinity(),
                                           Limits::quiet_NaN()};
  std::mt19937_64 random(72);
  HomogeneousPolygonClipper<float, K> clip;
  for (int n = 0; n < 5000; ++n) {
    Corners corners = lattice_corners(random);
    for (int i = 0; i < 3; ++i) {
      corners[random() % 3][random() % 4] = specials[random() % specials.size()];
    }
    const auto triangle = clip_triangle<float>(corners);
    for (const ClipVolume& volume : {ClipVolume{}, kVolumes[1]}) {
      NdcPolygon<float, K> expected;
      HomogeneousSutherlandHodgman{}(volume, triangle, expected);
      CHECK(same_polygon<float>(clip(volume, triangle), vertices(expected)));
    }
  }
}

TEST_CASE("polygons: the part inside has the area of the parts of its fan") {
  std::mt19937_64 random(73);
  HomogeneousPolygonClipper<Exact, K> clip;
  int cut = 0;
  for (int n = 0; n < 60; ++n) {
    const auto polygon = arc(4 + n % 30, random);
    Exact expected(0);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      NdcPolygon<Exact, K> part;
      HomogeneousSutherlandHodgman{}(ClipVolume{}, {polygon[0], polygon[i - 1], polygon[i]}, part);
      expected = expected + twice_area(part);
    }
    const auto found = clip(ClipVolume{}, polygon);
    CHECK(twice_area(found) == expected);
    cut += expected == Exact(0) ? 0 : 1;
  }
  CHECK(cut > 20);
}

TEST_CASE(
    "polygons: a hundred vertices inside come out as they are, in the same memory each time") {
  HomogeneousPolygonClipper<double, K> clip;
  std::vector<ClipVertex<double, K>> circle(100);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const double angle = static_cast<double>(i) * 2 * 3.14159 / 100;
    circle[i].position = Vec4<double>(std::cos(angle), std::sin(angle), 0, 2);
    circle[i].attributes.values = {1, 2, 3};
  }
  const auto first = clip(ClipVolume{}, circle);
  REQUIRE(first.size() == 100);
  CHECK(first[7].position[0] == circle[7].position[0] / 2);
  const auto* memory = first.data();
  for (auto& v : circle) v.position[3] = 0.8;
  const auto second = clip(ClipVolume{}, circle);
  CHECK(second.size() > 4);
  CHECK(second.data() == memory);
}

TEST_CASE("polygons: view space gives what its projection gives") {
  HomogeneousPolygonClipper<float, K> clip, clip_projected;
  std::mt19937_64 random(74);
  const Projection<float> projection{Frustum<float>{}};
  for (int n = 0; n < 200; ++n) {
    const auto view = view_triangle<float>(random_corners(random, 4));
    const auto projected = to_clip(projection, view);
    const auto a = clip(projection, view);
    const auto b = clip_projected(projection.volume, projected);
    CHECK(same_polygon<float>(a, b));
  }
}

TEST_CASE("polygons: fewer than three vertices are nothing") {
  HomogeneousPolygonClipper<float, K> clip;
  const auto triangle = clip_triangle<float>({{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}});
  const std::span<const ClipVertex<float, K>> vertices = triangle;
  CHECK(clip(ClipVolume{}, vertices.first(0)).empty());
  CHECK(clip(ClipVolume{}, vertices.first(2)).empty());
  CHECK(clip(ClipVolume{}, vertices).size() == 3);
}
