// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "spaces/cut.hpp"
#include "spaces/plane_segment.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Counted;
using experiments::Exact;

namespace {

constexpr std::array<DepthRange, 3> kDepths = {DepthRange::minus_one_to_one,
                                               DepthRange::zero_to_one, DepthRange::reversed};

// What f costs, and the side that it answers.
struct Cost {
  SegmentSide side;
  OperationCounts counts;
};

template <class F>
Cost cost_of(F&& f) {
  operation_counts() = {};
  const PlaneCut<Counted> cut = f();
  return {cut.side, operation_counts()};
}

ClipVertex<Counted, 1> counted_vertex(const std::array<float, 4>& p) {
  return {Vec4<Counted>(Counted(p[0]), Counted(p[1]), Counted(p[2]), Counted(p[3])),
          {{Counted(p[0])}}};
}

Frustum<Counted> counted_frustum(ProjectionKind kind, float shear) {
  Frustum<Counted> f;
  f.kind = kind;
  f.shear_x = Counted(shear);
  f.shear_y = Counted(shear / 2);
  return f;
}

}  // namespace

TEST_CASE("plane_segment: a plane by point and normal costs 6 multiplications and 1 division") {
  const PointNormalPlane<Counted> plane = {
      Vec3<Counted>(Counted(0.5f), Counted(0.25f), Counted(-2.0f)),
      Vec3<Counted>(Counted(0.6f), Counted(-0.8f), Counted(0.1f))};
  const Vec3<Counted> inside(Counted(3.0f), Counted(-1.0f), Counted(-2.0f));
  const Vec3<Counted> outside(Counted(-3.0f), Counted(2.0f), Counted(-4.0f));

  const Cost cut = cost_of([&] { return cut_segment(plane, inside, outside); });
  CHECK(cut.side == SegmentSide::cut_second);
  CHECK(cut.counts.multiplications == 6);
  CHECK(cut.counts.divisions == 1);
  CHECK(cut.counts.additions == 11);

  for (const Vec3<Counted>& end : {inside, outside}) {
    const Cost whole = cost_of([&] { return cut_segment(plane, end, end); });
    CHECK(whole.counts.multiplications == 6);
    CHECK(whole.counts.divisions == 0);
  }
}

TEST_CASE("plane_segment: in clip space and in NDC a cut costs 1 division and no multiplication") {
  for (const DepthRange depth : kDepths) {
    for (const Plane plane : kAllPlanes) {
      // Beyond every plane, so that the segment from the middle is cut by each of them.
      const float side = plane == Plane::left || plane == Plane::bottom ? -8.0f : 8.0f;
      const bool low_z = (plane == Plane::near) == (depth != DepthRange::reversed);
      const float z = low_z ? -8.0f : 8.0f;
      const auto inside = counted_vertex({0, 0, 0.5f, 1});
      const auto outside = counted_vertex({side, side, z, 1});
      const NdcVertex<Counted, 1> ndc_inside = to_ndc(inside), ndc_outside = to_ndc(outside);
      for (const Cost& cost :
           {cost_of([&] { return cut_segment(depth, plane, inside, outside); }),
            cost_of([&] { return cut_segment(depth, plane, ndc_inside, ndc_outside); })}) {
        CHECK(cost.side == SegmentSide::cut_second);
        CHECK(cost.counts.divisions == 1);
        CHECK(cost.counts.multiplications == 0);
        CHECK(cost.counts.additions <= 3);
      }
      const Cost accepted = cost_of([&] { return cut_segment(depth, plane, inside, inside); });
      CHECK(accepted.side == SegmentSide::accepted);
      CHECK(accepted.counts.divisions + accepted.counts.multiplications == 0);
      const Cost rejected = cost_of([&] { return cut_segment(depth, plane, outside, outside); });
      CHECK(rejected.side == SegmentSide::rejected);
      CHECK(rejected.counts.divisions + rejected.counts.multiplications == 0);
    }
  }
}

TEST_CASE("plane_segment: perspective, parallel and oblique volumes cost the same once projected") {
  using enum ProjectionKind;
  for (const auto& [kind, shear] :
       {std::pair{perspective, 0.0f}, std::pair{parallel, 0.0f}, std::pair{parallel, 0.5f}}) {
    const Projection<Counted> projection(counted_frustum(kind, shear));
    const ViewSegment<Counted, 0> segment = {
        {{Vec3<Counted>(Counted(0.0f), Counted(0.0f), Counted(-2.0f)), {}},
         {Vec3<Counted>(Counted(40.0f), Counted(0.0f), Counted(-3.0f)), {}}}};
    const ClipSegment<Counted, 0> clip = to_clip(projection, segment);
    const Cost cost = cost_of(
        [&] { return cut_segment(projection.volume.depth, Plane::right, clip[0], clip[1]); });
    CHECK(cost.side == SegmentSide::cut_second);
    CHECK(cost.counts == OperationCounts{.additions = 3,
                                         .multiplications = 0,
                                         .divisions = 1,
                                         .comparisons = cost.counts.comparisons});
  }
}

TEST_CASE("plane_segment: t runs from the kept end to the one cut away, in both directions") {
  const PlaneCut<double> second = cut_segment(1.0, -3.0);
  CHECK(second.side == SegmentSide::cut_second);
  CHECK(second.t == 0.25);
  const PlaneCut<double> first = cut_segment(-3.0, 1.0);
  CHECK(first.side == SegmentSide::cut_first);
  CHECK(first.t == 0.25);
}

TEST_CASE("plane_segment: on the plane is inside, and a segment of one point is rejected") {
  CHECK(cut_segment(0.0, 0.0).side == SegmentSide::accepted);
  CHECK(cut_segment(0.0, 2.0).side == SegmentSide::accepted);
  CHECK(cut_segment(2.0, -0.0).side == SegmentSide::accepted);
  CHECK(cut_segment(0.0, -1.0).side == SegmentSide::rejected);
  CHECK(cut_segment(-1.0, 0.0).side == SegmentSide::rejected);
  CHECK(cut_segment(-1.0, -1.0).side == SegmentSide::rejected);
}

TEST_CASE("plane_segment: ulp neighbours of the plane fall on their own side") {
  const float below = std::nextafter(-1.0f, -2.0f), above = std::nextafter(-1.0f, 0.0f);
  const ClipVertex<float, 0> inside = {Vec4<float>(0, 0, 0, 1), {}};
  const auto side = [&](float x) {
    const ClipVertex<float, 0> end = {Vec4<float>(x, 0, 0, 1), {}};
    return cut_segment(DepthRange::minus_one_to_one, Plane::left, inside, end).side;
  };
  CHECK(side(below) == SegmentSide::cut_second);
  CHECK(side(-1.0f) == SegmentSide::accepted);
  CHECK(side(above) == SegmentSide::accepted);
}

TEST_CASE("plane_segment: a NaN distance leaves nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double d : {-1.0, 0.0, 1.0, nan}) {
    CHECK(cut_segment(d, nan).side == SegmentSide::rejected);
    CHECK(cut_segment(nan, d).side == SegmentSide::rejected);
  }
}

// x / w = -1 has no solution on this segment: x + w = 1 all along it.
TEST_CASE("plane_segment: where x = -w has no solution nothing is divided by zero") {
  const auto a = counted_vertex({-2, 0, 0, 3}), b = counted_vertex({4, 0, 0, -3});
  const DepthRange depth = DepthRange::minus_one_to_one;
  const Cost left = cost_of([&] { return cut_segment(depth, Plane::left, a, b); });
  CHECK(left.side == SegmentSide::accepted);
  CHECK(left.counts.divisions == 0);
  const PlaneCut<Counted> right = cut_segment(depth, Plane::right, a, b);
  CHECK(right.side == SegmentSide::cut_second);
  CHECK(right.t.value() == 5.0f / 12);
}

TEST_CASE("plane_segment: the denominator vanishes for no distances of any sign and magnitude") {
  std::mt19937_64 random(21);
  for (int n = 0; n < 20000; ++n) {
    const auto distance = [&] {
      const double sign = (random() & 1) == 0 ? 1 : -1;
      return static_cast<float>(sign * std::ldexp(1.0 + static_cast<double>(random() % 97) / 97,
                                                  static_cast<int>(random() % 270) - 149));
    };
    const PlaneCut<float> cut = cut_segment(distance(), distance());
    CHECK((cut.t >= 0 && cut.t <= 1));
  }
}

TEST_CASE("plane_segment: the cut of a polygon's edge from its inside end is that of a segment") {
  std::mt19937_64 random(22);
  for (int n = 0; n < 2000; ++n) {
    const auto triangle = clip_triangle<float>(random_corners(random, 3));
    ClipPolygon<float, K> in, out;
    in.assign(triangle);
    cut_by_distances(
        in, out,
        [](const ClipVertex<float, K>& v) {
          return clip_distance(DepthRange::minus_one_to_one, Plane::right, v.position);
        },
        [](const auto& inside, const auto& outside, float d_inside, float d_outside) {
          return interpolate(inside, outside, cut_parameter(d_inside, d_outside));
        });
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = triangle[i], &b = triangle[(i + 1) % 3];
      const PlaneCut<float> edge = cut_segment(DepthRange::minus_one_to_one, Plane::right, a, b);
      if (edge.side != SegmentSide::cut_first && edge.side != SegmentSide::cut_second) continue;
      const bool first = edge.side == SegmentSide::cut_first;
      const auto expected = first ? interpolate(b, a, edge.t) : interpolate(a, b, edge.t);
      CHECK(std::any_of(out.begin(), out.end(),
                        [&](const auto& v) { return v.position == expected.position; }));
    }
  }
}
