// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/paper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <regex>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/report/paper_rows.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;
using Json = PaperEntry;

Json read_contents(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: can't be read", path.string()));
  try {
    return Json::parse(file);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

// The text escaped and set: powers of ten, comparisons and percentages as in print; lines may break
// within names such as homogeneous/sutherland_hodgman.
std::string latex_prose(const std::string& text) {
  static const std::regex one(R"((^|[\s(])1e\+?(-?)0*(\d+))"),
      number(R"((^|[\s(])(\d+(?:\.\d+)?)e\+?(-?)0*(\d+))"), less(R"(\\textless\{\}=)"),
      greater(R"(\\textgreater\{\}=)"), percent(R"( \\%)"), within(R"((/|\\_))");
  std::string prose = latex_escape(text);
  prose = std::regex_replace(prose, one, "$1$$10^{$2$3}$$");
  prose = std::regex_replace(prose, number, "$1$$$2\\cdot10^{$3$4}$$");
  prose = std::regex_replace(prose, less, "$$\\le$$");
  prose = std::regex_replace(prose, greater, "$$\\ge$$");
  prose = std::regex_replace(prose, percent, "\\,\\%");
  return std::regex_replace(prose, within, "$1\\allowbreak{}");
}

double taken(const std::vector<double>& numbers, const std::string& how) {
  if (how == "first") return numbers.front();
  if (how == "min") return *std::min_element(numbers.begin(), numbers.end());
  if (how == "max") return *std::max_element(numbers.begin(), numbers.end());
  if (how == "sum") return std::accumulate(numbers.begin(), numbers.end(), 0.0);
  if (how == "count") return static_cast<double>(numbers.size());
  throw InputError(fmt::format("\"take\" is {}; expected first, min, max, sum or count", how));
}

double number_of_entry(const PaperRows& run, const Json& entry) {
  return taken(run.numbers(entry, entry.at("column").get<std::string>()),
               entry.value("take", "first"));
}

// The entry's number, or what it is of that of "over".
double figure_of(const PaperRows& run, const Json& entry) {
  const double number = number_of_entry(run, entry);
  if (!entry.contains("over")) return number;
  Json other = entry;
  other.update(entry.at("over"));
  const double divisor = number_of_entry(run, other);
  if (divisor == 0) throw MissingFigure("the figure of \"over\" is 0");
  const std::string as = entry.value("as", "ratio");
  if (as == "ratio") return number / divisor;
  if (as == "percent") return 100 * number / divisor;
  if (as == "percent more") return 100 * (number / divisor - 1);
  throw InputError(fmt::format("\"as\" is {}; expected ratio, percent or percent more", as));
}

// The first phrase whose bound the figure is below, the number put in for {}.
std::string phrase_for(const Json& phrases, double figure, const std::string& number) {
  for (const Json& phrase : phrases) {
    if (phrase.contains("below") && !(figure < phrase.at("below").get<double>())) continue;
    std::string text = phrase.at("text").get<std::string>();
    if (const auto place = text.find("{}"); place != std::string::npos) {
      text.replace(place, 2, number);
    }
    return text;
  }
  throw InputError(fmt::format("\"say\" has no phrase for {}", figure));
}

// The text in the entry's first row; none where that is a number, or one is made of several rows.
std::optional<std::string> text_of_entry(const PaperRows& run, const Json& entry) {
  if (entry.value("take", "first") != "first") return std::nullopt;
  const auto rows = run.cells(entry, {entry.at("column").get<std::string>()});
  if (rows.empty()) return std::nullopt;
  const auto* text = std::get_if<std::string>(&rows.front().front());
  return text == nullptr ? std::nullopt : std::optional(*text);
}

std::string value_text(const PaperRows& run, const Json& entry) {
  if (const auto text = text_of_entry(run, entry)) {
    return latex_prose(run.name_of(entry.at("column").get<std::string>(), *text));
  }
  const double figure = figure_of(run, entry);
  const std::string format = entry.value("format", "");
  const std::string number = format.empty()
                                 ? latex_number(figure)
                                 : fmt::format(fmt::runtime("{:" + format + "}"), figure);
  return entry.contains("say") ? phrase_for(entry.at("say"), figure, number) : number;
}

// A macro that takes a key: \name{key}. A key that is not there is an error.
class KeyedMacro {
 public:
  explicit KeyedMacro(std::string name) : name_(std::move(name)) {
    const std::string known = fmt::format("\\csname {}-#1\\endcsname", name_);
    text_ = fmt::format(
        "\\newcommand{{\\{0}}}[1]{{\\if{1}\\{1}\\else\\errmessage{{no {0} of #1}}\\fi}}\n", name_,
        known.substr(1));
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
    question.define(e.name, latex_prose(e.question));
    finding.define(e.name, latex_prose(e.finding));
    command.define(e.name, latex_escape(e.command));
    seconds += e.seconds;
  }
  run.define("minutes", fmt::format("{:.0f}", std::ceil(seconds / 60)));
  return run.text() + question.text() + finding.text() + command.text();
}

std::string claim_macros(const PaperRows& run) {
  KeyedMacro verdict("claimverdict"), because("claimbecause");
  std::map<std::string, int> counts;
  const Json claims = Json::object({{"table", "claims"}});
  for (const auto& row : run.cells(claims, {"number", "verdict", "because"})) {
    const std::string number = format_cell(row[0]), text = format_cell(row[1]);
    verdict.define(number, latex_escape(text));
    because.define(number, latex_prose(format_cell(row[2])));
    ++counts[text];
  }
  KeyedMacro count("claimcount");
  for (const char* text : {"confirmed", "true only when", "refuted", "not settled", "undecided"}) {
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

std::string latex_cell(const PaperRows& run, const std::string& column, const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return latex_number(*number);
  if (std::holds_alternative<std::monostate>(cell)) return "--";
  return latex_prose(run.name_of(column, format_cell(cell)));
}

LatexTable plain_table(const PaperRows& run, const Json& entry) {
  LatexTable table;
  std::vector<std::string> columns;
  for (const auto& [key, head] : entry.at("columns").items()) {
    columns.push_back(key);
    table.heads.push_back(head.get<std::string>());
  }
  const auto rows = run.cells(entry, columns);
  for (const auto& row : rows) {
    auto& cells = table.rows.emplace_back();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      cells.push_back(latex_cell(run, columns[c], row[c]));
    }
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

LatexTable pivot_table(const PaperRows& run, const Json& entry) {
  const Json& pivot = entry.at("pivot");
  const auto row_column = pivot.at("rows").get<std::string>();
  const auto column_column = pivot.at("columns").get<std::string>();
  const auto value_column = pivot.at("value").get<std::string>();
  const std::vector<std::string> across = run.texts(entry, column_column);
  LatexTable table{{pivot.value("head", "")}, {}, "l" + std::string(across.size(), 'r')};
  for (const std::string& text : across) {
    table.heads.push_back(latex_cell(run, column_column, text));
  }
  for (const std::string& text : run.texts(entry, row_column)) {
    auto& cells = table.rows.emplace_back(1, latex_cell(run, row_column, text));
    for (const std::string& other : across) {
      Json one = {{"table", entry.at("table")}, {"where", entry.value("where", Json::object())}};
      one["where"][row_column] = text;
      one["where"][column_column] = other;
      const auto found = run.cells(one, {value_column});
      cells.push_back(
          latex_cell(run, value_column, found.empty() ? Cell() : found.front().front()));
    }
  }
  return table;
}

std::string table_text(const PaperRows& run, const Json& entry) {
  LatexTable table = entry.contains("pivot") ? pivot_table(run, entry) : plain_table(run, entry);
  if (table.rows.empty() && entry.contains("else")) return entry.at("else").get<std::string>();
  if (table.rows.empty()) throw InputError("no row matches");
  table.align = entry.value("align", table.align);
  table.is_long = entry.value("long", false);
  return table.text();
}

// The file of the run that a figure's name stands for, relative to the folder: the picture of that
// name, or the PDF of the plot. Nothing where there is no such figure.
std::optional<fs::path> figure_file(const ResultsStore& store, const fs::path& name) {
  for (const StoredExperiment& experiment : store.experiments()) {
    for (const StoredFigure& figure : store.figures(experiment.name)) {
      const fs::path file = figure.file;
      if (file.filename() == name) return file;
      if (figure.kind == FigureKind::plot && file.stem() == name) {
        return fs::path(file).replace_extension(".pdf");
      }
    }
  }
  return std::nullopt;
}

// entry: the figure's name; {"if_there": name} of one that a run may not have.
void copy_figure(const ResultsStore& store, const Json& entry, const fs::path& out) {
  const std::string name = (entry.is_object() ? entry.at("if_there") : entry).get<std::string>();
  const std::optional<fs::path> file = figure_file(store, name);
  if (!file && entry.is_object()) return;
  if (!file) throw InputError(fmt::format("figure {} is not among the results", name));
  const fs::path from = store.file().parent_path() / *file;
  std::error_code error;
  fs::copy_file(from, out / file->filename(), fs::copy_options::overwrite_existing, error);
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
      throw InputError(fmt::format("{}: {}[{}] {}: {}", path.string(), list, i,
                                   json_text(entries[i]), error.what()));
    }
  }
}

}  // namespace

void write_paper_inputs(const ResultsStore& store, const std::filesystem::path& path,
                        const std::filesystem::path& out) {
  const Json contents = read_contents(path);
  const PaperRows run(store, contents.value("names", Json::object()));
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
                 [&](const Json& entry) { copy_figure(store, entry, out); });
}

}  // namespace clipscope::experiments
