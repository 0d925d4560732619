// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables: filled once, written as text for a terminal, Markdown, CSV, LaTeX (booktabs) and JSON.
//
// A cell keeps its value; each writer formats it. CSV and JSON carry full precision, the others the
// digits that a reader needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace clipscope::experiments {

struct Column {
  std::string key;   // for CSV and JSON: lower case, with its unit: "max_px"
  std::string head;  // for people: "max [px]"
  // On a terminal, texts are broken into lines of at most so many characters; 0: they are not.
  std::size_t wrap = 0;
};

// Empty (printed as a dash), a text, a count, or a measured number.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double>;

// A figure that is asked for is not there: the message says which.
struct MissingFigure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Table {
 public:
  // name: stem of the files; title: one line, what is shown and on what.
  Table(std::string name, std::string title, std::vector<Column> columns);

  // Pre-condition: one cell per column.
  void add_row(std::vector<Cell> cells);
  // A line printed beneath the table: machine, seed, meaning of a column.
  void add_note(std::string note);

  const std::string& name() const { return name_; }
  const std::string& title() const { return title_; }
  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }
  const std::vector<std::string>& notes() const { return notes_; }

  // At most 100 columns wide: what does not fit goes into a further block beneath, which repeats
  // the keys, the fewest leading text columns that tell all rows apart. Columns that say nothing
  // are left out and named in a note: 0 or nothing in every row, or a key that is the same in all
  // of several rows. A figure and its interval (is_interval) share a column. Shows the first `most`
  // rows, and says how many more there are.
  std::string to_text(std::size_t most = SIZE_MAX) const;
  std::string to_markdown() const;
  std::string to_csv() const;
  std::string to_latex() const;
  nlohmann::json to_json() const;

  // Writes name.md, name.csv and name.tex into the directory, each complete or not at all. Throws
  // OutputError.
  void write(const std::filesystem::path& directory) const;

 private:
  std::vector<std::vector<std::string>> formatted() const;  // every cell as people read it
  bool is_text(std::size_t column) const;

  std::string name_, title_;
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
  std::vector<std::string> notes_;
};

// The place of a column by its key. Throws MissingFigure if the table has no such column.
std::size_t place_of(const Table& table, std::string_view key);

// Whether columns of these keys, one behind the other, are a figure and the ends of its interval:
// low is S_low, high is S_high, and the figure's key begins with S.
bool is_interval(std::string_view figure, std::string_view low, std::string_view high);

// Three significant digits, plain where that is short, else with a power of ten: 0.125, 13.4,
// 2.1e-07.
std::string format_number(double value);

// As people read it: a dash for an empty cell, numbers as format_number has them.
std::string format_cell(const Cell& cell);

// To the last digit; nothing for an empty cell.
std::string full_text(const Cell& cell);

// A count or a measured number.
std::optional<double> number_of(const Cell& cell);

// The text with every character that LaTeX gives a meaning to escaped. UTF-8 stays as it is.
std::string latex_escape(const std::string& text);

// Three significant digits, powers of ten in mathematics: 0.125, 13.4, $2.1\cdot10^{-7}$.
std::string latex_number(double value);

}  // namespace clipscope::experiments
