// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table as people read it on a terminal: what says nothing is left out, a figure and its interval
// share a column, and what is wider than the terminal goes on beneath.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "experiments/table/table.hpp"
#include "experiments/table/terminal.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kGap = 2;

// A column of the text. The key columns are the fewest leading ones with text that tell all rows
// apart, or all of these if they don't.
struct Shown {
  std::string head;
  std::vector<std::string> cells;
  std::size_t wrap = 0;
  bool is_text = false, is_key = false;

  std::size_t width() const {
    std::size_t width = character_count(head);
    for (const std::string& cell : cells) width = std::max(width, character_count(cell));
    return width;
  }
  // Whether every row has the text.
  bool is_all(std::string_view text) const {
    return std::ranges::all_of(cells, [&](const std::string& cell) { return cell == text; });
  }
};
using Columns = std::vector<Shown>;

Shown shown(const Table& table, std::size_t column) {
  Shown result{table.columns()[column].head, {}, table.columns()[column].wrap};
  for (const std::vector<Cell>& row : table.rows()) {
    result.cells.push_back(format_cell(row[column]));
    result.is_text = result.is_text || std::holds_alternative<std::string>(row[column]);
  }
  return result;
}

// A figure with the interval of the two columns behind it: 65.5 [63.8, 69.0].
Shown with_interval(Shown figure, const Shown& low, const Shown& high) {
  figure.head += " [95 %]";
  for (std::size_t i = 0; i < figure.cells.size(); ++i) {
    if (low.cells[i] == "-") continue;
    figure.cells[i] += fmt::format(" [{}, {}]", low.cells[i], high.cells[i]);
  }
  return figure;
}

void mark_keys(Columns& columns) {
  std::vector<std::string> keys(columns.empty() ? 0 : columns[0].cells.size());
  for (Shown& column : columns) {
    if (!column.is_text) return;
    column.is_key = true;
    for (std::size_t r = 0; r < keys.size(); ++r) keys[r] += column.cells[r] + '\n';
    if (std::set(keys.begin(), keys.end()).size() == keys.size()) return;
  }
}

Columns columns_of(const Table& table) {
  const std::vector<Column>& all = table.columns();
  Columns columns;
  for (std::size_t c = 0; c < all.size(); ++c) {
    columns.push_back(shown(table, c));
    if (c + 2 < all.size() && is_interval(all[c].key, all[c + 1].key, all[c + 2].key)) {
      columns.back() =
          with_interval(std::move(columns.back()), shown(table, c + 1), shown(table, c + 2));
      c += 2;
    }
  }
  mark_keys(columns);
  return columns;
}

// Removes the columns that are the same in every row without telling anything: all 0, all empty,
// or a key that does not tell rows apart. Returns a note that names them; empty if there is none.
std::string leave_out_the_silent(Columns& columns) {
  std::vector<std::string> zero, empty, same;
  const auto is_silent = [&](const Shown& column) {
    if (column.is_all("0")) return zero.push_back(column.head), true;
    if (column.is_all("-") || column.is_all("")) return empty.push_back(column.head), true;
    if (!column.is_key || column.cells.size() < 2 || !column.is_all(column.cells[0])) return false;
    return same.push_back(fmt::format("{} ({})", column.head, column.cells[0])), true;
  };
  Columns telling;
  std::ranges::copy_if(columns, std::back_inserter(telling), std::not_fn(is_silent));
  if (columns.empty() || columns[0].cells.empty() || telling.empty()) return "";
  columns = std::move(telling);
  std::vector<std::string> parts;
  const auto add = [&](std::string_view what, const std::vector<std::string>& heads) {
    if (!heads.empty()) parts.push_back(fmt::format("{}: {}", what, fmt::join(heads, ", ")));
  };
  add("the same in every row", same);
  add("0 in every row", zero);
  add("nothing in any row", empty);
  return parts.empty() ? "" : fmt::format("Left out: {}.", fmt::join(parts, "; "));
}

// Long cells go on in further rows, empty elsewhere.
void break_into_lines(Columns& columns) {
  const std::size_t rows = columns.empty() ? 0 : columns[0].cells.size();
  Columns broken = columns;
  for (Shown& column : broken) column.cells.clear();
  for (std::size_t r = 0; r < rows; ++r) {
    const std::size_t first = broken[0].cells.size();
    std::size_t end = first;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      std::ranges::move(wrapped(columns[c].cells[r], columns[c].wrap),
                        std::back_inserter(broken[c].cells));
      end = std::max(end, broken[c].cells.size());
    }
    for (Shown& column : broken) column.cells.resize(end);
  }
  columns = std::move(broken);
}

// Columns in blocks that fit kTextWidth, each beginning with the keys.
std::vector<std::vector<const Shown*>> blocks_of(const Columns& columns) {
  std::vector<const Shown*> keys;
  std::size_t key_width = 0;
  for (const Shown& column : columns) {
    if (!column.is_key) break;
    key_width += column.width() + kGap;
    keys.push_back(&column);
  }
  std::vector<std::vector<const Shown*>> blocks;
  std::size_t used = 0;
  for (std::size_t c = keys.size(); c < columns.size(); ++c) {
    const std::size_t width = columns[c].width() + kGap;
    if (blocks.empty() || used + width > kTextWidth + kGap) {
      blocks.push_back(keys);
      used = key_width;
    }
    blocks.back().push_back(&columns[c]);
    used += width;
  }
  if (blocks.empty()) blocks.push_back(keys);
  return blocks;
}

std::string pad(const std::string& text, std::size_t width, bool left) {
  const std::size_t used = character_count(text);
  const std::string blanks(width > used ? width - used : 0, ' ');
  return left ? text + blanks : blanks + text;
}

std::string text_of(const std::vector<const Shown*>& block) {
  const auto line = [&](const auto& cell_of) {
    std::string result;
    for (const Shown* column : block) {
      result += std::string(result.empty() ? 0 : kGap, ' ') +
                pad(cell_of(*column), column->width(), column->is_text);
    }
    result.erase(result.find_last_not_of(' ') + 1);
    return result + "\n";
  };
  std::string text = line([](const Shown& column) { return column.head; });
  text += line([](const Shown& column) { return std::string(column.width(), '-'); });
  for (std::size_t r = 0; r < block[0]->cells.size(); ++r) {
    text += line([&](const Shown& column) { return column.cells[r]; });
  }
  return text;
}

}  // namespace

std::string indented(const std::string& text) {
  std::string lines;
  for (const std::string& line : wrapped(text, kTextWidth - 2)) lines += "  " + line + "\n";
  return lines;
}

std::string Table::to_text(std::size_t most) const {
  Columns columns = columns_of(*this);
  const std::string left_out = leave_out_the_silent(columns);
  const std::size_t hidden = rows_.size() > most ? rows_.size() - most : 0;
  for (Shown& column : columns) column.cells.resize(rows_.size() - hidden);
  break_into_lines(columns);
  std::string text = title_ + "\n";
  for (const auto& block : blocks_of(columns)) text += "\n" + text_of(block);
  if (hidden > 0) text += fmt::format("... and {} more rows in {}.md\n", hidden, name_);
  if (!left_out.empty()) text += indented(left_out);
  for (const std::string& note : notes_) text += indented(note);
  return text;
}

}  // namespace clipscope::experiments
