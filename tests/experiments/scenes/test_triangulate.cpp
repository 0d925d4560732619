// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/flatness.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using Catch::Contains;

namespace {

using Point3 = std::array<double, 3>;
using Point4 = std::array<double, 4>;
using Point2 = std::array<double, 2>;

// On the plane z = x - 2 y + 1: exact for small numbers.
std::vector<Point3> on_plane(const std::vector<Point2>& points) {
  std::vector<Point3> r;
  for (const Point2& p : points) r.push_back({p[0], p[1], p[0] - 2 * p[1] + 1});
  return r;
}

double twice_area(const std::vector<Point2>& points) {
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 &p = points[i], &q = points[(i + 1) % points.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return area;
}

// Each triangle has the polygon's winding and the areas add up: they tile it.
void check_tiles(const std::vector<Point2>& polygon, const std::vector<IndexTriangle>& triangles) {
  REQUIRE(triangles.size() == polygon.size() - 2);
  const double whole = twice_area(polygon);
  double sum = 0;
  for (const IndexTriangle& t : triangles) {
    std::vector<Point2> corners;
    for (const int i : t) corners.push_back(polygon.at(static_cast<std::size_t>(i)));
    const double area = twice_area(corners);
    CHECK(area * whole > 0);
    sum += area;
  }
  CHECK(sum == whole);
}

const std::vector<Point2> kComb = {{0, 0}, {7, 0}, {7, 4}, {6, 1}, {5, 4},
                                   {4, 1}, {3, 4}, {2, 1}, {1, 4}, {0, 1}};

std::vector<Point2> reversed(std::vector<Point2> points) {
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

TEST_CASE("triangulate: a concave polygon is tiled by n - 2 triangles in its winding") {
  check_tiles(kComb, triangulate(on_plane(kComb)));
  check_tiles(reversed(kComb), triangulate(on_plane(reversed(kComb))));
}

TEST_CASE("triangulate: vertices in the middle of a straight edge are used, too") {
  const std::vector<Point2> polygon = {{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 2}, {1, 1}};
  check_tiles(polygon, triangulate(on_plane(polygon)));
}

TEST_CASE("triangulate: every edge of the polygon belongs to one triangle") {
  const auto triangles = triangulate(on_plane(kComb));
  for (int i = 0; i < static_cast<int>(kComb.size()); ++i) {
    const int next = (i + 1) % static_cast<int>(kComb.size());
    int found = 0;
    for (const IndexTriangle& t : triangles) {
      for (std::size_t e = 0; e < 3; ++e) found += t[e] == i && t[(e + 1) % 3] == next ? 1 : 0;
    }
    CHECK(found == 1);
  }
}

TEST_CASE("triangulate: polygons seen edge-on from some axes are projected along another") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Point3> points;
    for (const Point2& p : kComb) {
      Point3 q = {};
      q[axis] = 5;
      q[(axis + 1) % 3] = p[0];
      q[(axis + 2) % 3] = p[1];
      points.push_back(q);
    }
    check_tiles(kComb, triangulate(points));
  }
}

TEST_CASE("triangulate: in clip space any two of the four coordinates may carry the polygon") {
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 4; ++b) {
      if (a == b) continue;
      std::vector<Point4> points;
      for (const Point2& p : kComb) {
        Point4 q = {};
        q[a] = p[0];
        q[b] = p[1];
        points.push_back(q);
      }
      check_tiles(kComb, triangulate(points));
    }
  }
}

TEST_CASE("triangulate: vertices are taken as they are, attributes stay with them") {
  std::vector<ClipVertex<float, 2>> polygon;
  for (const Point2& p : kComb) {
    const auto x = static_cast<float>(p[0]), y = static_cast<float>(p[1]);
    polygon.push_back({Vec4<float>(x, y, 0, 2), {{x, y}}});
  }
  check_tiles(kComb, triangulate(std::span<const ClipVertex<float, 2>>(polygon)));
}

TEST_CASE("triangulate: random star polygons are tiled, whatever their size") {
  std::mt19937_64 random(81);
  for (int n = 3; n < 60; ++n) {
    // Around the origin by increasing angle: simple, and mostly concave. Multiples of 2^-10 sum
    // exactly.
    std::vector<Point2> polygon;
    for (int i = 0; i < n; ++i) {
      const double radius = 1 + static_cast<double>(random() % 64);
      const double angle = 6.283185 * i / n;
      polygon.push_back({std::round(1024 * radius * std::cos(angle)) / 1024,
                         std::round(1024 * radius * std::sin(angle)) / 1024});
    }
    check_tiles(polygon, triangulate(on_plane(polygon)));
  }
}

TEST_CASE("triangulate: what is not a simple polygon is named as such") {
  const auto message_of = [](const std::vector<Point3>& points) {
    try {
      triangulate(points, "shape.txt:7");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const auto bow_tie = on_plane({{0, 0}, {3, 2}, {3, 0}, {0, 1}});
  CHECK_THAT(message_of(bow_tie), Contains("shape.txt:7") && Contains("cross or touch"));
  const auto touching = on_plane({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}});
  CHECK_THAT(message_of(touching),
             Contains("vertices 2 and 5 (counted from 0) are the same point"));
  const auto on_an_edge = on_plane({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}});
  CHECK_THAT(message_of(on_an_edge), Contains("cross or touch"));
  const auto twice = on_plane({{0, 0}, {2, 0}, {2, 0}, {0, 2}});
  CHECK_THAT(message_of(twice), Contains("vertices 1 and 2 (counted from 0) are the same point"));
  CHECK_THAT(message_of(on_plane({{0, 0}, {1, 1}, {2, 2}})), Contains("no area"));
  CHECK_THAT(message_of(on_plane({{0, 0}, {1, 1}})), Contains("2 vertices"));
  auto infinite = on_plane(kComb);
  infinite[3][1] = std::numeric_limits<double>::infinity();
  CHECK_THAT(message_of(infinite), Contains("vertex 3") && Contains("inf"));
}

TEST_CASE("triangulate: a square with a corner off its plane is two triangles, by an ulp too") {
  const double off = GENERATE(1.0, 0x1p-52, -0x1p-1074);
  auto square = on_plane({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  CHECK(departure_from_plane(std::span<const Point3>(square)).is_flat());
  square[3][2] = off == 0x1p-52 ? std::nextafter(square[3][2], 0.0) : square[3][2] + off;
  if (off == -0x1p-1074) square = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, off}};
  CHECK_FALSE(departure_from_plane(std::span<const Point3>(square)).is_flat());
  CHECK(convex_parts(std::span<const Point3>(square)).size() == 2);
}

TEST_CASE("triangulate: how far a vertex is off the plane is told") {
  const std::vector<Point3> roof = {{0, 0, 0}, {16, 0, 0}, {16, 16, 0}, {4, 12, 3}};
  const Departure found = departure_from_plane(std::span<const Point3>(roof));
  CHECK(found.vertex == 3);
  CHECK(found.distance == 3);
  const std::vector<Point4> clip = {{0, 0, 0, 1}, {16, 0, 0, 1}, {16, 16, 0, 1}, {4, 12, 3, 5}};
  CHECK(departure_from_plane(std::span<const Point4>(clip)).distance == 5);
}

TEST_CASE("triangulate: a convex polygon is one part, straight angles included; a dart is two") {
  const auto square = on_plane({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto dart = on_plane({{-2, -2}, {0, -1}, {2, -2}, {0, 2}});
  CHECK(convex_parts(std::span<const Point3>(square)) ==
        std::vector<IndexPolygon>{{0, 1, 2, 3, 4}});
  const auto parts = convex_parts(std::span<const Point3>(dart));
  REQUIRE(parts.size() == 2);
  for (const IndexPolygon& part : parts) {
    CHECK(part.size() == 3);
    CHECK(std::count(part.begin(), part.end(), 1) == 1);
    CHECK(std::count(part.begin(), part.end(), 3) == 1);
  }
}
