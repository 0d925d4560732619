// SPDX-License-Identifier: MIT
//
// What a scene, seen through one projection, can ask of a clipping pipeline: SceneFacts.
//
// Triangles are looked at in groups. The box of a group is held against the planes
// (culling_planes.hpp, whose error bound covers the rounding of the pipeline's transform as well);
// only where that leaves open a question that is still of interest are the group's triangles looked
// at one by one, by the clip coordinates and outcodes that the pipeline itself computes. The
// looking ends where nothing more can be found: once everything is called for.
// Method: this project. Boxes against planes: see visibility.hpp. Outcodes: see planes.hpp.
//
// A triangle is called rejected here if all its vertices are outside of one plane, by outcodes.
// Guarantees, for a pipeline with the same rounding mode and the same treatment of contraction
// (FMA):
//   - crossed(): every plane that some vertex of a triangle that is not rejected is outside of;
//   - rejecting(): planes that together with crossed() suffice to reject each rejected triangle;
//   - crossed_band(): side planes at guard_band times their distance that such a vertex is outside
//     of;
//   - has_bad_w() false: w is positive and finite at all vertices of triangles that are not
//     rejected;
//   - has_unit_w(): w is exactly 1 at every vertex of the scene;
//   - w_ratio(): no triangle that is not rejected has a larger w_max / w_min.
// Facts err to one side only: they may report what does not happen. NaN and infinity count as
// anything.
//
// Facts hold for the projection and the triangles looked at, as long as these stay as they are.
// `revision` is the caller's number for that state: whoever animates a vertex changes the number,
// and a plan made of older facts then runs the full pipeline (pipeline.hpp).
// Does not guarantee: the least that a scene calls for, where boxes settle a question.
#pragma once

#include <cstdint>
#include <span>

#include "spaces/bounds/visibility.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

// What attributes are like. It is the same from every view, so it is found once per mesh. The
// default is that nothing is known.
template <std::floating_point T>
struct AttributeFacts {
  // Each attribute has the same value at the three vertices of any triangle, is finite and not -0:
  // then a + t (a - a) is a to the bit (-0 would give 0).
  bool flat = false;
  // The largest difference within a triangle, and the largest magnitude, of any attribute.
  T range = std::numeric_limits<T>::infinity();
  T magnitude = std::numeric_limits<T>::infinity();
};

template <std::floating_point T, int K>
AttributeFacts<T> attribute_facts(std::span<const ViewTriangle<T, K>> triangles) {
  AttributeFacts<T> facts{true, T(0), T(0)};
  T poison(0);  // NaN once an attribute is NaN or infinite
  for (const ViewTriangle<T, K>& triangle : triangles) {
    for (int k = 0; k < triangle[0].attributes.size(); ++k) {
      const T a = triangle[0].attributes[k], b = triangle[1].attributes[k];
      const T c = triangle[2].attributes[k];
      const T low = std::min({a, b, c}), high = std::max({a, b, c});
      poison += T(0) * a + T(0) * b + T(0) * c;
      facts.range = std::max(facts.range, high - low);
      facts.magnitude = std::max({facts.magnitude, -low, high});
      const bool minus_zero = a == T(0) && (std::signbit(a) || std::signbit(b) || std::signbit(c));
      facts.flat = facts.flat && low == high && !minus_zero;
    }
  }
  return poison == T(0) ? facts : AttributeFacts<T>{};
}

template <std::floating_point T>
struct LookOptions {
  // Whoever takes the polygons scissors them to the window: x and y may reach so many times w.
  // 1: no guard band, polygons end at the sides of the volume. Pre-condition: >= 1.
  T guard_band = T(1);
  std::uint64_t revision = 0;  // of the triangles
  // Primitives beside the triangles; they are clipped by their own clippers.
  std::size_t segments = 0, points = 0;
};

template <std::floating_point T>
class SceneFacts {
 public:
  // Nothing is known: anything may happen.
  explicit SceneFacts(const Projection<T>& projection)
      : projection_(projection), rows_(rows_of(projection)) {
    know_nothing();
  }

  // Looks at all triangles of a scene.
  template <int K>
  SceneFacts(const Projection<T>& projection, std::span<const ViewTriangle<T, K>> triangles,
             const AttributeFacts<T>& attributes, const LookOptions<T>& options = {})
      : projection_(projection),
        rows_(rows_of(projection)),
        attributes_(attributes),
        options_(options) {
    look_at_all(culling_planes(projection), triangles);
  }

  // The same for triangles that any matrix takes to clip space, by the transform of its rows
  // (projection.hpp). Of the projection only the volume counts then, and pipelines, which project
  // by a frustum, have no use for the facts.
  template <int K>
  SceneFacts(const ClipVolume& volume, const MatrixRows<T>& rows,
             std::span<const ViewTriangle<T, K>> triangles, const AttributeFacts<T>& attributes,
             const LookOptions<T>& options = {})
      : rows_(rows), is_given_(true), attributes_(attributes), options_(options) {
    projection_.volume = volume;
    look_at_all(culling_planes(volume.depth, rows), triangles);
  }

  const Projection<T>& projection() const { return projection_; }
  const AttributeFacts<T>& attributes() const { return attributes_; }
  const LookOptions<T>& options() const { return options_; }
  Outcode crossed() const { return crossed_; }
  Outcode rejecting() const { return rejecting_; }
  Outcode crossed_band() const { return crossed_band_; }
  bool has_bad_w() const { return has_bad_w_; }
  bool has_unit_w() const { return has_unit_w_; }
  T w_ratio() const { return w_ratio_; }

 private:
  static constexpr std::size_t kGroup = 64;  // triangles
  static constexpr Outcode kSidePlanes =
      bit(Plane::left) | bit(Plane::right) | bit(Plane::bottom) | bit(Plane::top);

  template <int K>
  void look_at_all(const CullingPlanes<T>& planes, std::span<const ViewTriangle<T, K>> triangles) {
    for (std::size_t first = 0; first < triangles.size(); first += kGroup) {
      if (is_everything_called_for()) return know_nothing();
      look_at_group(planes, triangles.subspan(first, std::min(kGroup, triangles.size() - first)));
    }
  }

  // Anything may happen.
  void know_nothing() {
    crossed_ = planes_of(projection_.volume);
    rejecting_ = 0;
    crossed_band_ = kSidePlanes;
    has_bad_w_ = true;
    has_unit_w_ = false;
    w_ratio_ = std::numeric_limits<T>::infinity();
  }

  // Nothing that comes after can change what is known then.
  bool is_everything_called_for() const {
    return crossed_ == planes_of(projection_.volume) && !is_band_open(kSidePlanes) && has_bad_w_ &&
           !has_unit_w_;
  }

  // Whether some of the planes, if crossed, might be crossed within the band only.
  bool is_band_open(Outcode planes) const {
    return options_.guard_band > T(1) && (planes & kSidePlanes & ~crossed_band_) != 0;
  }

  // As the transform computes it.
  Vec4<T> clip_position(const Vec3<T>& p) const {
    return is_given_ ? to_clip(rows_, p) : to_clip(projection_, p);
  }
  T w_at(const Vec3<T>& p) const {
    const Vec4<T>& w = rows_[3];
    return is_given_ ? w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3] : w[2] * p[2] + w[3];
  }
  bool is_w_constant() const {
    return rows_[3][0] == T(0) && rows_[3][1] == T(0) && rows_[3][2] == T(0);
  }

  template <int K>
  static AxisBox<T> box_of(std::span<const ViewTriangle<T, K>> group) {
    AxisBox<T> box;
    T poison(0);  // NaN once a coordinate is NaN or infinite; min and max may overlook a NaN
    for (const ViewTriangle<T, K>& triangle : group) {
      for (const ViewVertex<T, K>& v : triangle) {
        const Vec3<T>& p = v.position;
        for (int i = 0; i < 3; ++i) {
          box.lower[i] = std::min(box.lower[i], p[i]);
          box.upper[i] = std::max(box.upper[i], p[i]);
        }
        poison += T(0) * p[0] + T(0) * p[1] + T(0) * p[2];
      }
    }
    if (poison == T(0)) return box;
    return {Vec3<T>(-std::numeric_limits<T>::infinity()),
            Vec3<T>(std::numeric_limits<T>::infinity())};
  }

  template <int K>
  void look_at_group(const CullingPlanes<T>& planes, std::span<const ViewTriangle<T, K>> group) {
    const AxisBox<T> box = box_of(group);
    const Outcode clipping = planes_of(projection_.volume);
    Outcode open = clipping & ~((Outcode{1} << kPlanes) - 1);  // boxes know no clip distances
    Outcode rejecting = 0;
    for (int i = 0; i < kPlanes && is_finite(box); ++i) {
      const bounds::Side side = bounds::side_of(planes.planes[static_cast<std::size_t>(i)], box);
      const Outcode plane = bit(static_cast<Plane>(i)) & clipping;
      if (side == bounds::Side::outside) rejecting |= plane;
      if (side != bounds::Side::inside) open |= plane;
    }
    const bool parallel_w = is_w_constant() && rows_[3][3] == T(1);
    if (!is_finite(box)) {
      look_closer(group);
    } else if (rejecting != 0) {
      reject_by(rejecting);
      has_unit_w_ = has_unit_w_ && parallel_w;
    } else if ((open & ~crossed_) != 0 || is_band_open(open) || !is_w_settled(box)) {
      look_closer(group);
    } else {
      note_w_ratios(group);
      has_unit_w_ = has_unit_w_ && parallel_w;
    }
  }

  // w of a point is monotonic in each coordinate, as computed: it is least and largest at corners.
  bool is_w_settled(const AxisBox<T>& box) const {
    Vec3<T> least, most;
    for (int i = 0; i < 3; ++i) {
      const bool rises = T(0) <= rows_[3][i];
      least[i] = rises ? box.lower[i] : box.upper[i];
      most[i] = rises ? box.upper[i] : box.lower[i];
    }
    return has_bad_w_ || (T(0) < w_at(least) && is_finite(w_at(most)));
  }

  template <int K>
  void note_w_ratios(std::span<const ViewTriangle<T, K>> group) {
    if (has_bad_w_ || is_w_constant()) return;
    for (const ViewTriangle<T, K>& t : group) {
      note_w(w_at(t[0].position), w_at(t[1].position), w_at(t[2].position));
    }
  }

  void note_w(const T& a, const T& b, const T& c) {
    const T low = std::min({a, b, c}), high = std::max({a, b, c});
    // The sum is NaN if one is NaN, which min and max may overlook.
    if (!(T(0) < low) || !is_finite(a + b + c)) {
      has_bad_w_ = true;
      w_ratio_ = std::numeric_limits<T>::infinity();
    } else {
      w_ratio_ = std::max(w_ratio_, high / low);
    }
  }

  void reject_by(Outcode planes) {
    if ((planes & (crossed_ | rejecting_)) == 0) rejecting_ |= planes & (~planes + 1);
  }

  template <int K>
  void look_closer(std::span<const ViewTriangle<T, K>> group) {
    for (const ViewTriangle<T, K>& triangle : group) look_closer(triangle);
  }

  template <int K>
  void look_closer(const ViewTriangle<T, K>& triangle) {
    const std::array<Vec4<T>, 3> positions = {clip_position(triangle[0].position),
                                              clip_position(triangle[1].position),
                                              clip_position(triangle[2].position)};
    const OutcodeSummary code = summarize_outcodes(
        projection_.volume, triangle,
        [&](std::size_t i) { return clip_outcode(projection_.volume.depth, positions[i]); });
    for (const Vec4<T>& p : positions) has_unit_w_ = has_unit_w_ && p[3] == T(1);
    if (code.all != 0) {
      reject_by(code.all);
      return;
    }
    crossed_ |= code.any;
    if (is_band_open(code.any)) {
      for (const Vec4<T>& p : positions) {
        const T band = options_.guard_band * p[3];
        crossed_band_ |= volume_outcode(projection_.volume.depth, p, band) & kSidePlanes;
      }
    }
    if (!has_bad_w_) note_w(positions[0][3], positions[1][3], positions[2][3]);
  }

  Projection<T> projection_;
  MatrixRows<T> rows_;     // of the projection, or as given
  bool is_given_ = false;  // the rows are the transform
  AttributeFacts<T> attributes_;
  LookOptions<T> options_;
  Outcode crossed_ = 0, rejecting_ = 0, crossed_band_ = 0;
  bool has_bad_w_ = false, has_unit_w_ = true;
  T w_ratio_ = T(1);
};

}  // namespace clipscope
