// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures looked up in the tables of a run, by what their row says.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// A figure that is asked for is not there: the message says which.
struct MissingFigure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Column key and the text (or count, as text) that the row has in it.
using RowKey = std::vector<std::pair<std::string, std::string>>;

class Results {
 public:
  // Where a table comes from, by its name; nothing if there is none. Asked once per name.
  using Source = std::function<std::optional<Table>(const std::string&)>;

  explicit Results(Source source) : source_(std::move(source)) {}

  // The number in a column of the first row that matches the key. Throws MissingFigure if there is no
  // such table, column or row, or the cell is empty.
  double number(const std::string& table, const std::string& column, const RowKey& key) const;
  // The numbers in that column of all rows that match, empty cells left out; at least one, else throws.
  std::vector<double> numbers(const std::string& table, const std::string& column,
                              const RowKey& key) const;
  // The distinct texts in a column, in order of appearance. Throws MissingFigure.
  std::vector<std::string> texts(const std::string& table, const std::string& column,
                                 const RowKey& key = {}) const;
  // The rows that match, each with its cells in the order of `columns`. Throws MissingFigure if there is no
  // such table or column.
  std::vector<std::vector<Cell>> rows(const std::string& table,
                                      const std::vector<std::string>& columns,
                                      const RowKey& key = {}) const;

 private:
  const Table& table(const std::string& name) const;

  Source source_;
  mutable std::map<std::string, std::optional<Table>> tables_;  // that were asked for
};

}  // namespace clipscope::experiments
