// SPDX-License-Identifier: GPL-3.0-or-later
//
// A row of a table read back, its cells by the keys of their columns: what summaries, plots and findings
// are made from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// Throws std::logic_error naming table and key if there is no such column or its cell holds something
// else: a mistake in the program.
class RowView {
 public:
  RowView(const Table& table, std::size_t row) : table_(&table), row_(&table.rows()[row]) {}

  const std::string& text(std::string_view key) const { return value<std::string>(key); }
  std::int64_t count(std::string_view key) const { return value<std::int64_t>(key); }
  double number(std::string_view key) const { return value<double>(key); }
  // A number or a count; nothing where the cell is empty or holds a text.
  std::optional<double> find_number(std::string_view key) const {
    const Cell& found = cell(key);
    if (const auto* number = std::get_if<double>(&found)) return *number;
    if (const auto* count = std::get_if<std::int64_t>(&found)) return static_cast<double>(*count);
    return std::nullopt;
  }

 private:
  const Cell& cell(std::string_view key) const {
    for (std::size_t c = 0; c < row_->size(); ++c) {
      if (table_->columns()[c].key == key) return (*row_)[c];
    }
    fail(key);
  }
  template <class T>
  const T& value(std::string_view key) const {
    const T* found = std::get_if<T>(&cell(key));
    if (found == nullptr) fail(key);
    return *found;
  }
  [[noreturn]] void fail(std::string_view key) const {
    throw std::logic_error("table " + table_->name() + ": no such value in column " +
                           std::string(key));
  }

  const Table* table_;
  const std::vector<Cell>* row_;
};

inline std::vector<RowView> rows_of(const Table& table) {
  std::vector<RowView> rows;
  for (std::size_t i = 0; i < table.rows().size(); ++i) rows.emplace_back(table, i);
  return rows;
}

// The texts of a column, each once, in the order of the rows.
inline std::vector<std::string> distinct_texts(const Table& table, std::string_view key) {
  std::vector<std::string> texts;
  for (const RowView& row : rows_of(table)) {
    if (std::find(texts.begin(), texts.end(), row.text(key)) == texts.end()) {
      texts.push_back(row.text(key));
    }
  }
  return texts;
}

}  // namespace clipscope::experiments
