// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes and spheres against a view volume by all axes that may separate them: by hand, and against
// exact arithmetic over random volumes.
#include <cfenv>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "reference/overlap.hpp"
#include "spaces/bounds/separating_axes.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/volumes.hpp"

using namespace clipscope;
using namespace clipscope::reference;

namespace {

template <class T>
Overlap exact_overlap(std::span<const LinearForm> forms, const AxisBox<T>& box) {
  std::vector<ExactPoint> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back(exact_point((i & 1) != 0 ? box.upper[0] : box.lower[0],
                                 (i & 2) != 0 ? box.upper[1] : box.lower[1],
                                 (i & 4) != 0 ? box.upper[2] : box.lower[2]));
  }
  return overlap(forms, points);
}

template <class T>
Overlap exact_overlap(std::span<const LinearForm> forms, const OrientedBox<T>& box) {
  std::vector<ExactPoint> points;
  for (int i = 0; i < 8; ++i) {
    ExactPoint& p = points.emplace_back(exact_point(box.centre[0], box.centre[1], box.centre[2]));
    for (int k = 0; k < 3; ++k) {
      const Dyadic half(double{(i >> k & 1) != 0 ? box.half[k] : -box.half[k]});
      for (int c = 0; c < 3; ++c) {
        p[static_cast<std::size_t>(c)] +=
            half * Dyadic(double{box.axes[static_cast<std::size_t>(k)][c]});
      }
    }
  }
  return overlap(forms, points);
}

template <class T>
Overlap exact_overlap(std::span<const LinearForm> forms, const Sphere<T>& sphere) {
  const auto& c = sphere.centre;
  return overlap(forms, exact_point(c[0], c[1], c[2]), Dyadic(double{sphere.radius}));
}

// A view volume three ways.
template <class T>
struct Volumes {
  CullingPlanes<T> planes;
  CullingHull<T> hull;
  std::vector<LinearForm> forms;
};

template <class T>
Volumes<T> of_frustum(const Frustum<T>& f) {
  return {culling_planes(f), culling_hull(f),
          half_spaces_of(Truth::of_frustum(frustum_cast<double>(f)))};
}

template <class T>
Volumes<T> of_matrix(DepthRange depth, const MatrixRows<T>& rows) {
  const CullingHull<T> hull = culling_hull(depth, rows);
  return {with_reach(culling_planes(depth, rows), hull), hull,
          half_spaces_of(Truth::of_matrix(matrix_cast<double>(rows), {.depth = depth}))};
}

// The projection after a turn about y and a shift.
template <class T>
MatrixRows<T> turned(Random& random, const Frustum<T>& f) {
  MatrixRows<T> rows = rows_of(Projection<T>(f));
  const double angle = uniform(random, -0.3, 0.3);
  const T c = static_cast<T>(std::cos(angle)), s = static_cast<T>(std::sin(angle));
  const T shift = static_cast<T>(uniform(random, -1, 1) * f.near);
  for (Vec4<T>& row : rows) {
    const T x = row[0], z = row[2];
    row = Vec4<T>(x * c - z * s, row[1], x * s + z * c, row[3] + x * shift);
  }
  return rows;
}

struct Tally {
  long volumes = 0, wrong = 0;
  long outside = 0;    // exactly so, and not made to graze a plane
  long by_planes = 0;  // of these rejected by the planes
  long by_axes = 0;    // of these rejected by the axes, too
};

std::string report(const Tally& t) {
  std::ostringstream out;
  out << t.volumes << " volumes; of " << t.outside << " outside the planes reject " << t.by_planes
      << ", the axes " << t.by_axes;
  return out.str();
}

template <class T, class Volume>
void hold(const Volumes<T>& v, const Volume& volume, bool grazing, Tally& tally) {
  const Overlap exact = exact_overlap(v.forms, volume);
  const Visibility by_planes = visibility(v.planes, volume);
  const Visibility by_axes = visibility(v.planes, v.hull, volume);
  ++tally.volumes;
  tally.wrong += by_axes == Visibility::rejected && exact != Overlap::outside ? 1 : 0;
  tally.wrong += by_axes == Visibility::accepted && exact != Overlap::inside ? 1 : 0;
  tally.wrong += by_planes != Visibility::look_closer && by_axes != by_planes ? 1 : 0;
  if (exact != Overlap::outside || grazing) return;
  ++tally.outside;
  tally.by_planes += by_planes == Visibility::rejected ? 1 : 0;
  tally.by_axes += by_axes == Visibility::rejected ? 1 : 0;
}

template <class T, class Volume>
Tally tally_of(std::uint64_t seed, bool with_matrix) {
  Random random(seed);
  Tally tally;
  for (int n = 0; n < 300; ++n) {
    const Frustum<T> f = random_frustum<T>(random);
    const Volumes<T> v = with_matrix ? of_matrix(f.depth, turned(random, f)) : of_frustum(f);
    for (int i = 0; i < 30; ++i) {
      const Place<T> place = random_place(random, culling_planes(f), f);
      hold(v, make(random, place, static_cast<Volume*>(nullptr)), place.grazing, tally);
    }
  }
  return tally;
}

// The axes settle all but what is within rounding.
template <class T, class Volume>
void check(std::uint64_t seed) {
  for (const bool with_matrix : {false, true}) {
    const Tally tally = tally_of<T, Volume>(seed, with_matrix);
    INFO(report(tally) << (with_matrix ? ", of a matrix" : ""));
    CHECK(tally.wrong == 0);
    CHECK(tally.outside > 1000);
    CHECK(tally.by_axes > tally.by_planes);
    CHECK((tally.outside - tally.by_axes) * 1000 <= tally.outside);
  }
}

AxisBox<float> box(float x0, float x1, float y0, float y1, float z0, float z1) {
  return {Vec3<float>(x0, y0, z0), Vec3<float>(x1, y1, z1)};
}

}  // namespace

TEMPLATE_TEST_CASE(
    "separating axes: no box with a point in the volume is rejected, few others aren't", "", float,
    double) {
  check<TestType, AxisBox<TestType>>(1);
}

TEMPLATE_TEST_CASE(
    "separating axes: no oriented box with a point in the volume is rejected, few others aren't",
    "", float, double) {
  check<TestType, OrientedBox<TestType>>(2);
}

TEMPLATE_TEST_CASE(
    "separating axes: no sphere with a point in the volume is rejected, few others aren't", "",
    float, double) {
  check<TestType, Sphere<TestType>>(3);
}

TEMPLATE_TEST_CASE("separating axes: no rounding mode rejects what has a point in the volume", "",
                   float, double) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    Random random(4);
    long rejected = 0, wrong = 0;
    for (int n = 0; n < 100; ++n) {
      const Frustum<TestType> f = random_frustum<TestType>(random);
      const Volumes<TestType> v = of_frustum(f);
      for (int i = 0; i < 30; ++i) {
        const Place<TestType> place = random_place(random, v.planes, f);
        const auto box = make(random, place, static_cast<OrientedBox<TestType>*>(nullptr));
        std::fesetround(mode);
        const Visibility answer = visibility(v.planes, v.hull, box);
        std::fesetround(FE_TONEAREST);
        if (answer != Visibility::rejected) continue;
        ++rejected;
        wrong += exact_overlap(v.forms, box) != Overlap::outside ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
    CHECK(rejected > 500);
  }
}

TEST_CASE("separating axes: a box that only the product of two edges separates") {
  const Frustum<float> f;  // its far right edge is x = 10, z = -10
  const CullingPlanes<float> planes = culling_planes(f);
  const CullingHull<float> hull = culling_hull(f);
  // With n = (1, 0, -1) the box reaches from n . centre - 4 on, where it ends in an edge along
  // (1, 1, 1); none of its faces, and none of the frustum's, is parallel to that.
  OrientedBox<float> beside;
  beside.axes = {Vec3<float>(1, 1, 1), Vec3<float>(0, 2, -2), Vec3<float>(2, -2, 0)};
  beside.half = Vec3<float>(1);
  beside.centre = Vec3<float>(12.1f, 0, -12.1f);
  CHECK(visibility(planes, beside) == Visibility::look_closer);
  CHECK(visibility(planes, hull, beside) == Visibility::rejected);
  beside.centre = Vec3<float>(12, 0, -12);  // the edges touch
  CHECK(visibility(planes, hull, beside) == Visibility::look_closer);
}

TEST_CASE("separating axes: slabs contain every corner of the view volume") {
  for (const CullingHull<float>& hull :
       {culling_hull(Frustum<float>{}), culling_hull(Projection<float>(Frustum<float>{}))}) {
    CHECK(hull.slab_count > 18);
    for (int i = 0; i < hull.slab_count; ++i) {
      const HullSlab<float>& slab = hull.slabs[static_cast<std::size_t>(i)];
      float reach = -std::numeric_limits<float>::infinity();
      for (const HullCorner<float>& c : hull.corners) {
        reach = std::max(reach, bounds::dot(slab.normal, c.position) / c.weight);
      }
      CHECK(reach <= slab.most);
      CHECK(slab.most <= reach + 1e-4f * (1 + std::abs(reach)) * length_above(slab.normal));
    }
  }
}

TEST_CASE("separating axes: an infinite far plane leaves directions, not corners") {
  Frustum<float> f;
  f.infinite_far = true;
  const CullingHull<float> hull = culling_hull(f);
  CHECK(hull.corners[7].weight == 0.0f);
  CHECK(hull.edge_count == 6);
  const AxisBox<float> far_inside = box(-1, 1, -1, 1, -2e20f, -1e20f);
  CHECK(visibility(culling_planes(f), hull, far_inside) == Visibility::accepted);
  const CullingHull<float> of_matrix = culling_hull(Projection<float>(f));
  REQUIRE(of_matrix.known);
  CHECK(of_matrix.corners[7].weight == 0.0f);
  CHECK(of_matrix.reach.lower[2] == -std::numeric_limits<float>::infinity());
  CHECK(of_matrix.reach.upper[2] >= -1.0f);
  CHECK(of_matrix.reach.upper[2] < -0.99999f);
}

TEST_CASE(
    "separating axes: a matrix's planes with the reach of its hull reject what a frustum's do") {
  const Frustum<float> f;
  const Projection<float> p(f);
  const CullingHull<float> hull = culling_hull(p);
  const AxisBox<float> beside = box(10.5f, 30, -5, 5, -25, -5);
  CHECK(visibility(culling_planes(f), beside) == Visibility::rejected);
  CHECK(visibility(culling_planes(p), beside) == Visibility::look_closer);
  CHECK(visibility(with_reach(culling_planes(p), hull), beside) == Visibility::rejected);
  for (int i = 0; i < 3; ++i) {
    const AxisBox<float> expected = culling_planes(f).reach;
    CHECK(hull.reach.lower[i] == Approx(expected.lower[i]).epsilon(1e-5));
    CHECK(hull.reach.upper[i] == Approx(expected.upper[i]).epsilon(1e-5));
  }
}

TEST_CASE("separating axes: a singular matrix settles nothing") {
  std::array<Vec4<float>, 4> rows = rows_of(Projection<float>(Frustum<float>{}));
  rows[1] = rows[0];
  CHECK_FALSE(culling_hull(DepthRange::minus_one_to_one, rows).known);
  rows[1] = Vec4<float>(std::nanf(""));
  CHECK_FALSE(culling_hull(DepthRange::minus_one_to_one, rows).known);
}
