// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in clip space for a convex polygon of any size.
//
// The caller owns the memory: vectors that grow to the largest polygon met and keep what they have.
// Nothing else is allocated.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974; homogeneous:
// Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
// Guarantees: for three vertices the same bits as homogeneous/sutherland_hodgman: the same
// outcodes, the same planes in the same order, the same arithmetic.
// Pre-condition: the polygon is planar and convex. The parts left of a concave one are joined
// along the planes, as Sutherland and Hodgman describe; triangulate it first.
// Does not guarantee: coordinates within the volume to the last bit after the divide; the exact
// vertex count where a vertex comes within rounding of a plane.
#pragma once

#include <span>
#include <vector>

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/measured.hpp"

namespace clipscope {

template <Scalar T, int K>
class HomogeneousPolygonClipper {
 public:
  static constexpr std::string_view name = "homogeneous/polygon";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman in clip space for a convex polygon of any size";
  static constexpr std::string_view source =
      "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974";
  static constexpr Promise promise{.ulps = kChainUlps};

  // The part of the polygon in the volume, divided, in the polygon's winding; empty if that has
  // fewer than three vertices. Valid until the next call. Policy for NaN and infinity: clipper.hpp.
  std::span<const NdcVertex<T, K>> operator()(const ClipVolume& volume,
                                              std::span<const ClipVertex<T, K>> polygon) {
    divided_.clear();
    Outcode all = planes_of(volume);
    Outcode any = 0;
    for (const ClipVertex<T, K>& v : polygon) {
      const Outcode code =
          clip_outcode(volume.depth, v.position) | clip_distance_outcode(volume, v.attributes);
      all &= code;
      any |= code;
    }
    any &= planes_of(volume);
    if (polygon.size() < 3 || all != 0) return divided_;
    const auto is_inside = [&](Plane side, std::size_t i) {
      return is_inside_side(side, polygon[i].position);
    };
    if (is_beyond_open_side(volume, polygon.size(), is_inside)) return divided_;
    for (const ClipVertex<T, K>& v : polygon) {
      if (!has_finite_position(v)) return divided_;
    }
    polygon_.clear();
    for (const ClipVertex<T, K>& v : polygon) polygon_.push_back(measured(volume.depth, v));
    divide(any == 0 ? polygon_ : cut_by(any));
    return divided_;
  }

  // The same for a polygon in view space.
  std::span<const NdcVertex<T, K>> operator()(const Projection<T>& projection,
                                              std::span<const ViewVertex<T, K>> polygon) {
    projected_.clear();
    for (const ViewVertex<T, K>& v : polygon) projected_.push_back(to_clip(projection, v));
    return (*this)(projection.volume, projected_);
  }

 private:
  using Measured = MeasuredVertex<Space::clip, T, K>;
  using Vertices = std::vector<Measured>;

  static constexpr std::array<Plane, kPlanes> kOrder = {Plane::near,  Plane::far,    Plane::left,
                                                        Plane::right, Plane::bottom, Plane::top};

  const Vertices& cut_by(Outcode planes) {
    return cut_by_planes(polygon_, scratch_, planes, kOrder,
                         [](Plane plane, const Measured& v) { return carried_distance(plane, v); });
  }

  // A vertex whose w is not positive is the eye itself and is left out.
  void divide(const Vertices& polygon) {
    for (const ClipVertex<T, K>& v : polygon) {
      if (T(0) < v.position[3]) divided_.push_back(to_ndc(v));
    }
    bool finite = true;
    for (const NdcVertex<T, K>& v : divided_) {
      for (int i = 0; i < 3; ++i) finite = finite && is_finite(v.position[i]);
    }
    if (divided_.size() < 3 || !finite) divided_.clear();
  }

  std::vector<ClipVertex<T, K>> projected_;
  Vertices polygon_, scratch_;
  std::vector<NdcVertex<T, K>> divided_;
};

}  // namespace clipscope
