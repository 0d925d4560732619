// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 720 orders of the six planes, and what is left of a triangle by each of them.
//
// A plane that no vertex of the triangle is outside of cuts nothing, whichever vertices other
// planes have made: these lie between the original ones. Clippers driven by outcodes leave such
// planes out, and so does this: n planes that cut have n! orders that matter, and each of the 720
// amounts to one of them. They are walked as a tree, so that orders that begin alike share their
// cuts.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "experiments/scenes/scene.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/measured.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::plane_order {

// Clip-space floats are the input: the question is about the cuts, so the rounding of the transform
// is none of its errors.
using FloatTriangle = ClipTriangle<float, kSceneAttributes>;

using Order = std::array<Plane, kPlanes>;
inline constexpr std::size_t kOrders = 720;

// The order that the others are compared with: near, far, left, right, bottom, top.
inline constexpr Order kNearFirst = kPlaneOrder<PlaneOrder::near_first>;
// Left, right, bottom, top, far, near.
inline constexpr Order kNearLast = kPlaneOrder<PlaneOrder::near_last>;

// Sorted by the numbers of their planes.
inline constexpr std::array<Order, kOrders> kAllOrders = [] {
  std::array<Order, kOrders> orders{};
  Order order = kAllPlanes;
  for (Order& o : orders) {
    o = order;
    std::ranges::next_permutation(order);
  }
  return orders;
}();

// "NFLRBT": the planes' initials, in order.
inline std::string order_text(const Order& order) {
  std::string text;
  for (const Plane plane : order) text += "LRBTNF"[static_cast<std::size_t>(plane)];
  return text;
}

// Among the orders of the planes in the code, sorted as kAllOrders are, the number of the one to
// which this order amounts.
inline std::size_t restricted(const Order& order, Outcode planes) {
  // Lexicographic rank: by Horner, each plane's number among those that are still to come.
  std::size_t rank = 0, left = static_cast<std::size_t>(std::popcount(planes));
  for (const Plane plane : order) {
    if ((planes & bit(plane)) == 0) continue;
    const Outcode smaller = planes & (bit(plane) - 1);
    rank = rank * left-- + static_cast<std::size_t>(std::popcount(smaller));
    planes &= ~bit(plane);
  }
  return rank;
}

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
  // Cuts by the planes of the code in each of their orders, through the code that the clippers use;
  // the results are in the order of `restricted`. The triangle's numbers are taken into T exactly,
  // with its first K attributes.
  static std::vector<OrderedCut<T, K>> cut_all(DepthRange depth, Outcode planes,
                                               const FloatTriangle& triangle) {
    OrderTree tree;
    Polygon polygon;
    for (const auto& [position, attributes] : triangle) {
      ClipVertex<T, K> vertex{Vec4<T>(position), {}};
      for (int k = 0; k < K; ++k) vertex.attributes[k] = T(attributes[k]);
      polygon.push_back(measured(depth, vertex));
    }
    tree.descend(polygon, planes, {});
    return std::move(tree.results_);
  }

 private:
  using Vertex = MeasuredVertex<Space::clip, T, K>;
  using Polygon = VertexList<Vertex>;

  void descend(const Polygon& polygon, Outcode planes, const OrderedCut<T, K>& so_far) {
    if (planes == 0) {
      results_.push_back(so_far);
      divide(polygon, results_.back().polygon);
      return;
    }
    for (const Plane plane : kAllPlanes) {
      if ((planes & bit(plane)) == 0) continue;
      OrderedCut<T, K> next = so_far;
      Polygon rest;
      cut(
          polygon, rest, [&](const Vertex& v) { return carried_distance(plane, v); },
          [&](const Vertex& from, const Vertex& to, const T& t) {
            ++next.intersections;
            return interpolate(from, to, t);
          });
      next.largest = std::max(next.largest, rest.size());
      next.overflowed = next.overflowed || rest.overflowed() ||
                        !std::ranges::all_of(rest, has_finite_position<Space::clip, T, K>);
      descend(rest, planes & ~bit(plane), next);
    }
  }

  std::vector<OrderedCut<T, K>> results_;
};

}  // namespace clipscope::experiments::plane_order
