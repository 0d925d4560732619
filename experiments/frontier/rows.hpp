// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the frontier's tables, and what is said of them at the end. Each measure of error has
// a frontier of its own:
//
//   max_px      columns on_frontier, dominated_by
//   misrounded  on_rounding_frontier, rounding_dominated_by
//   wrong       on_wrong_frontier, wrong_dominated_by
//
// dominated_by: the fastest of the members that are not slower, not less accurate, and better in
// one of the two (pareto.hpp).
#pragma once

#include "experiments/contestants/columns.hpp"
#include "experiments/frontier/contest.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::frontier {

struct Place {
  Standing standing = Standing::unranked;
  std::optional<std::string> dominated_by;
};

struct Row {
  std::string set;
  Contract contract = Contract::full;
  InputFrom from = InputFrom::memory;
  std::string clipper, scalar;
  std::optional<Timing> timing;
  // Nothing is said about errors where nothing is visible.
  std::optional<double> max_px = {}, q999_px = {}, correctly_rounded_percent = {};
  std::optional<double> misrounded_percent, wrong_percent;
  Place by_px, by_rounding, by_wrong;
  std::int64_t judged_triangles = 0, visible_triangles = 0;

  // Plots and price lists speak of the stage from memory; from view space on there is one place.
  bool is_main() const { return contract == Contract::full || from == InputFrom::memory; }
  std::optional<double> error(Measure measure) const {
    return std::array{max_px, misrounded_percent, wrong_percent}[static_cast<std::size_t>(measure)];
  }
  const Place& place(Measure measure) const {
    return *std::array{&by_px, &by_rounding, &by_wrong}[static_cast<std::size_t>(measure)];
  }

  static constexpr std::string_view kName = "frontier";
  static constexpr std::string_view kTitle =
      "Error and time on the same triangles, and who is beaten in both";
  static constexpr std::array<std::string_view, 4> kNotes = {
      "Every contestant is judged on all triangles of the set and timed on the same, a slow one on a leading share of them (they are shuffled). Errors are over visible triangles, wrong ones included: max px is the largest distance on a screen of 3840 x 2160 between what is drawn and what should be. Rounded right: coordinates that, kept as floats, are the floats nearest to the exact ones. Wrong set: triangles with the wrong vertices.",
      "Frontier (by max px, by misrounded coordinates, by wrong sets): no other contestant is at most as slow (median), at most as far off, and better in one of the two; times differ if their 95 % intervals are apart. Each contract has frontiers of its own. Not timed: the answers break the promise (frontier_refused).",
      "Contract full: view space in, NDC out, judged against the exact frustum. Copy and number: the stage, the same triangles in clip space, clip space out, batch clippers in SIMD; judged against what is exact for these clip coordinates. Rounded right is then about x, y, z, w.",
      "From: the full contract's triangles come again and again, and stay in the second-level cache. The stage's come again and again in other orders, from memory, and in blocks that were read before, though not clipped before, from cache (as in cost_stage)."};
  static constexpr auto columns() {
    using R = Row;
    const auto place = [](std::string_view on, std::string_view head, std::string_view by) {
      return std::tuple(column(on, head, &Place::standing), column(by, "by", &Place::dominated_by));
    };
    return std::tuple(
        column("set", &R::set), column("contract", &R::contract), column("from", &R::from),
        contestant_columns(&R::clipper, &R::scalar), group(&R::timing),
        column("max_px", "max px", &R::max_px), column("q999_px", "99.9 % px", &R::q999_px),
        column("correctly_rounded_percent", "rounded right %", &R::correctly_rounded_percent),
        column("misrounded_percent", "misrounded %", &R::misrounded_percent),
        column("wrong_percent", "wrong set %", &R::wrong_percent),
        group(&R::by_px, place("on_frontier", "frontier", "dominated_by")),
        group(&R::by_rounding,
              place("on_rounding_frontier", "rounding frontier", "rounding_dominated_by")),
        group(&R::by_wrong, place("on_wrong_frontier", "wrong-set frontier", "wrong_dominated_by")),
        column("judged_triangles", "judged", &R::judged_triangles),
        column("visible_triangles", "visible", &R::visible_triangles));
  }
};

struct StepRow {
  std::string set;
  Contract contract = Contract::full;
  InputFrom input_from = InputFrom::memory;
  Measure measure = Measure::max_px;
  std::string from, to;  // contestants
  double time_percent = 0;
  std::string buys;
  double ns_from = 0, ns_to = 0, max_px_from = 0, max_px_to = 0;
  std::optional<double> rounded_from, rounded_to, wrong_from, wrong_to;  // percent

  static constexpr std::string_view kName = "frontier_steps";
  static constexpr std::string_view kTitle =
      "What the next step along the frontier costs, and what it buys";
  static constexpr auto columns() {
    using R = StepRow;
    return std::tuple(
        column("set", &R::set), column("contract", &R::contract),
        column("input_from", "input from", &R::input_from), column("measure", "by", &R::measure),
        column("from", &R::from), column("to", &R::to),
        column("time_percent", "time +%", &R::time_percent), column("buys", &R::buys),
        column("ns_from", "ns from", &R::ns_from), column("ns_to", "ns to", &R::ns_to),
        column("max_px_from", "max px from", &R::max_px_from),
        column("max_px_to", "to", &R::max_px_to),
        column("correctly_rounded_percent_from", "rounded right % from", &R::rounded_from),
        column("correctly_rounded_percent_to", "to", &R::rounded_to),
        column("wrong_percent_from", "wrong set % from", &R::wrong_from),
        column("wrong_percent_to", "to", &R::wrong_to));
  }
};

struct RefusedRow {
  std::string set;
  Contract contract = Contract::full;
  std::string clipper, scalar, reason;

  static constexpr std::string_view kName = "frontier_refused";
  static constexpr std::string_view kTitle =
      "Contestants that are not timed since they break their promise";
  static constexpr auto columns() {
    using R = RefusedRow;
    return std::tuple(column("set", &R::set), column("contract", &R::contract),
                      contestant_columns(&R::clipper, &R::scalar), column("reason", &R::reason));
  }
};

// What settles the signs and quotients of the correctly rounded clipper: the filter in double, or
// expansions, and by which of their steps (barycentric::Stage).
struct RoundingRow {
  std::string set, input;  // input: "view space" or "clip space"
  std::int64_t signs = 0;
  std::optional<double> signs_exact_percent;
  std::int64_t quotients = 0;
  std::optional<double> exact_percent, midpoint_percent, tie_percent;

  static constexpr std::string_view kName = "frontier_rounding";
  static constexpr std::string_view kTitle =
      "What settles the correctly rounded clipper's decisions";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "The rest is settled by the filter in double. By a midpoint: the exact quotient was compared with the middle of two floats; a tie is that middle."};
  static constexpr auto columns() {
    using R = RoundingRow;
    return std::tuple(column("set", &R::set), column("input", &R::input),
                      column("signs", &R::signs),
                      column("signs_exact_percent", "by expansions %", &R::signs_exact_percent),
                      column("quotients", &R::quotients),
                      column("exact_percent", "by expansions %", &R::exact_percent),
                      column("midpoint_percent", "by a midpoint %", &R::midpoint_percent),
                      column("tie_percent", "ties %", &R::tie_percent));
  }
};

// Entries of one contract.
void add_rows(const std::string& set, std::span<const Entry> entries, TableOf<Row>& table);
void add_rows(const std::string& set, std::span<const Entry> entries, TableOf<StepRow>& table);
void add_rows(const std::string& set, std::span<const Entry> entries, TableOf<RefusedRow>& table);
// The triangles in view space, and brought to clip space by the float transform.
void add_rows(const std::string& set, std::span<const SampledView> views,
              TableOf<RoundingRow>& table);

// What correct rounding costs, in the stage if that was timed, on the first set from memory and
// where it is dearest;
// and by which scalars the frontier by max_px leads in the full contract of the first set.
std::string finding(const std::vector<Row>& rows);

// Error over time, one plot per set, contract and measure: the frontier as a line, who is dominated
// in grey.
// Of the stage that from memory.
struct PlottedFrontier {
  std::string set;
  Measure measure = Measure::max_px;
  Contract contract = Contract::full;
};

// An error of 0 is drawn on the bottom line. Named along the frontier are the fastest for each
// error; of the dominated, in the full contract one well-known clipper per space in float and the
// batch clippers, in the stage all. All names are in the table.
Plot frontier_plot(const std::vector<Row>& rows, const PlottedFrontier& of);

}  // namespace clipscope::experiments::frontier
