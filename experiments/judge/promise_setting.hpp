// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the check of a promise works on before any distance is computed, and of which primitives a
// promise speaks (spaces/clipper.hpp).
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "experiments/contestants/answers.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/clipper.hpp"

namespace clipscope::experiments {

// A primitive's vertices in clip space.
using RoundedCorners = std::vector<std::array<double, 4>>;

struct Corners {
  std::vector<std::array<Exact, 4>> exact;
  RoundedCorners rounded;
  bool divisible = true;  // no w is 0
};

// The range of w over the part of the primitive in front of the near plane.
struct WRange {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0;
  bool in_front = true;  // all of the primitive is
};

// magnitude: M; unit: what an error is measured in, (u M + eta) * amplification.
struct PromiseSetting {
  std::span<const reference::InputVertex> vertices;
  int attribute_count;
  Corners corners;
  WRange w = {};
  double magnitude = 0, unit = 0, tolerance = 0;
  double largest_attribute = 0;
  Exact attribute_scale = Exact(0);  // attributes times this have the unit of positions
};

// What a frustum's matrix and planes are made of, as far as it may leave a scalar's format.
struct FrustumRange {
  double smallest_entry = 1, largest_entry = 1;  // of the projection matrix, but for zeros
  double largest_sum = 1;                        // of two of the frustum's bounds
  double steepest = 0;                           // slope of a side
  // Between two sides on the near plane; planes in view space have products of that order.
  double narrowest = std::numeric_limits<double>::infinity();

  FrustumRange() = default;  // of what is clipped without a frustum: everything stays
  explicit FrustumRange(const Frustum<double>& frustum);

  // magnitude: M of the primitive.
  bool fits(const Format& format, double magnitude) const;
};

Corners corners_of(const reference::Truth& truth, std::span<const reference::InputVertex> vertices);

WRange w_in_front(DepthRange depth, const RoundedCorners& corners);

// What attributes are to be multiplied by; 0 where all of them are 0. Pre-condition: the setting's
// magnitudes and range of w are set.
Exact attribute_scale(const Promise& promise, const Format& format, const PromiseSetting& setting);

// Whether the promise speaks of the primitive: of its place before the eye, and of numbers that
// stay in the format where it is divided. intermediate: the largest before that.
bool speaks_of(const Promise& promise, const ClipVolume& volume, const PromiseSetting& setting,
               const Format& format, double intermediate);

}  // namespace clipscope::experiments
