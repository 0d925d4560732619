// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope report: the page of a run's results, written again from its store.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/errors.hpp"
#include "experiments/report/report.hpp"

namespace clipscope::experiments {

void add_report_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "report", "Write the page of a run's results (report.html) again from its store");
  command->footer(
      "The page needs no other file: tables to sort and filter, plots, pictures, commands.\n"
      "`clipscope run` writes it at its end; of a run that was interrupted it shows what was "
      "done.");
  const auto directory = std::make_shared<std::string>("results");
  command->add_option("--run", *directory, "Folder of the run's results [results]")
      ->type_name("DIR");
  command->callback([&action, directory] {
    action = [directory] {
      const ResultsStore store{std::filesystem::path(*directory)};
      write_report(store, *directory);
      fmt::print("written: {}\n", (std::filesystem::path(*directory) / kReportFile).string());
      return kExitOk;
    };
  });
}

}  // namespace clipscope::experiments
