// SPDX-License-Identifier: GPL-3.0-or-later
//
// All results of a run as one HTML page that needs no other file: claims, then experiments with finding,
// plots, tables, pictures and the command that does them again. Its look and its script lie in page/.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "experiments/report/table.hpp"

namespace clipscope::experiments {

struct ReportFigure {
  bool plot = false;    // an SVG that goes into the page as it is, else a picture
  std::string type;     // of a picture: "image/png", "image/svg+xml"
  std::string bytes;    // the file; empty: it could not be read, which the page says
  std::string file;     // its name, for people
  std::string title;    // may be empty
  std::string caption;  // what is to be seen; stands for the figure where it can't be seen
};

struct ReportExperiment {
  std::string name, question, command, finding;  // an empty finding is said to be missing
  double seconds = 0;
  bool finished = true;
  std::vector<Table> tables;
  std::vector<Table> more_tables = {};  // shown folded
  std::vector<ReportFigure> figures = {};
};

struct ReportContent {
  std::vector<std::pair<std::string, std::string>>
      run;  // machine, compiler, flags, …: name and value
  std::vector<ReportExperiment> experiments;
};

// The page. The experiment "claims" comes first, whatever its place.
std::string report_page(const ReportContent& content);

// Writes it, complete or not at all. Throws OutputError naming the path and the reason.
void write_report_page(const ReportContent& content, const std::filesystem::path& path);

}  // namespace clipscope::experiments
