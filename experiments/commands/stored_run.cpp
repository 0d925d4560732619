// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is asked of a run that is stored:
//   clipscope table   its tables
//   clipscope diff    which figures moved from one run to another
//   clipscope report  the page of its results, written again
//   clipscope paper   the numbers, tables and figures of the paper
#include <cmath>

#include "experiments/commands/options.hpp"
#include "experiments/report/paper.hpp"
#include "experiments/report/report.hpp"
#include "experiments/store/diff.hpp"
#include "experiments/table/json_text.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr const char* kRunHelp = "Folder of a run (its --out), or a results.sqlite";

// --- table ---------------------------------------------------------------------------------------

struct TableOptions {
  std::string name, finding, run = "results", format = "text";
};

struct StoredRow {
  std::string table, experiment;
  std::size_t rows = 0;
  std::string state, title;

  static constexpr auto columns() {
    using R = StoredRow;
    return std::tuple(column("table", &R::table), column("experiment", &R::experiment),
                      column("rows", &R::rows), column("state", &R::state),
                      column("title", "title", &R::title, 36));
  }
};

Table list_of_tables(const ResultsStore& store) {
  TableOf<StoredRow> list("tables", fmt::format("Tables of {}", store.file().string()));
  for (const StoredTable& t : store.tables()) {
    list.add({t.name, t.experiment, t.rows, t.complete ? "complete" : "unfinished", t.title});
  }
  return list;
}

std::string finding_of(const ResultsStore& store, const std::string& experiment) {
  for (const StoredExperiment& e : store.experiments()) {
    if (e.name == experiment && !e.finding.empty()) return e.finding;
  }
  usage_error("--finding: {} has none of an experiment '{}'", store.file().string(), experiment);
}

int print_stored(const TableOptions& options) {
  const ResultsStore store(options.run);
  if (!options.finding.empty()) {
    fmt::print("{}\n", finding_of(store, options.finding));
    return kExitOk;
  }
  const Table table = options.name.empty() ? list_of_tables(store) : store.table(options.name);
  fmt::print("{}", formatted(table, options.format));
  return kExitOk;
}

// --- diff ----------------------------------------------------------------------------------------

struct DiffOptions {
  std::string a, b, format = "text";
  std::optional<std::string> table;
};

// The change in percent of a; empty where that is no number.
Cell change_of(const Cell& a, const Cell& b) {
  const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  if (x != nullptr && y != nullptr) return 100 * (*y - *x) / std::abs(*x);
  const auto *m = std::get_if<std::int64_t>(&a), *n = std::get_if<std::int64_t>(&b);
  if (m == nullptr || n == nullptr) return std::monostate();
  return 100 * static_cast<double>(*n - *m) / std::abs(static_cast<double>(*m));
}

Table moved_table(const Difference& difference) {
  Table table("diff", "Figures that moved",
              {{"table", "table"},
               {"row", "row"},
               {"column", "column"},
               {"a", "A"},
               {"b", "B"},
               {"change_percent", "change [%]"}});
  for (const MovedFigure& m : difference.moved) {
    table.add_row({m.table, m.row, m.column, m.a, m.b, change_of(m.a, m.b)});
  }
  table.add_note(
      "A figure with a 95 % interval (columns S_low and S_high after it) moved if the intervals of both runs have no point in common; another one if it is another value.");
  return table;
}

Table lone_table(const Difference& difference) {
  Table table("diff_lone", "In one run only",
              {{"run", "run"}, {"table", "table"}, {"row", "row"}, {"column", "column"}});
  const auto or_all = [](const std::string& text) { return text.empty() ? "(all)" : text; };
  for (const LoneRow& l : difference.lone) {
    table.add_row({l.in_a ? "A" : "B", l.table, or_all(l.row), or_all(l.column)});
  }
  return table;
}

Table runs_table(const Difference& difference) {
  Table table("diff_runs", "What the runs were made with",
              {{"what", "what"}, {"a", "A"}, {"b", "B"}});
  for (const RunDifference& r : difference.runs) table.add_row({r.what, r.a, r.b});
  return table;
}

int diff(const DiffOptions& options) {
  const ResultsStore a(options.a), b(options.b);
  const Difference difference = difference_of(a, b, options.table);
  const Table runs = runs_table(difference), lone = lone_table(difference),
              moved = moved_table(difference);
  if (options.format == "json") {
    const nlohmann::json json = {{"figures", difference.figures},
                                 {"moved", moved.to_json()["rows"]},
                                 {"lone", lone.to_json()["rows"]},
                                 {"runs", runs.to_json()["rows"]}};
    fmt::print("{}\n", json_text(json, 2));
  } else {
    for (const Table* table : {&runs, &lone, &moved}) {
      if (!table->rows().empty()) fmt::print("{}\n", formatted(*table, options.format));
    }
  }
  if (options.format == "text") {
    fmt::print("{} of {} figures moved; {} rows, columns or tables are in one run only.\n",
               difference.moved.size(), difference.figures, difference.lone.size());
  }
  if (!difference.moved.empty() || !difference.lone.empty()) return kExitMoved;
  return difference.figures > 0 ? kExitOk : kExitNothingJudged;
}

// --- report, paper -------------------------------------------------------------------------------

struct ReportOptions {
  std::string run = "results";
  PageForm form = PageForm::folder;
};

int write_page(const ReportOptions& options) {
  const std::filesystem::path page = std::filesystem::path(options.run) / kReportFile;
  write_report(ResultsStore(options.run), options.run, options.form);
  fmt::print("written: {} ({:.1f} MB)\n", page.string(),
             static_cast<double>(std::filesystem::file_size(page)) / 1e6);
  return kExitOk;
}

struct PaperOptions {
  std::string run = "results", contents = "paper/contents.json", out = "paper/generated";
};

int write_paper(const PaperOptions& options) {
  write_paper_inputs(ResultsStore(options.run), options.contents, options.out);
  fmt::print("written: {}\n", options.out);
  return kExitOk;
}

}  // namespace

void add_table_command(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, print_stored, "table",
                  "Print a table of a run, or list the tables that there are",
                  "Also of a run in work or one that was interrupted: what it has finished.");
  command.add_option("name", options.name, "Name of a table [a list of all]");
  add_option(command, "--finding", options.finding, "EXPERIMENT",
             "Print the finding of this experiment instead of a table");
  add_option(command, "--run", options.run, "DIR|FILE", fmt::format("{} [results]", kRunHelp));
  add_format_option(command, options.format);
}

void add_diff_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, diff, "diff", "Which figures moved from one run to another?",
      R"(A figure with a 95 % interval moved if the intervals of both runs have no point in common;
another one if it is another value. Exit code: 0 if nothing moved and both runs have the same
rows, 1 if not.)");
  add_option(command, "run_a", options.a, "DIR|FILE", kRunHelp)->required();
  add_option(command, "run_b", options.b, "DIR|FILE", kRunHelp)->required();
  add_option(command, "--table", options.table, "NAME", "Compare this table only [all]");
  add_format_option(command, options.format);
}

void add_report_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, write_page, "report",
      "Write the page of a run's results (report.html) again from its store",
      R"(The run's answers, then tables to sort and filter, plots, pictures, commands. The page shows the
pictures and loads the long tables that lie beside it. `clipscope run` writes it at its end; of a
run that was interrupted it shows what was done. Where explorer.html lies in the folder, which
`experiments/run explorer` makes, the page leads to it, and worst inputs open in it.)");
  add_option(command, "--run", options.run, "DIR", "Folder of the run's results [results]");
  add_single_file_option(command, options.form);
}

void add_paper_command(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, write_paper, "paper",
                  "Write the paper's numbers, tables and figures from a run");
  add_option(command, "--run", options.run, "DIR", "The run's folder [results]");
  add_option(command, "--contents", options.contents, "FILE",
             "What to write [paper/contents.json]");
  add_option(command, "--out", options.out, "DIR", "Where to [paper/generated]");
}

}  // namespace clipscope::experiments::commands
