// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the audit of drivers: what each is, how far off it is, where it violates its
// specification.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/audit/rows.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::drivers {

struct DriverRow {
  std::string driver, api, version, renderer;
  int subpixel_bits = 0;
  std::size_t cases = 0, violating = 0, findings = 0;
  std::size_t apart = 0, refused = 0, unable = 0;
  std::uint64_t pixels = 0, undecided = 0, inexact = 0;

  static constexpr std::string_view kName = "drivers",
                                    kTitle = "Drivers: what each drew, and how much is right";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Cases: draw calls. Violating: break the specification. Ways: of doing that, see drivers_findings. Apart: beyond what the specification guarantees, so they accuse nobody. Unable: draw calls left out, since the driver says that it can't. Undecided: pixels within the sub-pixel margin of an edge. Inexact: pixels covered otherwise than the sub-pixel bits say, within what the specification leaves open."};
  static constexpr auto columns() {
    using R = DriverRow;
    return std::tuple(column("driver", &R::driver), column("cases", &R::cases),
                      column("violating", &R::violating), column("findings", "ways", &R::findings),
                      column("pixels", &R::pixels), column("undecided", &R::undecided),
                      column("inexact", &R::inexact), column("apart", &R::apart),
                      column("refused", &R::refused), column("unable", &R::unable),
                      column("subpixel_bits", "sub-pixel bits", &R::subpixel_bits),
                      column("api", &R::api), column("version", &R::version),
                      column("renderer", "renderer", &R::renderer, 30));
  }
};
DriverRow driver_row(const Audit& audit);

struct DriverClassRow {
  std::string driver;
  ViolationKind kind = ViolationKind::missing;
  std::size_t findings = 0, cases = 0;
  std::uint64_t pixels = 0;

  static constexpr std::string_view kName = "drivers_classes",
                                    kTitle = "Violations by driver and class";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Ways: findings of that class. Cases: draw calls, counted once for each finding that they show. Classes that a driver has no violation of are left out."};
  static constexpr auto columns() {
    using R = DriverClassRow;
    return std::tuple(column("driver", &R::driver), column("class", &R::kind),
                      column("findings", "ways", &R::findings), column("cases", &R::cases),
                      column("pixels", &R::pixels));
  }
};
// By class, in the order of ViolationKind.
std::vector<DriverClassRow> class_rows(const Audit& audit);

struct DriverQuantityRow {
  std::string driver;
  QuantityRow row;

  static constexpr std::string_view kName = "drivers_quantities",
                                    kTitle = "What was read back, by driver and quantity";
  static constexpr auto kNotes = QuantityRow::kNotes;
  static constexpr auto columns() {
    using R = DriverQuantityRow;
    return std::tuple(column("driver", &R::driver), group(&R::row));
  }
};

struct DriverFindingRow {
  std::string driver;
  FindingRow row;

  static constexpr std::string_view kName = "drivers_findings",
                                    kTitle = "Where drivers violate their specification";
  static constexpr auto kNotes = FindingRow::kNotes;
  static constexpr auto columns() {
    using R = DriverFindingRow;
    return std::tuple(column("driver", &R::driver), group(&R::row));
  }
};

// The gravest finding, of the first driver with it; null if there is none.
const DriverFindingRow* gravest(const std::vector<DriverFindingRow>& findings);

// Who violates, and how in the gravest of ways. Of no driver it says so.
std::string finding(const std::vector<DriverRow>& drivers,
                    const std::vector<DriverFindingRow>& findings);

}  // namespace clipscope::experiments::drivers
