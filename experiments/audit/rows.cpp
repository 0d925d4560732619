// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "experiments/audit/draw_text.hpp"

namespace clipscope::experiments {
namespace {

std::string violations_text(const Audit& audit, Quantity quantity) {
  std::map<ViolationKind, std::size_t> cases;
  for (const DriverFinding& finding : audit.findings) {
    if (finding.key.quantity == quantity) cases[finding.key.kind] += finding.cases;
  }
  std::vector<std::string> parts;
  for (const auto& [kind, count] : cases) {
    parts.push_back(fmt::format("{} {}", name_of(kind), count));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string FindingRow::what() const {
  return fmt::format("{} {}: {}", name_of(quantity), name_of(kind), circumstances);
}

std::vector<QuantityRow> quantity_rows(const Audit& audit) {
  std::vector<QuantityRow> rows;
  for (std::size_t q = 0; q < kQuantities; ++q) {
    const QuantityErrors& of = audit.errors[q];
    const auto quantity = static_cast<Quantity>(q);
    QuantityRow row{.quantity = quantity,
                    .cases = of.cases,
                    .values = of.errors.count(),
                    .worst_case = of.worst_case,
                    .violations = violations_text(audit, quantity)};
    if (row.values > 0) {
      row.median_ulp = of.errors.quantile(0.5);
      row.p99_ulp = of.errors.quantile(0.99);
      row.max_ulp = of.errors.greatest;
    }
    if (row.values > 0 || !row.violations.empty()) rows.push_back(row);
  }
  return rows;
}

std::vector<FindingRow> finding_rows(const Audit& audit) {
  std::vector<FindingRow> rows;
  for (const DriverFinding& finding : audit.findings) {
    const DrawExample& example = finding.example();
    FindingRow row{.quantity = finding.key.quantity,
                   .kind = finding.key.kind,
                   .circumstances = to_string(finding.key.circumstances),
                   .cases = finding.cases,
                   .pixels = finding.pixels,
                   .excess = finding.worst.violation.size,
                   .example = draw_text(example.call),
                   .clause = section_text(finding.clause),
                   .meaning = std::string(finding.clause.meaning)};
    if (example.violation.pixels > 0) {
      row.exact = example.violation.worst.exact;
      row.returned = example.violation.worst.returned;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace clipscope::experiments
