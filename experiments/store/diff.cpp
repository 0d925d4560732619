// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/errors.hpp"
#include "experiments/store/run_identity.hpp"

namespace clipscope::experiments {
namespace {

using Row = std::vector<Cell>;
constexpr std::size_t kNoInterval = SIZE_MAX;

std::optional<double> number_of(const Cell& cell) {
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*count);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return std::nullopt;
}

bool is_same(const Cell& a, const Cell& b) {
  if (a == b) return true;
  const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  return x != nullptr && y != nullptr && std::isnan(*x) && std::isnan(*y);
}

std::string text_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *count);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  return "-";
}

// By the first `columns` cells.
std::string key_of(const Row& row, const std::vector<std::size_t>& columns) {
  std::string key;
  for (const std::size_t c : columns) key += (key.empty() ? "" : ", ") + text_of(row[c]);
  return key;
}

bool are_unique(const Table& table, const std::vector<std::size_t>& columns) {
  std::set<std::string> keys;
  return std::ranges::all_of(
      table.rows(), [&](const Row& row) { return keys.insert(key_of(row, columns)).second; });
}

// The columns of both tables by their place in each.
struct Shared {
  std::vector<std::size_t> a, b;
};

std::size_t find_column(const Table& table, const std::string& key) {
  const auto& columns = table.columns();
  return static_cast<std::size_t>(std::ranges::find(columns, key, &Column::key) - columns.begin());
}

void find_lone_columns(const Table& table, const Table& other, bool in_a, Difference& difference) {
  for (const Column& column : table.columns()) {
    if (find_column(other, column.key) == other.columns().size()) {
      difference.lone.push_back({table.name(), "", column.key, in_a});
    }
  }
}

Shared shared_columns(const Table& a, const Table& b) {
  Shared shared;
  for (std::size_t c = 0; c < a.columns().size(); ++c) {
    const std::size_t in_b = find_column(b, a.columns()[c].key);
    if (in_b == b.columns().size()) continue;
    shared.a.push_back(c);
    shared.b.push_back(in_b);
  }
  return shared;
}

bool is_text(const Table& table, std::size_t column) {
  return std::ranges::all_of(table.rows(), [&](const Row& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

// How many of the shared columns make up the key.
std::size_t key_length(const Table& a, const Table& b, const Shared& shared) {
  Shared key;
  for (std::size_t n = 0; n < shared.a.size(); ++n) {
    key.a.push_back(shared.a[n]);
    key.b.push_back(shared.b[n]);
    if (are_unique(a, key.a) && are_unique(b, key.b)) return n + 1;
  }
  std::size_t texts = 0;
  while (texts < shared.a.size() && is_text(a, shared.a[texts]) && is_text(b, shared.b[texts])) {
    ++texts;
  }
  return texts;
}

// Rows by key; of rows with the same key, the second is "key (2)", and so on.
std::map<std::string, const Row*> rows_by_key(const Table& table,
                                              const std::vector<std::size_t>& columns,
                                              std::vector<std::string>& order) {
  std::map<std::string, const Row*> rows;
  std::map<std::string, int> times;
  for (const Row& row : table.rows()) {
    std::string key = key_of(row, columns);
    if (const int n = ++times[key]; n > 1) key += fmt::format(" ({})", n);
    rows[key] = &row;
    order.push_back(key);
  }
  return rows;
}

bool is_interval(const std::string& figure, const std::string& low, const std::string& high) {
  if (!low.ends_with("_low") || !high.ends_with("_high")) return false;
  const std::string stem = low.substr(0, low.size() - 4);
  return !stem.empty() && high == stem + "_high" && figure.starts_with(stem);
}

// For each shared column, the place of its interval's low end among the shared columns.
std::vector<std::size_t> intervals_of(const Table& a, const Shared& shared) {
  std::vector<std::size_t> low(shared.a.size(), kNoInterval);
  const auto key = [&](std::size_t n) { return a.columns()[shared.a[n]].key; };
  for (std::size_t n = 0; n + 2 < shared.a.size(); ++n) {
    if (is_interval(key(n), key(n + 1), key(n + 2))) low[n] = n + 1;
  }
  return low;
}

// Nothing if an end is no number.
std::optional<bool> are_apart(const Row& a, const Row& b, const Shared& shared, std::size_t low) {
  const auto a_low = number_of(a[shared.a[low]]), a_high = number_of(a[shared.a[low + 1]]);
  const auto b_low = number_of(b[shared.b[low]]), b_high = number_of(b[shared.b[low + 1]]);
  if (!a_low || !a_high || !b_low || !b_high) return std::nullopt;
  return *a_high < *b_low || *b_high < *a_low;
}

struct RowPair {
  const Row &a, &b;
  std::string key;
};

void compare_rows(const Table& table, const RowPair& rows, const Shared& shared, std::size_t first,
                  Difference& difference) {
  const std::vector<std::size_t> intervals = intervals_of(table, shared);
  for (std::size_t n = first; n < shared.a.size(); ++n) {
    const Cell &a = rows.a[shared.a[n]], &b = rows.b[shared.b[n]];
    ++difference.figures;
    bool moved = !is_same(a, b);
    if (intervals[n] != kNoInterval) {
      moved = are_apart(rows.a, rows.b, shared, intervals[n]).value_or(moved);
    }
    if (moved) {
      difference.moved.push_back({table.name(), rows.key, table.columns()[shared.a[n]].key, a, b});
    }
    if (intervals[n] != kNoInterval) n += 2;
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
    difference.runs.push_back({"--" + name, value.dump(), other.dump()});
  }
}

}  // namespace

void add_difference(const Table& a, const Table& b, Difference& difference) {
  find_lone_columns(a, b, true, difference);
  find_lone_columns(b, a, false, difference);
  const Shared shared = shared_columns(a, b);
  const std::size_t keys = key_length(a, b, shared);
  const auto count = static_cast<std::ptrdiff_t>(keys);
  std::vector<std::string> order_a, order_b;
  const auto rows_a = rows_by_key(a, {shared.a.begin(), shared.a.begin() + count}, order_a);
  const auto rows_b = rows_by_key(b, {shared.b.begin(), shared.b.begin() + count}, order_b);
  for (const std::string& key : order_a) {
    const auto in_b = rows_b.find(key);
    if (in_b == rows_b.end()) {
      difference.lone.push_back({a.name(), key, "", true});
    } else {
      compare_rows(a, {*rows_a.at(key), *in_b->second, key}, shared, keys, difference);
    }
  }
  for (const std::string& key : order_b) {
    if (!rows_a.contains(key)) difference.lone.push_back({a.name(), key, "", false});
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
