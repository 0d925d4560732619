// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of a run: one HTML page that needs no other file. Its look and its script lie in
// page/.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "experiments/store/results_store.hpp"
#include "experiments/table/table.hpp"

namespace clipscope::experiments {

inline constexpr const char* kReportFile = "report.html";

// All results of a run: claims, whatever their place among the experiments, then the others with
// finding, plots, tables, pictures and the command that does them again. Figures come from the
// folder; the page says which can't be read. Errors: InputError if the store is damaged.
std::string report_page(const ResultsStore& store, const std::filesystem::path& directory);

// Writes directory/report.html, complete or not at all. Errors: as above; OutputError.
void write_report(const ResultsStore& store, const std::filesystem::path& directory);

// The text as character data or as a quoted attribute: & < > " ' escaped, what is not UTF-8
// replaced by U+FFFD, control characters that XML forbids by blanks.
std::string html_escape(std::string_view text);

// Base64 (RFC 4648), padded, in one line.
std::string base64(std::string_view bytes);

// A table with the title, the rows, the notes, and the tools that the script brings to life.
// Numbers are shown as people read them and carry their full value in data-v. The cells of a column
// with the key "verdict" are coloured by what they say; those of "experiment" lead to the part of
// the page with that id, if it is among `parts`.
std::string table_html(const Table& table, const std::set<std::string>& parts = {});

// A verdict on a claim, coloured by what it is.
std::string verdict_html(const std::string& verdict);

}  // namespace clipscope::experiments
