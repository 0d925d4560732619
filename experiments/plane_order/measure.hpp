// SPDX-License-Identifier: GPL-3.0-or-later
//
// What depends on the order of the planes: the exact result, and in rounded arithmetic bits, vertices,
// outcomes and errors.
//
// Triangles are judged in parallel; sums and maxima do not depend on the number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "experiments/plane_order/orders.hpp"
#include "experiments/plane_order/triangle_sets.hpp"

namespace clipscope::experiments {

// The order that the others are compared with: near, far, left, right, bottom, top.
const Order& near_first_order();

// Left, right, bottom, top, far, near.
const Order& near_last_order();

// Of one order, over the triangles of a set.
struct OrderTally {
  std::int64_t differs = 0;        // other bits than near first, rotations of the polygon aside
  std::int64_t other_outline = 0;  // of them another number of vertices
  std::int64_t wrong = 0;          // not what exact arithmetic gives, see is_failure
  std::int64_t overflowed = 0;     // a vertex on the way was not finite
  std::int64_t intersections = 0;  // vertices that were computed, in all
  int largest = 0;                 // vertices of the largest polygon on the way
  // px on 3840 x 2160: largest distance of a vertex from the nearest one by near first, where both leave
  // something; and largest error where the vertices are the right ones.
  double moved_px = 0, error_px = 0;

  OrderTally& operator+=(const OrderTally& other);
};

struct RoundedOrders {
  std::array<OrderTally, kOrders> orders;  // as all_orders
  std::int64_t triangles = 0;
  std::int64_t differs = 0;  // triangles with other bits in some order than in another
  std::int64_t appears = 0;  // of them, something is left in some orders and nothing in others
  std::int64_t wrong_in_some = 0, wrong_in_all = 0;
  // Where near last moves a vertex farthest from where near first has it: the triangle's number.
  double near_last_px = 0;
  std::size_t farthest = 0;
};

// In T: float or double.
template <class T>
RoundedOrders measure_rounded(const TriangleSet& set);

struct ExactOrders {
  std::int64_t triangles = 0;
  std::int64_t mixed_w = 0;          // a vertex has w <= 0
  std::int64_t differs = 0;          // orders leave different sets of vertices
  std::int64_t differs_in_area = 0;  // of them, with an area on the screen in some order
  std::int64_t wrong = 0;  // in some order another set of vertices than the reference, with an area
  std::int64_t runs = 0;   // different orders that were run
};

// At most `limit` of the triangles, evenly spaced, in exact rational numbers.
ExactOrders measure_exact(const TriangleSet& set, std::size_t limit);

}  // namespace clipscope::experiments
