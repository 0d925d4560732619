// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats in which a command prints a table: --format.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "experiments/report/table.hpp"

namespace clipscope::experiments {

inline void add_format_option(CLI::App& command, std::string& format) {
  command
      .add_option("--format", format,
                  "How to print: text (at most 100 columns wide), markdown, csv (full precision), "
                  "latex, json [text]")
      ->check(CLI::IsMember({"text", "markdown", "csv", "latex", "json"}))
      ->type_name("NAME");
}

// Pre-condition: the format is one of those above.
inline std::string formatted(const Table& table, const std::string& format) {
  if (format == "markdown") return table.to_markdown();
  if (format == "csv") return table.to_csv();
  if (format == "latex") return table.to_latex();
  if (format == "json") return table.to_json().dump(2) + "\n";
  return table.to_text();
}

}  // namespace clipscope::experiments
