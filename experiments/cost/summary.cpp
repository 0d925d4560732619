// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plots and the finding, from the rows of the tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "experiments/cost/tables.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::string_view, 5> kMainClippers = {
    "textbook", "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first",
    "barycentric/distance_matrix"};
constexpr std::string_view kClipSpace = "homogeneous/sutherland_hodgman";

// The scalar that a plot shows.
std::string plotted_scalar(const Table& table) {
  const std::vector<std::string> scalars = distinct_texts(table, "scalar");
  const bool has_float = std::find(scalars.begin(), scalars.end(), "float") != scalars.end();
  return has_float || scalars.empty() ? "float" : scalars.front();
}

using Conditions = std::vector<std::pair<std::string_view, std::string_view>>;

// Of the first row that meets all conditions; nothing if there is none or its cell is empty.
std::optional<double> find_number(const Table& table, const Conditions& conditions,
                                  std::string_view key) {
  for (const RowView& row : rows_of(table)) {
    const bool meets = std::all_of(conditions.begin(), conditions.end(),
                                   [&](const auto& c) { return row.text(c.first) == c.second; });
    if (meets) return row.find_number(key);
  }
  return std::nullopt;
}

void add_bar(Series& series, const Table& table, const Conditions& conditions) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  series.y.push_back(find_number(table, conditions, "ns_per_triangle").value_or(kNone));
  series.low.push_back(find_number(table, conditions, "ns_low").value_or(kNone));
  series.high.push_back(find_number(table, conditions, "ns_high").value_or(kNone));
}

// The sum of a clipper's operations but comparisons.
std::optional<double> arithmetic(const Table& operations, const std::string& mix,
                                 std::string_view clipper) {
  double sum = 0;
  for (const char* kind : {"additions", "multiplications", "divisions"}) {
    const auto count = find_number(operations, {{"mix", mix}, {"clipper", clipper}}, kind);
    if (!count) return std::nullopt;
    sum += *count;
  }
  return sum;
}

std::optional<double> ratio(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b || *b == 0) return std::nullopt;
  return *a / *b;
}

// "view/sutherland_hodgman takes 1.5 times the time, 1.2 times the operations and 1.0 times the divisions"
std::string against_clip_space(std::string_view clipper, const std::string& mix,
                               const std::string& scalar, const Table& times,
                               const Table& operations) {
  const auto time = [&](std::string_view c) {
    return find_number(times, {{"mix", mix}, {"clipper", c}, {"scalar", scalar}},
                       "ns_per_triangle");
  };
  const auto divisions = [&](std::string_view c) {
    return find_number(operations, {{"mix", mix}, {"clipper", c}}, "divisions");
  };
  const auto all = [&](std::string_view c) { return arithmetic(operations, mix, c); };
  std::vector<std::string> parts;
  const auto add = [&](const auto& of, std::string_view what) {
    if (const auto times_as = ratio(of(clipper), of(kClipSpace))) {
      parts.push_back(fmt::format("{:.2f} times the {}", *times_as, what));
    }
  };
  add(time, "time");
  add(all, "arithmetic");
  add(divisions, "divisions");
  if (parts.empty()) return "";
  return fmt::format("{} takes {}", clipper, fmt::join(parts, ", "));
}

}  // namespace

Plot cost_plot(const Table& times) {
  const std::string scalar = plotted_scalar(times);
  Plot plot{.name = "cost",
            .title = fmt::format("Time by mix of triangles, in {}", scalar),
            .caption =
                "One clipper of each space and the baseline, with 95 % intervals of the median: "
                "view space in, NDC polygons with four attributes out.",
            .x = {.label = "mix"},
            .y = {.label = "time [ns per triangle]"},
            .series = {},
            .categories = distinct_texts(times, "mix")};
  const std::vector<std::string> clippers = distinct_texts(times, "clipper");
  for (const std::string_view clipper : kMainClippers) {
    if (std::find(clippers.begin(), clippers.end(), clipper) == clippers.end()) continue;
    Series series{.name = std::string(clipper), .x = {}, .y = {}, .muted = clipper == "textbook"};
    for (const std::string& mix : plot.categories) {
      add_bar(series, times, {{"mix", mix}, {"clipper", clipper}, {"scalar", scalar}});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

Plot split_plot(const Table& split) {
  const std::string scalar = plotted_scalar(split);
  const std::string mix = rows_of(split).front().text("mix");
  Plot plot{.name = "cost_split",
            .title = fmt::format("Where the time goes on {}, in {}", mix, scalar),
            .caption =
                "The parts are differences of runs that do one step more each, with 95 % "
                "intervals; steps overlap, so that a part may be hidden behind the others.",
            .x = {.label = "clipper"},
            .y = {.label = "time [ns per triangle]"},
            .series = {},
            .categories = distinct_texts(split, "clipper")};
  for (const char* part : {"transform", "cut", "divide"}) {
    Series series{.name = part, .x = {}, .y = {}};
    for (const std::string& clipper : plot.categories) {
      add_bar(series, split,
              {{"mix", mix}, {"clipper", clipper}, {"scalar", scalar}, {"part", part}});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::string cost_finding(const Table& times, const Table& operations) {
  if (times.rows().empty()) return "nothing was timed";
  const std::string mix = rows_of(times).front().text("mix");
  const std::string scalar = plotted_scalar(times);
  std::vector<std::string> parts;
  for (const char* clipper : {"view/sutherland_hodgman", "cvv/near_first", "cvv/perspective"}) {
    const std::string part = against_clip_space(clipper, mix, scalar, times, operations);
    if (!part.empty()) parts.push_back(part);
  }
  if (parts.empty()) return fmt::format("{} was not compared on {}", kClipSpace, mix);
  return fmt::format("Against {} on {} in {}: {}.", kClipSpace, mix, scalar,
                     fmt::join(parts, "; "));
}

}  // namespace clipscope::experiments
