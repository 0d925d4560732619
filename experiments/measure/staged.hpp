// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scalar with which a clipper leaves a step out: the same source, timed without it.
//
// Staged<T, kSkip> computes as T does. The projection and the divide of spaces/projection.hpp, when they
// are asked for in such a scalar, hand the position through:
//
//   Skip::divide                the polygon comes out in clip coordinates
//   Skip::transform_and_divide  of a clipper that cuts in view space: in view coordinates, w = -z
//
// Only the step that is last in a clipper may be left out: what follows it would compute with other
// numbers. The arithmetic before it has the same bits as in T.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include "experiments/measure/computes_as.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

enum class Skip { divide, transform_and_divide };

template <std::floating_point T, Skip kSkip>
class Staged : public ComputesAs<Staged<T, kSkip>, T> {
 public:
  constexpr Staged() = default;
  constexpr explicit Staged(double value) : value_(static_cast<T>(value)) {}

  constexpr T value() const { return value_; }

  static constexpr Staged of(T value) {
    Staged r;
    r.value_ = value;
    return r;
  }
  static constexpr Staged quotient(const Staged& a, const Staged& b) {
    return of(a.value_ / b.value_);
  }

  friend Staged sqrt(const Staged& a) { return of(std::sqrt(a.value_)); }

 private:
  T value_;  // unspecified until it is set, as in T: polygons have room for many vertices
};

// Found in place of those of spaces/projection.hpp by the type of their arguments.
template <std::floating_point T>
constexpr Vec4<Staged<T, Skip::transform_and_divide>> to_clip(
    const Projection<Staged<T, Skip::transform_and_divide>>&,
    const Vec3<Staged<T, Skip::transform_and_divide>>& v) {
  return {v[0], v[1], v[2], -v[2]};
}

template <std::floating_point T, Skip kSkip>
constexpr Vec4<Staged<T, kSkip>> to_ndc(const Vec4<Staged<T, kSkip>>& v) {
  return v;
}

}  // namespace clipscope::experiments

template <class T, clipscope::experiments::Skip kSkip>
struct std::numeric_limits<clipscope::experiments::Staged<T, kSkip>> : std::numeric_limits<T> {};
