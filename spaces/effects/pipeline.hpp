// SPDX-License-Identifier: MIT
//
// Clipping pipelines composed of the effects that a plan calls for, and of nothing else.
//
// A Composition is a compile-time choice of steps; what it leaves out is not in its code. The
// compositions of a table are instantiated, and a plan picks the least one that covers it, once for
// a batch of triangles: opposite sides are tested as a pair, far together with near, the w guard
// wherever anything is tested, user planes with everything else (by homogeneous/sutherland_hodgman
// itself). A composition with more than the plan gives the same polygons.
//
// In: view-space triangles. Out: per triangle one polygon of the contract (spaces/clipper.hpp), but
//   - without perspective correction 1/w is 1 at every vertex, so that whoever interpolates a/w and
//     1/w gets the affine answer, within the plan's tolerance;
//   - without depth z is 0;
//   - with a guard band polygons may reach beyond the sides, up to that band.
// All other bits are those of homogeneous/sutherland_hodgman.
// Total, no allocation, as all clippers.
// Pre-condition: the triangles are those that the facts were made of, whole or in parts, if their
// revision is that of the plan. With another revision everything is done.
#pragma once

#include <utility>

#include "spaces/effects/plan.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope {

struct Composition {
  enum class DepthPlanes : std::uint8_t { none, near, near_and_far };
  enum class Cuts : std::uint8_t { none, flat, interpolated };  // attributes of new vertices
  enum class Divide : std::uint8_t { none, position, position_and_w };

  DepthPlanes depth_planes = DepthPlanes::near_and_far;
  bool x_sides = true, y_sides = true;
  Cuts cuts = Cuts::interpolated;
  Divide divide = Divide::position_and_w;
  bool depth = true;

  constexpr bool tests() const { return depth_planes != DepthPlanes::none || x_sides || y_sides; }
};

namespace effects {

// Polygons on the stack start at a cache line, so that handing them on costs the same wherever the
// stack happens to lie; bytes.
inline constexpr std::size_t kCacheLine = 64;

inline constexpr std::size_t kCompositions = 3 * 2 * 2 * 3 * 3 * 2;

constexpr std::size_t index_of(const Composition& c) {
  std::size_t i = static_cast<std::size_t>(c.depth_planes);
  i = 2 * i + c.x_sides;
  i = 2 * i + c.y_sides;
  i = 3 * i + static_cast<std::size_t>(c.cuts);
  i = 3 * i + static_cast<std::size_t>(c.divide);
  return 2 * i + c.depth;
}

// The inverse; what tests nothing cuts nothing, so that some compositions are in the table twice.
constexpr Composition composition_at(std::size_t i) {
  Composition c;
  const auto digit = [&i](std::size_t base) {
    const std::size_t d = i % base;
    i /= base;
    return d;
  };
  c.depth = digit(2) != 0;
  c.divide = static_cast<Composition::Divide>(digit(3));
  c.cuts = static_cast<Composition::Cuts>(digit(3));
  c.y_sides = digit(2) != 0;
  c.x_sides = digit(2) != 0;
  c.depth_planes = static_cast<Composition::DepthPlanes>(digit(3));
  if (!c.tests()) c.cuts = Composition::Cuts::none;
  return c;
}

// The least composition that covers the effects. Planes that do not clip in this volume (depth
// clamp) are not tested, whoever asks for it. Pre-condition: no user planes are called for.
constexpr Composition compose(const ClipVolume& volume, const EffectSet& e) {
  const Outcode clipping = planes_of(volume);
  const auto tests = [&](Plane p) {
    return e.plane(p) != PlaneEffect::none && (clipping & bit(p)) != 0;
  };
  Composition c;
  c.depth_planes = tests(Plane::far)    ? Composition::DepthPlanes::near_and_far
                   : tests(Plane::near) ? Composition::DepthPlanes::near
                                        : Composition::DepthPlanes::none;
  c.x_sides = tests(Plane::left) || tests(Plane::right);
  c.y_sides = tests(Plane::bottom) || tests(Plane::top);
  // The w guard comes with any test; the sides are there in every volume.
  c.x_sides = c.x_sides || (e.w_guard() && !c.tests());
  c.cuts = !e.has_plane(PlaneEffect::cut) ? Composition::Cuts::none
           : e.interpolation()            ? Composition::Cuts::interpolated
                                          : Composition::Cuts::flat;
  c.divide = !e.divide()       ? Composition::Divide::none
             : e.perspective() ? Composition::Divide::position_and_w
                               : Composition::Divide::position;
  c.depth = e.depth();
  return c;
}

// The planes that may cut a triangle: all but those left to a guard band.
constexpr Outcode cutting_planes(const EffectSet& e) {
  Outcode planes = 0;
  for (const Plane p : kAllPlanes) {
    if (e.plane(p) != PlaneEffect::guard_band) planes |= bit(p);
  }
  return planes;
}

// The bits of clip_outcode for the planes tested, 0 for the others.
template <Composition kC, Scalar T>
constexpr Outcode tested_outcode(DepthRange depth, const Vec4<T>& v) {
  const T one = kC.divide == Composition::Divide::none ? T(1) : v[3];
  const T minus_one = -one;
  Outcode code = 0;
  if constexpr (kC.x_sides) {
    code |= static_cast<Outcode>(!(minus_one <= v[0])) << static_cast<int>(Plane::left);
    code |= static_cast<Outcode>(!(v[0] <= one)) << static_cast<int>(Plane::right);
  }
  if constexpr (kC.y_sides) {
    code |= static_cast<Outcode>(!(minus_one <= v[1])) << static_cast<int>(Plane::bottom);
    code |= static_cast<Outcode>(!(v[1] <= one)) << static_cast<int>(Plane::top);
  }
  if constexpr (kC.depth_planes != Composition::DepthPlanes::none) {
    const T lowest = depth == DepthRange::minus_one_to_one ? minus_one : T(0);
    const auto below = static_cast<Outcode>(!(lowest <= v[2]));
    const auto above = static_cast<Outcode>(!(v[2] <= one));
    const bool reversed = depth == DepthRange::reversed;
    code |= (reversed ? above : below) << static_cast<int>(Plane::near);
    if constexpr (kC.depth_planes == Composition::DepthPlanes::near_and_far) {
      code |= (reversed ? below : above) << static_cast<int>(Plane::far);
    }
  }
  return code;
}

// to_ndc without what is left out.
template <Composition kC, Scalar T>
constexpr Vec4<T> to_planned_ndc(const Vec4<T>& v) {
  if constexpr (kC.divide == Composition::Divide::none) {
    return Vec4<T>(v[0], v[1], kC.depth ? v[2] : T(0), T(1));
  } else {
    const T x = v[0] / v[3];
    const T y = v[1] / v[3];
    const T z = kC.depth ? v[2] / v[3] : T(0);
    const T inv_w = kC.divide == Composition::Divide::position ? T(1) : T(1) / v[3];
    return Vec4<T>(x, y, z, inv_w);
  }
}

// The way of a triangle that is cut, the same for all compositions: what could be left out here is
// left out afterwards, so that an overflow on the way drops the triangle as it does in the full
// pipeline. kCarried: the number of attributes that are interpolated, all or none. Pre-condition:
// `out` is empty.
template <int kCarried, Scalar T, int K>
constexpr void cut_triangle(DepthRange depth, Outcode planes,
                            const std::array<Vec4<T>, 3>& positions,
                            const ViewTriangle<T, K>& triangle, NdcPolygon<T, K>& out) {
  ClipTriangle<T, kCarried> carried{};
  for (std::size_t i = 0; i < 3; ++i) {
    carried[i].position = positions[i];
    if constexpr (kCarried == K) carried[i].attributes = triangle[i].attributes;
  }
  HomogeneousSutherlandHodgman::cut_and_then({depth}, planes, carried, [&](const auto& rest) {
    if constexpr (kCarried == K) {
      divide(rest, out);
    } else {
      for (const ClipVertex<T, kCarried>& v : rest) {
        if (T(0) < v.position[3]) out.push_back({to_ndc(v.position), triangle[0].attributes});
      }
      out.drop_if_degenerate();
      clear_if_overflowed(out);
    }
  });
}

template <Composition kC, Scalar T, int K>
constexpr void leave_out(NdcPolygon<T, K>& polygon) {
  for (int i = 0; i < polygon.size(); ++i) {
    if constexpr (kC.divide != Composition::Divide::position_and_w) polygon[i].position[3] = T(1);
    if constexpr (!kC.depth) polygon[i].position[2] = T(0);
  }
}

// Transform and divide of a triangle that nothing is tested on.
template <Composition kC, Scalar T, int K>
constexpr void pass_on(const Projection<T>& projection, const ViewTriangle<T, K>& triangle,
                       NdcPolygon<T, K>& out) {
  out.clear();
  for (const ViewVertex<T, K>& v : triangle) {
    const Vec4<T> ndc = to_planned_ndc<kC>(to_clip(projection, v.position));
    out.push_back({ndc, v.attributes});
  }
}

template <Composition kC, Scalar T, int K>
constexpr void test_and_clip(const Projection<T>& projection, [[maybe_unused]] Outcode cutting,
                             const ViewTriangle<T, K>& triangle, NdcPolygon<T, K>& out) {
  const std::array<Vec4<T>, 3> positions = {to_clip(projection, triangle[0].position),
                                            to_clip(projection, triangle[1].position),
                                            to_clip(projection, triangle[2].position)};
  const ClipVolume& volume = projection.volume;
  const std::array<Outcode, 3> codes = {tested_outcode<kC>(volume.depth, positions[0]),
                                        tested_outcode<kC>(volume.depth, positions[1]),
                                        tested_outcode<kC>(volume.depth, positions[2])};
  out.clear();
  if ((codes[0] & codes[1] & codes[2]) != 0) return;
  if constexpr (kC.cuts != Composition::Cuts::none) {
    const Outcode crossed = (codes[0] | codes[1] | codes[2]) & cutting;
    if (crossed != 0) {
      constexpr int kCarried = kC.cuts == Composition::Cuts::interpolated ? K : 0;
      cut_triangle<kCarried>(volume.depth, crossed, positions, triangle, out);
      leave_out<kC>(out);
      return;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const T& w = positions[i][3];
    const Vec4<T> ndc = to_planned_ndc<kC>(positions[i]);
    if (!(T(0) < w) || !is_finite(w) || (volume.depth_clamp && !is_finite(ndc[2]))) {
      out.clear();
      return;
    }
    out.push_back({ndc, triangle[i].attributes});
  }
}

template <Scalar T, int K, class Sink>
using BatchFunction = void (*)(const Projection<T>&, Outcode, std::span<const ViewTriangle<T, K>>,
                               Sink&);

template <Composition kC, Scalar T, int K, class Sink>
void clip_batch(const Projection<T>& projection, Outcode cutting,
                std::span<const ViewTriangle<T, K>> triangles, Sink& sink) {
  alignas(kCacheLine) NdcPolygon<T, K> polygon;
  for (const ViewTriangle<T, K>& triangle : triangles) {
    if constexpr (kC.tests()) {
      test_and_clip<kC>(projection, cutting, triangle, polygon);
    } else {
      pass_on<kC>(projection, triangle, polygon);
    }
    sink(std::as_const(polygon));
  }
}

template <Scalar T, int K, class Sink>
inline constexpr auto kBatchFunctions = []<std::size_t... kI>(std::index_sequence<kI...>) {
  return std::array<BatchFunction<T, K, Sink>, kCompositions>{
      clip_batch<composition_at(kI), T, K, Sink>...};
}
(std::make_index_sequence<kCompositions>());

}  // namespace effects

// The full pipeline: homogeneous/sutherland_hodgman, whatever the scene is like.
template <Scalar T, int K, class Sink>
void clip_fully(const Projection<T>& projection, std::span<const ViewTriangle<T, K>> triangles,
                Sink&& sink) {
  alignas(effects::kCacheLine) NdcPolygon<T, K> polygon;
  for (const ViewTriangle<T, K>& triangle : triangles) {
    HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
    sink(std::as_const(polygon));
  }
}

// Clips with just what the plan calls for; sink(const NdcPolygon<T, K>&) gets one polygon, maybe
// empty, for each triangle, in order. revision: of the triangles as they are now.
template <std::floating_point T, int K, class Sink>
void clip_as_planned(const Plan<T>& plan, std::uint64_t revision,
                     std::span<const ViewTriangle<T, K>> triangles, Sink&& sink) {
  const EffectSet& effects = plan.effects();
  if (revision != plan.revision() || effects.user_planes() != PlaneEffect::none) {
    clip_fully(plan.projection(), triangles, sink);
    return;
  }
  const std::size_t i = effects::index_of(effects::compose(plan.projection().volume, effects));
  effects::kBatchFunctions<T, K, std::remove_reference_t<Sink>>[i](
      plan.projection(), effects::cutting_planes(effects), triangles, sink);
}

}  // namespace clipscope
