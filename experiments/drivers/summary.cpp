// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/drivers/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::drivers {
namespace {

// What violations do, the gravest first.
struct Fault {
  ViolationKind kind;
  std::string_view text;
};
constexpr std::array kFaults = {
    Fault{ViolationKind::crashed, "a draw call crashes"},
    Fault{ViolationKind::timed_out, "a draw call does not end on"},
    Fault{ViolationKind::primitive_lost, "whole primitives are lost by"},
    Fault{ViolationKind::not_finite, "values that are no numbers come from"},
    Fault{ViolationKind::missing, "parts of primitives are missing in"},
    Fault{ViolationKind::outside_hull, "values beyond those of the vertices come from"},
};
constexpr std::size_t kMostFaults = 2;  // that a reader takes in at once

std::vector<std::string> drivers_with(const std::vector<DriverFindingRow>& findings,
                                      ViolationKind kind) {
  std::vector<std::string> names;
  for (const DriverFindingRow& row : findings) {
    if (row.row.kind == kind && std::ranges::count(names, row.driver) == 0) {
      names.push_back(row.driver);
    }
  }
  return names;
}

// Pre-condition: at least one violates.
std::string violating_text(const std::vector<DriverRow>& drivers, std::ptrdiff_t violating) {
  const std::ptrdiff_t all = std::ranges::ssize(drivers);
  if (all == 1) {
    return fmt::format("The only driver here, {}, violates its specification.",
                       drivers.front().driver);
  }
  if (violating == all) return "All drivers violate their specification somewhere.";
  return fmt::format("Of {} drivers {} {} specification somewhere.", number_word(all),
                     number_word(violating), violating == 1 ? "violates its" : "violate their");
}

}  // namespace

const DriverFindingRow* gravest(const std::vector<DriverFindingRow>& findings) {
  for (const Fault& fault : kFaults) {
    for (const DriverFindingRow& row : findings) {
      if (row.row.kind == fault.kind) return &row;
    }
  }
  return findings.empty() ? nullptr : &findings.front();
}

std::string finding(const std::vector<DriverRow>& drivers,
                    const std::vector<DriverFindingRow>& findings) {
  if (drivers.empty()) return "No driver was there to be asked.";
  const auto violating =
      std::ranges::count_if(drivers, [](const DriverRow& row) { return row.findings > 0; });
  if (violating == 0) return "No driver violates its specification on what was drawn.";
  const std::string text = violating_text(drivers, violating);
  std::vector<std::string> faults;
  for (const auto& [kind, what] : kFaults) {
    const std::vector<std::string> names = drivers_with(findings, kind);
    if (names.empty() || faults.size() == kMostFaults) continue;
    faults.push_back(fmt::format("{} {}", what, listed(names)));
  }
  if (faults.empty()) return text;
  return text + " " + capitalised(fmt::format("{}.", fmt::join(faults, "; ")));
}

}  // namespace clipscope::experiments::drivers
