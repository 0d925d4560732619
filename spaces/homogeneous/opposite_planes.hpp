// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in clip space with two opposite planes at once: one pass cuts by -w <= x <= w.
//
// An edge is cut by both planes of its axis from its original ends; an edge from beyond one to
// beyond the other gives both new vertices in one step. Three passes stand for six, and each vertex
// has been cut three times at most instead of six. A pass by a single plane serves where vertices
// are outside of one of the two alone.
// Source: opposite sides of an edge at once: Skia, SkLineClipper::ClipLine, which chops by top and
// bottom, then by left and right; the same order in Anti-Grain Geometry's rasterizer_sl_clip. Both
// do so for edges of paths in the plane; for vertices in clip space: this project.
// Pre-condition of such a pass is w >= 0: there the two planes meet in w = 0 alone, and no corner
// between them is left out. So a cut by w >= 0 comes before it where some w is negative.
// Does not guarantee: coordinates within the volume to the last bit after the divide; the exact
// vertex count where a vertex comes within rounding of a plane; equal bits on a shared edge of
// neighbours of which one is cut by both planes of an axis.
#pragma once

#include "spaces/homogeneous/by_outcodes.hpp"

namespace clipscope {

struct HomogeneousOppositePlanes : CutsByOutcodes<HomogeneousOppositePlanes> {
  static constexpr std::string_view name = "homogeneous/opposite_planes";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman in clip space, the two planes of an axis in one pass";
  static constexpr std::string_view source =
      "Skia: SkLineClipper, for edges in the plane; in clip space: this project";
  // A cut by w and three passes are less than the six cuts of the chain.
  static constexpr Promise promise{.ulps = kChainUlps};

  using CutsByOutcodes<HomogeneousOppositePlanes>::cut;

  template <class V>
  static constexpr const VertexList<V>& cut(const ClipVolume& volume, Outcode planes,
                                            VertexList<V>& polygon, VertexList<V>& scratch) {
    clear_unless_finite(polygon);
    VertexList<V>* in = &polygon;
    VertexList<V>* next = &scratch;
    const auto cut_single = [&](Plane plane) {
      clipscope::cut(*in, *next,
                     [&](const V& v) { return signed_distance(volume.depth, plane, v); });
      std::swap(in, next);
    };
    for (const auto& [low, high] : kPairs) {
      const Outcode pair = bit(low) | bit(high);
      if ((planes & pair) == pair) {
        cut_if_crossed(*in, *next, [](const V& v) { return v.position[3]; });
        cut_between(volume.depth, low, high, *in, *next);
        std::swap(in, next);
      } else {
        for_each_plane(planes & pair, kAllPlanes, cut_single);
      }
    }
    for_each_plane(planes, std::array<Plane, 0>{}, cut_single);
    return *in;
  }

 private:
  static constexpr std::array<std::array<Plane, 2>, 3> kPairs = {
      {{Plane::near, Plane::far}, {Plane::left, Plane::right}, {Plane::bottom, Plane::top}}};

  // A vertex and its distances to the two planes.
  template <class V, Scalar T>
  struct Sides {
    const V* vertex;
    T low, high;

    constexpr bool is_inside() const { return T(0) <= low && T(0) <= high; }
  };

  // Writes to `out` the part of `in` that is inside of both planes. Pre-condition: w >= 0.
  template <class V>
  static constexpr void cut_between(DepthRange depth, Plane low, Plane high,
                                    const VertexList<V>& in, VertexList<V>& out) {
    using T = decltype(signed_distance(depth, low, in[0]));
    const auto sides = [&](const V& v) {
      return Sides<V, T>{&v, signed_distance(depth, low, v), signed_distance(depth, high, v)};
    };
    out.clear();
    if (in.empty()) return;
    Sides<V, T> a = sides(in[in.size() - 1]);
    for (const V& v : in) {
      const Sides<V, T> b = sides(v);
      // Where the edge crosses both planes it meets first the one that its first end is beyond.
      if (a.low < T(0)) {
        meet(a, b, a.low, b.low, out);
        meet(a, b, a.high, b.high, out);
      } else {
        meet(a, b, a.high, b.high, out);
        meet(a, b, a.low, b.low, out);
      }
      if (b.is_inside()) out.push_back(v);
      a = b;
    }
  }

  // Adds the point where the edge crosses a plane with these distances.
  template <class V, Scalar T>
  static constexpr void meet(const Sides<V, T>& a, const Sides<V, T>& b, const T& d_a, const T& d_b,
                             VertexList<V>& out) {
    const SegmentSide side = segment_side(d_a, d_b);
    if (side == SegmentSide::cut_first) {
      out.push_back(meeting(*b.vertex, *a.vertex, d_b, d_a));
    } else if (side == SegmentSide::cut_second) {
      out.push_back(meeting(*a.vertex, *b.vertex, d_a, d_b));
    }
  }
};

}  // namespace clipscope
