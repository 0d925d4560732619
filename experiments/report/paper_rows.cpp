// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/paper_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "experiments/contestants/spoken.hpp"

namespace clipscope::experiments {
namespace {

using Row = std::vector<Cell>;
using RowPointers = std::vector<const Row*>;

// An object of the entry that may be left out.
PaperEntry part(const PaperEntry& entry, const char* name) {
  return entry.value(name, PaperEntry::object());
}

void keep_where(const Table& table, const PaperEntry& where, RowPointers& rows) {
  for (const auto& [column, text] : where.items()) {
    const std::size_t place = place_of(table, column);
    const auto wanted = text.get<std::string>();
    std::erase_if(rows, [&](const Row* row) { return full_text((*row)[place]) != wanted; });
  }
}

// Keeps the rows that have one of the texts, and puts them in the order of these.
void keep_only(const Table& table, const std::string& column,
               const std::vector<std::string>& wanted, RowPointers& rows) {
  const std::size_t place = place_of(table, column);
  RowPointers kept;
  for (const std::string& text : wanted) {
    const std::size_t before = kept.size();
    std::ranges::copy_if(rows, std::back_inserter(kept),
                         [&](const Row* row) { return full_text((*row)[place]) == text; });
    if (kept.size() > before) continue;
    throw MissingFigure(fmt::format("table {} has no row with {} {}", table.name(), column, text));
  }
  rows = std::move(kept);
}

void put_in_order(const Table& table, const PaperEntry& order, RowPointers& rows) {
  const std::size_t place = place_of(table, order.at("by").get<std::string>());
  const bool is_descending = order.value("descending", false);
  std::erase_if(rows, [&](const Row* row) { return !number_of((*row)[place]); });
  std::ranges::stable_sort(rows, [&](const Row* a, const Row* b) {
    const double x = *number_of((*a)[place]), y = *number_of((*b)[place]);
    return is_descending ? y < x : x < y;
  });
}

RowPointers selected(const Table& table, const PaperEntry& entry) {
  RowPointers rows;
  for (const Row& row : table.rows()) rows.push_back(&row);
  keep_where(table, part(entry, "where"), rows);
  // The first column named is the first to order by, so it comes last.
  std::vector<std::pair<std::string, std::vector<std::string>>> lists;
  const PaperEntry only = part(entry, "only");
  for (const auto& [column, texts] : only.items()) {
    lists.insert(lists.begin(), {column, texts.get<std::vector<std::string>>()});
  }
  for (const auto& [column, texts] : lists) keep_only(table, column, texts, rows);
  if (entry.contains("order")) put_in_order(table, entry.at("order"), rows);
  const auto top = entry.value("top", rows.size());
  if (rows.size() > top) rows.resize(top);
  return rows;
}

}  // namespace

const Table& PaperRows::table(const std::string& name) const {
  const auto known = tables_.find(name);
  if (known != tables_.end()) return known->second;
  if (!store_.has_table(name)) {
    throw MissingFigure(fmt::format("table {} is not among the results", name));
  }
  return tables_.emplace(name, store_.table(name)).first->second;
}

std::vector<std::vector<Cell>> PaperRows::cells(const PaperEntry& entry,
                                                const std::vector<std::string>& columns) const {
  const Table& source = table(entry.at("table").get<std::string>());
  std::vector<std::vector<Cell>> cells;
  for (const Row* row : selected(source, entry)) {
    std::vector<Cell>& chosen = cells.emplace_back();
    for (const std::string& column : columns) chosen.push_back((*row)[place_of(source, column)]);
  }
  return cells;
}

std::vector<double> PaperRows::numbers(const PaperEntry& entry, const std::string& column) const {
  std::vector<double> numbers;
  for (const Row& row : cells(entry, {column})) {
    if (const auto number = number_of(row[0])) numbers.push_back(*number);
  }
  if (!numbers.empty()) return numbers;
  throw MissingFigure(fmt::format("table {} has no figure {} in such a row",
                                  entry.at("table").get<std::string>(), column));
}

std::vector<std::string> PaperRows::texts(const PaperEntry& entry,
                                          const std::string& column) const {
  std::vector<std::string> texts;
  for (const Row& row : cells(entry, {column})) {
    const std::string text = full_text(row[0]);
    if (std::ranges::count(texts, text) == 0) texts.push_back(text);
  }
  const PaperEntry only = part(entry, "only");
  return only.contains(column) ? only.at(column).get<std::vector<std::string>>() : texts;
}

std::string PaperRows::name_of(const std::string& column, const std::string& text) const {
  if (column == "clipper") return spoken_clipper(text);
  if (column == "scalar") return spoken_scalar(text);
  return names_.value(text, text);
}

}  // namespace clipscope::experiments
