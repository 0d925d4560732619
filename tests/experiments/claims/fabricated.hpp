// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results made by hand: tables of a few rows, which can be altered.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/clock/clock.hpp"
#include "experiments/table/results.hpp"

namespace clipscope::experiments {

// Sets members, given as pairs of a member and a value.
template <class Row>
void set_members(Row&) {}
template <class Row, class V, class Value, class... Rest>
void set_members(Row& row, V Row::*member, const Value& value, const Rest&... rest) {
  row.*member = value;
  set_members(row, rest...);
}

// A time that is known exactly.
inline Timing timing(double ns, double speedup = 1) {
  Timing t;
  t.ns = {ns, ns, ns};
  t.speedup = {speedup, speedup, speedup};
  return t;
}

// A row that says no more than that.
template <class Row, class... Members>
Row row_with(const Members&... members) {
  Row row{};
  set_members(row, members...);
  return row;
}

class Fabricated {
 public:
  // All rows of a table, in place of what it had.
  template <class Row>
  void set(const std::vector<Row>& rows) {
    TableOf<Row> table(std::string(Row::kName), "");
    for (const Row& row : rows) table.add(row);
    tables_.insert_or_assign(table.name(), table);
  }
  // Changes the first row that has the values; see find_row.
  template <class Row, class... Conditions>
  void alter(void (*change)(Row&), const Conditions&... conditions) {
    std::vector<Row> rows = rows_of<Row>(tables_.at(std::string(Row::kName)));
    const Row* found = find_row(rows, conditions...);
    if (found == nullptr) throw std::out_of_range("no row to alter");
    change(rows[static_cast<std::size_t>(found - rows.data())]);
    set(rows);
  }
  std::optional<Table> table(const std::string& name) const {
    const auto found = tables_.find(name);
    return found == tables_.end() ? std::nullopt : std::optional(found->second);
  }
  Results results() const {
    return Results([run = *this](const std::string& name) { return run.table(name); });
  }

 private:
  std::map<std::string, Table> tables_;
};

}  // namespace clipscope::experiments
