// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a run as one HTML page. Its look and its script lie in page/.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

inline constexpr const char* kReportFile = "report.html";
inline constexpr const char* kPageQuestion = "Where should a triangle be clipped?";

enum class PageForm {
  folder,      // shows the pictures in the run's folder, and loads long tables from files beside it
  single_file  // needs no other file
};

struct ReportPage {
  std::string html;
  std::map<std::string, std::string> scripts;  // files that it needs, relative to it
};

// All results of a run: its answers and claims, whatever their place among the experiments, then
// the others with finding, plots, tables, pictures and the command that does them again. Figures
// come from the folder; the page says which can't be read. Where explorer.html lies there, the page
// leads to it, and the worst inputs open in it. Errors: InputError if the store is
// damaged; OutputError if a picture can't be encoded.
ReportPage report_page(const ResultsStore& store, const std::filesystem::path& directory,
                       PageForm form = PageForm::folder);

// Writes directory/report.html and what it needs, each complete or not at all. Errors: as above.
void write_report(const ResultsStore& store, const std::filesystem::path& directory,
                  PageForm form = PageForm::folder);

}  // namespace clipscope::experiments
