// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace clipscope::experiments::cost {
namespace {

constexpr std::array<std::string_view, 5> kMainClippers = {
    "textbook", "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first",
    "barycentric/distance_matrix"};
constexpr std::string_view kClipSpace = "homogeneous/sutherland_hodgman";
constexpr std::array<std::string_view, kGrowing.size()> kGrowingLabels = {
    "triangles", "floats per vertex, position included", "planes that a triangle crosses",
    "threads"};

// The scalar that a plot or finding speaks of.
template <class R>
std::string shown_scalar(const std::vector<R>& rows) {
  const bool has_float = find_row(rows, &R::scalar, "float") != nullptr;
  return has_float || rows.empty() ? "float" : rows.front().scalar;
}

// The fastest of some rows, of any build; null if none was timed.
const StageRow* fastest_row(const std::vector<StageRow>& rows) {
  const StageRow* fastest = nullptr;
  for (const StageRow& row : rows) {
    if (!row.timing) continue;
    if (!fastest || row.timing->ns.median < fastest->timing->ns.median) fastest = &row;
  }
  return fastest;
}

}  // namespace

Plot time_plot(const std::vector<Row>& times) {
  const std::string scalar = shown_scalar(times);
  Plot plot{
      .name = "cost",
      .title = fmt::format("Time by mix of triangles, in {}", scalar),
      .caption =
          "One clipper of each space and the baseline, with 95 % intervals of the median: view space in, NDC polygons with four attributes out.",
      .x = {.label = "mix"},
      .y = {.label = "time [ns per triangle]"},
      .categories = distinct(times, &Row::mix)};
  const auto ns = [](const Row& row) {
    return row.timing ? std::optional(row.timing->ns) : std::nullopt;
  };
  for (const std::string_view clipper : kMainClippers) {
    if (find_row(times, &Row::clipper, clipper) == nullptr) continue;
    add_bars(plot, clipper, times, ns, &Row::mix, &Row::clipper, clipper, &Row::scalar, scalar)
        .muted = clipper == "textbook";
  }
  return plot;
}

Plot split_plot(const std::vector<SplitRow>& split) {
  using R = SplitRow;
  const std::string scalar = shown_scalar(split), mix = split.front().mix;
  Plot plot{
      .name = "cost_split",
      .title = fmt::format("Where the time goes on {}, in {}", mix, scalar),
      .caption =
          "The parts are differences of runs that do one step more each, with 95 % intervals; steps overlap, so that a part may be hidden behind the others.",
      .x = {.label = "clipper"},
      .y = {.label = "time [ns per triangle]"},
      .categories = distinct(split, &R::clipper)};
  for (const char* part : {"transform", "cut", "divide"}) {
    add_bars(plot, part, split, &R::ns, &R::clipper, &R::mix, mix, &R::scalar, scalar, &R::part,
             part);
  }
  return plot;
}

Plot stage_plot(const std::vector<StageRow>& stage, Contract contract, InputFrom from) {
  using R = StageRow;
  const std::string name(name_of(contract));
  const bool is_cached = from == InputFrom::cache;
  const std::vector<R> all = rows_where(stage, &R::contract, name, &R::from, from);
  std::vector<R> rows = rows_where(all, &R::is_shown, true);
  std::erase_if(rows, [](const R& row) { return row.clipper == "textbook"; });
  Plot plot{
      .name = fmt::format("cost_stage_{}{}", name, is_cached ? "_cached" : ""),
      .title =
          fmt::format("Time of the stage by mix of triangles: {}, from {}", name, name_of(from)),
      .caption =
          "Clip-space triangles in, clip-space polygons out; medians with 95 % intervals. Batch clippers in SIMD. Grey: what moving the same bytes takes.",
      .x = {.label = "mix"},
      .y = {.label = "time [ns per triangle]", .logarithmic = true},
      .categories = distinct(rows, &R::mix)};
  if (rows.empty()) return plot;
  for (const std::string& label : distinct(rows, &R::label)) {
    const auto ns = [](const R& row) { return row.timing->ns; };
    add_bars(plot, label, rows, ns, &R::mix, &R::label, label);
  }
  const auto limit = [&](const R& row) {
    const R& fastest = *fastest_row(rows_where(all, &R::mix, row.mix));
    return fastest.timing->ns.median * fastest.timing->limit_percent->median / 100;
  };
  add_bars(plot, "limit of moving bytes", rows, limit, &R::mix).muted = true;
  return plot;
}

Plot growth_plot(const std::vector<GrowthRow>& growth, Growing growing) {
  const bool by_magnitude = growing == Growing::triangles || growing == Growing::attributes;
  const std::string_view label = kGrowingLabels[static_cast<std::size_t>(growing)];
  Plot plot{
      .name = fmt::format("cost_growth_{}", name_of(growing)),
      .title = fmt::format("Time per triangle by {}", name_of(growing)),
      .caption =
          "The stage: clip-space triangles in, clip-space polygons out, batch clippers in SIMD; medians with 95 % intervals.",
      .x = {.label = std::string(label), .logarithmic = by_magnitude},
      .y = {.label = "time [ns per triangle]", .logarithmic = true}};
  for (const GrowthRow& row : rows_where(growth, &GrowthRow::grows, growing)) {
    if (!row.ns) continue;
    const std::string name = fmt::format("{} {}{}", row.clipper, name_of(row.contract),
                                         row.from == InputFrom::cache ? ", from cache" : "");
    auto series = std::ranges::find(plot.series, name, &Series::name);
    if (series == plot.series.end()) {
      series = plot.series.insert(series, {.name = name, .muted = row.clipper == "textbook"});
    }
    const double offset = growing == Growing::attributes ? 4 : 0;
    series->add(static_cast<double>(row.n) + offset, *row.ns);
  }
  return plot;
}

}  // namespace clipscope::experiments::cost
