// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every promise that holds to the bit, attacked: what a clipper promises must survive, and where a
// promise is not made, a case that shows why.
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tests/catch.hpp"
#include "tests/sampled.hpp"
#include "tests/spaces/clippers.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::for_each_type;

namespace {

// Calls f(clipper) for the clippers that start at clip coordinates, in the binary formats.
template <class F>
void for_clip_space(F&& f) {
  for_every_clipper<TypeList<float, double>>([&](const auto& clip) {
    if (clip.takes_clip_space()) f(clip);
  });
}

// Corners that make trouble in turn: anywhere, on a coarse lattice, near the planes, of wide
// exponents.
Corners troublesome(std::mt19937_64& random, int n) {
  switch (n % 4) {
    case 0: return random_corners(random, 3);
    case 1: return lattice_corners(random);
    case 2: {
      Corners corners = lattice_corners(random);
      for (auto& corner : corners) {
        for (double& x : corner) {
          const auto f = static_cast<float>(x);  // 0 has denormal neighbours: a case of its own
          if (x != 0) x = std::nextafter(f, random() % 2 == 0 ? 9.0f : -9.0f);
        }
      }
      return corners;
    }
    default: {
      Corners corners = random_corners(random, 1);
      for (auto& corner : corners) {
        const int e = static_cast<int>(random() % 61) - 30;
        for (double& x : corner) x = std::ldexp(x, e);
      }
      return corners;
    }
  }
}

// No NaN, no infinite x, y or z; 1/w may overflow.
template <class T>
bool is_total(const NdcPolygon<T, K>& polygon) {
  for (const auto& v : polygon) {
    if (std::isnan(v.position[3])) return false;
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(v.position[i])) return false;
    }
  }
  return !polygon.overflowed();
}

// The vertices on the edge from vertex 0 to vertex 1: positions and shares of the two. A vertex
// that any computation with vertex 2 led to carries vertex 2's mark in its last attribute.
template <class T>
using Edge = std::set<std::array<T, 6>>;

template <class T>
Edge<T> on_first_edge(const NdcPolygon<T, K>& polygon) {
  Edge<T> edge;
  for (const auto& v : polygon) {
    if (v.attributes[2] == T(0)) {
      const auto& p = v.position;
      edge.insert({p[0], p[1], p[2], p[3], v.attributes[0], v.attributes[1]});
    }
  }
  return edge;
}

// A NaN marks all that it touches, but a barycentric clipper multiplies it by 0 everywhere: its
// weight of vertex 2 is exactly 0 on the edge, and 1 marks what has any.
template <class T>
T mark_for(const ClipperIn<T, 3>& clip) {
  return clip.name.starts_with("barycentric/") ? T(1) : std::numeric_limits<T>::quiet_NaN();
}

// Whether triangles 0 1 2 and 1 0 3 have the same bits on the edge that they share.
template <class T>
bool is_watertight(const ClipperIn<T, 3>& clip, const Corners& corners,
                   const std::array<double, 4>& fourth) {
  auto left = clip_triangle<T>(corners);
  auto right = clip_triangle<T>({corners[1], corners[0], fourth});
  std::swap(right[0].attributes, right[1].attributes);
  left[2].attributes[2] = mark_for(clip);
  right[2].attributes[2] = mark_for(clip);
  const auto left_polygon = clip(left);
  const auto right_polygon = clip(right);
  // A triangle that vanished as a whole has no edge to compare.
  return left_polygon.empty() || right_polygon.empty() ||
         on_first_edge(left_polygon) == on_first_edge(right_polygon);
}

// Where an edge lies in a plane, one side may keep nothing but the edge: no crack, but other
// vertices.
bool lies_in_a_plane(const Corners& corners) {
  const auto triangle = clip_triangle<double>(corners);
  return std::any_of(kAllPlanes.begin(), kAllPlanes.end(), [&](Plane plane) {
    constexpr DepthRange kDepth = DepthRange::minus_one_to_one;
    return signed_distance(kDepth, plane, triangle[0]) == 0 &&
           signed_distance(kDepth, plane, triangle[1]) == 0;
  });
}

// One end on the plane, the other an ulp inside of it: what lies between may be rounded to either
// side.
void lay_first_edge_along_the_top(Corners& corners) {
  for (std::size_t i = 0; i < 2; ++i) {
    corners[i][3] = static_cast<float>(std::abs(corners[i][3]) + 0.25);
  }
  corners[0][1] = corners[0][3];
  corners[1][1] = std::nextafter(static_cast<float>(corners[1][3]), 0.0f);
}

std::array<double, 4> random_vertex(std::mt19937_64& random, int n) {
  return troublesome(random, n)[0];
}

}  // namespace

TEST_CASE("promises: total clippers make no NaN and no infinite coordinate of finite positions") {
  std::mt19937_64 random(21);
  constexpr float kLargest = std::numeric_limits<float>::max();
  constexpr float kSmallest = std::numeric_limits<float>::denorm_min();
  const std::array<float, 8> extremes = {0.0f,     -0.0f,     kSmallest, -kSmallest,
                                         kLargest, -kLargest, 1.0f,      -1.0f};
  for (int n = 0; n < sampled(20000); ++n) {
    Corners corners = troublesome(random, n);
    if (n % 2 == 0) {
      for (auto& corner : corners) {
        for (double& x : corner) {
          if (random() % 3 == 0) x = extremes[random() % extremes.size()];
        }
      }
    }
    for (const auto& clip : clippers<float>()) {
      if (clip.takes_clip_space() && !is_total(clip(clip_triangle<float>(corners)))) {
        FAIL(clip.name << " " << n << " from clip space");
      }
      if (!is_total(clip(view_triangle<float>(corners)))) {
        FAIL(clip.name << " " << n << " from view space");
      }
    }
  }
}

TEST_CASE("promises: a position that is NaN or infinite yields nothing, whatever the clipper") {
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  const double bad = GENERATE(as<double>{}, kNan, kInf, -kInf);
  const Corners base =
      GENERATE(Corners{{{-0.5, -0.5, -0.25, 1}, {0.5, -0.5, 0, 1}, {0, 0.5, 0, 1}}},
               Corners{{{-2, -0.5, -3, 1}, {3, -0.5, -2, 1}, {0, 4, -2, 2}}});
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    for (std::size_t c = 0; c < 4; ++c) {
      Corners corners = base;
      corners[vertex][c] = bad;
      for_every_clipper([&]<class T>(const ClipperIn<T, 3>& clip) {
        if constexpr (kHasInfinity<T>) {
          INFO("vertex " << vertex << " coordinate " << c << " = " << bad);
          if (clip.takes_clip_space()) CHECK(clip(clip_triangle<T>(corners)).empty());
          if (c < 3) CHECK(clip(view_triangle<T>(corners)).empty());
        }
      });
    }
  }
}

TEST_CASE("promises: attributes are not looked at") {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  auto triangle = view_triangle<float>({{{0, 0, -2, 0}, {0.5, 0, -2, 0}, {0, 0.5, -2, 0}}});
  triangle[0].attributes[0] = kNan;
  for (const auto& clip : clippers<float>()) {
    INFO(clip.name);
    CHECK(clip(triangle).size() == 3);
  }
}

TEST_CASE("promises: signed zeros and denormals are numbers like others") {
  const double tiny = GENERATE(as<double>{}, 0.0, -0.0, 0x1p-149, -0x1p-149, 0x1p-127, -0x1p-127);
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    for (std::size_t c = 0; c < 3; ++c) {
      Corners corners = {{{-0.5, -0.5, -0.25, 1}, {0.5, -0.5, 0.25, 1}, {0.25, 0.5, 0.25, 1}}};
      corners[vertex][c] = tiny;
      for_clip_space([&]<class T>(const ClipperIn<T, 3>& clip) {
        CHECK(clip(clip_triangle<T>(corners)).size() == 3);
      });
    }
  }
}

TEST_CASE("promises: where the first vertex is does not matter, to the bit") {
  std::mt19937_64 random(22);
  for (int n = 0; n < 2000; ++n) {
    const Corners corners = troublesome(random, n);
    for_clip_space([&]<class T>(const ClipperIn<T, 3>& clip) {
      if (!clip.promise.rotation_invariant) return;
      const auto a = clip_triangle<T>(corners);
      const auto first = clip(a), turned = clip(ClipTriangle<T, K>{a[1], a[2], a[0]});
      CHECK(same_cycle<T>(first, turned));
    });
  }
}

TEST_CASE("promises: homogeneous coordinates scaled by 2^k give the same picture, to the bit") {
  std::mt19937_64 random(23);
  const int k = GENERATE(-60, -7, 1, 40);
  for (int n = 0; n < 600; ++n) {
    const Corners corners = troublesome(random, n % 3);
    Corners scaled = corners;
    for (auto& corner : scaled) {
      for (double& x : corner) x = std::ldexp(x, k);
    }
    for_clip_space([&]<class T>(const ClipperIn<T, 3>& clip) {
      if (!clip.promise.scale_invariant) return;
      auto expected = clip(clip_triangle<T>(scaled));
      for (int v = 0; v < expected.size(); ++v) {
        expected[v].position[3] = std::ldexp(expected[v].position[3], k);
      }
      CHECK(same_polygon(clip(clip_triangle<T>(corners)), expected));
    });
  }
}

TEST_CASE(
    "promises: a w-plane with epsilon is not invariant under scaling: it can lose everything") {
  const Corners corners = {{{-0.5, -0.5, 0, 1}, {0.5, -0.5, 0, 1}, {0, 0.5, 0, 1}}};
  Corners scaled = corners;
  for (auto& corner : scaled) {
    for (double& x : corner) x = std::ldexp(x, -20);
  }
  CHECK(clip<HomogeneousWFirst<WPlane::one_100000th>>(clip_triangle<float>(corners)).size() == 3);
  CHECK(clip<HomogeneousWFirst<WPlane::one_100000th>>(clip_triangle<float>(scaled)).empty());
  CHECK(clip<HomogeneousWFirst<WPlane::one_16384th>>(clip_triangle<float>(scaled)).empty());
  CHECK(clip<HomogeneousWFirst<WPlane::zero>>(clip_triangle<float>(scaled)).size() == 3);
}

TEST_CASE("promises: watertight clippers leave the same bits on an edge from both sides") {
  std::mt19937_64 random(24);
  std::map<std::string, int> leaks;
  for (int n = 0; n < sampled(20000); ++n) {
    Corners corners = troublesome(random, n % 3);
    const auto fourth = random_vertex(random, n % 3);
    if (n % 2 == 0) lay_first_edge_along_the_top(corners);
    if (lies_in_a_plane(corners)) continue;
    for_clip_space([&](const auto& clip) {
      if (is_watertight(clip, corners, fourth)) return;
      CAPTURE(corners, fourth);
      CHECK_FALSE(clip.promise.watertight);
      ++leaks[std::string(clip.name)];
    });
  }
  // The test can tell: clippers that do not promise it do leak.
  CHECK(leaks["textbook"] > 0);
  CHECK(leaks["homogeneous/from_inside"] > 0);
}

TEST_CASE("promises: a clip distance cuts where it is negative, in every space") {
  // The first attribute is 1 at vertex 0 and 0 at the others; moved down by 1/2 it is a clip
  // distance that keeps the corner at vertex 0, up to half of both edges.
  for_every_clipper([&]<class T>(const ClipperIn<T, 3>& clip) {
    if (!keeps_contract(clip.promise)) return;
    auto triangle = view_triangle<T>({{{0, 0, -4, 0}, {1, 0, -2, 0}, {0, 1, -2, 0}}});
    for (auto& v : triangle) v.attributes[0] = v.attributes[0] - T(0.5f);
    Projection<T> projection(Frustum<T>{});
    projection.volume.clip_distances = 1;
    const auto out = clip(triangle, projection);
    REQUIRE(out.size() == 3);
    double largest = 0;
    for (const auto& v : out) {
      const double second = experiments::nearest_double(v.attributes[1]);
      largest = std::max(largest, std::abs(second - 0.5) * second);
      CHECK(experiments::nearest_double(v.attributes[0]) > -1e-6);
    }
    CHECK(largest < 1e-6);
  });
}

TEST_CASE("promises: eight clip distances at once, on their planes and one ulp outside") {
  constexpr int kEight = kMaxClipDistances;
  for_each_type(AllClippers{}, [&]<class C>() {
    if (!C::promise.clip_distances) return;
    INFO(C::name);
    ViewTriangle<float, kEight> triangle{};
    triangle[0].position = {0, 0, -2};
    triangle[1].position = {1, 0, -2};
    triangle[2].position = {0, 1, -2};
    Projection<float> projection(Frustum<float>{});
    projection.volume.clip_distances = kEight;
    NdcPolygon<float, kEight> out;
    C{}(projection, triangle, out);
    CHECK(out.size() == 3);  // 0 is inside
    for (auto& v : triangle) v.attributes[kEight - 1] = -0x1p-149f;
    C{}(projection, triangle, out);
    CHECK(out.empty());
  });
}

TEST_CASE("promises: with depth clamp near and far cut nothing and the sides keep w positive") {
  const Corners through = {{{-0.5, 0, -2, 0}, {0.5, 0, -2, 0}, {0, 0.5, 20, 0}}};
  const Corners near_the_eye = {{{0, 0, -0.5, 0}, {0.25, 0, -0.5, 0}, {0, 0.25, -0.5, 0}}};
  for_every_clipper([&]<class T>(const ClipperIn<T, 3>& clip) {
    if (!keeps_contract(clip.promise) || !clip.promise.depth_clamp) return;
    Projection<T> projection(Frustum<T>{});
    projection.volume.depth_clamp = true;
    CHECK(clip(view_triangle<T>(near_the_eye), projection).size() == 3);
    const auto out = clip(view_triangle<T>(through), projection);
    CHECK(out.size() >= 3);
    for (const auto& v : out) CHECK(T(0) < v.position[3]);
  });
}

TEST_CASE("promises: with one plane of depth clamped the other still cuts") {
  // Depth -2 to 20 at w = 1, near at -1 and far at 1.
  const Corners through = {{{-0.5, 0, -2, 1}, {0.5, 0, -2, 1}, {0, 0.5, 20, 1}}};
  for_every_clipper([&]<class T>(const ClipperIn<T, 3>& clip) {
    if (!keeps_clip_contract(clip) || !clip.promise.depth_clamp) return;
    const auto depths = [&](DepthClamp clamp) {
      std::array<double, 2> range = {100, -100};
      for (const auto& v : clip(clip_triangle<T>(through), ClipVolume{.depth_clamp = clamp})) {
        const double z = experiments::nearest_double(v.position[2]);
        range = {std::min(range[0], z), std::max(range[1], z)};
      }
      return range;
    };
    CHECK(depths(kClampNear)[0] == -2);
    CHECK(depths(kClampNear)[1] == Approx(1));
    CHECK(depths(kClampFar)[0] == Approx(-1));
    CHECK(depths(kClampFar)[1] == 20);
    CHECK(depths(true) == std::array<double, 2>{-2, 20});
  });
}

TEST_CASE("promises: what a clipper cannot take is said by its promise") {
  CHECK(is_applicable(HomogeneousSutherlandHodgman::promise, {.depth_clamp = true}));
  CHECK_FALSE(is_applicable(CvvNearFirst::promise, {.depth_clamp = true}));
  CHECK_FALSE(is_applicable(CvvNearFirst::promise, {.depth_clamp = kClampNear}));
  CHECK(is_applicable(CvvNearFirst::promise, {.clip_distances = 8}));
}
