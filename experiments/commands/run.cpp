// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope run: the experiments.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/errors.hpp"
#include "experiments/experiment.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

struct RunOptions {
  Selection selection;
  std::vector<std::string> names;
  std::string out = "results";
};

const Experiment& find_experiment(const std::string& name) {
  const auto all = all_experiments();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Experiment& e) { return e.name == name; });
  if (found == all.end()) {
    std::vector<std::string_view> known;
    for (const Experiment& e : all) known.push_back(e.name);
    throw UsageError(
        fmt::format("no experiment is called '{}'; there are: {}", name, fmt::join(known, ", ")));
  }
  return *found;
}

// Finds out at once what would only be found out after minutes: that a name is wrong, that results
// can't be written.
std::vector<const Experiment*> check(const RunOptions& options) {
  std::vector<const Experiment*> chosen;
  for (const std::string& name : options.names) chosen.push_back(&find_experiment(name));
  if (chosen.empty()) {
    for (const Experiment& e : all_experiments()) chosen.push_back(&e);
  }
  selected_contestants(options.selection);
  write_file(std::filesystem::path(options.out) / "README.md",
             "Tables and pictures written by `clipscope run`.\n");
  return chosen;
}

int run_experiments(const RunOptions& options) {
  const std::vector<const Experiment*> chosen = check(options);
  const ExperimentContext context(options.selection, options.out);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto start = std::chrono::steady_clock::now();
    fmt::print(stderr, "[{}/{}] {}: {}\n", i + 1, chosen.size(), chosen[i]->name,
               chosen[i]->question);
    chosen[i]->run(context);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print(stderr, "[{}/{}] {}: done in {:.0f} s\n", i + 1, chosen.size(), chosen[i]->name,
               seconds);
  }
  return kExitOk;
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("run", "Run experiments; write tables and pictures");
  command->footer(
      "Tables are printed and written as Markdown, CSV and LaTeX, pictures as PNG and EXR.");
  const auto options = std::make_shared<RunOptions>();
  options->selection.scalars = {"float", "double", "double_double", "exact"};
  command->add_option("experiment", options->names,
                      "Names of experiments (see `clipscope list experiments`) [all]");
  add_scene_options(*command, options->selection);
  add_contestant_options(*command, options->selection);
  command->add_flag("--pictures", options->selection.pictures,
                    "hard_cases: also a picture (SVG) of every case that a clipper fails on");
  command->add_option("--out", options->out, "Folder for the results [results]")->type_name("DIR");
  add_json_option(*command, options->selection);
  command->callback(
      [&action, options] { action = [options] { return run_experiments(*options); }; });
}

}  // namespace clipscope::experiments
