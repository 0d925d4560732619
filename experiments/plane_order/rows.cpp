// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/plane_order/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace clipscope::experiments::plane_order {
namespace {

double share(double part, double whole) { return whole == 0 ? 0 : part / whole; }
double percent(double part, double whole) { return 100 * share(part, whole); }

OrdersRow::Rounded rounded_cells(const RoundedOrders& r) {
  OrdersRow::Rounded cells{.differs = r.differs,
                           .differs_percent = percent(r.differs, r.triangles),
                           .wrong_in_all = r.wrong_in_all};
  std::int64_t near_first = 0, near_last = 0;
  for (std::size_t o = 0; o < kOrders; ++o) {
    if (kAllOrders[o].front() == Plane::near) near_first += r.orders[o].wrong;
    if (kAllOrders[o].back() == Plane::near) near_last += r.orders[o].wrong;
    cells.max_px = std::max(cells.max_px, r.orders[o].moved_px);
  }
  cells.wrong_near_first = share(near_first, kOrders / kPlanes);
  cells.wrong_near_last = share(near_last, kOrders / kPlanes);
  return cells;
}

void add(const OrdersRow::Rounded& more, std::int64_t triangles, OrdersRow::Rounded& sum) {
  sum.differs += more.differs;
  sum.differs_percent = percent(sum.differs, triangles);
  sum.max_px = std::max(sum.max_px, more.max_px);
  sum.wrong_near_first += more.wrong_near_first;
  sum.wrong_near_last += more.wrong_near_last;
  sum.wrong_in_all += more.wrong_in_all;
}

// A curve for each set, in float.
std::vector<Series> by_place(const std::vector<ClassRow>& classes, double ClassRow::*value) {
  std::vector<Series> curves;
  for (const std::string& set : distinct(classes, &ClassRow::set)) {
    Series& curve = curves.emplace_back(Series{.name = set});
    for (int place = 1; place <= kPlanes; ++place) {
      const ClassRow* row = find_row(classes, &ClassRow::set, set, &ClassRow::scalar, "float",
                                     &ClassRow::orders_class, near_at(place));
      if (row != nullptr) curve.add(place, row->*value);
    }
  }
  return curves;
}

const Axis kPlace{.label = "place of the near plane in the order", .from = 0.8, .to = 6.2};
constexpr const char* kCaption = "Mean over the 120 orders with the near plane at that place.";

}  // namespace

OrdersRow orders_row(const std::string& set, const ExactOrders& exact,
                     const RoundedOrders& in_float, const RoundedOrders& in_double) {
  return {set, in_float.triangles, exact, rounded_cells(in_float), rounded_cells(in_double)};
}

OrdersRow total(const std::vector<OrdersRow>& rows) {
  OrdersRow all{.set = "all"};
  for (const OrdersRow& row : rows) {
    all.triangles += row.triangles;
    all.exact += row.exact;
    add(row.in_float, all.triangles, all.in_float);
    add(row.in_double, all.triangles, all.in_double);
  }
  return all;
}

std::string near_at(int place) { return fmt::format("near {} of {}", place, kPlanes); }

std::vector<ClassRow> class_rows(const std::string& set, const RoundedOrders& rounded) {
  std::vector<ClassRow> rows;
  // The orders that `belongs` accepts, put together.
  const auto add = [&](const std::string& name, const auto& belongs) {
    ClassRow& row = rows.emplace_back(ClassRow{.set = set,
                                               .scalar = std::string(rounded.scalar),
                                               .orders_class = name,
                                               .triangles = rounded.triangles,
                                               .fewest_wrong = INT64_MAX});
    OrderTally sum;
    for (std::size_t o = 0; o < kOrders; ++o) {
      if (!belongs(kAllOrders[o])) continue;
      sum += rounded.orders[o];
      ++row.orders;
      row.fewest_wrong = std::min(row.fewest_wrong, rounded.orders[o].wrong);
      row.most_wrong = std::max(row.most_wrong, rounded.orders[o].wrong);
    }
    row.differs_percent = percent(share(sum.differs, row.orders), row.triangles);
    row.other_count_percent = percent(share(sum.other_outline, row.orders), row.triangles);
    row.wrong_percent = percent(share(sum.wrong, row.orders), row.triangles);
    row.max_px = sum.moved_px;
    row.max_error_px = sum.error_px;
    row.intersections_per_triangle = share(share(sum.intersections, row.orders), row.triangles);
    row.largest_polygon = sum.largest;
    row.overflowed = share(sum.overflowed, row.orders);
  };
  for (int place = 1; place <= kPlanes; ++place) {
    add(near_at(place),
        [&](const Order& o) { return o[static_cast<std::size_t>(place - 1)] == Plane::near; });
  }
  for (const Order& order : {kNearFirst, kNearLast}) {
    add(order_text(order), [&](const Order& o) { return o == order; });
  }
  return rows;
}

Plot wrong_plot(const std::vector<ClassRow>& classes) {
  return {.name = "plane_order",
          .title = "Wrong triangles by the place of the near plane, float",
          .caption = kCaption,
          .x = kPlace,
          .y = {.label = "wrong triangles [%]"},
          .series = by_place(classes, &ClassRow::wrong_percent)};
}

Plot intersections_plot(const std::vector<ClassRow>& classes) {
  return {.name = "plane_order_intersections",
          .title = "Vertices computed by the place of the near plane, float",
          .caption = kCaption,
          .x = kPlace,
          .y = {.label = "intersections per triangle"},
          .series = by_place(classes, &ClassRow::intersections_per_triangle)};
}

}  // namespace clipscope::experiments::plane_order
