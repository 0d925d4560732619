// SPDX-License-Identifier: MIT
//
// The plane that binds an end of a segment, found by comparing products instead of parameters.
//
// An end is bound by the plane that cuts away most, among those that it is outside of. The part cut
// away and the part kept are as |d_cut| to d_kept, so two planes compare by two products and no
// division; and what binds the one end comes before what binds the other if cut / kept there < kept
// / cut here. This is the determinant of the distances whose sign tells on which side of a corner
// of the volume the segment passes; Nicholl, Lee and Nicholl, "An Efficient New Algorithm for 2-D
// Line Clipping: Its Development and Analysis", SIGGRAPH 1987, compare slopes by it.
// Does not guarantee: the exact order of planes whose ratios differ by less than the rounding of
// two products.
#pragma once

#include <limits>

#include "spaces/segment.hpp"

namespace clipscope {

// Whether a / b < c / d, for a, b, c, d > 0: by products, or by quotients where a product may have
// overflowed or lost bits to underflow.
template <Scalar T>
constexpr bool is_ratio_less(const T& a, const T& b, const T& c, const T& d) {
  const T left = a * d;
  const T right = c * b;
  const bool less = left < right;
  if constexpr (kHasInfinity<T>) {
    using Limits = std::numeric_limits<T>;
    const T smallest(Limits::min() / Limits::epsilon());
    const T largest(Limits::max());
    const bool in_range = less ? smallest <= left && right <= largest  //
                               : smallest <= right && left <= largest;
    if (!in_range) {
      const T left_quotient = a / b;
      const T right_quotient = c / d;
      return left_quotient < right_quotient;
    }
  }
  return less;
}

// The plane that an end is to be moved to, with the distances d_kept of the other end and d_cut of
// the end itself.
template <Scalar T>
struct BindingPlane {
  bool binds = false;
  Plane plane = Plane::left;
  T d_kept = T(0), d_cut = T(0);

  // Takes over a plane that cuts away more. Pre-condition: kept > 0 > cut.
  constexpr void tighten(Plane by, const T& kept, const T& cut) {
    if (!binds || is_ratio_less<T>(T(-d_cut), d_kept, T(-cut), kept)) *this = {true, by, kept, cut};
  }
};

// Whether something longer than a point is left between the planes that bind the two ends.
template <Scalar T>
constexpr bool is_visible(const BindingPlane<T>& first, const BindingPlane<T>& second) {
  return !first.binds || !second.binds ||
         is_ratio_less<T>(T(-first.d_cut), first.d_kept, second.d_kept, T(-second.d_cut));
}

// Moves the ends to the planes that bind them: one division for each.
template <SegmentSpace S>
constexpr std::optional<SegmentIn<S>> move_ends(
    const S& space, const SegmentIn<S>& segment, const BindingPlane<typename S::ScalarType>& first,
    const BindingPlane<typename S::ScalarType>& second) {
  using T = typename S::ScalarType;
  SegmentIn<S> ends = segment;
  if (first.binds) {
    const T t = cut_parameter(first.d_kept, first.d_cut);
    if (!(T(0) < t)) return std::nullopt;
    ends[0] = space.meet(first.plane, segment[1], segment[0], t);
  }
  if (second.binds) {
    const T t = cut_parameter(second.d_kept, second.d_cut);
    if (!(T(0) < t)) return std::nullopt;
    ends[1] = space.meet(second.plane, segment[0], segment[1], t);
  }
  return ends;
}

}  // namespace clipscope
