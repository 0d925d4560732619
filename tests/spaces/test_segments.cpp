// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every clipper of segments must keep, in every scalar.
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "tests/catch.hpp"
#include "tests/spaces/clippers.hpp"
#include "tests/spaces/segments.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::AllScalars;
using experiments::Counted;
using experiments::Exact;
using experiments::for_each_type;
using experiments::nearest_double;

namespace {

constexpr ClipVolume kGl{};

using FloatingScalars = TypeList<float, double, dd_real, Counted>;

// Calls f(clipper) for every segment clipper that takes clip space, in every scalar given.
template <class Scalars, class F>
void for_every_clip_space(F&& f) {
  for_every_clipper<Scalars, 2>([&](const auto& clip) {
    if (clip.takes_clip_space()) f(clip);
  });
}

template <Scalar T>
using SegmentClipper = ClipperIn<T, 2>;

template <Scalar T>
NdcPolygon<T, K> clip_ends(const SegmentClipper<T>& clip, const Ends& ends,
                           const ClipVolume& volume = kGl) {
  return clip(clip_segment<T>(ends), volume);
}

// The planes that a method cuts by before it divides; it drops what then has w <= 0.
Outcode planes_before_divide(const SegmentClipper<Exact>& clip) {
  if (clip.name.starts_with("window/")) return ~kSidePlanes;
  if (clip.promise.domain == Promise::Domain::divisible) return bit(Plane::near);
  return 0;
}

std::optional<Interval<Exact>> exact_interval(const ClipVolume& volume, Outcode planes,
                                              const ClipSegment<Exact, K>& segment) {
  return visible_interval<Exact>(planes_of(volume) & planes, Exact(0), [&](Plane plane) {
    return std::array<Exact, 2>{signed_distance(volume.depth, plane, segment[0]),
                                signed_distance(volume.depth, plane, segment[1])};
  });
}

ClipVertex<Exact, K> at(const ClipSegment<Exact, K>& segment, const Exact& s) {
  return interpolate(segment[0], segment[1], s);
}

bool has_positive_w(const ClipSegment<Exact, K>& segment, const Interval<Exact>& part) {
  return Exact(0) < at(segment, part.from).position[3] &&
         Exact(0) < at(segment, part.to).position[3];
}

// Whether the method's promise speaks of the segment.
bool in_domain(const SegmentClipper<Exact>& clip, const ClipVolume& volume,
               const ClipSegment<Exact, K>& segment) {
  if (!is_applicable(clip.promise, volume)) return false;
  if (clip.promise.domain == Promise::Domain::any) return true;
  if (clip.promise.domain == Promise::Domain::in_front) return has_positive_w(segment, {});
  const auto part = exact_interval(volume, planes_before_divide(clip), segment);
  return !part || has_positive_w(segment, *part);
}

// Whether some end is strictly inside of each open side.
bool reaches_in(const ClipVolume& volume, const ClipSegment<Exact, K>& segment) {
  const auto is_inside = [&](Plane side, std::size_t end) {
    return Exact(0) < signed_distance(volume.depth, side, segment[end]);
  };
  const OpenSides& open = volume.open_sides;
  const std::array is_open = {open.left, open.right, open.bottom, open.top};
  for (std::size_t side = 0; side < 4; ++side) {
    const auto plane = static_cast<Plane>(side);
    if (is_open[side] && !is_inside(plane, 0) && !is_inside(plane, 1)) return false;
  }
  return true;
}

// No vertex, or the two ends of what is visible, divided.
NdcPolygon<Exact, K> exact_answer(const ClipVolume& volume, const ClipSegment<Exact, K>& segment) {
  NdcPolygon<Exact, K> out;
  const auto part = exact_interval(volume, ~Outcode{0}, segment);
  if (part && has_positive_w(segment, *part) && reaches_in(volume, segment)) {
    out.push_back(to_ndc(at(segment, part->from)));
    out.push_back(to_ndc(at(segment, part->to)));
    keep_if_segment(out);
  }
  return out;
}

const std::vector<ClipVolume> kVolumes = {{DepthRange::minus_one_to_one, false, 0},
                                          {DepthRange::zero_to_one, false, 0},
                                          {DepthRange::reversed, false, 0},
                                          {DepthRange::minus_one_to_one, true, 0},
                                          {DepthRange::reversed, true, 1},
                                          {DepthRange::zero_to_one, false, 3},
                                          {.open_sides = true},
                                          {.depth_clamp = true, .open_sides = true}};

}  // namespace

TEST_CASE("segments: names are unique and every clipper models the concept") {
  std::set<std::string_view> names;
  for_each_type(AllSegmentClippers{}, [&]<class C>() {
    static_assert(Clipper<C, 2>);
    CHECK(names.insert(C::name).second);
  });
  CHECK(names.size() == static_cast<std::size_t>(AllSegmentClippers::size));
}

TEST_CASE("segments: in exact arithmetic every clipper has the exact interval in clip space") {
  std::mt19937_64 random(31);
  for (const ClipVolume& volume : kVolumes) {
    int visible = 0;
    for (int n = 0; n < 600; ++n) {
      // Clip distances that are inside, outside and on the border.
      const std::array<double, 2> attribute = {static_cast<double>(n % 5) - 2,
                                               static_cast<double>(n % 3) - 1};
      const auto segment = clip_segment<Exact>(
          n % 2 == 0 ? lattice_ends(random) : random_ends(random, 2), attribute);
      const auto expected = exact_answer(volume, segment);
      visible += expected.empty() ? 0 : 1;
      for_every_clip_space<TypeList<Exact>>([&](const SegmentClipper<Exact>& clip) {
        if (!in_domain(clip, volume, segment)) return;
        CHECK(same_polygon(clip(segment, volume), expected));
      });
    }
    CHECK(visible > 50);
  }
}

TEST_CASE("segments: in exact arithmetic every clipper has the exact interval in view space") {
  std::mt19937_64 random(32);
  Frustum<double> perspective, infinite, parallel;
  perspective.left = -0.5;
  infinite.infinite_far = true;
  infinite.depth = DepthRange::reversed;
  parallel.kind = ProjectionKind::parallel;
  parallel.shear_x = 0.25;
  parallel.depth = DepthRange::zero_to_one;
  for (const Frustum<double>& frustum : {perspective, infinite, parallel}) {
    for (const DepthClamp depth_clamp : {DepthClamp(), DepthClamp(true), kClampNear, kClampFar}) {
      Projection<Exact> projection(frustum_cast<Exact>(frustum));
      projection.volume.depth_clamp = depth_clamp;
      int visible = 0;
      for (int n = 0; n < 500; ++n) {
        auto view = view_segment<Exact>(n % 2 == 0 ? lattice_ends(random) : random_ends(random, 4));
        projection.volume.clip_distances = n % 3 == 0 ? 1 : 0;
        for (auto& v : view) v.attributes[0] = Exact(static_cast<int>(random() % 4) - 1);
        const auto segment = to_clip(projection, view);
        const auto expected = exact_answer(projection.volume, segment);
        visible += expected.empty() ? 0 : 1;
        for_every_clipper<TypeList<Exact>, 2>([&](const SegmentClipper<Exact>& clip) {
          if (!in_domain(clip, projection.volume, segment)) return;
          CHECK(same_polygon(clip(view, projection), expected));
        });
      }
      CHECK(visible > 20);
    }
  }
}

TEST_CASE(
    "segments: view space leaves w > 0 in front of the near plane for every method but naive") {
  std::mt19937_64 random(33);
  const Projection<Exact> projection{Frustum<Exact>{}};
  for (int n = 0; n < 300; ++n) {
    const auto segment = to_clip(projection, view_segment<Exact>(lattice_ends(random)));
    for (const auto& clip : clippers<Exact, 2>()) {
      if (clip.promise.domain == Promise::Domain::in_front) continue;
      CHECK(in_domain(clip, projection.volume, segment));
    }
  }
}

TEST_CASE("segments: one inside comes out as it is, divided") {
  for_every_clip_space<AllScalars>([]<class T>(const SegmentClipper<T>& clip) {
    const auto out = clip_ends(clip, {{{-0.5, 0.25, 0, 1}, {1, 0.5, -1, 2}}});
    REQUIRE(out.size() == 2);
    CHECK(nearest_double(out[0].position[0]) == -0.5);
    CHECK(nearest_double(out[0].position[1]) == 0.25);
    CHECK(nearest_double(out[1].position[0]) == 0.5);
    CHECK(nearest_double(out[1].position[3]) == 0.5);
    CHECK(nearest_double(out[1].attributes[1]) == 1);
  });
}

TEST_CASE("segments: the volume is closed, a segment between its corners is untouched") {
  for_every_clip_space<AllScalars>([]<class T>(const SegmentClipper<T>& clip) {
    for (const double w : {1.0, 3.0, 1e-20, 0x1p-126}) {
      const auto out = clip_ends(clip, {{{-w, -w, -w, w}, {w, w, w, w}}});
      REQUIRE(out.size() == 2);
      CHECK(nearest_double(out[0].position[0]) == -1);
      CHECK(nearest_double(out[1].position[2]) == 1);
    }
  });
}

TEST_CASE("segments: the ulp neighbours of a plane are cut exactly when they are outside") {
  using Limits = std::numeric_limits<float>;
  for_every_clip_space<AllScalars>([]<class T>(const SegmentClipper<T>& clip) {
    for (const int axis : {0, 1, 2}) {
      for (const float sign : {-1.0f, 1.0f}) {
        const std::array<float, 3> neighbours = {std::nextafter(sign, 0.0f), sign,
                                                 std::nextafter(sign, sign * Limits::max())};
        for (std::size_t i = 0; i < 3; ++i) {
          Ends ends = {{{0, 0, 0, 1}, {0, 0, 0, 1}}};
          ends[1][static_cast<std::size_t>(axis)] = neighbours[i];
          const auto out = clip_ends(clip, ends);
          REQUIRE(out.size() == 2);
          const double expected = i == 0 ? neighbours[0] : sign;
          CHECK(nearest_double(out[1].position[axis]) == expected);
        }
      }
    }
  });
}

TEST_CASE("segments: only one point left is nothing") {
  for_every_clip_space<AllScalars>([]<class T>(const SegmentClipper<T>& clip) {
    CHECK(clip_ends(clip, {{{1, 0, 0, 1}, {2, 0, 0, 1}}}).empty());           // touches with an end
    CHECK(clip_ends(clip, {{{2, 0, 0, 1}, {1, 0, 0, 1}}}).empty());           // the other end
    CHECK(clip_ends(clip, {{{2, 0, 0, 1}, {0, 2, 0, 1}}}).empty());           // touches an edge
    CHECK(clip_ends(clip, {{{0.5, 0, 0, 1}, {0.5, 0, 0, 1}}}).empty());       // is a point, inside
    CHECK(clip_ends(clip, {{{-1, 1, 1, 1}, {-2, 2, 2, 1}}}).empty());         // touches a corner
    CHECK(clip_ends(clip, {{{1, 0.5, 0, 1}, {1, -0.5, 0, 1}}}).size() == 2);  // lies in a plane
    CHECK(clip_ends(clip, {{{1, 1, 5, 1}, {1, 1, -5, 1}}}).size() == 2);      // lies in an edge
  });
}

// x + w = 1 all along the segment: there is no solution of x / w = -1.
TEST_CASE("segments: from (-2, 0, 0, 3) to (4, 0, 0, -3) what is in front of x = w is visible") {
  for_every_clip_space<AllScalars>([]<class T>(const SegmentClipper<T>& clip) {
    if (clip.promise.domain == Promise::Domain::in_front) return;
    // With z = -1 the near plane leaves w >= 1; with z = 0 only w >= 0, which can't be divided.
    const auto near = clip_ends(clip, {{{-2, 0, -1, 3}, {4, 0, -1, -3}}});
    REQUIRE(near.size() == 2);
    CHECK(nearest_double(near[1].position[0]) == Approx(0).margin(1e-6));
    CHECK(nearest_double(near[1].position[3]) == Approx(1));
    const auto out = clip_ends(clip, {{{-2, 0, 0, 3}, {4, 0, 0, -3}}});
    if (clip.promise.domain == Promise::Domain::divisible) {
      CHECK(out.empty());
      return;
    }
    REQUIRE(out.size() == 2);
    CHECK(nearest_double(out[0].position[0]) == Approx(-2.0 / 3));
    CHECK(nearest_double(out[1].position[0]) == Approx(1.0));
    CHECK(nearest_double(out[1].position[3]) == Approx(2.0));
    CHECK(nearest_double(out[1].attributes[1]) == Approx(5.0 / 12));
  });
}

TEST_CASE("segments: w <= 0 at one end, at both, and at the eye") {
  for_every_clip_space<AllScalars>([]<class T>(const SegmentClipper<T>& clip) {
    if (clip.promise.domain == Promise::Domain::in_front) return;
    CHECK(clip_ends(clip, {{{0.1, 0, 0, -1}, {0.2, 0, 0, -2}}}).empty());  // behind
    CHECK(clip_ends(clip, {{{0.1, 0, 0, 0}, {0.2, 0, 0, 0}}}).empty());    // at infinity
    CHECK(clip_ends(clip, {{{0, 0, 0, 0}, {0, 0, 0, 0}}}).empty());        // nowhere
    CHECK(clip_ends(clip, {{{0, 0, 0, 0}, {0.5, 0, 0, 1}}}).empty());  // one point of the picture
    CHECK(clip_ends(clip, {{{0.5, 0.5, 0.5, 1}, {-0.5, -0.5, -0.5, -1}}}).empty());  // the same
    for (const double w : {-1.0, -0.0, 0.0}) {
      const auto out = clip_ends(clip, {{{0, 0.5, -0.5, 1}, {0, 0.5, -2, w}}});
      REQUIRE(out.size() == 2);
      CHECK(nearest_double(out[1].position[2]) == Approx(-1.0));
    }
  });
}

TEST_CASE(
    "segments: dividing whatever w is draws the wrong segment, cutting near first the right one") {
  const Ends through_the_eye_plane = {{{0, 0, -2, 0}, {0, 2, 2, 0}}};
  const Projection<double> projection(Frustum<double>{});
  NdcPolygon<double, K> right, wrong;
  CvvLiangBarsky{}(projection, view_segment<double>(through_the_eye_plane), right);
  CvvLiangBarskyNaive{}(projection, view_segment<double>(through_the_eye_plane), wrong);
  REQUIRE(right.size() == 2);
  CHECK(right[1].position[1] == Approx(0.5));
  CHECK((wrong.size() != 2 || wrong[1].position[1] != Approx(0.5)));
}

TEST_CASE("segments: depth clamp keeps what is nearer than near and farther than far") {
  const ClipVolume clamped{.depth_clamp = true};
  for_every_clip_space<AllScalars>([&]<class T>(const SegmentClipper<T>& clip) {
    if (!is_applicable(clip.promise, clamped)) return;
    const auto out = clip_ends(clip, {{{0, 0, -3, 1}, {2, 0, 5, 1}}}, clamped);
    REQUIRE(out.size() == 2);
    CHECK(nearest_double(out[0].position[2]) == -3);
    CHECK(nearest_double(out[1].position[0]) == 1);
    CHECK(nearest_double(out[1].position[2]) == 1);
  });
}

TEST_CASE("segments: a clip distance cuts, and one that is NaN leaves nothing") {
  const ClipVolume one_distance{.clip_distances = 1};
  for_every_clip_space<AllScalars>([&]<class T>(const SegmentClipper<T>& clip) {
    auto segment = clip_segment<T>({{{-0.5, 0, 0, 1}, {0.5, 0, 0, 1}}});
    segment[0].attributes[0] = T(1);
    segment[1].attributes[0] = T(-3);
    const auto out = clip(segment, one_distance);
    REQUIRE(out.size() == 2);
    CHECK(nearest_double(out[1].position[0]) == -0.25);
    CHECK(nearest_double(out[1].attributes[0]) == 0);
    if constexpr (kHasInfinity<T>) {
      segment[0].attributes[0] = T(std::numeric_limits<float>::quiet_NaN());
      CHECK(clip(segment, one_distance).empty());
      CHECK(clip(segment).size() == 2);
    }
  });
}

TEST_CASE("segments: NaN and infinity in any position coordinate yield nothing") {
  std::mt19937_64 random(34);
  using Limits = std::numeric_limits<float>;
  for (const float bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (int n = 0; n < 100; ++n) {
      const Ends ends = random_ends(random, n % 2 == 0 ? 0.5 : 3);
      const ClipVolume& volume = kVolumes[static_cast<std::size_t>(n) % kVolumes.size()];
      for (const std::size_t end : {0u, 1u}) {
        for (const int coordinate : {0, 1, 2, 3}) {
          for_every_clip_space<FloatingScalars>([&]<class T>(const SegmentClipper<T>& clip) {
            auto segment = clip_segment<T>(ends, {1, 1});
            if (n % 2 == 0) segment[1 - end].position[3] = T(2);
            segment[end].position[coordinate] = T(bad);
            CHECK(clip(segment, volume).empty());
          });
          if (coordinate == 3) continue;
          for_every_clipper<FloatingScalars, 2>([&]<class T>(const SegmentClipper<T>& clip) {
            Projection<T> projection{Frustum<T>{}};
            projection.volume.depth_clamp = volume.depth_clamp;
            auto segment = view_segment<T>(ends);
            if (n % 2 == 0) segment[1 - end].position[2] = T(-2);
            segment[end].position[coordinate] = T(bad);
            CHECK(clip(segment, projection).empty());
          });
        }
      }
    }
  }
}

TEST_CASE("segments: from finite positions of any magnitude no NaN and no infinity comes out") {
  std::mt19937_64 random(35);
  using Limits = std::numeric_limits<float>;
  const std::array<float, 12> specials = {0.0f,
                                          -0.0f,
                                          Limits::denorm_min(),
                                          Limits::min(),
                                          -Limits::min(),
                                          Limits::max(),
                                          -1.0f,
                                          -Limits::max(),
                                          1.0f,
                                          0.5f,
                                          Limits::max() / 2,
                                          -1e-42f};
  for (int n = 0; n < 6000; ++n) {
    Ends ends;
    for (auto& end : ends) {
      for (double& x : end) x = specials[random() % specials.size()];
    }
    const ClipVolume& volume = kVolumes[static_cast<std::size_t>(n) % kVolumes.size()];
    for_every_clip_space<TypeList<float, Counted>>([&]<class T>(const SegmentClipper<T>& clip) {
      const auto out = clip_ends(clip, ends, volume);
      CHECK((out.size() == 0 || out.size() == 2));
      for (const auto& v : out) {
        for (int i = 0; i < 3; ++i) CHECK(is_finite(v.position[i]));
        CHECK_FALSE(is_nan(v.position[3]));
      }
    });
    for_every_clipper<TypeList<float>, 2>([&]<class T>(const SegmentClipper<T>& clip) {
      for (const auto& v : clip(view_segment<T>(ends))) {
        for (int i = 0; i < 3; ++i) CHECK(is_finite(v.position[i]));
        CHECK_FALSE(is_nan(v.position[3]));
      }
    });
  }
}

TEST_CASE("segments: random bits of floats end, and give what lies in the volume") {
  std::mt19937_64 random(36);
  for (int n = 0; n < 30000; ++n) {
    Ends ends;
    for (auto& end : ends) {
      for (double& x : end) {
        x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(x)) x = 0;
      }
    }
    for_every_clip_space<TypeList<float>>([&]<class T>(const SegmentClipper<T>& clip) {
      for (const auto& v : clip_ends(clip, ends)) {
        for (int i = 0; i < 3; ++i) CHECK(is_finite(v.position[i]));
      }
    });
  }
}

TEST_CASE("segments: the reverse of a segment gives the same bits where that is promised") {
  std::mt19937_64 random(37);
  for (int n = 0; n < 1000; ++n) {
    const Ends ends = random_ends(random, std::ldexp(1.0, n % 8));
    for_every_clip_space<FloatingScalars>([&]<class T>(const SegmentClipper<T>& clip) {
      if (!clip.promise.rotation_invariant) return;
      const auto segment = clip_segment<T>(ends);
      auto back = clip(reversed(segment));
      if (back.size() == 2) std::swap(back[0], back[1]);
      CHECK(same_polygon(clip(segment), back));
    });
    for_every_clipper<FloatingScalars, 2>([&]<class T>(const SegmentClipper<T>& clip) {
      if (!clip.promise.rotation_invariant) return;
      auto back = clip(reversed(view_segment<T>(ends)));
      if (back.size() == 2) std::swap(back[0], back[1]);
      CHECK(same_polygon(clip(view_segment<T>(ends)), back));
    });
  }
}

TEST_CASE("segments: homogeneous coordinates scaled by 2^k give the same picture, to the bit") {
  std::mt19937_64 random(38);
  for (const int k : {-100, -60, -7, 1, 40, 100}) {
    for (int n = 0; n < 300; ++n) {
      const Ends ends = random_ends(random, 3);
      Ends scaled = ends;
      for (auto& end : scaled) {
        for (double& x : end) x = std::ldexp(x, k);
      }
      for_every_clip_space<TypeList<float, double>>([&]<class T>(const SegmentClipper<T>& clip) {
        REQUIRE(clip.promise.scale_invariant);
        const auto a = clip_ends(clip, ends);
        const auto b = clip_ends(clip, scaled);
        REQUIRE(a.size() == b.size());
        for (int v = 0; v < a.size(); ++v) {
          for (int i = 0; i < 3; ++i) CHECK(a[v].position[i] == b[v].position[i]);
          CHECK(a[v].attributes.values == b[v].attributes.values);
        }
      });
    }
  }
}

TEST_CASE(
    "segments: cut by one plane, a segment gets the bits of an edge cut from its inside end") {
  std::mt19937_64 random(39);
  std::ptrdiff_t found = 0;
  for (int n = 0; n < 500; ++n) {
    auto triangle = clip_triangle<float>(random_corners(random, 0.5));
    for (auto& v : triangle) v.position[3] = 1;
    triangle[2].position[0] += 2;
    NdcPolygon<float, K> polygon, edge;
    HomogeneousFromInside{}(kGl, triangle, polygon);
    for_each_type(TypeList<HomogeneousCohenSutherland, HomogeneousLiangBarsky,
                           HomogeneousLiangBarskyDivisionFree>{},
                  [&]<class C>() {
                    C{}(kGl, ClipSegment<float, K>{triangle[0], triangle[2]}, edge);
                    REQUIRE(edge.size() == 2);
                    for (const auto& v : edge) {
                      found += std::count_if(polygon.begin(), polygon.end(),
                                             [&](const auto& p) { return same(p, v); });
                    }
                  });
  }
  CHECK(found == 2 * 3 * 500);
}
