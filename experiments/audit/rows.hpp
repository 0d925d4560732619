// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an audit found, as rows of tables. None names the driver, so that `clipscope diff` compares
// those of two drivers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/audit/audit.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

struct QuantityRow {
  Quantity quantity = Quantity::covered;
  std::size_t cases = 0;     // in which legal values of it were measured
  std::uint64_t values = 0;  // measured
  std::optional<double> median_ulp = {}, p99_ulp = {}, max_ulp = {};
  std::string worst_case;
  std::string violations;  // "not_finite 12, outside_hull 3": cases of its findings, by kind

  static constexpr std::string_view kName = "audit_quantities",
                                    kTitle = "What was read back, and how far it is off";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Violations: draw calls that break the specification, by class; one may break it in several ways.",
      "ulp: errors of legal values, from exact arithmetic; the median and the 99th percentile are upper bounds, powers of two."};
  static constexpr auto columns() {
    using R = QuantityRow;
    return std::tuple(
        column("quantity", &R::quantity), column("cases", &R::cases), column("values", &R::values),
        column("violations", "violations", &R::violations, 18),
        column("median_ulp", "median ulp", &R::median_ulp),
        column("p99_ulp", "p99 ulp", &R::p99_ulp), column("max_ulp", "max ulp", &R::max_ulp),
        column("worst_case", "worst case", &R::worst_case, 18));
  }
};

struct FindingRow {
  Quantity quantity = Quantity::covered;
  ViolationKind kind = ViolationKind::missing;
  std::string circumstances;
  std::size_t cases = 0;
  std::uint64_t pixels = 0;
  double excess = 0;  // of the worst case, in multiples of what is allowed
  std::string example;
  std::optional<double> exact = {}, returned = {};  // its worst pixel
  std::string clause, meaning;

  std::string what() const;  // as finding_text has it

  static constexpr std::string_view kName = "audit_findings",
                                    kTitle = "Where the specification is violated";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "One row for each class of violation of a quantity in the same circumstances. Example: the smallest draw call found that shows it; exact and returned: of its worst pixel."};
  static constexpr auto columns() {
    using R = FindingRow;
    return std::tuple(column("quantity", &R::quantity), column("class", &R::kind),
                      column("circumstances", "circumstances", &R::circumstances, 20),
                      column("cases", &R::cases), column("pixels", &R::pixels),
                      column("excess", "times allowed", &R::excess),
                      column("example", "example", &R::example, 30), column("exact", &R::exact),
                      column("returned", &R::returned), column("clause", "clause", &R::clause, 20),
                      column("meaning", "meaning", &R::meaning, 40));
  }
};

// One for each quantity that was read back, in their order.
std::vector<QuantityRow> quantity_rows(const Audit& audit);
// In the order of the findings.
std::vector<FindingRow> finding_rows(const Audit& audit);

}  // namespace clipscope::experiments
