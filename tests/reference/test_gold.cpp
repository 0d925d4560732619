// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fast reference against gold: equal as sets of rational vertices.
#include "reference/gold.hpp"

#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <stdexcept>

#include "tests/catch.hpp"
#include "tests/reference/helpers.hpp"

namespace clipscope::reference {
namespace {

using Random = std::mt19937;
using MakeTriangle = std::function<InputTriangle(Random&)>;
using Clip = std::function<std::vector<RationalVertex>(const InputTriangle&)>;

// Every coordinate is an integer in [low, high]: many vertices lie on planes and in corners.
InputTriangle lattice_triangle(Random& random, int low, int high) {
  std::uniform_int_distribution<int> coordinate(low, high);
  InputTriangle r;
  r.attribute_count = 4;
  for (InputVertex& v : r.vertices) {
    for (double& p : v.position) p = coordinate(random);
    for (int k = 0; k < 4; ++k) v.attributes[k] = coordinate(random);
  }
  return r;
}

InputTriangle float_triangle(Random& random, float extent) {
  std::uniform_real_distribution<float> coordinate(-extent, extent);
  InputTriangle r;
  r.attribute_count = 4;
  for (InputVertex& v : r.vertices) {
    for (double& p : v.position) p = coordinate(random);
    for (int k = 0; k < 4; ++k) v.attributes[k] = coordinate(random);
  }
  return r;
}

// Moves view-space triangles to where the frusta of these tests are.
MakeTriangle in_view(const MakeTriangle& make) {
  return [make](Random& random) {
    InputTriangle t = make(random);
    for (InputVertex& v : t.vertices) v.position[2] -= 3;
    return t;
  };
}

const MakeTriangle kLattice3 = [](Random& r) { return lattice_triangle(r, -3, 3); };
const MakeTriangle kLattice1 = [](Random& r) { return lattice_triangle(r, -1, 1); };
const MakeTriangle kLattice2 = [](Random& r) { return lattice_triangle(r, -2, 2); };
const MakeTriangle kFloats = [](Random& r) { return float_triangle(r, 5); };

// Counts of what was compared, so that a test can tell that it was no empty exercise.
struct Tally {
  int clipped = 0;
  std::set<std::size_t> sizes;
};

Tally compare(const Truth& truth, const Clip& gold, const MakeTriangle& make, int count) {
  Random random(5489);
  Tally tally;
  while (count > 0) {
    const InputTriangle t = make(random);
    std::vector<RationalVertex> expected;
    try {
      expected = gold(t);
    } catch (const std::invalid_argument&) {
      continue;  // no area
    }
    --count;
    const ExactPolygon polygon = clip(truth, t);
    CAPTURE(t.vertices[0].position, t.vertices[1].position, t.vertices[2].position);
    REQUIRE(polygon.vertices.size() == expected.size());
    REQUIRE(vertex_set(polygon) == expected);
    tally.clipped += polygon.verdict == Verdict::clipped ? 1 : 0;
    tally.sizes.insert(expected.size());
  }
  return tally;
}

Tally compare(const Frustum<double>& frustum, const MakeTriangle& make, int count) {
  const auto gold = [&](const InputTriangle& t) { return gold_of_frustum(frustum, t); };
  return compare(Truth::of_frustum(frustum), gold, make, count);
}

Tally compare_matrix(const Frustum<double>& frustum, const MakeTriangle& make, int count) {
  const Projection<float> projection(frustum_cast<float>(frustum));
  const auto gold = [&](const InputTriangle& t) { return gold_of_matrix(projection, t); };
  return compare(Truth::of_matrix(projection), gold, make, count);
}

DepthRange any_depth() {
  return GENERATE(DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed);
}

DepthClamp any_depth_clamp() {
  return GENERATE(DepthClamp(), DepthClamp(true), kClampNear, kClampFar);
}

OpenSides any_open_sides() {
  return GENERATE(OpenSides(true), OpenSides(true, false, false, true),
                  OpenSides(true, true, false, false));
}

Frustum<double> perspective(DepthRange depth) {
  Frustum<double> f;
  f.far = 4;
  f.depth = depth;
  return f;
}

Frustum<double> off_centre(DepthRange depth) {
  Frustum<double> f = perspective(depth);
  f.left = -0.3f;
  f.right = 0.7f;
  f.bottom = -1.1f;
  f.top = 0.1f;
  f.near = 0.3f;
  return f;
}

Frustum<double> infinite(DepthRange depth) {
  Frustum<double> f = perspective(depth);
  f.infinite_far = true;
  return f;
}

Frustum<double> parallel(DepthRange depth) {
  Frustum<double> f = perspective(depth);
  f.kind = ProjectionKind::parallel;
  f.right = 2;
  return f;
}

Frustum<double> oblique(DepthRange depth) {
  Frustum<double> f = parallel(depth);
  f.shear_x = 0.25;
  f.shear_y = -1;
  return f;
}

TEST_CASE("gold: one plane turns a triangle into a quadrilateral, by hand") {
  const InputTriangle t = triangle({0, 0, -0.5, 1}, {0, 0, -2, 1}, {0, 1, -2, 1});
  const Rational third = ratio(1, 3), two_thirds = ratio(2, 3), half = ratio(1, 2);
  const std::vector<RationalVertex> expected = {{0, 0, -1, 1, {two_thirds, third, 0}},
                                                {0, 0, ratio(1, 9), half, {0, 1, 0}},
                                                {0, third, -1, 1, {two_thirds, 0, third}},
                                                {0, half, ratio(1, 9), half, {0, 0, 1}}};
  // Seen edge-on by the eye, and yet with an area in NDC.
  CHECK(gold_of_frustum(unit_frustum(), t) == expected);
}

TEST_CASE("gold: a triangle behind the eye yields nothing") {
  CHECK(
      gold_of_frustum(unit_frustum(), triangle({0, 0, 1, 1}, {1, 0, 2, 1}, {0, 1, 3, 1})).empty());
}

TEST_CASE("gold: clip space is cut where w has both signs, by hand") {
  const InputTriangle t = triangle({-2, 0, 0, 3}, {4, 0, 0, -3}, {-2, .5, 0, 3});
  const std::vector<RationalVertex> r = gold_of_clip(DepthRange::minus_one_to_one, t);
  REQUIRE(r.size() == 4);
  CHECK(r.back() == RationalVertex{1, ratio(7, 12), 0, 2, {0, ratio(5, 12), ratio(7, 12)}});
}

TEST_CASE("gold: a triangle without area is refused") {
  const Position a = {0, 0, -2, 1}, b = {1, 0, -2, 1}, c = {2, 0, -2, 1};
  CHECK_THROWS_AS(gold_of_frustum(unit_frustum(), triangle(a, b, c)), std::invalid_argument);
  CHECK_THROWS_AS(gold_of_clip(DepthRange::reversed, triangle(a, b, c)), std::invalid_argument);
}

TEST_CASE("reference: equals gold on lattices in a perspective frustum") {
  const auto make_frustum = GENERATE(perspective, off_centre, infinite);
  const Tally tally = compare(make_frustum(any_depth()), in_view(kLattice3), 300);
  CHECK(tally.clipped > 100);
  CHECK(tally.sizes.size() >= 5);
}

TEST_CASE("reference: equals gold on lattices in a parallel frustum") {
  const auto make_frustum = GENERATE(parallel, oblique);
  const Tally tally = compare(make_frustum(any_depth()), in_view(kLattice3), 300);
  CHECK(tally.clipped > 100);
  CHECK(tally.sizes.size() >= 5);
}

TEST_CASE("reference: equals gold on floats in every frustum") {
  const auto make_frustum = GENERATE(perspective, off_centre, infinite, parallel, oblique);
  const Tally tally = compare(make_frustum(any_depth()), in_view(kFloats), 200);
  CHECK(tally.clipped > 50);
}

TEST_CASE("reference: equals gold under a float matrix") {
  const auto make_frustum = GENERATE(perspective, off_centre, infinite, parallel, oblique);
  const auto depth = any_depth();
  CHECK(compare_matrix(make_frustum(depth), in_view(kFloats), 60).clipped > 15);
  CHECK(compare_matrix(make_frustum(depth), in_view(kLattice3), 60).clipped > 15);
}

TEST_CASE("reference: equals gold on clip-space lattices, w of any sign") {
  const DepthRange depth = any_depth();
  const Truth truth = Truth::of_clip(depth);
  const auto gold = [&](const InputTriangle& t) { return gold_of_clip(depth, t); };
  const Tally tally = compare(truth, gold, kLattice2, 400);
  CHECK(tally.clipped > 100);
  CHECK(tally.sizes.size() >= 4);
}

TEST_CASE("reference: equals gold on clip-space floats, w of any sign") {
  const DepthRange depth = any_depth();
  const Truth truth = Truth::of_clip(depth);
  const auto gold = [&](const InputTriangle& t) { return gold_of_clip(depth, t); };
  CHECK(compare(truth, gold, kFloats, 200).clipped > 50);
}

TEST_CASE("reference: equals gold with depth clamp and clip distances in clip space") {
  const ClipVolume volume = {
      .depth = any_depth(), .depth_clamp = any_depth_clamp(), .clip_distances = 2};
  const Truth truth = Truth::of_clip(volume);
  const auto gold = [&](const InputTriangle& t) { return gold_of_clip(volume, t); };
  CHECK(compare(truth, gold, kLattice2, 100).clipped > 15);
  CHECK(compare(truth, gold, kFloats, 100).clipped > 15);
}

TEST_CASE("reference: equals gold with depth clamp and clip distances in view space") {
  const auto make_frustum = GENERATE(off_centre, infinite, oblique);
  const Frustum<double> frustum = make_frustum(DepthRange::zero_to_one);
  const ClipVolume volume = {
      .depth = frustum.depth, .depth_clamp = any_depth_clamp(), .clip_distances = 1};
  const auto gold = [&](const InputTriangle& t) { return gold_of_frustum(frustum, volume, t); };
  const Truth truth = Truth::of_frustum(frustum, volume);
  CHECK(compare(truth, gold, in_view(kLattice3), 60).clipped > 15);
  CHECK(compare(truth, gold, in_view(kFloats), 60).clipped > 10);
}

TEST_CASE("reference: equals gold with depth clamp and clip distances under a float matrix") {
  const auto make_frustum = GENERATE(off_centre, oblique);
  Projection<float> projection(frustum_cast<float>(make_frustum(DepthRange::reversed)));
  projection.volume.depth_clamp = any_depth_clamp();
  projection.volume.clip_distances = 1;
  const auto gold = [&](const InputTriangle& t) { return gold_of_matrix(projection, t); };
  CHECK(compare(Truth::of_matrix(projection), gold, in_view(kLattice3), 60).clipped > 15);
}

// On a coarse lattice many triangles touch the volume with a vertex or an edge, or lie in a side.
TEST_CASE("reference: equals gold with open sides in clip space") {
  const ClipVolume volume = {.depth = any_depth(), .open_sides = any_open_sides()};
  const Truth truth = Truth::of_clip(volume);
  const auto gold = [&](const InputTriangle& t) { return gold_of_clip(volume, t); };
  CHECK(compare(truth, gold, kLattice2, 150).clipped > 25);
  CHECK(compare(truth, gold, kLattice1, 150).clipped > 15);
}

TEST_CASE("reference: equals gold with open sides in view space and under a float matrix") {
  const auto make_frustum = GENERATE(perspective, infinite, parallel, oblique);
  const Frustum<double> frustum = make_frustum(DepthRange::zero_to_one);
  const ClipVolume volume = {.depth = frustum.depth, .open_sides = any_open_sides()};
  const auto gold = [&](const InputTriangle& t) { return gold_of_frustum(frustum, volume, t); };
  CHECK(compare(Truth::of_frustum(frustum, volume), gold, in_view(kLattice3), 100).clipped > 20);
  Projection<float> projection(frustum_cast<float>(frustum));
  projection.volume = volume;
  const auto gold_matrix = [&](const InputTriangle& t) { return gold_of_matrix(projection, t); };
  CHECK(compare(Truth::of_matrix(projection), gold_matrix, in_view(kLattice3), 60).clipped > 10);
}

// Vertices hundreds of binary orders of magnitude apart.
TEST_CASE("reference: equals gold on clip-space doubles of any magnitude") {
  const MakeTriangle make = [](Random& random) {
    std::uniform_int_distribution<int> exponent(-300, 300);
    InputTriangle t = float_triangle(random, 2);
    for (InputVertex& v : t.vertices) {
      const int k = exponent(random);
      for (double& p : v.position) p = std::ldexp(p, k);
    }
    return t;
  };
  const DepthRange depth = DepthRange::minus_one_to_one;
  const auto gold = [&](const InputTriangle& t) { return gold_of_clip(depth, t); };
  CHECK(compare(Truth::of_clip(depth), gold, make, 200).clipped > 50);
}

// Vertices on the sides of a frustum that no float holds exactly, give or take an ulp.
TEST_CASE("reference: equals gold within an ulp of the planes") {
  const Frustum<double> frustum = off_centre(DepthRange::zero_to_one);
  const MakeTriangle make = [&](Random& random) {
    std::uniform_real_distribution<float> depth(-4.1f, -0.2f);
    std::uniform_int_distribution<int> pick(0, 2), ulps(-1, 1);
    InputTriangle t = float_triangle(random, 2);
    for (InputVertex& v : t.vertices) {
      const float z = depth(random);
      const double sides[2][3] = {{frustum.left, frustum.right, 0},
                                  {frustum.bottom, frustum.top, 0}};
      v.position[2] = z;
      for (int c = 0; c < 2; ++c) {
        const auto on_plane = static_cast<float>(-sides[c][pick(random)] * z / frustum.near);
        const int step = ulps(random);
        v.position[c] = step == 0 ? on_plane : std::nextafter(on_plane, 100.0f * step);
      }
    }
    return t;
  };
  CHECK(compare(frustum, make, 600).clipped > 100);
}

// The same, decided by the filter and by exact numbers alone.
TEST_CASE("truth: the filter decides as exact arithmetic does within an ulp of the planes") {
  const auto make_frustum = GENERATE(off_centre, perspective, oblique);
  const Frustum<double> frustum = make_frustum(DepthRange::minus_one_to_one);
  const Truth truths[] = {Truth::of_frustum(frustum),
                          Truth::of_matrix(Projection<float>(frustum_cast<float>(frustum))),
                          Truth::of_frustum(frustum).inset(0x1p-20)};
  Random random(3);
  std::uniform_real_distribution<float> depth(-4.1f, -0.2f);
  std::uniform_int_distribution<int> pick(0, 1), ulps(-1, 1);
  int on_plane = 0, close = 0;
  for (int i = 0; i < 20000; ++i) {
    const double z = depth(random);
    const double scale = frustum.kind == ProjectionKind::perspective ? -z / frustum.near : 1;
    double x = pick(random) == 0 ? frustum.left : frustum.right;
    double y = pick(random) == 0 ? frustum.bottom : frustum.top;
    x = x * scale - frustum.shear_x * z;
    y = y * scale - frustum.shear_y * z;
    const InputVertex v = {{std::nextafter(x, x + ulps(random)), y, z, 1}, {}};
    for (const Truth& truth : truths) {
      for (const Truth::HalfSpace& half_space : truth.half_spaces()) {
        const Dyadic d = value(half_space.form, v);
        REQUIRE(sign(half_space.form, v) == static_cast<int>(d.sign()));
        on_plane += d.is_zero() ? 1 : 0;
        close += std::abs(d.to_double()) < 1e-15 ? 1 : 0;
      }
    }
  }
  CHECK(close > 10000);
  CHECK(on_plane > 0);
}

}  // namespace
}  // namespace clipscope::reference
