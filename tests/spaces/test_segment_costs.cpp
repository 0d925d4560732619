// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the segment methods cost in operations: divisions above all.
#include "spaces/cohen_sutherland.hpp"
#include "spaces/cvv/skala_polyhedron.hpp"
#include "spaces/cyrus_beck.hpp"
#include "spaces/homogeneous/blinn.hpp"
#include "spaces/liang_barsky.hpp"
#include "spaces/pruning.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/segments.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Counted;
using experiments::for_each_type;

namespace {

struct Cost {
  bool visible;
  OperationCounts counts;
};

// What the method alone costs, without projection and divide.
template <class Method>
Cost cost_in_clip_space(const Ends& ends) {
  const auto segment = clip_segment<Counted>(ends);
  const HomogeneousSegmentSpace<Counted, K> space{ClipVolume{}};
  operation_counts() = {};
  const bool visible = Method{}(space, segment).has_value();
  return {visible, operation_counts()};
}

template <class Method>
Cost cost_in_plane(const std::array<std::array<float, 2>, 2>& s) {
  const Segment2<Counted> segment = {Vec2<Counted>(Counted(s[0][0]), Counted(s[0][1])),
                                     Vec2<Counted>(Counted(s[1][0]), Counted(s[1][1]))};
  const RectangleSpace<Counted> space{Rectangle<Counted>{}};
  operation_counts() = {};
  const bool visible = Method{}(space, segment).has_value();
  return {visible, operation_counts()};
}

const Ends kInside = {{{-0.5, 0, 0, 1}, {0.5, 0.25, 0.5, 1}}};
const Ends kOneEndOut = {{{-0.5, 0, 0, 1}, {3, 0.25, 0.5, 1}}};
const Ends kBothEndsOut = {{{-3, 0, 0, 1}, {3, 0.25, 0.5, 1}}};
const Ends kOutsideOnePlane = {{{2, 0, 0, 1}, {3, 0.25, 0.5, 1}}};
const Ends kPastAnEdge = {{{3, 0, 0, 1}, {0, 3, 0, 1}}};
// Outside of right, top and far: the last of these binds.
const Ends kThreePlanes = {{{0, 0, 0, 1}, {2, 3, 4, 1}}};

}  // namespace

TEST_CASE("segment costs: division-free Liang-Barsky divides once for each end that it moves") {
  using Method = LiangBarskyDivisionFree;
  CHECK(cost_in_clip_space<Method>(kInside).counts.divisions == 0);
  CHECK(cost_in_clip_space<Method>(kInside).counts.multiplications == 0);
  CHECK(cost_in_clip_space<Method>(kOutsideOnePlane).counts.divisions == 0);
  CHECK(cost_in_clip_space<Method>(kPastAnEdge).counts.divisions == 0);
  CHECK_FALSE(cost_in_clip_space<Method>(kPastAnEdge).visible);
  CHECK(cost_in_clip_space<Method>(kOneEndOut).counts.divisions == 1);
  CHECK(cost_in_clip_space<Method>(kBothEndsOut).counts.divisions == 2);
  CHECK(cost_in_clip_space<Method>(kThreePlanes).counts.divisions == 1);
}

TEST_CASE("segment costs: classical Liang-Barsky divides for planes that shorten nothing") {
  using Method = LiangBarskyClassical;
  CHECK(cost_in_clip_space<Method>(kInside).visible);
  CHECK(cost_in_clip_space<Method>(kInside).counts.divisions == 6);
  CHECK(cost_in_clip_space<Method>(kOneEndOut).counts.divisions == 6);
  CHECK(cost_in_clip_space<Method>(kPastAnEdge).counts.divisions > 0);
}

TEST_CASE("segment costs: Blinn's outcodes settle free, each plane between the ends divides once") {
  using Method = BlinnLines;
  for (const Ends& ends : {kInside, kOutsideOnePlane}) {
    const OperationCounts counts = cost_in_clip_space<Method>(ends).counts;
    CHECK(counts.divisions + counts.multiplications == 0);
  }
  CHECK(cost_in_clip_space<Method>(kOneEndOut).counts.divisions == 1);
  CHECK(cost_in_clip_space<Method>(kBothEndsOut).counts.divisions == 2);
  CHECK(cost_in_clip_space<Method>(kThreePlanes).counts.divisions == 3);
  CHECK_FALSE(cost_in_clip_space<Method>(kPastAnEdge).visible);
}

TEST_CASE("segment costs: pruning divides for each plane that still cuts") {
  CHECK(cost_in_clip_space<Pruning>(kInside).counts.divisions == 0);
  CHECK(cost_in_clip_space<Pruning>(kOutsideOnePlane).counts.divisions == 0);
  CHECK(cost_in_clip_space<Pruning>(kBothEndsOut).counts.divisions == 2);
  CHECK(cost_in_clip_space<Pruning>(kThreePlanes).counts.divisions == 3);
}

TEST_CASE("segment costs: Cyrus-Beck in clip space divides for every plane, multiplies for none") {
  for (const Ends& ends : {kInside, kOneEndOut, kOutsideOnePlane, kThreePlanes}) {
    const OperationCounts counts = cost_in_clip_space<CyrusBeck>(ends).counts;
    CHECK(counts.divisions == 6);
  }
}

TEST_CASE("segment costs: Skala's two planes leave two facets to divide for, or none") {
  const CvvSegmentSpace<Counted, K> space{ClipVolume{}};
  const auto cut_divisions = [&](const Ends& ends) {
    const auto segment = clip_segment<Counted>(ends);
    const std::array<NdcVertex<Counted, K>, 2> divided = {to_ndc(segment[0]), to_ndc(segment[1])};
    operation_counts() = {};
    const bool visible = SkalaPolyhedron{}(space, divided).has_value();
    const std::uint64_t divisions = operation_counts().divisions;
    // One more for the attributes of each new end, where something is visible.
    return std::pair(visible, divisions);
  };
  CHECK(cut_divisions(kInside) == std::pair(true, std::uint64_t{2}));
  CHECK(cut_divisions(kOneEndOut) == std::pair(true, std::uint64_t{3}));
  CHECK(cut_divisions(kBothEndsOut) == std::pair(true, std::uint64_t{4}));
  CHECK(cut_divisions({{{3, 0, 0, 1}, {0, 5, 0, 1}}}) == std::pair(false, std::uint64_t{0}));
}

TEST_CASE("segment costs: Cohen-Sutherland accepts and rejects free, and repeats work to shorten") {
  using Method = CohenSutherland;
  for (const Ends& ends : {kInside, kOutsideOnePlane}) {
    const OperationCounts counts = cost_in_clip_space<Method>(ends).counts;
    CHECK(counts.divisions + counts.multiplications == 0);
  }
  CHECK(cost_in_clip_space<Method>(kOneEndOut).counts.divisions == 1);
  CHECK(cost_in_clip_space<Method>(kThreePlanes).counts.divisions == 3);
  CHECK(cost_in_clip_space<Method>(kPastAnEdge).counts.divisions > 0);
  CHECK_FALSE(cost_in_clip_space<Method>(kPastAnEdge).visible);
}

TEST_CASE("segment costs: in the plane Nicholl-Lee-Nicholl compares least and divides least") {
  const std::array<std::array<float, 2>, 2> inside = {{{0, 0}, {0.5f, 0.5f}}};
  const std::array<std::array<float, 2>, 2> beside = {{{-3, 0}, {-2, 5}}};
  const std::array<std::array<float, 2>, 2> past_corner = {{{-3, 0.5f}, {0.5f, 3}}};
  const std::array<std::array<float, 2>, 2> across = {{{-3, 0}, {3, 0.5f}}};
  const std::array<std::array<float, 2>, 2> corners = {{{-3, -2}, {2, 3.25f}}};
  const std::array<std::array<float, 2>, 2> out_by_corner = {{{0, 0}, {2, 3}}};
  for (const auto& s : {inside, beside, past_corner, across, corners, out_by_corner}) {
    const Cost nln = cost_in_plane<NichollLeeNicholl>(s);
    const Cost classical = cost_in_plane<LiangBarskyClassical>(s);
    const Cost division_free = cost_in_plane<LiangBarskyDivisionFree>(s);
    const Cost outcodes = cost_in_plane<CohenSutherland>(s);
    for (const Cost& other : {classical, division_free, outcodes}) {
      CHECK(nln.visible == other.visible);
      CHECK(nln.counts.divisions <= other.counts.divisions);
    }
    CHECK(nln.counts.additions <= division_free.counts.additions);
    CHECK(nln.counts.multiplications <= division_free.counts.multiplications);
  }
  CHECK(cost_in_plane<NichollLeeNicholl>(past_corner).counts.divisions == 0);
  CHECK(cost_in_plane<NichollLeeNicholl>(out_by_corner).counts.divisions == 1);
  CHECK(cost_in_plane<CohenSutherland>(out_by_corner).counts.divisions == 2);
  CHECK(cost_in_plane<LiangBarskyClassical>(inside).counts.divisions == 4);
}

TEST_CASE("segment costs: who divides to accept or to reject in the plane") {
  using Ends2 = std::array<std::array<float, 2>, 2>;
  const Ends2 inside = {{{0, 0}, {0.5f, 0.25f}}};
  const Ends2 beside = {{{-3, 0}, {-2, 5}}};
  const Ends2 past_corner = {{{-3, 0.5f}, {0.5f, 3}}};
  const Ends2 one_out = {{{0, 0}, {3, 0.5f}}};
  const Ends2 across = {{{-3, 0}, {3, 0.5f}}};
  const auto divisions = [&]<class Method>(Method) {
    std::vector<std::uint64_t> counts;
    for (const Ends2& s : {inside, beside, past_corner, one_out, across}) {
      counts.push_back(cost_in_plane<Method>(s).counts.divisions);
    }
    return counts;
  };
  using Counts = std::vector<std::uint64_t>;
  CHECK(divisions(MidpointSubdivision{}) == Counts{0, 0, 0, 0, 0});
  CHECK(divisions(SobkowPospisilYang{}) == Counts{0, 0, 1, 1, 2});
  CHECK(divisions(SkalaHomogeneous{}) == Counts{0, 0, 0, 1, 2});
  CHECK(divisions(RayCorners{}) == Counts{0, 0, 0, 1, 2});
  CHECK(divisions(KodituwakkuWijeweeraChamikara{}) == Counts{2, 4, 4, 2, 2});
  CHECK(divisions(MatthesDrakopoulos{}) == Counts{0, 0, 3, 1, 2});
}

TEST_CASE("segment costs: Cyrus-Beck divides for every plane, whatever comes of it") {
  const Projection<Counted> projection{Frustum<Counted>{}};
  for (const Ends& ends :
       {Ends{{{-0.5, 0, -2, 0}, {0.25, 0.5, -3, 0}}}, Ends{{{9, 0, -2, 0}, {7, 0.5, -3, 0}}}}) {
    const auto segment = view_segment<Counted>(ends);
    NdcPolygon<Counted, K> out;
    operation_counts() = {};
    ViewCyrusBeck{}(projection, segment, out);
    const std::uint64_t divide = out.empty() ? 0 : 2 * 4;
    CHECK(operation_counts().divisions == 6 + divide);
  }
}
