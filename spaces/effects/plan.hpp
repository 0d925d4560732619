// SPDX-License-Identifier: MIT
//
// Which effects a scene calls for: a Plan made of its SceneFacts.
//
// An effect is left out only where the facts prove that the full pipeline,
// homogeneous/sutherland_hodgman, would give the same without it:
//
//   plane             no vertex of a triangle that is not rejected is outside of it (no cut); and
//                     it is not needed to reject one either (no test)
//   guard band        sides that are crossed within the band only: left to the scissor of whoever
//                     takes the polygons, if there is one (LookOptions)
//   w guard           every w is positive and finite
//   divide            every w is 1
//   perspective       w differs so little within a triangle that affine attributes are within the
//   correction        tolerance of the true ones; 1/w is then 1 at every vertex
//   depth             the user says that nobody reads it; z is then 0 at every vertex
//   interpolation     no triangle is cut, or attributes are constant over each triangle
//
// Open sides call for everything: the facts are those of a closed volume.
//
// All but perspective correction and depth leave the bits of the polygons as they are.
//
// Perspective correction. A point of a triangle at barycentric coordinates b on the screen has
// lambda_i = b_i q_i / q in space, with q_i = 1 / w_i and q = sum of b_i q_i: Heckbert and Moreton,
// "Interpolation for Polygon Texture Mapping and Shading", 1991. Affine interpolation takes b for
// lambda. Its error in an attribute of range R is at most R/2 sum |b_i - lambda_i|. With a share p
// of b where q_i > q this is largest where q_i takes two values, R p (1 - p) (Q - 1) / (p Q + 1 -
// p) for Q = w_max / w_min, and over p
//
//     R (sqrt(Q) - 1) / (sqrt(Q) + 1) = R (Q - 1) / (sqrt(Q) + 1)^2,
//
// reached on an edge. What is cut off a triangle changes neither bound, but for the rounding of new
// vertices: each cut adds at most 3 u w_max to a w and 3 u |a| to an attribute, 14 cuts 42 u; 96 u
// covers both ends of a range, and the roundings of the bound itself are covered by a factor. Where
// 96 u Q is 1 or more the rounding may take w down to nothing, and the bound is R, for both ways
// give a mean of the attribute's values.
//
// A plan can't be made too lean: an EffectSet is everything unless Plan, which asks the facts,
// takes something out; facts know nothing unless they looked; sets can only be joined.
#pragma once

#include <cmath>

#include "spaces/effects/scene_facts.hpp"

namespace clipscope {

// What is done about a plane, in rising order of work.
enum class PlaneEffect : std::uint8_t {
  none,
  reject,      // triangles outside of it are dropped; none crosses it
  guard_band,  // the same, and what crosses it is left to the scissor
  cut
};

template <std::floating_point T>
class Plan;

// Of new vertices, and of the bound of what affine interpolation does; both in units of epsilon.
inline constexpr int kCutRoundings = 96, kAffineRoundings = 16;

class EffectSet {
 public:
  // Everything.
  constexpr EffectSet() { planes_.fill(PlaneEffect::cut); }

  constexpr PlaneEffect plane(Plane p) const { return planes_[static_cast<std::size_t>(p)]; }
  constexpr PlaneEffect user_planes() const { return user_planes_; }
  constexpr bool w_guard() const { return w_guard_; }
  constexpr bool divide() const { return divide_; }
  constexpr bool perspective() const { return perspective_; }
  constexpr bool depth() const { return depth_; }
  constexpr bool interpolation() const { return interpolation_; }

  // Whether some plane gets at least that much work.
  constexpr bool has_plane(PlaneEffect least) const {
    return user_planes_ >= least ||
           std::any_of(planes_.begin(), planes_.end(), [&](PlaneEffect e) { return e >= least; });
  }

  // What either calls for.
  friend constexpr EffectSet operator|(const EffectSet& a, const EffectSet& b) {
    EffectSet r;
    for (std::size_t p = 0; p < kPlanes; ++p) r.planes_[p] = std::max(a.planes_[p], b.planes_[p]);
    r.user_planes_ = std::max(a.user_planes_, b.user_planes_);
    r.w_guard_ = a.w_guard_ || b.w_guard_;
    r.divide_ = a.divide_ || b.divide_;
    r.perspective_ = a.perspective_ || b.perspective_;
    r.depth_ = a.depth_ || b.depth_;
    r.interpolation_ = a.interpolation_ || b.interpolation_;
    return r;
  }
  friend constexpr bool operator==(const EffectSet&, const EffectSet&) = default;

 private:
  template <std::floating_point T>
  friend class Plan;

  std::array<PlaneEffect, kPlanes> planes_;
  PlaneEffect user_planes_ = PlaneEffect::cut;
  bool w_guard_ = true, divide_ = true, perspective_ = true, depth_ = true, interpolation_ = true;
};

template <std::floating_point T>
struct PlanOptions {
  // The largest error of an attribute anywhere in a triangle that may pass for perspective-correct,
  // in the attribute's own unit. 0 leaves perspective correction out only where it changes nothing.
  T tolerance = T(1) / T(512);
  bool depth = true;  // somebody reads z
};

template <std::floating_point T>
class Plan {
 public:
  // Everything.
  explicit Plan(const Projection<T>& projection) : Plan(SceneFacts<T>(projection), {}) {}

  Plan(const SceneFacts<T>& facts, const PlanOptions<T>& options)
      : projection_(facts.projection()), revision_(facts.options().revision) {
    const ClipVolume& volume = projection_.volume;
    affine_error_ = affine_error(facts);
    if (volume.open_sides) return;
    const auto effect_of = [&](Outcode planes) {
      if ((facts.crossed() & planes) != 0) return PlaneEffect::cut;
      return (facts.rejecting() & planes) != 0 ? PlaneEffect::reject : PlaneEffect::none;
    };
    for (const Plane plane : kAllPlanes) {
      PlaneEffect& effect = effects_.planes_[static_cast<std::size_t>(plane)];
      effect = effect_of(bit(plane));
      const bool is_side = plane != Plane::near && plane != Plane::far;
      const bool in_band =
          facts.options().guard_band > T(1) && (facts.crossed_band() & bit(plane)) == 0;
      if (effect == PlaneEffect::cut && is_side && in_band) effect = PlaneEffect::guard_band;
    }
    effects_.user_planes_ = effect_of(~((Outcode{1} << kPlanes) - 1));
    // With depth clamp nothing bounds z, and a triangle whose depth overflows is dropped.
    effects_.w_guard_ = facts.has_bad_w() || bool{volume.depth_clamp};
    effects_.depth_ = options.depth || bool{volume.depth_clamp};
    effects_.divide_ = !facts.has_unit_w();
    effects_.perspective_ = effects_.divide_ && !(affine_error_ <= options.tolerance);
    effects_.interpolation_ = effects_.has_plane(PlaneEffect::cut) && !facts.attributes().flat;
  }

  const Projection<T>& projection() const { return projection_; }
  std::uint64_t revision() const { return revision_; }
  const EffectSet& effects() const { return effects_; }
  // A bound of what leaving perspective correction out does to an attribute; infinite if none is
  // known.
  T affine_error() const { return affine_error_; }

  // The same plan with more effects.
  Plan with(const EffectSet& more) const {
    Plan r = *this;
    r.effects_ = effects_ | more;
    return r;
  }

 private:
  static T affine_error(const SceneFacts<T>& facts) {
    constexpr T u = std::numeric_limits<T>::epsilon();
    const AttributeFacts<T>& a = facts.attributes();
    if (a.flat || facts.has_unit_w()) return T(0);
    const T growth = kCutRoundings * u * facts.w_ratio();
    if (!std::isfinite(growth)) return std::numeric_limits<T>::infinity();
    const T ratio = facts.w_ratio() * (1 + growth);
    const T range = a.range + kCutRoundings * u * a.magnitude;
    const T root = std::sqrt(ratio) + 1;
    const T share = growth < 1 ? (ratio - 1) / (root * root) : T(1);
    const T bound = (1 + kAffineRoundings * u) * range * share;
    return bound == bound ? bound : std::numeric_limits<T>::infinity();
  }

  Projection<T> projection_;
  std::uint64_t revision_ = 0;
  EffectSet effects_;
  T affine_error_ = T(0);
};

}  // namespace clipscope
