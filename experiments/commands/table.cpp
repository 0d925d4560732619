// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope table: the tables of a run, from its store.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/table_format.hpp"
#include "experiments/errors.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {
namespace {

struct TableOptions {
  std::string name, finding, run = "results", format = "text";
};

Table list_of_tables(const ResultsStore& store) {
  Table list("tables", fmt::format("Tables of {}", store.file().string()),
             {{"table", "table"},
              {"experiment", "experiment"},
              {"rows", "rows"},
              {"state", "state"},
              {"title", "title", 36}});
  for (const StoredTable& t : store.tables()) {
    list.add_row({t.name, t.experiment, static_cast<std::int64_t>(t.rows),
                  std::string(t.complete ? "complete" : "unfinished"), t.title});
  }
  return list;
}

std::string finding_of(const ResultsStore& store, const std::string& experiment) {
  for (const StoredExperiment& e : store.experiments()) {
    if (e.name == experiment && !e.finding.empty()) return e.finding;
  }
  throw UsageError(fmt::format("--finding: {} has none of an experiment '{}'",
                               store.file().string(), experiment));
}

int print_table(const TableOptions& options) {
  const ResultsStore store(options.run);
  if (!options.finding.empty()) {
    fmt::print("{}\n", finding_of(store, options.finding));
    return kExitOk;
  }
  const Table table = options.name.empty() ? list_of_tables(store) : store.table(options.name);
  fmt::print("{}", formatted(table, options.format));
  return kExitOk;
}

}  // namespace

void add_table_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("table", "Print a table of a run, or list the tables that there are");
  command->footer("Also of a run in work or one that was interrupted: what it has finished.");
  const auto options = std::make_shared<TableOptions>();
  command->add_option("name", options->name, "Name of a table [a list of all]");
  command
      ->add_option("--finding", options->finding,
                   "Print the finding of this experiment instead of a table")
      ->type_name("EXPERIMENT");
  command
      ->add_option("--run", options->run,
                   "Folder of a run (its --out), or a results.sqlite [results]")
      ->type_name("DIR|FILE");
  add_format_option(*command, options->format);
  command->callback([&action, options] { action = [options] { return print_table(*options); }; });
}

}  // namespace clipscope::experiments
