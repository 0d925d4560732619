// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "experiments/machine/files.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

// The value to the last digit, quoted where CSV asks for it (RFC 4180).
std::string csv_cell(const Cell& cell) {
  std::string text = full_text(cell);
  return text.find_first_of(",\"\n") == std::string::npos ? text : double_quoted(text);
}

nlohmann::json json_cell(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return *count;
  if (const auto* number = std::get_if<double>(&cell)) {
    if (std::isfinite(*number)) return *number;
    return fmt::format("{}", *number);
  }
  return nullptr;
}

}  // namespace

std::size_t place_of(const Table& table, std::string_view key) {
  const auto found = std::ranges::find(table.columns(), key, &Column::key);
  if (found == table.columns().end()) {
    throw MissingFigure(fmt::format("table {} has no column {}", table.name(), key));
  }
  return static_cast<std::size_t>(found - table.columns().begin());
}

std::string format_cell(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *count);
  if (const auto* number = std::get_if<double>(&cell)) return format_number(*number);
  return "-";
}

std::string full_text(const Cell& cell) {
  if (std::holds_alternative<std::monostate>(cell)) return "";
  const auto* number = std::get_if<double>(&cell);
  return number != nullptr ? fmt::format("{}", *number) : format_cell(cell);
}

bool is_interval(std::string_view figure, std::string_view low, std::string_view high) {
  constexpr std::string_view kLow = "_low", kHigh = "_high";
  if (!low.ends_with(kLow) || !high.ends_with(kHigh)) return false;
  const std::string_view stem = low.substr(0, low.size() - kLow.size());
  return !stem.empty() && high.substr(0, high.size() - kHigh.size()) == stem &&
         figure.starts_with(stem);
}

std::optional<double> number_of(const Cell& cell) {
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*count);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return std::nullopt;
}

std::string format_number(double value) {
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return fmt::format("{}", value);
  const double size = std::abs(value);
  if (size < 1e-3 || size >= 1e6) return fmt::format("{:.1e}", value);
  if (size >= 100) return fmt::format("{:.0f}", value);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 4);
  return fmt::format("{:.{}f}", value, decimals);
}

std::string latex_escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '\\': escaped += "\\textbackslash{}"; break;
      case '~': escaped += "\\textasciitilde{}"; break;
      case '^': escaped += "\\textasciicircum{}"; break;
      case '<': escaped += "\\textless{}"; break;
      case '>': escaped += "\\textgreater{}"; break;
      default:
        if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
  }
  return escaped;
}

std::string latex_number(double value) {
  std::string text = format_number(value);
  const std::size_t e = text.find('e');
  if (!std::isfinite(value) || e == std::string::npos) {
    return text.starts_with('-') ? fmt::format("${}$", text) : text;
  }
  return fmt::format("${}\\cdot10^{{{}}}$", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

Table::Table(std::string name, std::string title, std::vector<Column> columns)
    : name_(valid_utf8(name)), title_(valid_utf8(title)), columns_(std::move(columns)) {}

void Table::add_row(std::vector<Cell> cells) {
  assert(cells.size() == columns_.size());
  for (Cell& cell : cells) {
    if (auto* text = std::get_if<std::string>(&cell)) *text = valid_utf8(*text);
  }
  rows_.push_back(std::move(cells));
}

void Table::add_note(std::string note) { notes_.push_back(valid_utf8(note)); }

std::vector<std::vector<std::string>> Table::formatted() const {
  std::vector<std::vector<std::string>> text;
  for (const std::vector<Cell>& row : rows_) {
    std::vector<std::string>& cells = text.emplace_back();
    std::transform(row.begin(), row.end(), std::back_inserter(cells), format_cell);
  }
  return text;
}

bool Table::is_text(std::size_t column) const {
  return std::any_of(rows_.begin(), rows_.end(), [&](const std::vector<Cell>& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

std::string Table::to_markdown() const {
  std::string text = fmt::format("### {}\n\n|", title_);
  for (const Column& column : columns_) text += fmt::format(" {} |", column.head);
  text += "\n|";
  for (std::size_t c = 0; c < columns_.size(); ++c) text += is_text(c) ? " --- |" : " ---: |";
  text += "\n";
  for (const auto& row : formatted()) text += fmt::format("| {} |\n", fmt::join(row, " | "));
  for (const std::string& note : notes_) text += "\n" + note + "\n";
  return text;
}

std::string Table::to_csv() const {
  std::vector<std::string> keys;
  for (const Column& column : columns_) keys.push_back(column.key);
  std::string text = fmt::format("{}\n", fmt::join(keys, ","));
  for (const std::vector<Cell>& row : rows_) {
    std::vector<std::string> cells;
    std::transform(row.begin(), row.end(), std::back_inserter(cells), csv_cell);
    text += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return text;
}

std::string Table::to_latex() const {
  std::string text = fmt::format("% {}\n\\begin{{tabular}}{{", title_);
  for (std::size_t c = 0; c < columns_.size(); ++c) text += is_text(c) ? 'l' : 'r';
  text += "}\n\\toprule\n";
  std::vector<std::string> heads;
  for (const Column& column : columns_) heads.push_back(latex_escape(column.head));
  text += fmt::format("{} \\\\\n\\midrule\n", fmt::join(heads, " & "));
  for (std::vector<std::string> row : formatted()) {
    std::transform(row.begin(), row.end(), row.begin(), latex_escape);
    text += fmt::format("{} \\\\\n", fmt::join(row, " & "));
  }
  text += "\\bottomrule\n\\end{tabular}\n";
  for (const std::string& note : notes_) text += "% " + note + "\n";
  return text;
}

nlohmann::json Table::to_json() const {
  nlohmann::json rows = nlohmann::json::array();
  for (const std::vector<Cell>& row : rows_) {
    nlohmann::json object = nlohmann::json::object();
    for (std::size_t c = 0; c < columns_.size(); ++c) object[columns_[c].key] = json_cell(row[c]);
    rows.push_back(std::move(object));
  }
  return {{"name", name_}, {"title", title_}, {"rows", std::move(rows)}, {"notes", notes_}};
}

void Table::write(const std::filesystem::path& directory) const {
  write_file(directory / (name_ + ".md"), to_markdown());
  write_file(directory / (name_ + ".csv"), to_csv());
  write_file(directory / (name_ + ".tex"), to_latex());
}

}  // namespace clipscope::experiments
