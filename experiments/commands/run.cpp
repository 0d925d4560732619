// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope run: the experiments.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <optional>
#include <set>

#include "experiments/answers/rows.hpp"
#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/commands/passes.hpp"
#include "experiments/commands/shard_options.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/measuring.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/report/report.hpp"
#include "experiments/store/run_folder.hpp"

namespace clipscope::experiments::commands {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
  Selection selection = default_run_selection();
  GuestOptions guests;
  std::vector<std::string> names;
  std::string out = "results";
  ShardOptions shard;
  PageForm page = PageForm::folder;
  bool no_first_pass = false;
  bool findings = false;
};

// Those that time nothing, and whose pieces no other piece is needed for.
constexpr std::array<std::string_view, 2> kSpreadExperiments = {"accuracy", "hard_cases"};

// Errors: UsageError if the run can't be spread over processes.
void check_spread(const RunOptions& options) {
  if (!options.shard.is_given) return;
  for (const std::string& name : options.names) {
    if (std::ranges::find(kSpreadExperiments, name) != kSpreadExperiments.end()) continue;
    usage_error(
        "--shard: '{}' given; {} are spread, and nothing that measures times or reads what others found",
        name, fmt::join(kSpreadExperiments, " and "));
  }
  if (options.names.empty()) {
    usage_error("--shard: name the experiments: {} are spread, and nothing that measures times",
                fmt::join(kSpreadExperiments, " and "));
  }
}

// Those that are named; all if none is. Errors: UsageError.
std::vector<PlannedExperiment> planned(const std::vector<std::string>& names) {
  std::vector<PlannedExperiment> all, chosen;
  std::vector<std::string_view> known;
  for (const Experiment* e : all_experiments()) {
    all.push_back({e, static_cast<std::int64_t>(all.size())});
    known.push_back(e->name);
  }
  for (const std::string& name : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      usage_error("no experiment is called '{}'; there are: {}", name, fmt::join(known, ", "));
    }
    chosen.push_back(all[static_cast<std::size_t>(found - known.begin())]);
  }
  return names.empty() ? all : chosen;
}

// What the answers are computed from, and they themselves.
std::vector<std::string> answers_and_evidence() {
  std::vector<std::string> names(answers::kEvidence.begin(), answers::kEvidence.end());
  names.emplace_back("answers");
  return names;
}

// What is named twice is run once.
void drop_repeated(std::vector<std::string>& names) {
  std::set<std::string> seen;
  std::erase_if(names, [&](const std::string& name) { return !seen.insert(name).second; });
}

// Those chosen. Finds out at once what would only be found out after minutes: that a
// name is wrong, that results can't be written.
std::vector<PlannedExperiment> check(const RunOptions& options) {
  std::vector<PlannedExperiment> chosen = planned(options.names);
  if (options.selection.camera.matrix) {
    usage_error(
        "--matrix: the experiments vary frusta and cut in view space; compare, verify, render, plan, explain and clip take a matrix as given");
  }
  selected_contestants(options.selection);
  write_file(
      fs::path(options.out) / "README.md",
      "A run of clipscope is in work, or was interrupted. What it has finished is in `results.sqlite` and in a folder for each experiment.\n");
  return chosen;
}

int run_experiments(RunOptions options) {
  check_spread(options);
  load_guests(options.guests, options.selection);
  check_takes_scenes(options.selection);
  drop_repeated(options.selection.scenes);
  drop_repeated(options.names);
  if (options.selection.realtime) measure_in_real_time();
  const std::vector<PlannedExperiment> chosen = check(options);
  // A limit on the size of files is reported as an error of writing instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  const ThreadLimit limit(options.shard.threads);
  const FolderLock lock(options.out);
  const bool is_all = options.names.empty();
  run_passes({.selection = options.selection,
              .out = options.out,
              .resume = options.shard.resume,
              .shard = options.shard.shard,
              // Who names experiments wants to know what each found; the answers are those of all.
              .findings = options.findings || !is_all,
              .page = options.page,
              .experiments = chosen,
              // Who runs everything need not wait for the first answers until all is done.
              .first_pass = is_all && !options.selection.quick && !options.no_first_pass
                                ? planned(answers_and_evidence())
                                : std::vector<PlannedExperiment>()});
  return kExitOk;
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, run_experiments, "run", "Run experiments; write tables and pictures",
      R"(What the answers need makes a quick pass first, whose page is there within a minute or so; the page
of the full run replaces it. Printed are the answers; of experiments that are named their findings,
and where their results are. Tables are written as Markdown, CSV and LaTeX, plots as SVG, PDF and
PNG, pictures as PNG and EXR, each experiment's into a folder of its own, and everything into
DIR/results.sqlite, piece by piece: a run that was interrupted is finished by the same command
with --resume. See `clipscope table` and `clipscope diff`.)");
  command.add_option("experiment", options.names,
                     "Names of experiments (see `clipscope list experiments`) [all]");
  add_scene_options(command, options.selection);
  add_contestant_options(command, options.selection);
  add_guest_options(command, options.guests);
  add_guest_space_option(command, options.guests);
  add_realtime_option(command, options.selection);
  command.add_flag("--pictures", options.selection.pictures,
                   "hard_cases: also a picture (SVG) of every case that a clipper fails on");
  add_option(command, "--out", options.out, "DIR", "Folder for the results [results]");
  add_shard_options(command, options.shard);
  add_threads_option(command, options.shard.threads);
  add_single_file_option(command, options.page);
  command.add_flag("--no-first-pass", options.no_first_pass,
                   "Begin with the full pass, without quick answers before it");
  command.add_flag("--findings", options.findings,
                   "Print every experiment's finding; those of experiments that are named are");
  command.add_flag("--tables", options.selection.tables, "Print every table, too");
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
