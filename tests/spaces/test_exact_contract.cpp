// SPDX-License-Identifier: GPL-3.0-or-later
//
// In exact arithmetic the contract holds exactly, and clippers of all spaces agree.
#include <vector>

#include "reference/exact_clip.hpp"
#include "spaces/cut.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/clippers.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Exact;

namespace {

constexpr auto kDepths = {DepthRange::minus_one_to_one, DepthRange::zero_to_one,
                          DepthRange::reversed};

// Twice the area in the triangle's own plane: attributes are the barycentric coordinates.
template <class P>
Exact parameter_area(const P& polygon) {
  Exact area(0);
  for (int i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i].attributes;
    const auto& b = polygon[(i + 1) % polygon.size()].attributes;
    area = area + Exact(a[0] * b[1]) - Exact(a[1] * b[0]);
  }
  return area;
}

// The parts that each plane in turn cuts away from a triangle.
Exact area_cut_away(DepthRange depth, const ClipTriangle<Exact, K>& triangle) {
  ClipPolygon<Exact, K> rest, inside, outside;
  rest.assign(triangle);
  Exact area(0);
  for (const Plane plane : kAllPlanes) {
    cut(rest, outside, [&](const ClipVertex<Exact, K>& v) {
      return Exact(-clip_distance(depth, plane, v.position));
    });
    cut(rest, inside,
        [&](const ClipVertex<Exact, K>& v) { return clip_distance(depth, plane, v.position); });
    area = area + parameter_area(outside);
    rest = inside;
  }
  return area;
}

// A point that is compared: x y z 1/w and attributes.
using Key = std::vector<Exact>;

template <class T>
std::vector<Key> sorted_keys(const NdcPolygon<T, K>& polygon) {
  std::vector<Key> keys;
  for (const auto& v : polygon) {
    Key key;
    for (int i = 0; i < 4; ++i) key.push_back(v.position[i]);
    for (int k = 0; k < K; ++k) key.push_back(v.attributes[k]);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

std::vector<Key> sorted_keys(const reference::ExactPolygon& polygon) {
  std::vector<Key> keys;
  for (const auto& v : polygon.vertices) {
    Key key = {reference::to_rational(v.x), reference::to_rational(v.y),
               reference::to_rational(v.z), reference::to_rational(v.inv_w)};
    for (const auto& a : v.attributes) key.push_back(reference::to_rational(a));
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

reference::InputTriangle input(const Corners& corners) {
  return reference::input_triangle(clip_triangle<double>(corners));
}

// A vertex (0,0,0,0) is inside all planes, but has no picture: the divide drops it, and an area
// with it.
bool has_apex(const ClipTriangle<Exact, K>& triangle) {
  const Vec4<Exact> apex(Exact(0), Exact(0), Exact(0), Exact(0));
  return triangle[0].position == apex || triangle[1].position == apex ||
         triangle[2].position == apex;
}

template <class F>
void for_each_that_keeps_the_clip_contract(F&& f) {
  for_every_clipper<TypeList<Exact>>([&](const ClipperIn<Exact, 3>& clip) {
    if (keeps_clip_contract(clip)) f(clip);
  });
}

// Clips the fan of a polygon again.
Exact area_clipped_again(const ClipperIn<Exact, 3>& clip, DepthRange depth,
                         const NdcPolygon<Exact, K>& polygon) {
  Exact area(0);
  for (int i = 2; i < polygon.size(); ++i) {
    ClipTriangle<Exact, K> fan;
    const std::array<int, 3> corners = {0, i - 1, i};
    for (std::size_t j = 0; j < 3; ++j) {
      const auto& v = polygon[corners[j]];
      const Exact w = Exact(1) / v.position[3];
      fan[j].position = Vec4<Exact>(Exact(v.position[0] * w), Exact(v.position[1] * w),
                                    Exact(v.position[2] * w), w);
      fan[j].attributes = v.attributes;
    }
    area = area + parameter_area(clip(fan, ClipVolume{depth}));
  }
  return area;
}

}  // namespace

TEST_CASE("exact contract: the inside and what planes cut away tile the triangle") {
  std::mt19937_64 random(11);
  for (const DepthRange depth : kDepths) {
    for (int n = 0; n < 300; ++n) {
      const auto triangle = clip_triangle<Exact>(lattice_corners(random));
      const Exact outside = area_cut_away(depth, triangle);
      if (has_apex(triangle)) continue;
      for_each_that_keeps_the_clip_contract([&](const ClipperIn<Exact, 3>& clip) {
        CHECK(parameter_area(clip(triangle, ClipVolume{depth})) + outside == Exact(1));
      });
    }
  }
}

TEST_CASE("exact contract: clipping what was clipped changes nothing") {
  std::mt19937_64 random(12);
  for (int n = 0; n < 300; ++n) {
    const auto triangle = clip_triangle<Exact>(random_corners(random, 3));
    for_each_that_keeps_the_clip_contract([&](const ClipperIn<Exact, 3>& clip) {
      const auto once = clip(triangle, ClipVolume{DepthRange::zero_to_one});
      CHECK(area_clipped_again(clip, DepthRange::zero_to_one, once) == parameter_area(once));
    });
  }
}

TEST_CASE("exact contract: in clip space every clipper has the reference's vertices") {
  std::mt19937_64 random(13);
  for (const DepthRange depth : kDepths) {
    const auto truth = reference::Truth::of_clip(depth);
    for (int n = 0; n < 400; ++n) {
      const Corners corners = random_corners(random, 3);
      const auto exact = reference::clip(truth, input(corners));
      for_each_that_keeps_the_clip_contract([&](const ClipperIn<Exact, 3>& clip) {
        const auto out = clip(clip_triangle<Exact>(corners), ClipVolume{depth});
        CHECK(sorted_keys(out) == sorted_keys(exact));
      });
    }
  }
}

TEST_CASE("exact contract: in view space every clipper has the reference's vertices") {
  std::mt19937_64 random(14);
  Frustum<double> perspective;
  perspective.left = -0.5;
  Frustum<double> infinite = perspective;
  infinite.infinite_far = true;
  infinite.depth = DepthRange::reversed;
  Frustum<double> oblique;
  oblique.kind = ProjectionKind::parallel;
  oblique.shear_x = 0.25;
  oblique.depth = DepthRange::zero_to_one;
  for (const Frustum<double>& frustum : {perspective, infinite, oblique}) {
    const auto truth = reference::Truth::of_frustum(frustum);
    const Projection<Exact> projection(frustum_cast<Exact>(frustum));
    for (int n = 0; n < 400; ++n) {
      const Corners corners = random_corners(random, 4);
      auto bits = reference::input_triangle(view_triangle<double>(corners));
      const auto exact = reference::clip(truth, bits);
      for_every_clipper<TypeList<Exact>>([&](const ClipperIn<Exact, 3>& clip) {
        if (!keeps_contract(clip.promise)) return;
        CHECK(sorted_keys(clip(view_triangle<Exact>(corners), projection)) == sorted_keys(exact));
      });
    }
  }
}
