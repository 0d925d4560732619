// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a run, from its results store.
#pragma once

#include <filesystem>

#include "experiments/report/report_page.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

inline constexpr const char* kReportFile = "report.html";

// What the store has, and the figures from the folder. A figure that is not there is left empty.
// Errors: InputError if the store is damaged.
ReportContent content_of(const ResultsStore& store, const std::filesystem::path& directory);

// Writes directory/report.html. Errors: as above; OutputError.
void write_report(const ResultsStore& store, const std::filesystem::path& directory);

}  // namespace clipscope::experiments
