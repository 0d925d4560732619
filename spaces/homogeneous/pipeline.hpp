// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman as a streaming pipeline: one stage per plane, each holding two vertices.
//
// A vertex goes through as many stages as it can at once; no polygon is stored between them, as in
// a hardware clipper. Every plane has its stage, whether the triangle crosses it or not.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974, which describes
// it so; in silicon: Clark, "The Geometry Engine: A VLSI Geometry System for Graphics", SIGGRAPH
// 1982.
// Guarantees: the vertices on an edge depend on that edge alone, bit for bit: every edge meets the
// same stages in the same order, and is cut from its end nearer to the plane.
// Does not guarantee: the exact vertex count where a vertex comes within rounding of a plane.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

struct HomogeneousPipeline : StartsInClipSpace<HomogeneousPipeline> {
  static constexpr std::string_view name = "homogeneous/pipeline";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman in clip space as a stream through one stage per plane";
  static constexpr std::string_view source =
      "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974";
  static constexpr Promise promise{.ulps = kChainUlps, .watertight = true};

  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                             NdcPolygon<T, K>& out) {
    divide(Stream<T, K>(volume, triangle).finish(), out);
  }

  template <Scalar T, int K>
  static constexpr ClipPolygon<T, K> cut(const ClipVolume& volume,
                                         const ClipTriangle<T, K>& triangle) {
    if (is_beyond_open_side(volume, triangle)) return {};
    return divisible<T, K>(Stream<T, K>(volume, triangle).finish());
  }

 private:
  template <Scalar T, int K>
  class Stream {
   public:
    constexpr Stream(const ClipVolume& volume, const ClipTriangle<T, K>& triangle)
        : depth_(volume.depth) {
      if (!has_finite_positions(triangle)) return;
      for_each_plane(planes_of(volume), kAllPlanes,
                     [&](Plane plane) { stages_[stage_count_++].plane = plane; });
      for (const ClipVertex<T, K>& v : triangle) push(0, v);
    }

    // Closes the polygon in every stage.
    constexpr const ClipPolygon<T, K>& finish() {
      for (int s = 0; s < stage_count_; ++s) {
        const Stage& stage = stages_[s];
        if (stage.started) pass_crossing(s, stage.first, stage.d_first);
      }
      return polygon_;
    }

   private:
    struct Stage {
      Plane plane = Plane::left;
      bool started = false;
      ClipVertex<T, K> first, previous;
      T d_first, d_previous;
    };

    constexpr void push(int s, const ClipVertex<T, K>& v) {
      if (s == stage_count_) {
        polygon_.push_back(v);
        return;
      }
      Stage& stage = stages_[s];
      const T d = signed_distance(depth_, stage.plane, v);
      if (stage.started) {
        pass_crossing(s, v, d);
      } else {
        stage.started = true;
        stage.first = v;
        stage.d_first = d;
      }
      stage.previous = v;
      stage.d_previous = d;
      if (T(0) <= d) push(s + 1, v);
    }

    // Hands on where the edge from the stage's previous vertex to v meets the plane, if it does.
    constexpr void pass_crossing(int s, const ClipVertex<T, K>& v, const T& d) {
      const Stage& stage = stages_[s];
      const SegmentSide side = segment_side(stage.d_previous, d);
      if (side == SegmentSide::cut_first) {
        push(s + 1, meeting(v, stage.previous, d, stage.d_previous));
      } else if (side == SegmentSide::cut_second) {
        push(s + 1, meeting(stage.previous, v, stage.d_previous, d));
      }
    }

    DepthRange depth_;
    int stage_count_ = 0;
    std::array<Stage, kMaxPlanes> stages_;
    ClipPolygon<T, K> polygon_;
  };
};

}  // namespace clipscope
