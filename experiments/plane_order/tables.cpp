// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/plane_order/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "experiments/report/replay_text.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kNearFirst = "homogeneous/sutherland_hodgman";
constexpr std::string_view kNearLast = "homogeneous/near_last";

double share(double part, std::int64_t whole) {
  return whole == 0 ? 0 : part / static_cast<double>(whole);
}

double percent(double part, std::int64_t whole) { return 100 * share(part, whole); }
double percent(std::int64_t part, std::int64_t whole) {
  return percent(static_cast<double>(part), whole);
}

// The tallies of some orders, put together.
struct Class {
  OrderTally sum;
  std::int64_t orders = 0, fewest_wrong = INT64_MAX, most_wrong = 0;

  void add(const OrderTally& tally) {
    sum += tally;
    ++orders;
    fewest_wrong = std::min(fewest_wrong, tally.wrong);
    most_wrong = std::max(most_wrong, tally.wrong);
  }
  // Of a count, per order.
  double mean(std::int64_t OrderTally::*count) const { return share(double(sum.*count), orders); }
};

template <class Accepts>
Class class_of(const RoundedOrders& rounded, Accepts&& accepts) {
  Class r;
  for (std::size_t o = 0; o < kOrders; ++o) {
    if (accepts(all_orders()[o])) r.add(rounded.orders[o]);
  }
  return r;
}

Class with_near_at(const RoundedOrders& rounded, std::size_t position) {
  return class_of(rounded, [&](const Order& o) { return position_of(Plane::near, o) == position; });
}

double farthest_moved(const RoundedOrders& rounded) {
  return class_of(rounded, [](const Order&) { return true; }).sum.moved_px;
}

void add_class(const SetResult& result, std::string_view scalar, const RoundedOrders& rounded,
               const std::string& name, const Class& c, Table& table) {
  const std::int64_t n = rounded.triangles;
  table.add_row({result.set.name, std::string(scalar), name, c.orders, n,
                 percent(c.mean(&OrderTally::differs), n),
                 percent(c.mean(&OrderTally::other_outline), n),
                 percent(c.mean(&OrderTally::wrong), n), c.fewest_wrong, c.most_wrong,
                 c.sum.moved_px, c.sum.error_px, share(c.mean(&OrderTally::intersections), n),
                 std::int64_t{c.sum.largest}, c.mean(&OrderTally::overflowed)});
}

std::string near_at(std::size_t position) {
  return fmt::format("near {} of {}", position, kPlanes);
}

void add_worst_in(const SetResult& result, std::string_view scalar, const RoundedOrders& rounded,
                  CellRecord& record) {
  if (rounded.near_last_px == 0) return;
  const std::string input = hex_line(result.set.triangles[rounded.farthest].triangle, 0);
  const std::string options = fmt::format("--space clip --depth {} --scalar {} --hex",
                                          depth_option(result.set.depth), scalar);
  record.worst_inputs.push_back(
      {std::string(kNearLast), std::string(scalar), "moved_px", rounded.near_last_px, input,
       fmt::format("for c in {} {}; do echo '{}' | clipscope clip --clipper $c {}; done",
                   kNearFirst, kNearLast, input, options)});
}

// A plot over the place of the near plane, a curve for each set in float.
Plot by_position(const Table& classes, std::string_view value) {
  Plot plot;
  plot.x = {.label = "place of the near plane in the order", .from = 0.8, .to = 6.2};
  for (const RowView& row : rows_of(classes)) {
    if (row.text("scalar") != "float") continue;
    for (std::size_t position = 1; position <= kPlanes; ++position) {
      if (row.text("orders_class") != near_at(position)) continue;
      if (plot.series.empty() || plot.series.back().name != row.text("set")) {
        plot.series.emplace_back().name = row.text("set");
      }
      plot.series.back().x.push_back(static_cast<double>(position));
      plot.series.back().y.push_back(row.number(value));
    }
  }
  return plot;
}

// "; near last takes 1.02 (1.01 to 1.03) times as long as near first on soup, ...".
std::string time_finding(const Table& times) {
  std::string text;
  for (const RowView& row : rows_of(times)) {
    if (row.text("clipper") != kNearLast || row.text("scalar") != "float") continue;
    text += fmt::format("{} {} ({} to {}) on {}", text.empty() ? " Near last takes" : ",",
                        format_number(row.number("ratio_to_near_first")),
                        format_number(row.number("ratio_low")),
                        format_number(row.number("ratio_high")), row.text("mix"));
  }
  return text.empty() ? text : text + " times as long as near first.";
}

}  // namespace

Table orders_table() {
  Table table("plane_order", "Does anything depend on the order of the six planes? All 720 orders",
              {{"set", "set"},
               {"triangles", "triangles"},
               {"exact_triangles", "exact: triangles"},
               {"exact_mixed_w", "with w <= 0"},
               {"exact_runs", "runs"},
               {"exact_differs", "differs"},
               {"exact_wrong", "wrong"},
               {"float_differs", "float: differs"},
               {"float_differs_percent", "[%]"},
               {"max_px", "moved [px]"},
               {"float_wrong_near_first", "wrong, near first"},
               {"float_wrong_near_last", "near last"},
               {"float_wrong_in_all", "in all orders"},
               {"double_differs", "double: differs"},
               {"double_differs_percent", "[%]"},
               {"double_max_px", "moved [px]"}});
  table.add_note(
      "Triangles in clip space that some plane cuts and none rejects. Exact, differs: orders leave "
      "different sets of vertices in rational arithmetic; wrong: another set than the exact "
      "reference in some order; runs: the orders that are different for the planes that cut.");
  table.add_note(
      "Float and double, differs: other bits in some order than in another; moved: the largest "
      "distance of a vertex from the nearest one of near first, on 3840 x 2160; wrong: triangles, "
      "per order, on average over the 120 orders with near first or last.");
  return table;
}

void add_set(const SetResult& r, Table& table) {
  const auto wrong = [&](std::size_t position) {
    return with_near_at(r.in_float, position).mean(&OrderTally::wrong);
  };
  table.add_row({r.set.name, r.in_float.triangles, r.exact.triangles, r.exact.mixed_w, r.exact.runs,
                 r.exact.differs, r.exact.wrong, r.in_float.differs,
                 percent(r.in_float.differs, r.in_float.triangles), farthest_moved(r.in_float),
                 wrong(1), wrong(kPlanes), r.in_float.wrong_in_all, r.in_double.differs,
                 percent(r.in_double.differs, r.in_double.triangles), farthest_moved(r.in_double)});
}

Table with_all(const Table& by_set) {
  Table table = by_set;
  std::vector<Cell> all = {"all"};
  const std::vector<RowView> rows = rows_of(by_set);
  for (std::size_t c = 1; c < by_set.columns().size(); ++c) {
    const std::string& key = by_set.columns()[c].key;
    const bool largest = key.ends_with("max_px");
    std::int64_t count = 0;
    double number = 0;
    for (const std::vector<Cell>& row : by_set.rows()) {
      if (const auto* n = std::get_if<std::int64_t>(&row[c])) count += *n;
      if (const auto* x = std::get_if<double>(&row[c])) {
        number = largest ? std::max(number, *x) : number + *x;
      }
    }
    const bool is_count = std::holds_alternative<std::int64_t>(by_set.rows().front()[c]);
    if (is_count) {
      all.emplace_back(count);
    } else if (key.ends_with("_percent")) {
      all.emplace_back(percent(std::get<std::int64_t>(all[c - 1]), std::get<std::int64_t>(all[1])));
    } else {
      all.emplace_back(number);
    }
  }
  table.add_row(std::move(all));
  return table;
}

Table classes_table() {
  Table table("plane_order_classes", "By the place of the near plane in the order",
              {{"set", "set"},
               {"scalar", "scalar"},
               {"orders_class", "orders"},
               {"orders", "number"},
               {"triangles", "triangles"},
               {"differs_percent", "other bits [%]"},
               {"other_count_percent", "other count [%]"},
               {"wrong_percent", "wrong [%]"},
               {"fewest_wrong", "fewest wrong"},
               {"most_wrong", "most wrong"},
               {"max_px", "moved [px]"},
               {"max_error_px", "max error [px]"},
               {"intersections_per_triangle", "intersections/tri"},
               {"largest_polygon", "largest polygon"},
               {"overflowed", "overflowed"}});
  table.add_note(
      "Orders by initials: Near, Far, Left, Right, Bottom, Top. Shares are means over the orders "
      "of "
      "a class; fewest and most wrong are triangles, by its best and its worst order. Other bits, "
      "other count of vertices and moved: against NFLRBT. Max error: against exact, where the "
      "vertices are the right ones.");
  return table;
}

void add_classes(const SetResult& result, Table& table) {
  const auto add = [&](std::string_view scalar, const RoundedOrders& rounded) {
    for (std::size_t position = 1; position <= kPlanes; ++position) {
      add_class(result, scalar, rounded, near_at(position), with_near_at(rounded, position), table);
    }
    for (const Order* order : {&near_first_order(), &near_last_order()}) {
      add_class(result, scalar, rounded, order_text(*order),
                class_of(rounded, [&](const Order& o) { return o == *order; }), table);
    }
  };
  add("float", result.in_float);
  add("double", result.in_double);
}

void add_worst(const SetResult& result, CellRecord& record) {
  add_worst_in(result, "float", result.in_float, record);
  add_worst_in(result, "double", result.in_double, record);
}

Table order_times_table() {
  Table table("plane_order_time", "Time per triangle by the order of planes",
              {{"mix", "mix"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"ratio_to_near_first", "x near first"},
               {"ratio_low", "95 % low"},
               {"ratio_high", "high"}});
  table.add_note(
      "x near first: time over that of homogeneous/sutherland_hodgman in the same scalar and the "
      "same round; median and 95 % interval. Not timed (-): the answers break the promise.");
  return table;
}

void add_times(const std::string& mix, std::span<const AnyContestant> contestants,
               std::span<const Timing> timings, Table& table, CellRecord& record) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const std::string clipper(clipper_name(contestants[i])), scalar(scalar_name(contestants[i]));
    std::vector<Cell> cells = {mix, clipper, scalar};
    const Timing* near_first = nullptr;
    for (std::size_t j = 0; j < contestants.size(); ++j) {
      if (clipper_name(contestants[j]) == kNearFirst && scalar_name(contestants[j]) == scalar)
        near_first = &timings[j];
    }
    const std::vector<double>& ns = timings[i].samples_ns;
    if (near_first != nullptr && !ns.empty() && near_first->samples_ns.size() == ns.size()) {
      std::vector<double> ratios(ns.size());
      std::ranges::transform(ns, near_first->samples_ns, ratios.begin(), std::divides{});
      const MedianInterval ratio = median_interval(ratios), time = timings[i].ns;
      cells.insert(cells.end(),
                   {time.median, time.low, time.high, ratio.median, ratio.low, ratio.high});
      record.samples.push_back({fmt::format("{} {} {}", mix, clipper, scalar), "ns/triangle", ns});
    } else {
      cells.resize(table.columns().size());
    }
    table.add_row(std::move(cells));
  }
}

Plot wrong_plot(const Table& classes) {
  Plot plot = by_position(classes, "wrong_percent");
  plot.name = "plane_order";
  plot.title = "Wrong triangles by the place of the near plane, float";
  plot.caption = "Mean over the 120 orders with the near plane at that place.";
  plot.y.label = "wrong triangles [%]";
  return plot;
}

Plot intersections_plot(const Table& classes) {
  Plot plot = by_position(classes, "intersections_per_triangle");
  plot.name = "plane_order_intersections";
  plot.title = "Vertices computed by the place of the near plane, float";
  plot.caption = "Mean over the 120 orders with the near plane at that place.";
  plot.y.label = "intersections per triangle";
  return plot;
}

std::string orders_finding(const Table& orders, const Table& times) {
  const RowView all = rows_of(orders).back();
  return fmt::format(
             "In exact arithmetic the order matters for {} of {} triangles ({} of them with w <= 0 "
             "somewhere), and {} are wrong in any order. In float {} % have other bits in some "
             "order, moved by up to {} px; wrong are {} % by near first and {} % by near last.",
             all.count("exact_differs"), all.count("exact_triangles"), all.count("exact_mixed_w"),
             all.count("exact_wrong"), format_number(all.number("float_differs_percent")),
             format_number(all.number("max_px")),
             format_number(percent(all.number("float_wrong_near_first"), all.count("triangles"))),
             format_number(percent(all.number("float_wrong_near_last"), all.count("triangles")))) +
         time_finding(times);
}

}  // namespace clipscope::experiments
