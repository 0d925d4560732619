// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-open volumes: tiles side by side answer what lies in their common border once, and what does
// not lie in it as closed ones do.
#include <cmath>
#include <vector>

#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/clippers.hpp"
#include "tests/spaces/segments.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::AllScalars;
using experiments::Exact;
using experiments::for_each_type;
using experiments::scalar_from;

namespace {

constexpr ClipVolume kTopLeft{.open_sides = true};

// A point in or beside the border of two tiles along an axis, 0 or 1: the coordinate is w in the
// lower tile and -w in the upper one.
using Place = std::array<double, 4>;

Place in_tile(Place p, std::size_t axis, bool upper) {
  p[axis] = upper ? -p[3] : p[3];
  return p;
}

// Inside of all other planes, and w >= 1: a w-plane with an epsilon drops what comes near the eye.
Place random_place(std::mt19937_64& random) {
  Place p = random_corners(random, 1)[0];
  for (double& x : p) x *= 0.75;
  p[3] = 1;
  const int k = static_cast<int>(random() % 41);
  for (double& x : p) x = std::ldexp(x, k);
  return p;
}

template <class T, std::size_t N>
Simplex<Space::clip, T, K, N> primitive(const std::vector<Place>& places) {
  const auto three = clip_triangle<T>({places[0], places[1 % N], places[2 % N]});
  Simplex<Space::clip, T, K, N> r;
  std::copy_n(three.begin(), N, r.begin());
  return r;
}

template <class T, std::size_t N>
Simplex<Space::view, T, K, N> view_primitive(const std::vector<Place>& places) {
  const auto three = view_triangle<T>({places[0], places[1 % N], places[2 % N]});
  Simplex<Space::view, T, K, N> r;
  std::copy_n(three.begin(), N, r.begin());
  return r;
}

// Calls f.template operator()<T, N>(name, takes_clip_space, clip) for all clippers of points,
// segments and triangles in every scalar; clip(where, primitive) gives the answer.
template <class F>
void for_all_primitives(F&& f) {
  for_each_type(AllPointClippers{}, [&]<class C>() {
    for_each_type(AllScalars{}, [&]<class T>() {
      INFO(C::name << " in " << experiments::kFormat<T>.name);
      f.template operator()<T, 1>(true, [](const auto& where, const auto& point) {
        NdcPolygon<T, K> out;
        C{}(where, point, out);
        return out;
      });
    });
  });
  const auto with = [&]<std::size_t N>(std::integral_constant<std::size_t, N>) {
    for_every_clipper<AllScalars, N>([&]<class T>(const ClipperIn<T, N>& clip) {
      f.template operator()<T, N>(
          clip.takes_clip_space(),
          [&](const auto& where, const auto& given) { return clip(given, where); });
    });
  };
  with(std::integral_constant<std::size_t, 2>());
  with(std::integral_constant<std::size_t, 3>());
}

// The parallel or perspective frustum [left, right] x [bottom, top] at distance 1.
template <class T>
Projection<T> tile(ProjectionKind kind, double left, double right, double bottom, double top) {
  Frustum<T> f;
  f.kind = kind;
  f.left = scalar_from<T>(left);
  f.right = scalar_from<T>(right);
  f.bottom = scalar_from<T>(bottom);
  f.top = scalar_from<T>(top);
  f.near = T(1);
  f.far = T(16);
  Projection<T> r(f);
  r.volume.open_sides = true;
  return r;
}

// Whether each open side has a vertex strictly inside, by the signs of exact distances.
template <std::size_t N>
bool reaches_in(const OpenSides& open, const Simplex<Space::clip, Exact, K, N>& given) {
  const std::array is_open = {open.left, open.right, open.bottom, open.top};
  for (std::size_t side = 0; side < 4; ++side) {
    const auto is_inside = [&](const auto& v) {
      return Exact(0) <
             clip_distance(DepthRange::minus_one_to_one, static_cast<Plane>(side), v.position);
    };
    if (is_open[side] && std::none_of(given.begin(), given.end(), is_inside)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("open sides: of two tiles one alone answers what lies in their common border") {
  std::mt19937_64 random(81);
  for (int n = 0; n < 40; ++n) {
    const std::vector<Place> places = {random_place(random), random_place(random),
                                       random_place(random)};
    for (const std::size_t axis : {0u, 1u}) {
      std::array<std::vector<Place>, 2> in;
      for (const bool upper : {false, true}) {
        for (const Place& p : places) in[upper].push_back(in_tile(p, axis, upper));
      }
      for_all_primitives([&]<class T, std::size_t N>(bool takes_clip_space, const auto& clip) {
        if (!takes_clip_space) return;
        CHECK(clip(kTopLeft, primitive<T, N>(in[0])).empty() == (axis == 0));
        CHECK(clip(kTopLeft, primitive<T, N>(in[1])).empty() == (axis == 1));
        for (const auto& tile_places : in) {
          CHECK_FALSE(clip(ClipVolume{}, primitive<T, N>(tile_places)).empty());
        }
      });
    }
  }
}

// x = 0 is the border of the two tiles, and so is y = 0 of two others.
TEST_CASE("open sides: of two frusta one alone answers what lies in their common border") {
  std::mt19937_64 random(82);
  for (const auto kind : {ProjectionKind::perspective, ProjectionKind::parallel}) {
    for (int n = 0; n < 20; ++n) {
      std::vector<Place> in_x, in_y;
      for (const Place& p : random_corners(random, 1)) {
        const double z = -std::ldexp(1 + std::abs(p[2]), n % 3);
        in_x.push_back({0, p[1] / 2, z, 0});
        in_y.push_back({p[0] / 2, 0, z, 0});
      }
      for_all_primitives([&]<class T, std::size_t N>(bool, const auto& clip) {
        const auto count = [&](const std::vector<Place>& places, const auto&... tiles) {
          return (static_cast<int>(!clip(tiles, view_primitive<T, N>(places)).empty()) + ...);
        };
        const auto left = tile<T>(kind, -1, 0, -1, 1), right = tile<T>(kind, 0, 1, -1, 1);
        const auto lower = tile<T>(kind, -1, 1, -1, 0), upper = tile<T>(kind, -1, 1, 0, 1);
        CHECK(count(in_x, left) == 0);
        CHECK(count(in_x, right) == 1);
        CHECK(count(in_y, lower) == 1);
        CHECK(count(in_y, upper) == 0);
      });
    }
  }
}

TEST_CASE("open sides: of the four tiles around a corner one alone answers what lies in it") {
  for_all_primitives([]<class T, std::size_t N>(bool takes_clip_space, const auto& clip) {
    if (!takes_clip_space) return;
    std::vector<std::array<double, 2>> owners;
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        // In the edge of the four, at several depths.
        const std::vector<Place> edge = {{x, y, 0, 1}, {2 * x, 2 * y, 1, 2}, {x, y, -0.5, 1}};
        if (!clip(kTopLeft, primitive<T, N>(edge)).empty()) owners.push_back({x, y});
      }
    }
    CHECK(owners == std::vector<std::array<double, 2>>{{-1, 1}});
  });
}

TEST_CASE("open sides: what reaches inside of them has the bits of the closed volume's answer") {
  std::mt19937_64 random(83);
  int nothing = 0, kept = 0;
  for (int n = 0; n < 400; ++n) {
    const Corners corners = n % 4 == 0 ? random_corners(random, 2) : lattice_corners(random);
    const std::vector<Place> places(corners.begin(), corners.end());
    const OpenSides open(random() % 2 == 0, random() % 2 == 0, random() % 2 == 0,
                         random() % 2 == 0);
    for_all_primitives([&]<class T, std::size_t N>(bool takes_clip_space, const auto& clip) {
      if (!takes_clip_space) return;
      const auto given = primitive<T, N>(places);
      const auto answer = clip(ClipVolume{.open_sides = open}, given);
      if (reaches_in(open, primitive<Exact, N>(places))) {
        const auto closed = clip(ClipVolume{}, given);
        CHECK(same_polygon(answer, closed));
        kept += !closed.empty();
      } else {
        CHECK(answer.empty());
        ++nothing;
      }
    });
  }
  CHECK(nothing > 1000);
  CHECK(kept > 1000);
}

namespace {

using Points = std::vector<std::array<Exact, 4>>;

// x y z 1/w, sorted, each once.
template <class T>
Points points_of(const NdcPolygon<T, K>& polygon) {
  Points r;
  for (const auto& v : polygon) {
    r.push_back({v.position[0], v.position[1], v.position[2], v.position[3]});
  }
  std::sort(r.begin(), r.end());
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}

Points points_of(const reference::ExactPolygon& polygon) {
  Points r;
  for (const auto& v : polygon.vertices) {
    r.push_back({reference::to_rational(v.x), reference::to_rational(v.y),
                 reference::to_rational(v.z), reference::to_rational(v.inv_w)});
  }
  std::sort(r.begin(), r.end());
  return r;
}

}  // namespace

// A closed part that is a point or, of a polygon, a segment is no answer of a clipper.
TEST_CASE("open sides: in exact arithmetic every clipper has the reference's vertices") {
  std::mt19937_64 random(84);
  const ClipVolume volume{.open_sides = true};
  const auto truth = reference::Truth::of_clip(volume);
  int drawn = 0;
  for (int n = 0; n < 500; ++n) {
    const Corners corners = lattice_corners(random);
    const auto bits = reference::input_triangle(clip_triangle<double>(corners));
    Points exact = points_of(reference::clip(truth, bits));
    if (exact.size() < 3) exact.clear();
    drawn += !exact.empty();
    for_every_clipper<TypeList<Exact>>([&](const ClipperIn<Exact, 3>& clip) {
      if (!keeps_clip_contract(clip)) return;
      Points found = points_of(clip(clip_triangle<Exact>(corners), volume));
      if (found.size() < 3) found.clear();
      CHECK(found == exact);
    });
  }
  CHECK(drawn > 50);
}

TEST_CASE("open sides: a square of a point stays as long as it comes strictly inside") {
  for_each_type(AllScalars{}, []<class T>() {
    const auto is_kept = [](double x, const ClipVolume& volume) {
      NdcPolygon<T, K> out;
      PointPopFree{}(volume, primitive<T, 1>({{x, 0, 0, 1}}), PointSize<T>{T(0.25f), T(0.25f)},
                     out);
      return !out.empty();
    };
    const float touching = 1.25f;
    CHECK(is_kept(touching, ClipVolume{}));
    CHECK_FALSE(is_kept(touching, kTopLeft));
    CHECK(is_kept(std::nextafter(touching, 0.0f), kTopLeft));
    CHECK(is_kept(-touching, kTopLeft));
  });
}

TEST_CASE("open sides: a clipper that does not take them says so by its promise") {
  CHECK(is_applicable(HomogeneousSutherlandHodgman::promise, kTopLeft));
  CHECK_FALSE(is_applicable(Promise{.open_sides = false}, kTopLeft));
  CHECK(is_applicable(Promise{.open_sides = false}, ClipVolume{.depth_clamp = true}));
}
