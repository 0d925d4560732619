// SPDX-License-Identifier: GPL-3.0-or-later
//
// Families: what is made from one hard case by small or exact changes.
//
// For exact changes (scalings by 2^k, rotations of the vertices, mirrored axes, other depth ranges) the
// exact result follows from the original's: a relation that holds for every right clipper, whatever
// the result is ("metamorphic": Chen, Cheung and Yiu, "Metamorphic Testing", 1998).
//
// Every variant has a name "theme/name (label)", floats for coordinates, and the outcome that the exact
// reference gives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// How the exact result of a variant follows from the original's, vertex by vertex:
//   x', y' = x, y or y, x by swap_xy, then times sign_x, sign_y     z' = z_scale z + z_offset
//   (1/w)' = 2^inv_w_exponent (1/w)                                 attributes' = attributes
// As a set of vertices. Of input without area (see ExactPolygon) other vertices among those that
// coincide may have stayed, unless keeps_order.
struct Relation {
  bool swap_xy = false;
  int sign_x = 1, sign_y = 1;
  double z_scale = 1, z_offset = 0;
  int inv_w_exponent = 0;
  bool keeps_order = true;  // the vertices of the input are in the original's order

  // Whether the winding on the screen is the other one.
  bool flips_winding() const { return swap_xy != (sign_x * sign_y < 0); }
};

struct CaseVariant {
  std::string label;
  HardCase hard_case;
  std::optional<Relation> relation;  // none: only the exact reference knows
};

// In this order, as far as they apply and all numbers remain floats:
//   scaled       all clip coordinates, or all view coordinates and the lengths of the frustum, times
//                2^k: k = -60, -20, -1, 1, 20, 60
//   rotated      the vertices begin with another one; of segments the ends are swapped; of triangles
//                and polygons also in reverse order
//   mirrored     x, y, x and y negated, x and y swapped
//   depth        clip space: depth mirrored (gl), or near and far exchanged (zero_to_one, reversed);
//                view space: the two other depth ranges
//   neighbours   one coordinate of one vertex moved by one float ulp up or down (not for polygons,
//                which would not be planar)
std::vector<CaseVariant> family(const HardCase& hard_case);

// One coordinate of one vertex replaced by NaN, an infinity, a zero of either sign, the smallest and
// the largest subnormal and the largest finite float, of either sign. Of polygons only NaN and the
// infinities. Without relation; `expected` means nothing where is_finite(variant) is false.
std::vector<CaseVariant> special_values(const HardCase& hard_case);

// Whether all coordinates are: where they aren't there is no exact answer.
bool is_finite(const CaseVariant& variant);

// The variant's exact vertices, sorted, from the original's.
std::vector<reference::RationalVertex> related(const Relation& relation,
                                               std::vector<reference::RationalVertex> original);

}  // namespace clipscope::experiments
