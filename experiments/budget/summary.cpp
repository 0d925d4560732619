// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/budget/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

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

// Of a clipper with a budget: its rows, the total's last.
using Parts = std::vector<Row>;

const Row& largest_part(const Parts& parts, double Spread::*figure) {
  return *std::ranges::max_element(parts.begin(), std::prev(parts.end()), {},
                                   [=](const Row& row) { return (*row.px).*figure; });
}

std::string spoken_part(Part part) {
  return part == Part::matrix ? "rounding the matrix" : fmt::format("the {}", name_of(part));
}

// "the transform for clip space and view space, and the cut for ..."; one part alone is that of
// every clipper.
std::string by_part(const std::vector<Parts>& clippers, double Spread::*figure) {
  std::vector<std::string> texts;
  for (const Part part : kParts) {
    std::vector<std::string> names;
    for (const Parts& parts : clippers) {
      const bool is_largest = largest_part(parts, figure).part == part;
      if (is_largest) names.push_back(spoken_clipper(parts[0].clipper));
    }
    if (names.size() == clippers.size()) return spoken_part(part) + " for every clipper";
    if (!names.empty()) texts.push_back(fmt::format("{} for {}", spoken_part(part), listed(names)));
  }
  return fmt::format("{}", fmt::join(texts, ", and "));
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
  if (rows.empty()) return "No contestant has a budget: only float and double round.";
  const std::string &scene = rows.front().scene, &scalar = rows.front().scalar;
  const std::vector<Row> shown = rows_with_budget(rows, scene, scalar);
  std::vector<Parts> clippers;
  for (const std::string_view clipper : kMainClippers) {
    Parts parts = rows_where(shown, &Row::clipper, clipper);
    if (!parts.empty()) clippers.push_back(std::move(parts));
  }
  if (clippers.empty()) return fmt::format("Nothing on {} has a budget.", spoken_set(scene));
  const auto clip_space = std::ranges::find_if(clippers, [](const Parts& parts) {
    return parts.front().clipper == "homogeneous/sutherland_hodgman";
  });
  const Parts& example = clip_space == clippers.end() ? clippers.front() : *clip_space;
  const Row& part = largest_part(example, &Spread::median);
  return fmt::format(
      "On {} in {} the largest part of the median error comes from {}: with {} it is {} of {} px. The largest part of the greatest error comes from {}.",
      spoken_set(scene), spoken_scalar(scalar), by_part(clippers, &Spread::median),
      spoken_clipper(part.clipper), format_number(part.px->median),
      format_number(example.back().px->median), by_part(clippers, &Spread::max));
}

}  // namespace clipscope::experiments::budget
