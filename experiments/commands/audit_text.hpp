// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `clipscope audit` found, and the ways to say it: for people, as JSON, as JUnit's XML.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/audit/audit.hpp"
#include "experiments/audit/driver_source.hpp"

namespace clipscope::experiments::commands {

struct AuditReport {
  DriverSource source;
  Audit audit;
  // Of each finding its folder, by the findings' numbers; empty if none were asked for.
  std::vector<std::filesystem::path> folders = {};
};

// 0 if nothing violates the specification, 1 if something does, 6 if nothing was judged.
int exit_code(const Audit& audit);

// At most 100 columns wide: the driver, the findings, the errors of legal values, what was scored
// apart, and where to look.
std::string text_of(const AuditReport& report);
// driver, version, cases, findings and what stands behind them; infinite numbers are "inf", "-inf"
// and "nan".
nlohmann::json json_of(const AuditReport& report);
// A test for each finding, and one for each class of violation that there was none of.
std::string junit_of(const AuditReport& report);

}  // namespace clipscope::experiments::commands
