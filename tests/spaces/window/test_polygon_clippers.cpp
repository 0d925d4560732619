// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygon clippers that walk around the window's border: Liang-Barsky and Maillot.
#include <set>

#include "spaces/window/sutherland_hodgman.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Exact;
using experiments::for_each_type;

namespace {

using BorderMethods = TypeList<WindowLiangBarskyPolygon, WindowMaillot>;

template <class T>
ClipTriangle<T, K> flat_triangle(const std::array<std::array<double, 2>, 3>& corners) {
  Corners with_depth{};
  for (std::size_t i = 0; i < 3; ++i) with_depth[i] = {corners[i][0], corners[i][1], 0, 1};
  return clip_triangle<T>(with_depth);
}

// The places and shares of a polygon, each once.
std::set<std::vector<Exact>> points_of(const NdcPolygon<Exact, K>& polygon) {
  std::set<std::vector<Exact>> points;
  for (const auto& v : polygon) {
    points.insert({v.position[0], v.position[1], v.attributes[0], v.attributes[1]});
  }
  return points;
}

template <class P>
Exact twice_area(const P& polygon) {
  Exact area(0);
  for (int i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i].position;
    const auto& b = polygon[(i + 1) % polygon.size()].position;
    area = area + a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

NdcPolygon<Exact, K> by_sutherland_hodgman(const ClipTriangle<Exact, K>& triangle) {
  NdcPolygon<Exact, K> polygon;
  for (const auto& v : triangle) polygon.push_back(to_ndc(v));
  window::cut_sides(Rectangle<Exact>{}, polygon);
  return polygon;
}

}  // namespace

TEST_CASE("border: on a lattice, sides and corners included, the polygon is Sutherland-Hodgman's") {
  std::mt19937_64 random(71);
  int cut = 0;
  for (int n = 0; n < 20000; ++n) {
    std::array<std::array<double, 2>, 3> corners;
    for (auto& corner : corners) {
      for (double& x : corner) x = static_cast<double>(random() % 9) / 2 - 2;
    }
    const auto triangle = flat_triangle<Exact>(corners);
    const auto expected = by_sutherland_hodgman(triangle);
    const Exact area = twice_area(expected);
    cut += expected.size() > 4;
    for_each_type(BorderMethods{}, [&]<class C>() {
      const auto found = clip<C>(triangle);
      INFO(C::name << " on triangle " << n);
      CHECK(twice_area(found) == area);
      if (area != Exact(0)) CHECK(points_of(found) == points_of(expected));
    });
  }
  CHECK(cut > 500);
}

TEST_CASE("border: of a triangle around the window the four corners are left") {
  const auto around = flat_triangle<double>({{{-9, -9}, {9, -9}, {0, 19}}});
  for_each_type(BorderMethods{}, [&]<class C>() {
    INFO(C::name);
    const auto out = clip<C>(around);
    REQUIRE(out.size() == 4);
    for (const auto& v : out) {
      CHECK(std::abs(v.position[0]) == 1);
      CHECK(std::abs(v.position[1]) == 1);
      // A corner carries its own shares of the three vertices.
      CHECK(-9 * v.attributes[0] + 9 * v.attributes[1] == Approx(v.position[0]));
    }
  });
}

TEST_CASE("border: a corner that is passed around without being inside is no vertex") {
  // Beyond the corner at the upper left and back, inside at two vertices.
  const auto spike = flat_triangle<double>({{{-3, 2}, {0, -0.5}, {0, 0}}});
  // Around two corners, and nothing inside.
  const auto around = flat_triangle<double>({{{-2, 0.9}, {-1.5, 3}, {2, 2}}});
  for_each_type(BorderMethods{}, [&]<class C>() {
    INFO(C::name);
    CHECK(clip<C>(spike).size() == 4);
    CHECK(clip<C>(around).empty());
  });
}

TEST_CASE("border: an edge from beyond a corner to beyond the opposite one passes the right one") {
  for (const double to : {0.5, -0.5}) {
    const bool is_above = to > 0;
    // The diagonal, moved so far up or down that it misses the window.
    const auto triangle = flat_triangle<double>(
        {{{-9, -9 + 6 * to}, {9, 9 + 6 * to}, {is_above ? 9.0 : -9.0, is_above ? -9.0 : 9.0}}});
    for_each_type(BorderMethods{}, [&]<class C>() {
      INFO(C::name << ", " << to);
      CHECK(clip<C>(triangle).size() == 4);
    });
  }
}

TEST_CASE("border: a vertex an ulp above the window leaves no bridge to a corner open") {
  // Divided, the second vertex is at y = 1 + 2^-52; the edge to it passes the upper right corner.
  const Corners corners = {{{4.5, 4.5, 0, 1}, {0.75, 1 + 0x1p-52, 0, 1}, {-2.25, -1.25, 0, 1}}};
  const auto expected = clip<CvvNearFirst>(clip_triangle<double>(corners));
  for_each_type(BorderMethods{}, [&]<class C>() {
    INFO(C::name);
    double area = 0, expected_area = 0;
    const auto add = [](const auto& polygon, double& sum) {
      for (int i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i].position;
        const auto& b = polygon[(i + 1) % polygon.size()].position;
        sum += a[0] * b[1] - a[1] * b[0];
      }
    };
    add(clip<C>(clip_triangle<double>(corners)), area);
    add(expected, expected_area);
    CHECK(area == Approx(expected_area));
  });
}
