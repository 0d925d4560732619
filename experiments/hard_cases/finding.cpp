// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of the catalogue: who gets the fewest triangles wrong, and what mends it.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/contestants/spoken.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

constexpr std::array<std::string_view, 5> kUsual = {
    "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first",
    "cvv/perspective", "barycentric/distance_matrix"};

const SummaryRow* row_of_triangles(const std::vector<SummaryRow>& summary, std::string_view clipper,
                                   std::string_view scalar) {
  using R = SummaryRow;
  const R* row = find_row(summary, &R::primitive, Primitive::triangle, &R::clipper, clipper,
                          &R::scalar, scalar);
  return row == nullptr || row->cases == 0 ? nullptr : row;
}

// Of the cases that a clipper takes: they are fewer where it needs view space.
double failing_percent(const SummaryRow& row) {
  return 100 * static_cast<double>(row.failures) / static_cast<double>(row.cases);
}

std::string percent_text(const SummaryRow& row) {
  return format_number(failing_percent(row)) + " %";
}

std::string name(const SummaryRow& row) { return spoken_clipper(row.clipper); }

std::vector<std::string> names(std::vector<SummaryRow>::const_iterator from,
                               std::vector<SummaryRow>::const_iterator to) {
  std::vector<std::string> names;
  std::transform(from, to, std::back_inserter(names), name);
  return names;
}

// rows: by share, the smallest first; at least one.
std::string shares_text(const std::vector<SummaryRow>& rows) {
  const SummaryRow &best = rows.front(), &worst = rows.back();
  if (failing_percent(best) == failing_percent(worst)) {
    return fmt::format("In float {} of the hard triangles are wrong with {}.", percent_text(best),
                       listed(names(rows.begin(), rows.end())));
  }
  std::string text = fmt::format(
      "In float {} gets the fewest hard triangles wrong, {} of those that it takes, and {} the most, {}.",
      name(best), percent_text(best), name(worst), percent_text(worst));
  const std::vector<std::string> between = names(rows.begin() + 1, rows.end() - 1);
  if (between.size() == 1) text += fmt::format(" {} lies between them.", capitalised(between[0]));
  if (between.size() > 1) {
    text += fmt::format(" From fewer to more, {} lie between them.", listed(between));
  }
  return text;
}

std::string rounded_text(const std::vector<SummaryRow>& summary) {
  const SummaryRow* row = row_of_triangles(summary, "barycentric/correctly_rounded", "float");
  if (row == nullptr) return "";
  return row->failures == 0 ? " The correctly rounded clipper gets none wrong."
                            : " The correctly rounded clipper gets some wrong, too.";
}

// What is the method's fault, not that of rounding.
std::string exact_text(const std::vector<SummaryRow>& summary) {
  std::vector<SummaryRow> exact, wrong;
  for (const std::string_view clipper : kUsual) {
    if (const auto* row = row_of_triangles(summary, clipper, "exact")) exact.push_back(*row);
  }
  if (exact.empty()) return "";
  std::ranges::copy_if(exact, std::back_inserter(wrong),
                       [](const SummaryRow& row) { return row.failures > 0; });
  if (wrong.empty()) return " In exact arithmetic none of these clippers gets any wrong.";
  return fmt::format(" More digits do not mend {}, wrong in exact arithmetic, too.",
                     listed(names(wrong.begin(), wrong.end())));
}

}  // namespace

std::string finding(const std::vector<SummaryRow>& summary) {
  std::vector<SummaryRow> rows;
  for (const std::string_view clipper : kUsual) {
    if (const auto* row = row_of_triangles(summary, clipper, "float")) rows.push_back(*row);
  }
  std::ranges::stable_sort(rows, {}, failing_percent);
  const std::string shares = rows.empty()
                                 ? "No usual clipper was asked about hard triangles in float."
                                 : shares_text(rows);
  return shares + rounded_text(summary) + exact_text(summary);
}

}  // namespace clipscope::experiments::hard_cases
