// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first screen of a page of results, made of the tables that experiments/answers leaves.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "experiments/report/page_source.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

constexpr const char *kPrices = "answers_prices", *kReaders = "answers_readers",
                     *kStability = "answers_stability", *kEffects = "answers_effects";

// A row's cells by the keys of their columns.
class RowView {
 public:
  RowView(const Table& table, const std::vector<Cell>& row) : table_(table), row_(row) {}

  // For people, as HTML; empty where the cell is.
  std::string html(const char* key) const {
    const Cell& cell = row_[place_of(table_, key)];
    return std::holds_alternative<std::monostate>(cell) ? "" : xml_escaped(format_cell(cell));
  }
  std::string text(const char* key) const { return full_text(row_[place_of(table_, key)]); }

 private:
  const Table& table_;
  const std::vector<Cell>& row_;
};

// Where a sentence's evidence lies: a table of the page, or the section of an experiment.
std::string evidence_html(const PageSource& source, const RowView& row) {
  const std::string table = row.text("table"), experiment = row.text("experiment");
  if (source.store().has_table(table)) {
    return fmt::format(" <a class=\"evidence\" href=\"#table-{0}\">{0}</a>", xml_escaped(table));
  }
  if (!source.parts().contains(experiment)) return "";
  return fmt::format(" <a class=\"evidence\" href=\"#{0}\">{0}</a>", xml_escaped(experiment));
}

// The answer to the page's own question leads, without the question.
std::string sentences_html(const PageSource& source, const Table& answers) {
  std::string lead, others;
  for (const auto& cells : answers.rows()) {
    const RowView row(answers, cells);
    const std::string answer = row.html("answer") + evidence_html(source, row);
    if (row.text("question") == kPageQuestion) {
      lead += fmt::format("<p class=\"lead\">{}</p>\n", answer);
    } else {
      others += fmt::format("<dt>{}</dt><dd>{}</dd>\n", row.html("question"), answer);
    }
  }
  return lead + "<dl class=\"answers\">\n" + others + "</dl>\n";
}

// The table without some of its columns.
Table without(const Table& table, const std::set<std::string>& keys) {
  std::vector<Column> columns;
  std::vector<std::size_t> kept;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    if (keys.contains(table.columns()[c].key)) continue;
    kept.push_back(c);
    columns.push_back(table.columns()[c]);
  }
  Table fewer(table.name(), table.title(), columns);
  for (const auto& row : table.rows()) {
    std::vector<Cell> cells;
    for (const std::size_t c : kept) cells.push_back(row[c]);
    fewer.add_row(std::move(cells));
  }
  for (const std::string& note : table.notes()) fewer.add_note(note);
  return fewer;
}

// The CSV has the clippers' names and the intervals, too, the plot what each step costs over the
// one before.
std::string prices_html(const PageSource& source, const Table& prices) {
  return source.table(without(prices, {"clipper", "ns_low", "ns_high", "over_last_percent"}),
                      kAnswers);
}

std::string line_html(const char* term, const std::string& text) {
  return text.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, text);
}

// What goes wrong otherwise, as a picture that another experiment left.
std::string mishap_html(const PageSource& source, const std::string& file) {
  for (const std::string& experiment : source.parts()) {
    for (const StoredFigure& figure : source.store().figures(experiment)) {
      if (figure.file == file) return source.picture(figure);
    }
  }
  return "";
}

std::string reader_html(const PageSource& source, const RowView& row) {
  const std::string clipper =
      fmt::format("{} <span class=\"name\">{}, {}</span>", row.html("recommended"),
                  row.html("clipper"), row.html("scalar"));
  const std::string over = row.html("over_fastest_percent");
  const std::string time = fmt::format("{} ns per triangle, {}", row.html("ns_per_triangle"),
                                       over == "0" ? "the fastest" : over + " % over the fastest");
  return fmt::format("<article>\n<h4>{}</h4>\n<p class=\"needs\">{}</p>\n<dl>\n",
                     row.html("reader"), row.html("needs")) +
         line_html("take", clipper) + line_html("planes", row.html("order")) +
         line_html("sides", row.html("guard")) + line_html("time", time) +
         line_html("otherwise", row.html("otherwise")) + "</dl>\n" +
         mishap_html(source, row.text("picture")) + "</article>\n";
}

std::string readers_html(const PageSource& source, const Table& readers) {
  std::string cards;
  for (const auto& cells : readers.rows()) cards += reader_html(source, RowView(readers, cells));
  return fmt::format(
      "<h3>{}</h3>\n<div class=\"readers\">\n{}</div>\n<details><summary>The same as a table</summary>\n{}</details>\n",
      xml_escaped(readers.title()), cards, source.table(readers, kAnswers));
}

// How much of a theme's cases a method fails on, as a class of its cell. The first row has the
// numbers of cases.
std::string failure_class(const Table& matrix, std::size_t row, std::size_t column) {
  constexpr double kFew = 0.1;
  const auto failures = number_of(matrix.rows()[row][column]);
  const auto cases = number_of(matrix.rows()[0][column]);
  if (row == 0 || !failures || !cases) return "";
  if (*failures == 0) return "right";
  return *failures <= kFew * *cases ? "few" : "many";
}

std::string stability_html(const PageSource& source, const Table& matrix) {
  TableSetting setting;
  setting.css = "matrix";
  setting.look = [&](std::size_t row, std::size_t column) {
    return failure_class(matrix, row, column);
  };
  return source.table(matrix, kAnswers, setting) +
         "<p class=\"legend\"><span class=\"right\">0</span> right on every case <span class=\"few\">n</span> wrong on up to a tenth <span class=\"many\">n</span> wrong on more</p>\n";
}

// The table in the form that it has on the first screen.
std::string answer_table_html(const PageSource& source, const Table& table) {
  if (table.name() == kPrices) return prices_html(source, table);
  if (table.name() == kReaders) return readers_html(source, table);
  if (table.name() == kStability) return stability_html(source, table);
  return source.table(table, kAnswers);
}

}  // namespace

std::string answers_html(const PageSource& source) {
  const ResultsStore& store = source.store();
  if (!store.has_table(kAnswers)) return "";
  std::string html = "<section id=\"answers\" aria-label=\"Answers\">\n";
  html += sentences_html(source, store.table(kAnswers));
  for (const StoredFigure& figure : store.figures(kAnswers)) {
    html += figure.kind == FigureKind::plot ? source.plot(figure) : source.picture(figure);
  }
  for (const char* name : {kPrices, kReaders, kStability, kEffects}) {
    if (store.has_table(name)) html += answer_table_html(source, store.table(name));
  }
  return html + "</section>\n";
}

}  // namespace clipscope::experiments
