// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace clipscope::experiments {
namespace {

std::string key_text(const RowKey& key) {
  std::string text;
  for (const auto& [column, value] : key) text += fmt::format(" {}={}", column, value);
  return text;
}

std::size_t column_index(const Table& table, std::string_view key) {
  const auto& columns = table.columns();
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.key == key; });
  if (found == columns.end()) {
    throw MissingFigure(fmt::format("table {} has no column {}", table.name(), key));
  }
  return static_cast<std::size_t>(found - columns.begin());
}

std::string text_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *count);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  return "";
}

std::optional<double> number_of(const Cell& cell) {
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*count);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return std::nullopt;
}

// Calls f(row) for each row that matches.
template <class F>
void for_each_row(const Table& table, const RowKey& key, F&& f) {
  std::vector<std::pair<std::size_t, std::string>> wanted;
  for (const auto& [column, value] : key) wanted.emplace_back(column_index(table, column), value);
  for (const std::vector<Cell>& row : table.rows()) {
    const bool matches = std::all_of(wanted.begin(), wanted.end(), [&](const auto& w) {
      return text_of(row[w.first]) == w.second;
    });
    if (matches) f(row);
  }
}

}  // namespace

const Table& Results::table(const std::string& name) const {
  auto found = tables_.find(name);
  if (found == tables_.end()) found = tables_.emplace(name, source_(name)).first;
  if (!found->second) {
    throw MissingFigure(fmt::format("table {} is not among the results", name));
  }
  return *found->second;
}

std::vector<double> Results::numbers(const std::string& table_name, const std::string& column,
                                     const RowKey& key) const {
  const Table& source = table(table_name);
  const std::size_t index = column_index(source, column);
  std::vector<double> result;
  for_each_row(source, key, [&](const std::vector<Cell>& row) {
    if (const auto number = number_of(row[index])) result.push_back(*number);
  });
  if (result.empty()) {
    throw MissingFigure(
        fmt::format("table {} has no figure {} for{}", table_name, column, key_text(key)));
  }
  return result;
}

double Results::number(const std::string& table_name, const std::string& column,
                       const RowKey& key) const {
  return numbers(table_name, column, key).front();
}

std::vector<std::string> Results::texts(const std::string& table_name, const std::string& column,
                                        const RowKey& key) const {
  const Table& source = table(table_name);
  const std::size_t index = column_index(source, column);
  std::vector<std::string> result;
  for_each_row(source, key, [&](const std::vector<Cell>& row) {
    std::string text = text_of(row[index]);
    if (std::find(result.begin(), result.end(), text) == result.end()) {
      result.push_back(std::move(text));
    }
  });
  return result;
}

std::vector<std::vector<Cell>> Results::rows(const std::string& table_name,
                                             const std::vector<std::string>& columns,
                                             const RowKey& key) const {
  const Table& source = table(table_name);
  std::vector<std::size_t> indices;
  for (const std::string& column : columns) indices.push_back(column_index(source, column));
  std::vector<std::vector<Cell>> result;
  for_each_row(source, key, [&](const std::vector<Cell>& row) {
    std::vector<Cell>& cells = result.emplace_back();
    for (const std::size_t index : indices) cells.push_back(row[index]);
  });
  return result;
}

}  // namespace clipscope::experiments
