// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/budget/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace clipscope::experiments::budget {
namespace {

constexpr std::array<std::string_view, 5> kMainClippers = {
    "textbook", "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first",
    "barycentric/distance_matrix"};

// The rows of one scene in one scalar that have figures.
std::vector<Row> rows_with_budget(std::vector<Row> rows, const std::string& scene,
                                  const std::string& scalar) {
  rows = rows_where(std::move(rows), &Row::scene, scene, &Row::scalar, scalar);
  std::erase_if(rows, [](const Row& row) { return !row.px; });
  return rows;
}

// The part with the largest figure among a clipper's rows, of which the total's is the last.
std::string largest_part(const std::vector<Row>& rows, double Spread::*figure) {
  const auto px = [=](const Row& row) { return (*row.px).*figure; };
  const Row& largest = *std::ranges::max_element(rows.begin(), std::prev(rows.end()), {}, px);
  return fmt::format("{} ({} of {} px)", name_of(largest.part), format_number(px(largest)),
                     format_number(px(rows.back())));
}

}  // namespace

Plot plot(const std::vector<Row>& rows, const std::string& scene, const std::string& scalar) {
  Plot plot{
      .name = fmt::format("budget_{}_{}", scene, scalar),
      .title = fmt::format("Where the error comes from on {}, in {}", scene, scalar),
      .caption =
          "Median over triangles of what each step adds to the error, and of the total; a part without a bar adds nothing to most triangles.",
      .x = {.label = "clipper"},
      .y = {.label = "median error [px]"}};
  std::ranges::replace_if(
      plot.name, [](unsigned char c) { return !std::isalnum(c) && c != '_'; }, '_');
  const std::vector<Row> shown = rows_with_budget(rows, scene, scalar);
  for (const std::string_view clipper : kMainClippers) {
    if (find_row(shown, &Row::clipper, clipper)) plot.categories.emplace_back(clipper);
  }
  for (const Part part : kParts) {
    const auto median = [](const Row& row) { return row.px->median; };
    add_bars(plot, name_of(part), shown, median, &Row::clipper, &Row::part, part).muted =
        part == Part::total;
  }
  return plot;
}

std::string finding(const std::vector<Row>& rows) {
  if (rows.empty()) return "no contestant has a budget: only float and double round.";
  const std::string &scene = rows.front().scene, &scalar = rows.front().scalar;
  const std::vector<Row> shown = rows_with_budget(rows, scene, scalar);
  std::vector<std::string> clippers;
  for (const std::string_view clipper : kMainClippers) {
    const std::vector<Row> parts = rows_where(shown, &Row::clipper, clipper);
    if (parts.empty()) continue;
    clippers.push_back(fmt::format("{}: in the median {}, at the most {}", clipper,
                                   largest_part(parts, &Spread::median),
                                   largest_part(parts, &Spread::max)));
  }
  if (clippers.empty()) return fmt::format("no triangle of {} has a budget.", scene);
  return fmt::format("The largest part on {} in {} is, for {}.", scene, scalar,
                     fmt::join(clippers, "; "));
}

}  // namespace clipscope::experiments::budget
