// SPDX-License-Identifier: GPL-3.0-or-later
//
// The claims on a page of results: how many got which verdict, and the figures behind each.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "experiments/report/page_source.hpp"

namespace clipscope::experiments {
namespace {

constexpr const char* kEvidence = "claims_evidence";

// The figures of each claim, by its number, as a table of its own.
std::map<std::string, Table> evidence_by_claim(const Table& evidence) {
  const std::size_t claim = place_of(evidence, "claim");
  std::vector<Column> columns = evidence.columns();
  columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(claim));
  std::map<std::string, Table> tables;
  for (std::vector<Cell> row : evidence.rows()) {
    const std::string number = format_cell(row[claim]);
    row.erase(row.begin() + static_cast<std::ptrdiff_t>(claim));
    tables.try_emplace(number, "figures", "", columns).first->second.add_row(std::move(row));
  }
  return tables;
}

}  // namespace

std::string tally_html(const Table& claims) {
  std::map<std::string, int> counts;
  std::vector<std::string> order = {"confirmed", "true only when", "refuted", "not settled",
                                    "undecided"};
  for (const auto& row : claims.rows()) ++counts[format_cell(row[place_of(claims, "verdict")])];
  for (const auto& [verdict, count] : counts) {
    if (std::ranges::find(order, verdict) == order.end()) order.push_back(verdict);
  }
  std::string html;
  for (const std::string& verdict : order) {
    if (counts[verdict] == 0) continue;
    html += fmt::format("<li>{} {}</li>", counts[verdict], verdict_html(verdict));
  }
  return html.empty() ? "" : "<ul class=\"tally\">" + html + "</ul>\n";
}

std::string claims_html(const PageSource& source, const Table& claims) {
  if (!source.store().has_table(kEvidence)) return source.table(claims, kClaims);
  const auto evidence = evidence_by_claim(source.store().table(kEvidence));
  const std::size_t number = place_of(claims, "number"), because = place_of(claims, "because");
  TableSetting setting;
  setting.more = [&](std::size_t row, std::size_t column) -> std::string {
    const auto found = evidence.find(format_cell(claims.rows()[row][number]));
    if (column != because || found == evidence.end()) return "";
    return fmt::format("<details class=\"figures\"><summary>Figures</summary>\n{}</details>",
                       plain_table_html(found->second));
  };
  return source.table(claims, kClaims, setting);
}

}  // namespace clipscope::experiments
