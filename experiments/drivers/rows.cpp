// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/drivers/rows.hpp"

#include <map>
#include <numeric>

#include "experiments/audit/draw_text.hpp"

namespace clipscope::experiments::drivers {
namespace {

std::size_t sum_of(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                         [](std::size_t sum, const auto& entry) { return sum + entry.second; });
}

}  // namespace

DriverRow driver_row(const Audit& audit) {
  const DriverInfo& info = audit.info;
  return {.driver = audit.driver,
          .api = api_text(info),
          .version = info.version,
          .renderer = info.renderer,
          .subpixel_bits = info.subpixel_bits,
          .cases = audit.cases,
          .violating = audit.violating,
          .findings = audit.findings.size(),
          .apart = sum_of(audit.apart),
          .refused = sum_of(audit.refused),
          .unable = sum_of(audit.unable),
          .pixels = audit.pixels,
          .undecided = audit.undecided,
          .inexact = audit.inexact};
}

std::vector<DriverClassRow> class_rows(const Audit& audit) {
  std::map<ViolationKind, DriverClassRow> by_kind;
  for (const DriverFinding& finding : audit.findings) {
    DriverClassRow& row = by_kind[finding.key.kind];
    row.driver = audit.driver;
    row.kind = finding.key.kind;
    ++row.findings;
    row.cases += finding.cases;
    row.pixels += finding.pixels;
  }
  std::vector<DriverClassRow> rows;
  for (const auto& [kind, row] : by_kind) rows.push_back(row);
  return rows;
}

}  // namespace clipscope::experiments::drivers
