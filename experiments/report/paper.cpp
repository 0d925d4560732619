// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/paper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;  // columns stay in the order given

Json read_contents(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: can't be read", path.string()));
  try {
    return Json::parse(file);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

// The texts that an entry's rows have, by their columns.
Json row_key(const Json& entry) { return entry.value("where", Json::object()); }

// The tables of a run, by the names and keys that the contents have for them; each is read once.
class RunTables {
 public:
  explicit RunTables(const ResultsStore& store) : store_(store) {}

  // The rows that have the key's texts, each with its cells in the order of `columns`. Errors:
  // MissingFigure, where there is no such table or column.
  std::vector<std::vector<Cell>> rows(const std::string& name,
                                      const std::vector<std::string>& columns,
                                      const Json& key = Json::object()) const {
    const Table& source = table(name);
    std::vector<std::vector<Cell>> rows;
    for (const std::vector<Cell>& row : source.rows()) {
      bool matches = true;
      for (const auto& [column, text] : key.items()) {
        matches = matches && full_text(row[place_of(source, column)]) == text.get<std::string>();
      }
      if (!matches) continue;
      std::vector<Cell>& cells = rows.emplace_back();
      for (const std::string& column : columns) cells.push_back(row[place_of(source, column)]);
    }
    return rows;
  }
  // The numbers and counts in a column of these rows.
  std::vector<double> numbers(const std::string& name, const std::string& column,
                              const Json& key) const {
    std::vector<double> numbers;
    for (const std::vector<Cell>& row : rows(name, {column}, key)) {
      if (const auto number = number_of(row[0])) numbers.push_back(*number);
    }
    if (!numbers.empty()) return numbers;
    throw MissingFigure(fmt::format("table {} has no figure {} in such a row", name, column));
  }
  // The distinct texts in a column of these rows, in order of appearance.
  std::vector<std::string> texts(const std::string& name, const std::string& column,
                                 const Json& key) const {
    std::vector<std::string> texts;
    for (const std::vector<Cell>& row : rows(name, {column}, key)) {
      const std::string text = full_text(row[0]);
      if (std::ranges::count(texts, text) == 0) texts.push_back(text);
    }
    return texts;
  }

 private:
  const Table& table(const std::string& name) const {
    const auto known = tables_.find(name);
    if (known != tables_.end()) return known->second;
    if (!store_.has_table(name)) {
      throw MissingFigure(fmt::format("table {} is not among the results", name));
    }
    return tables_.emplace(name, store_.table(name)).first->second;
  }

  const ResultsStore& store_;
  mutable std::map<std::string, Table> tables_;
};

double taken(const std::vector<double>& numbers, const std::string& how) {
  if (how == "first") return numbers.front();
  if (how == "min") return *std::min_element(numbers.begin(), numbers.end());
  if (how == "max") return *std::max_element(numbers.begin(), numbers.end());
  if (how == "sum") return std::accumulate(numbers.begin(), numbers.end(), 0.0);
  if (how == "count") return static_cast<double>(numbers.size());
  throw InputError(fmt::format("\"take\" is {}; expected first, min, max, sum or count", how));
}

std::string value_text(const RunTables& run, const Json& entry) {
  const auto table = entry.at("table").get<std::string>();
  const auto numbers = run.numbers(table, entry.at("column").get<std::string>(), row_key(entry));
  const double value = taken(numbers, entry.value("take", "first"));
  const std::string format = entry.value("format", "");
  if (format.empty()) return latex_number(value);
  return fmt::format(fmt::runtime("{:" + format + "}"), value);
}

// A macro that takes a key: \name{key}.
class KeyedMacro {
 public:
  explicit KeyedMacro(std::string name) : name_(std::move(name)) {
    text_ = fmt::format("\\newcommand{{\\{0}}}[1]{{\\csname {0}-#1\\endcsname}}\n", name_);
  }
  void define(const std::string& key, const std::string& value) {
    text_ += fmt::format("\\expandafter\\def\\csname {}-{}\\endcsname{{{}}}\n", name_, key, value);
  }
  const std::string& text() const { return text_; }

 private:
  std::string name_, text_;
};

std::string run_macros(const ResultsStore& store) {
  KeyedMacro run("run"), question("question"), finding("finding"), command("command");
  double seconds = 0;
  for (const auto& [key, value] : store.run_info()) run.define(key, latex_escape(value));
  for (const StoredExperiment& e : store.experiments()) {
    question.define(e.name, latex_escape(e.question));
    finding.define(e.name, latex_escape(e.finding));
    command.define(e.name, latex_escape(e.command));
    seconds += e.seconds;
  }
  run.define("minutes", fmt::format("{:.0f}", std::ceil(seconds / 60)));
  return run.text() + question.text() + finding.text() + command.text();
}

std::string claim_macros(const RunTables& run) {
  KeyedMacro verdict("claimverdict"), because("claimbecause");
  std::map<std::string, int> counts;
  for (const auto& row : run.rows("claims", {"number", "verdict", "because"})) {
    const std::string number = format_cell(row[0]), text = format_cell(row[1]);
    verdict.define(number, latex_escape(text));
    because.define(number, latex_escape(format_cell(row[2])));
    ++counts[text];
  }
  KeyedMacro count("claimcount");
  for (const char* text : {"confirmed", "true only when", "refuted", "undecided"}) {
    count.define(text, fmt::format("{}", counts[text]));
  }
  return verdict.text() + because.text() + count.text();
}

struct LatexTable {
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;
  std::string align;
  bool is_long = false;

  std::string text() const {
    const char* environment = is_long ? "longtable" : "tabular";
    std::string t = fmt::format("\\begin{{{}}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n", environment,
                                align, fmt::join(heads, " & "));
    if (is_long) t += "\\endhead\n";
    for (const auto& row : rows) t += fmt::format("{} \\\\\n", fmt::join(row, " & "));
    return t + fmt::format("\\bottomrule\n\\end{{{}}}\n", environment);
  }
};

std::string latex_cell(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return latex_number(*number);
  if (std::holds_alternative<std::monostate>(cell)) return "--";
  return latex_escape(format_cell(cell));
}

LatexTable plain_table(const RunTables& run, const Json& entry) {
  LatexTable table;
  std::vector<std::string> columns;
  for (const auto& [key, head] : entry.at("columns").items()) {
    columns.push_back(key);
    table.heads.push_back(head.get<std::string>());
  }
  const auto rows = run.rows(entry.at("table").get<std::string>(), columns, row_key(entry));
  for (const auto& row : rows) {
    auto& cells = table.rows.emplace_back();
    std::transform(row.begin(), row.end(), std::back_inserter(cells), latex_cell);
  }
  // Left for columns that hold a text, right for numbers.
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto is_text = [c](const auto& row) {
      return std::holds_alternative<std::string>(row[c]);
    };
    table.align += std::ranges::any_of(rows, is_text) ? 'l' : 'r';
  }
  return table;
}

LatexTable pivot_table(const RunTables& run, const Json& entry) {
  const Json& pivot = entry.at("pivot");
  const auto name = entry.at("table").get<std::string>();
  const auto row_column = pivot.at("rows").get<std::string>();
  const auto column_column = pivot.at("columns").get<std::string>();
  const auto value_column = pivot.at("value").get<std::string>();
  const std::vector<std::string> across = run.texts(name, column_column, row_key(entry));
  LatexTable table{{pivot.value("head", "")}, {}, "l" + std::string(across.size(), 'r')};
  for (const std::string& text : across) table.heads.push_back(latex_escape(text));
  for (const std::string& text : run.texts(name, row_column, row_key(entry))) {
    auto& cells = table.rows.emplace_back(1, latex_escape(text));
    for (const std::string& other : across) {
      Json key = row_key(entry);
      key[row_column] = text;
      key[column_column] = other;
      const auto found = run.rows(name, {value_column}, key);
      cells.push_back(found.empty() ? "--" : latex_cell(found.front().front()));
    }
  }
  return table;
}

std::string table_text(const RunTables& run, const Json& entry) {
  LatexTable table = entry.contains("pivot") ? pivot_table(run, entry) : plain_table(run, entry);
  if (table.rows.empty()) throw InputError("no row matches");
  table.align = entry.value("align", table.align);
  table.is_long = entry.value("long", false);
  return table.text();
}

// The file of the run that a figure's name stands for, relative to the folder: the picture of that
// name, or the PDF of the plot. Errors: InputError, where there is no such figure.
fs::path figure_file(const ResultsStore& store, const fs::path& name) {
  for (const StoredExperiment& experiment : store.experiments()) {
    for (const StoredFigure& figure : store.figures(experiment.name)) {
      const fs::path file = figure.file;
      if (file.filename() == name) return file;
      if (figure.kind == FigureKind::plot && file.stem() == name) {
        return fs::path(file).replace_extension(".pdf");
      }
    }
  }
  throw InputError(fmt::format("figure {} is not among the results", name.string()));
}

void copy_figure(const ResultsStore& store, const std::string& name, const fs::path& out) {
  const fs::path file = figure_file(store, name), from = store.file().parent_path() / file;
  std::error_code error;
  fs::copy_file(from, out / file.filename(), fs::copy_options::overwrite_existing, error);
  if (error) {
    throw InputError(
        fmt::format("{}: can't be copied to {}: {}", from.string(), out.string(), error.message()));
  }
}

// Calls f(entry) for each entry of the list; what goes wrong is told with the entry's place.
template <class F>
void for_each_entry(const Json& contents, const fs::path& path, const char* list, F&& f) {
  const Json entries = contents.value(list, Json::array());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    try {
      f(entries[i]);
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& error) {
      throw InputError(fmt::format("{}: {}[{}] {}: {}", path.string(), list, i, entries[i].dump(),
                                   error.what()));
    }
  }
}

}  // namespace

void write_paper_inputs(const ResultsStore& store, const std::filesystem::path& path,
                        const std::filesystem::path& out) {
  const Json contents = read_contents(path);
  const RunTables run(store);
  std::string values = run_macros(store) + claim_macros(run);
  for_each_entry(contents, path, "values", [&](const Json& entry) {
    values += fmt::format("\\newcommand{{\\{}}}{{{}}}\n", entry.at("name").get<std::string>(),
                          value_text(run, entry));
  });
  write_file(out / "values.tex", values);
  for_each_entry(contents, path, "tables", [&](const Json& entry) {
    write_file(out / (entry.at("file").get<std::string>() + ".tex"), table_text(run, entry));
  });
  for_each_entry(contents, path, "figures",
                 [&](const Json& entry) { copy_figure(store, entry.get<std::string>(), out); });
}

}  // namespace clipscope::experiments
