// SPDX-License-Identifier: MIT
//
// Skala's segment clipper against a convex polyhedron, for the box that the canonical view volume
// is.
//
// The segment's line is the intersection of two planes. A facet can be met by the line only if both
// planes have vertices of it on either side, and a vertex is put into the equation of each plane
// once, whatever the number of its facets. Only for facets that pass is a parameter computed; the
// others cost no division. Both planes are chosen parallel to an axis of the box: with a the axis
// that the segment is longest along, the planes hold the segment's direction D and the axes b and
// c,
//
//     F(v) = D_a (v_b - P_b) - D_b (v_a - P_a),    and the same with c,
//
// so that each takes four different values at the eight corners. A corner on the plane (F = 0)
// counts for both sides.
//
// For a box the facets that pass are enough to tell a miss, too: in the picture along c the line
// enters and leaves the rectangle through facets that pass, and likewise along b; and a facet that
// bounds the line in one picture alone is overtaken by the bound of the other. So the largest
// parameter of entry and the smallest of exit settle what is visible, and no point is tested for
// lying in its facet.
//
// Source: Skala, "Line Clipping by Convex and Non-Convex Polyhedra in E3", Computer Graphics Forum
// 15(1), 1996, where facets are triangles and a facet that passes is tested in detail; of the text
// its first part was at hand, the rest is known from accounts of it. The box's own test in place of
// the detailed one: this project.
// What the contract adds: a clip distance is one more plane that always passes; with depth clamp
// the volume is no polyhedron, and the method is not applicable.
// Does not guarantee: the same bits for a segment and its reverse: F is measured from the first
// end. An answer where w <= 0 is left in front of the near plane: such a segment is dropped.
#pragma once

#include "spaces/cvv/segment_space.hpp"
#include "spaces/parametric_bounds.hpp"

namespace clipscope {

struct SkalaPolyhedron {
  // The part of the segment that is inside, or none. Only for spaces with Cartesian positions whose
  // six planes bound a box.
  template <SegmentSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    const Line<S> line(space, segment);
    Outcode passed = line.facets(line.b, line.c) & line.facets(line.c, line.b);
    if (passed == 0) return std::nullopt;
    passed |= space.planes() & ~kFacets;
    ParametricBounds<typename S::ScalarType> bounds;
    bool visible = true;
    for_each_plane(passed, kAllPlanes, [&](Plane plane) {
      if (!visible) return;
      visible =
          bounds.cut(plane, space.distance(plane, segment[0]), space.distance(plane, segment[1]));
    });
    if (!visible) return std::nullopt;
    return bounds.move_ends(space, segment);
  }

 private:
  static constexpr Outcode kFacets = (Outcode{1} << kPlanes) - 1;

  // The two facets that an axis is normal to.
  static constexpr Plane lower(int axis) { return static_cast<Plane>(2 * axis); }
  static constexpr Plane upper(int axis) { return static_cast<Plane>(2 * axis + 1); }

  // Which sides of a plane hold something; on the plane is on both.
  struct Sides {
    bool above = false, below = false;

    constexpr bool are_both() const { return above && below; }
    friend constexpr Sides operator|(const Sides& a, const Sides& b) {
      return {a.above || b.above, a.below || b.below};
    }
  };

  template <SegmentSpace S>
  struct Line {
    using T = typename S::ScalarType;

    const S& space;
    Vec3<T> point, direction;
    int a = 0, b = 1, c = 2;  // axes; the segment is longest along a

    constexpr Line(const S& s, const SegmentIn<S>& segment) : space(s) {
      Vec3<T> length;
      for (int i = 0; i < 3; ++i) {
        point[i] = segment[0].position[i];
        direction[i] = segment[1].position[i] - point[i];
        length[i] = direction[i];
        if (length[i] < T(0)) length[i] = -direction[i];
      }
      for (int i = 1; i < 3; ++i) {
        if (length[a] < length[i]) a = i;
      }
      b = (a + 1) % 3;
      c = (a + 2) % 3;
    }

    // The sides of the plane that holds the line and axis `parallel` that a corner is on.
    constexpr Sides sides(int across, const T& along_a, const T& along_across) const {
      const T f =
          direction[a] * (along_across - point[across]) - direction[across] * (along_a - point[a]);
      return {!(f < T(0)), !(T(0) < f)};
    }

    // The facets that the plane which holds the line and axis `parallel` has vertices of on either
    // side; `across` is the third axis.
    constexpr Outcode facets(int across, int parallel) const {
      const T a_low = space.coordinate(lower(a)), a_high = space.coordinate(upper(a));
      const T low = space.coordinate(lower(across)), high = space.coordinate(upper(across));
      const Sides low_low = sides(across, a_low, low), low_high = sides(across, a_low, high);
      const Sides high_low = sides(across, a_high, low), high_high = sides(across, a_high, high);
      Outcode code = 0;
      if ((low_low | low_high).are_both()) code |= bit(lower(a));
      if ((high_low | high_high).are_both()) code |= bit(upper(a));
      if ((low_low | high_low).are_both()) code |= bit(lower(across));
      if ((low_high | high_high).are_both()) code |= bit(upper(across));
      if (code != 0) code |= bit(lower(parallel)) | bit(upper(parallel));
      return code;
    }
  };
};

struct CvvSkalaPolyhedron : StartsInClipSpace<NearCutThenCvv<SkalaPolyhedron>> {
  static constexpr std::string_view name = "cvv/skala_polyhedron";
  static constexpr std::string_view summary =
      "homogeneous cut by the near plane, divide, then facets that two planes through the segment cross";
  static constexpr std::string_view source =
      "Skala, Line Clipping by Convex and Non-Convex Polyhedra in E3, 1996";
  // As cvv/liang_barsky; and F has four roundings, each of at most the product of two lengths of 2
  // M: a corner is taken for one on the other side if the line passes it by 16 u M at most.
  static constexpr Promise promise{.domain = Promise::Domain::divisible,
                                   .ulps = kProjectUlps + kSegmentCutUlps + kParametricUlps + 16,
                                   .amplification = Promise::Amplification::w_ratio,
                                   .rotation_invariant = false,
                                   .depth_clamp = false};
};

}  // namespace clipscope
