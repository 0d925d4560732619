// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/plane_order/orders.hpp"

#include <algorithm>
#include <bit>

namespace clipscope::experiments {

const std::array<Order, kOrders>& all_orders() {
  static const std::array<Order, kOrders> all = [] {
    std::array<Order, kOrders> orders;
    Order order = kAllPlanes;
    for (Order& o : orders) {
      o = order;
      std::next_permutation(order.begin(), order.end());
    }
    return orders;
  }();
  return all;
}

std::string order_text(const Order& order) {
  std::string text;
  for (const Plane plane : order) text += "LRBTNF"[static_cast<std::size_t>(plane)];
  return text;
}

std::size_t position_of(Plane plane, const Order& order) {
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), plane) - order.begin()) + 1;
}

std::size_t restricted(const Order& order, Outcode planes) {
  // Lexicographic rank: by Horner, each plane's number among those that are still to come.
  std::size_t rank = 0, left = static_cast<std::size_t>(std::popcount(planes));
  for (const Plane plane : order) {
    if ((planes & bit(plane)) == 0) continue;
    const Outcode smaller = planes & (bit(plane) - 1);
    rank = rank * left + static_cast<std::size_t>(std::popcount(smaller));
    planes &= ~bit(plane);
    --left;
  }
  return rank;
}

}  // namespace clipscope::experiments
