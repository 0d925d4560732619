// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope diff: which figures moved from one run to another.
#include "experiments/store/diff.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/table_format.hpp"
#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

struct DiffOptions {
  std::string a, b, format = "text";
  std::optional<std::string> table;
};

// In percent of a; empty where that is no number.
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
      "A figure with a 95 % interval (columns S_low and S_high after it) moved if the intervals of "
      "both runs have no point in common; another one if it is another value.");
  return table;
}

Table lone_table(const Difference& difference) {
  Table table("diff_lone", "In one run only",
              {{"run", "run"}, {"table", "table"}, {"row", "row"}, {"column", "column"}});
  for (const LoneRow& l : difference.lone) {
    table.add_row({std::string(l.in_a ? "A" : "B"), l.table,
                   l.row.empty() ? std::string("(all)") : l.row,
                   l.column.empty() ? std::string("(all)") : l.column});
  }
  return table;
}

Table runs_table(const Difference& difference) {
  Table table("diff_runs", "What the runs were made with",
              {{"what", "what"}, {"a", "A"}, {"b", "B"}});
  for (const RunDifference& r : difference.runs) table.add_row({r.what, r.a, r.b});
  return table;
}

void print_json(const Difference& difference) {
  fmt::print("{}\n", nlohmann::json{{"figures", difference.figures},
                                    {"moved", moved_table(difference).to_json()["rows"]},
                                    {"lone", lone_table(difference).to_json()["rows"]},
                                    {"runs", runs_table(difference).to_json()["rows"]}}
                         .dump(2));
}

void print_tables(const DiffOptions& options, const Difference& difference) {
  for (const Table& table :
       {runs_table(difference), lone_table(difference), moved_table(difference)}) {
    if (!table.rows().empty()) fmt::print("{}\n", formatted(table, options.format));
  }
  if (options.format == "text") {
    fmt::print("{} of {} figures moved; {} rows, columns or tables are in one run only.\n",
               difference.moved.size(), difference.figures, difference.lone.size());
  }
}

int diff(const DiffOptions& options) {
  const ResultsStore a(options.a), b(options.b);
  const Difference difference = difference_of(a, b, options.table);
  if (options.format == "json") {
    print_json(difference);
  } else {
    print_tables(options, difference);
  }
  return difference.moved.empty() && difference.lone.empty() ? kExitOk : kExitMoved;
}

}  // namespace

void add_diff_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("diff", "Which figures moved from one run to another?");
  command->footer(
      "A figure with a 95 % interval moved if the intervals of both runs have no point in common;\n"
      "another one if it is another value. Exit code: 0 if nothing moved and both runs have the "
      "same\n"
      "rows, 1 if not.");
  const auto options = std::make_shared<DiffOptions>();
  const std::string help = "Folder of a run (its --out), or a results.sqlite";
  command->add_option("run_a", options->a, help)->required()->type_name("DIR|FILE");
  command->add_option("run_b", options->b, help)->required()->type_name("DIR|FILE");
  command->add_option("--table", options->table, "Compare this table only [all]")
      ->type_name("NAME");
  add_format_option(*command, options->format);
  command->callback([&action, options] { action = [options] { return diff(*options); }; });
}

}  // namespace clipscope::experiments
