// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the tables about the order of planes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/columns.hpp"
#include "experiments/plane_order/measure.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::plane_order {

// Over all orders of one set: does anything depend on the order?
struct OrdersRow {
  struct Rounded {
    std::int64_t differs = 0;
    double differs_percent = 0, max_px = 0;
    double wrong_near_first = 0, wrong_near_last = 0;  // triangles per order, on average
    std::int64_t wrong_in_all = 0;
  };
  std::string set;
  std::int64_t triangles = 0;
  ExactOrders exact = {};
  Rounded in_float = {}, in_double = {};

  static constexpr std::string_view kName = "plane_order";
  static constexpr std::string_view kTitle =
      "Does anything depend on the order of the six planes? All 720 orders";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Triangles in clip space that some plane cuts and none rejects. Exact, differs: orders leave different sets of vertices in rational arithmetic; wrong: another set than the exact reference in some order; runs: the orders that are different for the planes that cut.",
      "Float and double, differs: other bits in some order than in another; moved: the largest distance of a vertex from the nearest one of near first, on 3840 x 2160; wrong: triangles, per order, on average over the 120 orders with near first or last."};
  static constexpr auto columns() {
    using R = OrdersRow;
    using E = ExactOrders;
    using F = Rounded;
    return std::tuple(
        column("set", &R::set), column("triangles", &R::triangles),
        group(&R::exact, std::tuple(column("exact_triangles", "exact: triangles", &E::triangles),
                                    column("exact_mixed_w", "with w <= 0", &E::mixed_w),
                                    column("exact_runs", "runs", &E::runs),
                                    column("exact_differs", "differs", &E::differs),
                                    column("exact_wrong", "wrong", &E::wrong))),
        group(
            &R::in_float,
            std::tuple(column("float_differs", "float: differs", &F::differs),
                       column("float_differs_percent", "[%]", &F::differs_percent),
                       column("max_px", "moved [px]", &F::max_px),
                       column("float_wrong_near_first", "wrong, near first", &F::wrong_near_first),
                       column("float_wrong_near_last", "near last", &F::wrong_near_last),
                       column("float_wrong_in_all", "in all orders", &F::wrong_in_all))),
        group(&R::in_double,
              std::tuple(column("double_differs", "double: differs", &F::differs),
                         column("double_differs_percent", "[%]", &F::differs_percent),
                         column("double_max_px", "moved [px]", &F::max_px))));
  }
};

OrdersRow orders_row(const std::string& set, const ExactOrders& exact,
                     const RoundedOrders& in_float, const RoundedOrders& in_double);

// The row of all sets: counts added, shares of these, the largest distance.
OrdersRow total(const std::vector<OrdersRow>& rows);

// Some of the orders: those with the near plane at a place, or one that clippers have.
struct ClassRow {
  std::string set, scalar, orders_class;
  std::int64_t orders = 0, triangles = 0;
  double differs_percent = 0, other_count_percent = 0, wrong_percent = 0;
  std::int64_t fewest_wrong = 0, most_wrong = 0;
  double max_px = 0, max_error_px = 0, intersections_per_triangle = 0;
  int largest_polygon = 0;
  double overflowed = 0;

  static constexpr std::string_view kName = "plane_order_classes";
  static constexpr std::string_view kTitle = "By the place of the near plane in the order";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Orders by initials: Near, Far, Left, Right, Bottom, Top. Shares are means over the orders of a class; fewest and most wrong are triangles, by its best and its worst order. Other bits, other count of vertices and moved: against NFLRBT. Max error: against exact, where the vertices are the right ones."};
  static constexpr auto columns() {
    using R = ClassRow;
    return std::tuple(
        column("set", &R::set), column("scalar", &R::scalar),
        column("orders_class", "orders", &R::orders_class), column("orders", "number", &R::orders),
        column("triangles", &R::triangles),
        column("differs_percent", "other bits [%]", &R::differs_percent),
        column("other_count_percent", "other count [%]", &R::other_count_percent),
        column("wrong_percent", "wrong [%]", &R::wrong_percent),
        column("fewest_wrong", "fewest wrong", &R::fewest_wrong),
        column("most_wrong", "most wrong", &R::most_wrong),
        column("max_px", "moved [px]", &R::max_px),
        column("max_error_px", "max error [px]", &R::max_error_px),
        column("intersections_per_triangle", "intersections/tri", &R::intersections_per_triangle),
        column("largest_polygon", "largest polygon", &R::largest_polygon),
        column("overflowed", &R::overflowed));
  }
};

// "near 2 of 6".
std::string near_at(int place);

// One row for each place of the near plane, then those of near first and near last.
std::vector<ClassRow> class_rows(const std::string& set, const RoundedOrders& rounded);

// A clipper's time, and over that of near first in the same scalar; empty if either was not timed.
struct TimeRow {
  std::string mix, clipper, scalar;
  std::optional<MedianInterval> ns = {}, ratio = {};

  static constexpr std::string_view kName = "plane_order_time";
  static constexpr std::string_view kTitle = "Time per triangle by the order of planes";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "x near first: time over that of homogeneous/sutherland_hodgman in the same scalar and the same round; median and 95 % interval. Not timed (-): the answers break the promise."};
  static constexpr auto columns() {
    using R = TimeRow;
    return std::tuple(column("mix", &R::mix), contestant_columns(&R::clipper, &R::scalar),
                      interval("ns_per_triangle", "ns", "ns/tri", &R::ns),
                      interval("ratio_to_near_first", "ratio", "x near first", &R::ratio));
  }
};

// What is said of the order of planes at the end, from the rows of its tables alone.

// Curves over the place of the near plane, in float: wrong triangles, and vertices computed.
Plot wrong_plot(const std::vector<ClassRow>& classes);
Plot intersections_plot(const std::vector<ClassRow>& classes);

// The answer to the experiment's question. all: the row of all sets.
std::string finding(const OrdersRow& all, const std::vector<TimeRow>& times);

}  // namespace clipscope::experiments::plane_order
