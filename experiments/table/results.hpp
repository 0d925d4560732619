// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures looked up in the tables of a run, by what their rows say. What is not there is thrown as
// MissingFigure, which names the table.
#pragma once

#include <any>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/table/row.hpp"

namespace clipscope::experiments {

class Results {
 public:
  // Where a table comes from, by its name; nothing if there is none. Asked once per name.
  using Source = std::function<std::optional<Table>(const std::string&)>;

  explicit Results(Source source) : source_(std::move(source)) {}

  // All rows of the row's table, at least one.
  template <class Row>
  const std::vector<Row>& rows() const {
    const std::string name(Row::kName);
    std::any& known = rows_[name];
    if (!known.has_value()) {
      const std::optional<Table> table = source_(name);
      if (!table) throw MissingFigure("table " + name + " is not among the results");
      std::vector<Row> rows = rows_of<Row>(*table);
      if (rows.empty()) throw MissingFigure("table " + name + " has no row");
      known = std::move(rows);
    }
    return std::any_cast<const std::vector<Row>&>(known);
  }
  // The first row that has the values, given as pairs of a member and a value.
  template <class Row, class... Conditions>
  const Row& row(const Conditions&... conditions) const {
    const Row* found = find_row(rows<Row>(), conditions...);
    if (found != nullptr) return *found;
    throw MissingFigure("table " + std::string(Row::kName) + " has no row with" +
                        conditions_text<Row>(conditions...));
  }
  // A figure (a member of the rows, or a function of one) in all rows that have the values, empty
  // ones left out; at least one.
  template <class Row, class Figure, class... Conditions>
  std::vector<double> figures(const Figure& figure, const Conditions&... conditions) const {
    std::vector<double> figures;
    for (const Row& row : rows<Row>()) {
      if (!matches(row, conditions...)) continue;
      const auto& value = std::invoke(figure, row);
      if (const auto* there = address_of(value)) figures.push_back(static_cast<double>(*there));
    }
    if (!figures.empty()) return figures;
    throw MissingFigure("table " + std::string(Row::kName) + " has no figure " +
                        std::string(key_of<Row>(figure)) + " for" +
                        conditions_text<Row>(conditions...));
  }

 private:
  Source source_;
  mutable std::map<std::string, std::any> rows_;  // of the tables that were asked for, by name
};

}  // namespace clipscope::experiments
