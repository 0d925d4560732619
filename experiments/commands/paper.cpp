// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope paper: the numbers, tables and figures of the paper, from a run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/errors.hpp"
#include "experiments/report/paper.hpp"

namespace clipscope::experiments {

void add_paper_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("paper", "Write the paper's numbers, tables and figures from a run");
  struct Options {
    std::string run = "results", contents = "paper/contents.json", out = "paper/generated";
  };
  const auto options = std::make_shared<Options>();
  command->add_option("--run", options->run, "The run's folder [results]")->type_name("DIR");
  command->add_option("--contents", options->contents, "What to write [paper/contents.json]")
      ->type_name("FILE");
  command->add_option("--out", options->out, "Where to [paper/generated]")->type_name("DIR");
  command->callback([&action, options] {
    action = [options] {
      write_paper_inputs(ResultsStore(options->run), options->contents, options->out);
      fmt::print("written: {}\n", options->out);
      return int{kExitOk};
    };
  });
}

}  // namespace clipscope::experiments
