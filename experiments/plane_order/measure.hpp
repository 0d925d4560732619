// SPDX-License-Identifier: GPL-3.0-or-later
//
// What depends on the order of the planes: the exact result, and in rounded arithmetic bits,
// vertices, outcomes and errors.
//
// Triangles are judged in parallel; the result does not depend on the number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/plane_order/orders.hpp"
#include "experiments/selection/select.hpp"

namespace clipscope::experiments::plane_order {

struct CutTriangle {
  FloatTriangle triangle;
  Outcode planes = 0;  // that some vertex is outside of
};

// Clip-space triangles that some plane cuts and none rejects, all seen in one depth range.
struct TriangleSet {
  std::string name;
  DepthRange depth = DepthRange::minus_one_to_one;
  std::vector<CutTriangle> triangles;
};

// The sets' names: the selected scenes, or soups, slivers, floor and corridor; then
//   mixed_w     random homogeneous coordinates in [-2, 2], w too
//   lattice     random integers in {-2, ..., 2}: many vertices on planes, at w = 0, no area
//   hard_cases  the triangles of the catalogue in clip space, depth -1 to 1
std::vector<std::string> set_names(const Selection& selection);

// At most `limit` triangles, evenly spaced or the first drawn. Errors: UsageError, InputError.
TriangleSet make_set(const Selection& selection, const std::string& name, std::size_t limit);

// What one order does with some triangles.
struct OrderTally {
  std::int64_t differs = 0;        // other bits than near first, rotations of the polygon aside
  std::int64_t other_outline = 0;  // of them another number of vertices
  std::int64_t wrong = 0;          // not what exact arithmetic gives, see is_failure
  std::int64_t overflowed = 0;     // a vertex on the way was not finite
  std::int64_t intersections = 0;  // vertices that were computed, in all
  int largest = 0;                 // vertices of the largest polygon on the way
  // px on 3840 x 2160: the largest distance of a vertex from the nearest one by near first, where
  // both leave something; and the largest error where the vertices are the right ones.
  double moved_px = 0, error_px = 0;

  OrderTally& operator+=(const OrderTally& other);
};

struct RoundedOrders {
  std::string_view scalar;
  std::array<OrderTally, kOrders> orders = {};  // as kAllOrders
  std::int64_t triangles = 0;
  std::int64_t differs = 0;  // triangles with other bits in some order than in another
  std::int64_t wrong_in_some = 0, wrong_in_all = 0;
  // The triangle on which near last moves a vertex farthest from where near first has it.
  double near_last_px = 0;
  std::size_t farthest = 0;
};

// T is float or double.
template <class T>
RoundedOrders measure_rounded(const TriangleSet& set);

struct ExactOrders {
  std::int64_t triangles = 0;
  std::int64_t mixed_w = 0;  // a vertex has w <= 0
  std::int64_t runs = 0;     // different orders that were run
  std::int64_t differs = 0;  // orders leave different sets of vertices
  std::int64_t wrong = 0;    // in some order another set than the reference, with an area on screen

  ExactOrders& operator+=(const ExactOrders& other);
};

// At most `limit` of the triangles, evenly spaced, in exact rational numbers.
ExactOrders measure_exact(const TriangleSet& set, std::size_t limit);

}  // namespace clipscope::experiments::plane_order
