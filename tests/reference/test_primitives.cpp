// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points, segments and convex polygons, depth clamp and clip distances, by hand.
#include <algorithm>
#include <cmath>
#include <random>

#include "reference/convex.hpp"
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/reference/helpers.hpp"

namespace clipscope::reference {
namespace {

const Truth kClip = Truth::of_clip(DepthRange::minus_one_to_one);

using Vertices = std::vector<InputVertex>;

// Vertices with the attributes 1 and their index.
Vertices vertices(const std::vector<Position>& positions) {
  Vertices r;
  for (const Position& position : positions) {
    r.push_back({position, {1, static_cast<double>(r.size())}});
  }
  return r;
}

ExactPolygon clipped(const Truth& truth, const std::vector<Position>& positions) {
  return clip(truth, vertices(positions), 0);
}

std::vector<std::array<Rational, 4>> positions_of(const ExactPolygon& polygon) {
  std::vector<std::array<Rational, 4>> r;
  for (const ExactVertex& v : polygon.vertices) {
    r.push_back({to_rational(v.x), to_rational(v.y), to_rational(v.z), to_rational(v.inv_w)});
  }
  return r;
}

using Positions = std::vector<std::array<Rational, 4>>;

TEST_CASE("reference: a point is inside or it isn't") {
  CHECK(clipped(kClip, {{1, -1, 1, 2}}).verdict == Verdict::accepted);
  CHECK(positions_of(clipped(kClip, {{1, -1, 1, 2}})) ==
        Positions{{ratio(1, 2), ratio(-1, 2), ratio(1, 2), ratio(1, 2)}});
  CHECK(clipped(kClip, {{2, -2, 2, 2}}).verdict == Verdict::accepted);
  CHECK(clipped(kClip, {{2, -2, std::nextafter(2.0, 3.0), 2}}).verdict == Verdict::rejected);
  CHECK(clipped(kClip, {{0, 0, 0, -1}}).verdict == Verdict::rejected);
  CHECK(clipped(kClip, {{0, 0, 0, 0}}).verdict == Verdict::rejected);
}

// x = -2 + 6 t, w = 3 - 6 t: w + x = 1 everywhere, w - x = 5 - 12 t. At t = 5/12, x = w = 1/2.
TEST_CASE("reference: the segment from (-2, 3) to (4, -3) ends at x = w") {
  const Vertices segment = vertices({{-2, 0, 0, 3}, {4, 0, 0, -3}});
  const ExactPolygon p = clip(kClip, segment, 2);
  CHECK(p.verdict == Verdict::clipped);
  REQUIRE(positions_of(p) == Positions{{ratio(-2, 3), 0, 0, ratio(1, 3)}, {1, 0, 0, 2}});
  CHECK(to_rational(p.vertices[1].attributes[0]) == 1);
  CHECK(to_rational(p.vertices[1].attributes[1]) == ratio(5, 12));
}

TEST_CASE("reference: a segment keeps the order of its ends") {
  const Position a = {-3, 0, 0, 1}, b = {3, 0, 0, 1}, inside = {0, 0, 0, 1};
  CHECK(positions_of(clipped(kClip, {a, b})) == Positions{{-1, 0, 0, 1}, {1, 0, 0, 1}});
  CHECK(positions_of(clipped(kClip, {b, a})) == Positions{{1, 0, 0, 1}, {-1, 0, 0, 1}});
  CHECK(positions_of(clipped(kClip, {a, inside})) == Positions{{-1, 0, 0, 1}, {0, 0, 0, 1}});
  CHECK(positions_of(clipped(kClip, {inside, a})) == Positions{{0, 0, 0, 1}, {-1, 0, 0, 1}});
}

TEST_CASE("reference: a segment through a corner of the volume is a point") {
  CHECK(positions_of(clipped(kClip, {{2, 0, 1, 1}, {0, 2, 1, 1}})) == Positions{{1, 1, 1, 1}});
  const double beside = std::nextafter(2.0, 3.0);
  CHECK(clipped(kClip, {{beside, 0, 1, 1}, {0, 2, 1, 1}}).vertices.empty());
}

TEST_CASE("reference: a segment whose ends coincide in NDC is a point") {
  CHECK(positions_of(clipped(kClip, {{1, 0, 0, 2}, {2, 0, 0, 4}})) ==
        Positions{{ratio(1, 2), 0, 0, ratio(1, 2)}});
}

TEST_CASE("reference: a segment from the clip position (0, 0, 0, 0) yields its other end") {
  CHECK(positions_of(clipped(kClip, {{0, 0, 0, 0}, {1, 0, 0, 2}})) ==
        Positions{{ratio(1, 2), 0, 0, ratio(1, 2)}});
}

TEST_CASE("reference: a square over the volume becomes the volume's cross-section") {
  const Vertices square = vertices({{-2, -2, 0, 1}, {2, -2, 0, 1}, {2, 2, 0, 1}, {-2, 2, 0, 1}});
  const ExactPolygon p = clip(kClip, square, 0);
  Positions corners = positions_of(p);
  std::sort(corners.begin(), corners.end());
  CHECK(corners == Positions{{-1, -1, 0, 1}, {-1, 1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}});
}

// |x| + |y| <= 3/2: each side of the volume cuts off a corner, at +-1/2 along it.
TEST_CASE("reference: a square on its corner becomes an octagon") {
  const double a = 1.5;
  const ExactPolygon p = clipped(kClip, {{a, 0, 0, 1}, {0, a, 0, 1}, {-a, 0, 0, 1}, {0, -a, 0, 1}});
  CHECK(p.vertices.size() == 8);
  for (const auto& v : positions_of(p)) CHECK(abs(v[0]) + abs(v[1]) == ratio(3, 2));
}

TEST_CASE("reference: a triangle given as vertices or as a triangle is the same") {
  const InputTriangle t = triangle({-3, 0, 0, 1}, {2, 5, 0, 1}, {2, -1, 3, 2});
  CHECK(vertex_set(clip(kClip, t.vertices, 3)) == vertex_set(clip(kClip, t)));
}

// A quadrilateral is two triangles: the union of their parts has the same extent.
TEST_CASE("reference: a square and its two halves meet the same planes at the same points") {
  const std::vector<Position> p = {{-3, -1, 0, 1}, {2, -1, 1, 2}, {4, 1, 1, 2}, {-1, 1, 0, 1}};
  REQUIRE(is_planar_convex(vertices(p), 0));
  Positions whole = positions_of(clipped(kClip, p));
  Positions halves = positions_of(clipped(kClip, {p[0], p[1], p[2]}));
  for (const auto& v : positions_of(clipped(kClip, {p[0], p[2], p[3]}))) halves.push_back(v);
  REQUIRE(whole.size() >= 4);
  for (const auto& v : whole) CHECK(std::find(halves.begin(), halves.end(), v) != halves.end());
}

// With the last two exchanged it crosses itself where w = 0.
TEST_CASE("convex: a parallelogram in clip space is a convex polygon, of either winding") {
  Vertices square =
      vertices({{100, 10, 0, 1}, {10, 10, 0, 1}, {-100, -1, 0, -1}, {-10, -1, 0, -1}});
  CHECK(is_planar_convex(square, 0));
  std::reverse(square.begin(), square.end());
  CHECK(is_planar_convex(square, 0));
}

TEST_CASE("convex: what isn't a convex polygon is refused") {
  const Position a = {0, 0, 0, 1}, b = {1, 0, 0, 1}, c = {1, 1, 0, 1}, d = {0, 1, 0, 1};
  CHECK(is_planar_convex(vertices({a, b, c, d}), 0));
  CHECK_FALSE(is_planar_convex(vertices({a, b}), 0));
  CHECK_FALSE(is_planar_convex(vertices({a, b, d, c}), 0));                 // crosses itself
  CHECK_FALSE(is_planar_convex(vertices({a, b, {.25, .25, 0, 1}, d}), 0));  // a reflex corner
  CHECK_FALSE(is_planar_convex(vertices({a, b, c, c}), 0));                 // a vertex twice
  CHECK_FALSE(is_planar_convex(vertices({a, b, d, a, b, d}), 0));           // twice around
  CHECK_FALSE(is_planar_convex(vertices({a, b, c, {0, 1, 0x1p-1000, 1}}), 0));
  CHECK_FALSE(is_planar_convex(vertices({a, b, c, {0, 2, 0, 2}}), 0));  // planar in NDC only
  CHECK_FALSE(is_planar_convex(vertices({a, b, {2, 0, 0, 1}, {3, 0, 0, 1}}), 0));
}

TEST_CASE("convex: three successive vertices may lie on a line") {
  CHECK(is_planar_convex(vertices({{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}, {0, 1, 0, 1}}), 0));
  // out of order on that line
  CHECK_FALSE(
      is_planar_convex(vertices({{0, 0, 0, 1}, {2, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}), 0));
}

TEST_CASE("convex: attributes must be affine over the polygon") {
  Vertices square = vertices({{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}});
  CHECK_FALSE(is_planar_convex(square, 2));  // 0 1 2 3
  square[3].attributes[1] = 1;
  CHECK(is_planar_convex(square, 2));  // 0 1 2 1 = x + y
}

// From z = -3 to 3 at w = 1: near and far leave the middle third, depth clamp all.
TEST_CASE("volume: with depth clamp near and far don't cut") {
  const std::vector<Position> segment = {{0, 0, -3, 1}, {0, 0, 3, 1}};
  const auto depth =
      GENERATE(DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed);
  const ClipVolume clamped = {.depth = depth, .depth_clamp = true};
  CHECK(clipped(Truth::of_clip(depth), segment).verdict == Verdict::clipped);
  CHECK(clipped(Truth::of_clip(clamped), segment).verdict == Verdict::accepted);
}

TEST_CASE("volume: with one plane of depth clamped the other still cuts") {
  const std::vector<Position> segment = {{0, 0, -3, 1}, {0, 0, 3, 1}};
  const Truth near = Truth::of_clip(ClipVolume{.depth_clamp = kClampNear});
  const Truth far = Truth::of_clip(ClipVolume{.depth_clamp = kClampFar});
  CHECK(positions_of(clipped(near, segment)) == Positions{{0, 0, -3, 1}, {0, 0, 1, 1}});
  CHECK(positions_of(clipped(far, segment)) == Positions{{0, 0, -1, 1}, {0, 0, 3, 1}});
  // Reversed the near plane is z = w and the far one z = 0.
  const ClipVolume reversed = {.depth = DepthRange::reversed, .depth_clamp = kClampNear};
  CHECK(positions_of(clipped(Truth::of_clip(reversed), segment)) ==
        Positions{{0, 0, 0, 1}, {0, 0, 3, 1}});
}

// w = 1 - 2 t: the sides meet x = w at t = 1/4 (x = t + 1/4) and leave nothing with w < 0.
TEST_CASE("volume: with depth clamp the sides leave nothing behind the eye") {
  const Truth truth = Truth::of_clip(ClipVolume{.depth_clamp = true});
  CHECK(positions_of(clipped(truth, {{.25, 0, 5, 1}, {1.25, 0, 5, -1}})) ==
        Positions{{ratio(1, 4), 0, 5, 1}, {1, 0, 10, 2}});
  CHECK(clipped(truth, {{0, 0, 5, -1}, {0, 0, 5, -2}, {.5, 0, 5, -1}}).vertices.empty());
}

TEST_CASE("volume: with depth clamp a vertex with w = 0 is outside") {
  const Truth truth = Truth::of_clip(ClipVolume{.depth_clamp = true});
  CHECK(clipped(truth, {{0, 0, -2, 0}}).verdict == Verdict::rejected);
  CHECK(positions_of(clipped(truth, {{0, 0, -2, 0}, {0, 0, 0, 1}})) == Positions{{0, 0, 0, 1}});
}

TEST_CASE("volume: depth clamp in view space leaves the pyramid up to the eye") {
  const ClipVolume clamped = {.depth_clamp = true};
  const Truth truth = Truth::of_frustum(unit_frustum(), clamped);  // near 1
  CHECK(clipped(truth, {{0, 0, -.5, 1}}).verdict == Verdict::accepted);
  CHECK(clipped(truth, {{0, 0, -100, 1}}).verdict == Verdict::accepted);
  CHECK(clipped(truth, {{0, 0, .5, 1}}).verdict == Verdict::rejected);
  CHECK(clipped(truth, {{0, 0, 0, 1}}).verdict == Verdict::rejected);
  Frustum<double> parallel = unit_frustum();
  parallel.kind = ProjectionKind::parallel;
  CHECK(clipped(Truth::of_frustum(parallel, clamped), {{0, 0, 5, 1}}).verdict == Verdict::accepted);
}

TEST_CASE("volume: by the top-left rule the right and bottom sides do not own their points") {
  const Truth open = Truth::of_clip(ClipVolume{.open_sides = true});
  const auto owned = [&](const Position& p) {
    REQUIRE(clipped(kClip, {p}).verdict == Verdict::accepted);
    return clipped(open, {p}).verdict == Verdict::accepted;
  };
  CHECK(owned({-2, 0, 0, 2}));
  CHECK(owned({0, 2, 0, 2}));
  CHECK_FALSE(owned({2, 0, 0, 2}));
  CHECK_FALSE(owned({0, -2, 0, 2}));
  CHECK(owned({std::nextafter(2.0, 0.0), 0, 0, 2}));
  // Of the corners the one at the top left alone.
  CHECK(owned({-1, 1, 0, 1}));
  for (const Position& p : {Position{1, 1, 0, 1}, {1, -1, 0, 1}, {-1, -1, 0, 1}}) {
    CHECK_FALSE(owned(p));
  }
}

TEST_CASE("volume: what reaches inside of an open side is cut as ever, up to its border") {
  const Truth open = Truth::of_clip(ClipVolume{.open_sides = true});
  CHECK(positions_of(clipped(open, {{0, 0, 0, 1}, {3, 0, 0, 1}})) ==
        Positions{{0, 0, 0, 1}, {1, 0, 0, 1}});
  CHECK(positions_of(clipped(open, {{1, 0, 0, 1}, {0, 0, 0, 1}})) ==
        Positions{{1, 0, 0, 1}, {0, 0, 0, 1}});
  CHECK(clipped(open, {{1, 0, 0, 1}, {3, 0, 0, 1}}).vertices.empty());         // touches
  CHECK(clipped(open, {{1, 0, 0, 1}, {1, .5, 0, 1}}).vertices.empty());        // lies in it
  CHECK(clipped(open, {{2, 0, 0, 1}, {0, -2, 0, 1}}).vertices.empty());        // through a corner
  CHECK(clipped(open, {{-1, 0, 0, 1}, {-1, .5, 0, 1}}).vertices.size() == 2);  // lies in its owner
}

TEST_CASE("volume: an outward inset moves an open side away from what lies in it") {
  const Truth open = Truth::of_clip(ClipVolume{.open_sides = true});
  CHECK(clipped(open, {{1, 0, 0, 1}}).verdict == Verdict::rejected);
  CHECK(clipped(open.inset(-0.25), {{1, 0, 0, 1}}).verdict == Verdict::accepted);
  CHECK(clipped(open.inset(-0.25), {{1.25, 0, 0, 1}}).verdict == Verdict::rejected);
}

// The first attribute is 1 at a, -1 at b, -3 at c: 0 in the middle of a-b and at 1/4 of a-c.
TEST_CASE("volume: a clip distance cuts where its attribute is 0") {
  InputTriangle t = triangle({0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1});
  t.attribute_count = 1;
  t.vertices[0].attributes[0] = 1;
  t.vertices[1].attributes[0] = -1;
  t.vertices[2].attributes[0] = -3;
  const ClipVolume volume = {.clip_distances = 1};
  Positions p = positions_of(clip(Truth::of_clip(volume), t));
  std::sort(p.begin(), p.end());
  CHECK(p == Positions{{0, 0, 0, 1}, {0, ratio(1, 4), 0, 1}, {ratio(1, 2), 0, 0, 1}});
  CHECK(clip(kClip, t).verdict == Verdict::accepted);
}

TEST_CASE("volume: a clip distance of 0 is inside") {
  const Truth truth = Truth::of_clip(ClipVolume{.clip_distances = 1});
  const InputVertex v = {{0, 0, 0, 1}, {-0.0}};
  CHECK(clip(truth, {&v, 1}, 1).verdict == Verdict::accepted);
}

TEST_CASE("volume: an inset moves clip distances by their own measure") {
  const Truth truth = Truth::of_clip(ClipVolume{.clip_distances = 1}).inset(0, 0.25);
  const InputVertex in = {{1, 0, 0, 1}, {0.25}}, out = {{1, 0, 0, 1}, {0.125}};
  CHECK(clip(truth, {&in, 1}, 1).verdict == Verdict::accepted);
  CHECK(clip(truth, {&out, 1}, 1).verdict == Verdict::rejected);
}

TEST_CASE("volume: what is no volume is refused") {
  CHECK_THROWS_AS(Truth::of_clip(ClipVolume{.clip_distances = 9}), std::invalid_argument);
  CHECK_THROWS_AS(Truth::of_clip(ClipVolume{.clip_distances = -1}), std::invalid_argument);
  CHECK_THROWS_AS(Truth::of_frustum(unit_frustum(), {.depth = DepthRange::reversed}),
                  std::invalid_argument);
}

}  // namespace
}  // namespace clipscope::reference
