// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of the budget, and what is made from its rows.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>

#include "experiments/budget/budget.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::string_view, 5> kMainClippers = {
    "textbook", "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first",
    "barycentric/distance_matrix"};

struct Key {
  std::string_view scene, clipper, scalar, part;
};

// Nothing where no triangle has a budget.
std::optional<double> find_number(const Table& table, const Key& key, std::string_view column) {
  for (const RowView& row : rows_of(table)) {
    if (row.text("scene") != key.scene || row.text("clipper") != key.clipper ||
        row.text("scalar") != key.scalar || row.text("part") != key.part) {
      continue;
    }
    if (row.count("triangles") == 0) return std::nullopt;
    return row.number(column);
  }
  return std::nullopt;
}

// The part with the largest value in the column, and that value over the total's.
std::optional<std::string> largest_part(const Table& table, Key key, std::string_view column) {
  std::string_view largest;
  double most = -1;
  for (const BudgetPart part : kBudgetParts) {
    if (part == BudgetPart::total) continue;
    key.part = budget_part_name(part);
    const std::optional<double> value = find_number(table, key, column);
    if (!value || *value <= most) continue;
    most = *value;
    largest = key.part;
  }
  if (largest.empty()) return std::nullopt;
  key.part = budget_part_name(BudgetPart::total);
  return fmt::format("{} ({} of {} px)", largest, format_number(most),
                     format_number(find_number(table, key, column).value_or(0)));
}

}  // namespace

Table budget_table() {
  Table table("budget", "Error by the step that it comes from",
              {{"scene", "scene"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"part", "part"},
               {"median_px", "median px"},
               {"max_px", "max px"},
               {"median_ulp", "median ulp"},
               {"max_ulp", "max ulp"},
               {"triangles", "triangles"},
               {"left_out", "left out"}});
  table.add_note(
      "A triangle's way from the exact answer to the clipper's: rounding the matrix, transforming, "
      "cutting, dividing, each in the clipper's own order, with everything after it exact. The "
      "parts sum "
      "to the total by vertex and coordinate; the largest over a triangle's vertices is what "
      "counts "
      "here. px on 3840 x 2160; ulp of the scalar over x, y, z and 1/w. Left out: visible "
      "triangles with "
      "other vertices at some stage, and of CVV clippers those that cross the near plane.");
  return table;
}

void add_budget_rows(const std::string& scene, std::span<const AnyContestant> contestants,
                     std::span<const BudgetTally> tallies, Table& table) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const BudgetTally& tally = tallies[i];
    for (const BudgetPart part : kBudgetParts) {
      const auto& [px, ulp] = tally.parts[static_cast<std::size_t>(part)];
      std::vector<Cell> cells = {scene, std::string(clipper_name(contestants[i])),
                                 std::string(scalar_name(contestants[i])),
                                 std::string(budget_part_name(part))};
      if (tally.triangles == 0) {
        cells.resize(cells.size() + 4);
      } else {
        cells.insert(cells.end(), {px.quantile(0.5), px.max(), ulp.quantile(0.5), ulp.max()});
      }
      cells.emplace_back(tally.triangles);
      cells.emplace_back(tally.left_out);
      table.add_row(std::move(cells));
    }
  }
}

Plot budget_plot(const Table& table, const std::string& scene, const std::string& scalar) {
  std::string name = fmt::format("budget_{}_{}", scene, scalar);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '_'; }, '_');
  Plot plot{
      .name = name,
      .title = fmt::format("Where the error comes from on {}, in {}", scene, scalar),
      .caption =
          "Median over triangles of what each step adds to the error, and of the total; a part "
          "without a bar adds nothing to most triangles.",
      .x = {.label = "clipper"},
      .y = {.label = "median error [px]"},
      .series = {},
      .categories = {}};
  const std::string total(budget_part_name(BudgetPart::total));
  for (const std::string_view clipper : kMainClippers) {
    if (find_number(table, {scene, clipper, scalar, total}, "median_px")) {
      plot.categories.emplace_back(clipper);
    }
  }
  for (const BudgetPart part : kBudgetParts) {
    Series series{.name = std::string(budget_part_name(part)),
                  .x = {},
                  .y = {},
                  .muted = part == BudgetPart::total};
    for (const std::string& clipper : plot.categories) {
      series.y.push_back(find_number(table, {scene, clipper, scalar, series.name}, "median_px")
                             .value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::string budget_finding(const Table& table) {
  if (table.rows().empty()) return "no contestant has a budget: only float and double round.";
  const std::string scene = rows_of(table).front().text("scene");
  const std::string scalar = rows_of(table).front().text("scalar");
  std::vector<std::string> clippers;
  for (const std::string_view clipper : kMainClippers) {
    const Key key{scene, clipper, scalar, ""};
    const auto median = largest_part(table, key, "median_px");
    const auto most = largest_part(table, key, "max_px");
    if (median && most) {
      clippers.push_back(
          fmt::format("{}: in the median {}, at the most {}", clipper, *median, *most));
    }
  }
  if (clippers.empty()) return fmt::format("no triangle of {} has a budget.", scene);
  return fmt::format("The largest part on {} in {} is, for {}.", scene, scalar,
                     fmt::join(clippers, "; "));
}

}  // namespace clipscope::experiments
