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
// neighbours that are cut by different planes.
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

  template <Scalar T, int K>
  static constexpr const ClipPolygon<T, K>& cut(const ClipVolume& volume, Outcode planes,
                                                ClipPolygon<T, K>& polygon,
                                                ClipPolygon<T, K>& scratch) {
    clear_unless_finite(polygon);
    ClipPolygon<T, K>* in = &polygon;
    ClipPolygon<T, K>* next = &scratch;
    const auto cut_single = [&](Plane plane) {
      clipscope::cut(*in, *next, [&](const ClipVertex<T, K>& v) {
        return signed_distance(volume.depth, plane, v);
      });
      std::swap(in, next);
    };
    for (const auto& [low, high] : kPairs) {
      const Outcode pair = bit(low) | bit(high);
      if ((planes & pair) == pair) {
        cut_if_crossed(*in, *next, [](const ClipVertex<T, K>& v) { return v.position[3]; });
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
  template <Scalar T, int K>
  struct Sides {
    const ClipVertex<T, K>* vertex;
    T low, high;

    constexpr bool is_inside() const { return T(0) <= low && T(0) <= high; }
  };

  // Writes to `out` the part of `in` that is inside of both planes. Pre-condition: w >= 0.
  template <Scalar T, int K>
  static constexpr void cut_between(DepthRange depth, Plane low, Plane high,
                                    const ClipPolygon<T, K>& in, ClipPolygon<T, K>& out) {
    const auto sides = [&](const ClipVertex<T, K>& v) {
      return Sides<T, K>{&v, signed_distance(depth, low, v), signed_distance(depth, high, v)};
    };
    out.clear();
    if (in.empty()) return;
    Sides<T, K> a = sides(in[in.size() - 1]);
    for (const ClipVertex<T, K>& v : in) {
      const Sides<T, K> b = sides(v);
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

  // Adds the point where the edge crosses a plane with these distances, from its inside end.
  template <Scalar T, int K>
  static constexpr void meet(const Sides<T, K>& a, const Sides<T, K>& b, const T& d_a, const T& d_b,
                             ClipPolygon<T, K>& out) {
    const PlaneCut<T> cut = cut_segment(d_a, d_b);
    if (cut.side == SegmentSide::cut_first) {
      out.push_back(interpolate(*b.vertex, *a.vertex, cut.t));
    } else if (cut.side == SegmentSide::cut_second) {
      out.push_back(interpolate(*a.vertex, *b.vertex, cut.t));
    }
  }
};

}  // namespace clipscope
