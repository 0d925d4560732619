// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results made by hand: tables of a few rows from CSV text, a number where one can be read, and cells
// that can be altered.
#pragma once

#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/report/results.hpp"

namespace clipscope::experiments {

inline std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ';');) fields.push_back(field);
  return fields;
}

inline Cell cell_of(const std::string& text) {
  if (text == "-") return std::monostate();
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0') return value;
  return text;
}

// The first line of the text has the columns' keys, the others the rows; fields end at semicolons.
inline Table table_from(const std::string& name, const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  std::vector<Column> columns;
  for (const std::string& key : csv_fields(line)) columns.push_back({key, key});
  Table table(name, name, columns);
  while (std::getline(lines, line)) {
    if (line.empty()) continue;
    std::vector<Cell> cells;
    for (const std::string& field : csv_fields(line)) cells.push_back(cell_of(field));
    table.add_row(std::move(cells));
  }
  return table;
}

using TableTexts = std::map<std::string, std::string>;

inline Results results_from(const TableTexts& tables) {
  return Results([tables](const std::string& name) -> std::optional<Table> {
    const auto found = tables.find(name);
    if (found == tables.end()) return std::nullopt;
    return table_from(name, found->second);
  });
}

}  // namespace clipscope::experiments
