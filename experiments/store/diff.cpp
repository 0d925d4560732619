// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>

#include "experiments/machine/errors.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments {
namespace {

using Row = std::vector<Cell>;

// A column that both tables have, by its place in each.
struct Shared {
  std::size_t a, b;
};
using Place = std::size_t Shared::*;

bool is_same(const Cell& a, const Cell& b) {
  if (a == b) return true;
  const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  return x != nullptr && y != nullptr && std::isnan(*x) && std::isnan(*y);
}

std::string key_of(const Row& row, std::span<const Shared> columns, Place place) {
  std::string key;
  for (const Shared& column : columns) {
    const Cell& cell = row[column.*place];
    key += (key.empty() ? "" : ", ") + (cell == Cell() ? "-" : full_text(cell));
  }
  return key;
}

bool are_unique(const Table& table, std::span<const Shared> columns, Place place) {
  std::set<std::string> keys;
  return std::ranges::all_of(table.rows(), [&](const Row& row) {
    return keys.insert(key_of(row, columns, place)).second;
  });
}

bool is_text(const Table& table, std::size_t column) {
  return std::ranges::all_of(table.rows(), [&](const Row& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

// Adds the columns that one table alone has to the difference.
std::vector<Shared> shared_columns(const Table& a, const Table& b, Difference& difference) {
  std::vector<Shared> shared;
  for (std::size_t c = 0; const Column& column : a.columns()) {
    const auto in_b = std::ranges::find(b.columns(), column.key, &Column::key);
    if (in_b == b.columns().end()) {
      difference.lone.push_back({a.name(), "", column.key, true});
    } else {
      shared.push_back({c, static_cast<std::size_t>(in_b - b.columns().begin())});
    }
    ++c;
  }
  for (const Column& column : b.columns()) {
    if (std::ranges::count(a.columns(), column.key, &Column::key) > 0) continue;
    difference.lone.push_back({b.name(), "", column.key, false});
  }
  return shared;
}

// The leading columns that make up the key.
std::span<const Shared> key_columns(const Table& a, const Table& b,
                                    std::span<const Shared> shared) {
  for (std::size_t n = 1; n <= shared.size(); ++n) {
    const std::span<const Shared> key = shared.first(n);
    if (are_unique(a, key, &Shared::a) && are_unique(b, key, &Shared::b)) return key;
  }
  return {shared.begin(), std::ranges::find_if_not(shared, [&](const Shared& column) {
            return is_text(a, column.a) && is_text(b, column.b);
          })};
}

// In the table's order; of rows with the same key, the second is "key (2)", and so on.
std::vector<std::pair<std::string, const Row*>> rows_by_key(const Table& table,
                                                            std::span<const Shared> columns,
                                                            Place place) {
  std::vector<std::pair<std::string, const Row*>> rows;
  std::map<std::string, int> times;
  for (const Row& row : table.rows()) {
    std::string key = key_of(row, columns, place);
    if (const int n = ++times[key]; n > 1) key += fmt::format(" ({})", n);
    rows.emplace_back(std::move(key), &row);
  }
  return rows;
}

// Whether the first of the columns is a figure whose interval is in the next two.
bool has_interval(const Table& a, std::span<const Shared> columns) {
  if (columns.size() < 3) return false;
  const auto key = [&](std::size_t n) -> const std::string& {
    return a.columns()[columns[n].a].key;
  };
  return is_interval(key(0), key(1), key(2));
}

// Nothing if an end of the interval is no number.
std::optional<bool> are_apart(const Row& a, const Row& b, const Shared& low, const Shared& high) {
  const auto a_low = number_of(a[low.a]), a_high = number_of(a[high.a]);
  const auto b_low = number_of(b[low.b]), b_high = number_of(b[high.b]);
  if (!a_low || !a_high || !b_low || !b_high) return std::nullopt;
  // A strange file may have the ends of an interval exchanged.
  const auto [a_least, a_most] = std::minmax(*a_low, *a_high);
  const auto [b_least, b_most] = std::minmax(*b_low, *b_high);
  return a_most < b_least || b_most < a_least;
}

// name: of the row.
void compare_rows(const Table& table, const std::string& name, const Row& a, const Row& b,
                  std::span<const Shared> figures, Difference& difference) {
  while (!figures.empty()) {
    const Shared& figure = figures.front();
    const bool interval = has_interval(table, figures);
    ++difference.figures;
    bool moved = !is_same(a[figure.a], b[figure.b]);
    if (interval) moved = are_apart(a, b, figures[1], figures[2]).value_or(moved);
    if (moved) {
      difference.moved.push_back(
          {table.name(), name, table.columns()[figure.a].key, a[figure.a], b[figure.b]});
    }
    figures = figures.subspan(interval ? 3 : 1);
  }
}

void compare_runs(const RunInfo& a, const RunInfo& b, Difference& difference) {
  using Json = nlohmann::ordered_json;
  for (const auto& [key, value] : a) {
    const std::string other = value_of(b, key);
    if (value == other || key == "options" || key == "started" || key == "command") continue;
    difference.runs.push_back({key, value, other});
  }
  const Json options_a = Json::parse(value_of(a, "options"), nullptr, false);
  const Json options_b = Json::parse(value_of(b, "options"), nullptr, false);
  if (!options_a.is_object() || !options_b.is_object()) return;
  for (const auto& [name, value] : options_a.items()) {
    const Json other = options_b.value(name, Json());
    if (name == "seed" || value == other) continue;  // the seed is one of the keys above
    difference.runs.push_back({"--" + name, json_text(value), json_text(other)});
  }
}

}  // namespace

void add_difference(const Table& a, const Table& b, Difference& difference) {
  const std::vector<Shared> shared = shared_columns(a, b, difference);
  const std::span<const Shared> key = key_columns(a, b, shared);
  const std::span<const Shared> figures = std::span(shared).subspan(key.size());
  const auto rows_a = rows_by_key(a, key, &Shared::a), rows_b = rows_by_key(b, key, &Shared::b);
  const std::map<std::string, const Row*> in_a(rows_a.begin(), rows_a.end());
  const std::map<std::string, const Row*> in_b(rows_b.begin(), rows_b.end());
  for (const auto& [name, row] : rows_a) {
    const auto other = in_b.find(name);
    if (other == in_b.end()) {
      difference.lone.push_back({a.name(), name, "", true});
    } else {
      compare_rows(a, name, *row, *other->second, figures, difference);
    }
  }
  for (const auto& [name, row] : rows_b) {
    if (!in_a.contains(name)) difference.lone.push_back({a.name(), name, "", false});
  }
}

Difference difference_of(const ResultsStore& a, const ResultsStore& b,
                         const std::optional<std::string>& table) {
  Difference difference;
  compare_runs(a.run_info(), b.run_info(), difference);
  std::vector<std::string> names;
  if (table) {
    if (!a.has_table(*table) && !b.has_table(*table)) a.table(*table);  // says which there are
    names.push_back(*table);
  } else {
    for (const StoredTable& t : a.tables()) names.push_back(t.name);
    for (const StoredTable& t : b.tables()) {
      if (!a.has_table(t.name)) names.push_back(t.name);
    }
  }
  for (const std::string& name : names) {
    const bool in_a = a.has_table(name), in_b = b.has_table(name);
    if (in_a && in_b) {
      add_difference(a.table(name), b.table(name), difference);
    } else {
      difference.lone.push_back({name, "", "", in_a});
    }
  }
  return difference;
}

}  // namespace clipscope::experiments
