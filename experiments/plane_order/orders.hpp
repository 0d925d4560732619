// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 720 orders of the six planes, and what is left of a triangle by each of them.
//
// A plane that no vertex of the triangle is outside of cuts nothing, whichever vertices other planes
// have made: these lie between the original ones. Clippers driven by outcodes leave such planes out, and
// so does this: n planes that cut have n! orders that matter, and each of the 720 amounts to one of
// them. They are walked as a tree, so that orders that begin alike share their cuts.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {

using Order = std::array<Plane, kPlanes>;
inline constexpr std::size_t kOrders = 720;

// Sorted by the numbers of their planes.
const std::array<Order, kOrders>& all_orders();

// "NFLRBT": the planes' initials, in order.
std::string order_text(const Order& order);

// The place of a plane in the order, from 1.
std::size_t position_of(Plane plane, const Order& order);

// Among the orders of the planes in the code, sorted as all_orders are, the number of the one to which
// this order amounts.
std::size_t restricted(const Order& order, Outcode planes);

// A triangle cut in one order.
template <class T, int K>
struct OrderedCut {
  NdcPolygon<T, K> polygon;
  int intersections = 0;    // vertices that were computed
  int largest = 3;          // vertices of the largest polygon on the way
  bool overflowed = false;  // a vertex on the way was not finite, or there were too many
};

template <class T, int K>
class OrderTree {
 public:
  // Cuts by the planes of the code in each of their orders, through the code that the clippers use; the
  // results are in the order of `restricted`.
  static std::vector<OrderedCut<T, K>> cut_all(DepthRange depth, Outcode planes,
                                               const ClipTriangle<T, K>& triangle) {
    OrderTree tree(depth);
    ClipPolygon<T, K> polygon;
    polygon.assign(triangle);
    tree.descend(polygon, planes, {});
    return std::move(tree.results_);
  }

 private:
  explicit OrderTree(DepthRange depth) : depth_(depth) {}

  void descend(const ClipPolygon<T, K>& polygon, Outcode planes, const OrderedCut<T, K>& so_far) {
    if (planes == 0) {
      results_.push_back(so_far);
      divide(polygon, results_.back().polygon);
      return;
    }
    for (const Plane plane : kAllPlanes) {
      if ((planes & bit(plane)) == 0) continue;
      OrderedCut<T, K> next = so_far;
      ClipPolygon<T, K> rest;
      cut(
          polygon, rest,
          [&](const ClipVertex<T, K>& v) { return signed_distance(depth_, plane, v); },
          [&](const ClipVertex<T, K>& inside, const ClipVertex<T, K>& outside, const T& t) {
            ++next.intersections;
            return interpolate(inside, outside, t);
          });
      note_size(rest, next);
      descend(rest, planes & ~bit(plane), next);
    }
  }

  static void note_size(const ClipPolygon<T, K>& polygon, OrderedCut<T, K>& cut) {
    cut.largest = std::max(cut.largest, polygon.size());
    cut.overflowed = cut.overflowed || polygon.overflowed();
    for (const ClipVertex<T, K>& v : polygon) {
      cut.overflowed = cut.overflowed || !has_finite_position(v);
    }
  }

  DepthRange depth_;
  std::vector<OrderedCut<T, K>> results_;
};

}  // namespace clipscope::experiments
