// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <set>

#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::AllScalars;
using experiments::Exact;
using experiments::for_each_type;
using experiments::nearest_double;
using experiments::scalar_from;

namespace {

constexpr ClipVolume kGl{};

template <class T>
ClipPoint<T, K> clip_point(const std::array<double, 4>& p) {
  return {clip_triangle<T>({p, p, p})[0]};
}

template <class C, class T>
bool is_kept(const std::array<double, 4>& p, double half = 0, const ClipVolume& volume = kGl) {
  const PointSize<T> size = {scalar_from<T>(half), scalar_from<T>(half)};
  NdcPolygon<T, K> out;
  C{}(volume, clip_point<T>(p), size, out);
  CHECK((out.size() == 0 || out.size() == 1));
  return out.size() == 1;
}

template <class F>
void for_every_point_clipper(F&& f) {
  for_each_type(AllPointClippers{}, [&]<class C>() {
    for_each_type(AllScalars{}, [&]<class T>() {
      INFO(C::name << " in " << experiments::kFormat<T>.name);
      f.template operator()<C, T>();
    });
  });
}

// Whether the volume has the point: by the definition, plane by plane.
bool is_inside(const ClipVolume& volume, const ClipVertex<Exact, K>& v) {
  bool inside = Exact(0) < v.position[3];
  for_each_plane(planes_of(volume), kAllPlanes, [&](Plane plane) {
    const Exact d = signed_distance(volume.depth, plane, v);
    const bool is_open = (open_planes_of(volume) & bit(plane)) != 0;
    inside = inside && (is_open ? Exact(0) < d : Exact(0) <= d);
  });
  return inside;
}

}  // namespace

TEST_CASE("points: names are unique and every clipper models the concept") {
  std::set<std::string_view> names;
  for_each_type(AllPointClippers{}, [&]<class C>() {
    static_assert(Clipper<C, 1>);
    static_assert(ClipsClipSpace<C, float, 4, 1>);
    CHECK(names.insert(C::name).second);
  });
}

TEST_CASE("points: of size 0, what is inside comes out divided, the rest does not") {
  std::mt19937_64 random(61);
  for (const ClipVolume& volume :
       {ClipVolume{}, ClipVolume{.depth = DepthRange::reversed},
        ClipVolume{.depth = DepthRange::zero_to_one, .clip_distances = 2},
        ClipVolume{.depth_clamp = true}, ClipVolume{.open_sides = true}}) {
    for (int n = 0; n < 500; ++n) {
      auto point = clip_point<Exact>(lattice_corners(random)[0]);
      point[0].attributes[0] = Exact(n % 3 - 1);
      for_each_type(AllPointClippers{}, [&]<class C>() {
        NdcPolygon<Exact, K> out;
        C{}(volume, point, out);
        REQUIRE(out.size() == (is_inside(volume, point[0]) ? 1 : 0));
        if (!out.empty()) CHECK(same(out[0], to_ndc(point[0])));
      });
    }
  }
}

TEST_CASE("points: view space gives what its projection gives") {
  std::mt19937_64 random(62);
  for (int n = 0; n < 200; ++n) {
    const Corners corners = random_corners(random, 4);
    for_every_point_clipper([&]<class C, class T>() {
      const Projection<T> projection{Frustum<T>{}};
      const ViewPoint<T, K> view = {view_triangle<T>(corners)[0]};
      NdcPolygon<T, K> from_view, from_clip;
      C{}(projection, view, from_view);
      C{}(projection.volume, to_clip(projection, view), from_clip);
      REQUIRE(from_view.size() == from_clip.size());
      if (!from_view.empty()) CHECK(same(from_view[0], from_clip[0]));
    });
  }
}

TEST_CASE("points: pop drops a point with its centre, pop-free with the last of its square") {
  const float half = 0.25f;
  const float touching = 1 + half;
  const float beyond = std::nextafter(touching, 2.0f);
  const float outside = std::nextafter(1.0f, 2.0f);
  for_each_type(AllScalars{}, [&]<class T>() {
    for (const double sign : {-1.0, 1.0}) {
      for (const double w : {1.0, 4.0}) {
        for (const std::size_t axis : {0u, 1u}) {
          const auto at = [&](double x) {
            std::array<double, 4> p = {0, 0, 0, w};
            p[axis] = sign * x * w;
            return p;
          };
          CHECK(is_kept<PointPop, T>(at(1), half));
          CHECK_FALSE(is_kept<PointPop, T>(at(outside), half));
          CHECK(is_kept<PointPopFree, T>(at(outside), half));
          CHECK(is_kept<PointPopFree, T>(at(touching), half));
          CHECK_FALSE(is_kept<PointPopFree, T>(at(beyond), half));
          CHECK_FALSE(is_kept<PointPopFree, T>(at(outside), 0));
        }
      }
    }
  });
}

TEST_CASE("points: a square past a corner must touch by both axes") {
  CHECK(is_kept<PointPopFree, float>({1.25, 1.25, 0, 1}, 0.25));
  CHECK_FALSE(is_kept<PointPopFree, float>({1.25, 1.5, 0, 1}, 0.25));
}

TEST_CASE("points: near, far and clip distances ask about the centre, whatever the size") {
  for_every_point_clipper([]<class C, class T>() {
    CHECK(is_kept<C, T>({0, 0, -1, 1}, 100));
    CHECK_FALSE(is_kept<C, T>({0, 0, -1.0001, 1}, 100));
    CHECK_FALSE(is_kept<C, T>({0, 0, 1.0001, 1}, 100));
    CHECK(is_kept<C, T>({0, 0, 2, 1}, 100, {.depth_clamp = true}));
    ClipPoint<T, K> point = clip_point<T>({0, 0, 0, 1});
    point[0].attributes[0] = T(-1);
    NdcPolygon<T, K> out;
    C{}(ClipVolume{.clip_distances = 1}, point, PointSize<T>{T(9), T(9)}, out);
    CHECK(out.empty());
  });
}

TEST_CASE("points: behind the eye and at the eye there is none, whatever the size and depth") {
  for_every_point_clipper([]<class C, class T>() {
    for (const ClipVolume& volume : {ClipVolume{}, ClipVolume{.depth_clamp = true}}) {
      CHECK_FALSE(is_kept<C, T>({0, 0, 0, -1}, 100, volume));
      CHECK_FALSE(is_kept<C, T>({0.5, 0, 0, 0}, 100, volume));
      CHECK_FALSE(is_kept<C, T>({0, 0, 0, 0}, 100, volume));
      CHECK_FALSE(is_kept<C, T>({0, 0, 5, -0.0}, 100, volume));
    }
  });
}

TEST_CASE("points: a size in pixels becomes half of it in NDC") {
  const PointSize<double> size = point_size_ndc(20.0, 640.0, 480.0);
  CHECK(size.half_width == 20.0 / 640);
  CHECK(size.half_height == 20.0 / 480);
  // 9.5 px left of the viewport: the square of 20 px still reaches 0.5 px into it.
  const double x = -1 - 9.5 * 2 / 640;
  NdcPolygon<double, K> out;
  PointPopFree{}(kGl, clip_point<double>({x, 0, 0, 1}), size, out);
  CHECK(out.size() == 1);
  PointPopFree{}(kGl, clip_point<double>({-1 - 10.5 * 2 / 640, 0, 0, 1}), size, out);
  CHECK(out.empty());
}

TEST_CASE("points: NaN and infinity yield nothing, and nothing not finite comes out") {
  using Limits = std::numeric_limits<float>;
  for_each_type(AllPointClippers{}, [&]<class C>() {
    for (const ClipVolume& volume : {ClipVolume{}, ClipVolume{.depth_clamp = true}}) {
      for (const float bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
        for (std::size_t coordinate = 0; coordinate < 4; ++coordinate) {
          std::array<double, 4> p = {0, 0, 0, 1};
          p[coordinate] = bad;
          CHECK_FALSE(is_kept<C, float>(p, 0, volume));
          CHECK_FALSE(is_kept<C, float>(p, Limits::max(), volume));
        }
      }
      // z / w overflows, or x / w for a size that reaches so far.
      CHECK_FALSE(is_kept<C, float>({0, 0, Limits::max(), 0.5}, 0, volume));
      CHECK_FALSE(is_kept<C, float>({Limits::max(), 0, 0, 0.5}, Limits::max(), volume));
    }
  });
}

TEST_CASE("points: a centre inside the sides costs its divide and no more") {
  using experiments::Counted;
  NdcPolygon<Counted, K> out;
  const auto point = clip_point<Counted>({0.5, 0, 0, 1});
  for_each_type(AllPointClippers{}, [&]<class C>() {
    operation_counts() = {};
    C{}(kGl, point, PointSize<Counted>{}, out);
    CHECK(operation_counts().divisions == 4);
    CHECK(operation_counts().multiplications == 0);
  });
}
