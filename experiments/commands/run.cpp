// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope run: the experiments.
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <numeric>
#include <optional>
#include <set>

#include "experiments/commands/options.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/report/report.hpp"
#include "experiments/report/results_readme.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/store/run_recorder.hpp"

namespace clipscope::experiments::commands {
namespace {

struct RunOptions {
  Selection selection = default_run_selection();
  std::vector<std::string> names;
  std::string out = "results";
  bool resume = false;
  std::optional<int> threads;
};

// The place of each among all experiments; all places if none is named. Errors: UsageError.
std::vector<std::size_t> places_of(const std::vector<std::string>& names) {
  std::vector<std::string_view> known;
  for (const Experiment* e : all_experiments()) known.push_back(e->name);
  std::vector<std::size_t> places(names.empty() ? known.size() : 0);
  std::iota(places.begin(), places.end(), std::size_t{0});
  for (const std::string& name : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      usage_error("no experiment is called '{}'; there are: {}", name, fmt::join(known, ", "));
    }
    places.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  return places;
}

// What is named twice is run once.
void drop_repeated(std::vector<std::string>& names) {
  std::set<std::string> seen;
  std::erase_if(names, [&](const std::string& name) { return !seen.insert(name).second; });
}

// The places of those chosen. Finds out at once what would only be found out after minutes: that a
// name is wrong, that results can't be written.
std::vector<std::size_t> check(const RunOptions& options) {
  std::vector<std::size_t> chosen = places_of(options.names);
  if (options.selection.camera.matrix) {
    usage_error(
        "--matrix: the experiments vary frusta and cut in view space; compare, verify, render, plan, explain and clip take a matrix as given");
  }
  selected_contestants(options.selection);
  write_file(
      std::filesystem::path(options.out) / "README.md",
      "A run of clipscope is in work, or was interrupted. What it has finished is in `results.sqlite` and in a folder for each experiment.\n");
  return chosen;
}

std::shared_ptr<RunRecorder> open_recorder(const RunOptions& options) {
  const RunInfo info = run_info_of(options.selection);
  const OpenedStore opened =
      options.resume ? resume_store(options.out, info) : start_store(options.out, info);
  if (!opened.kept.empty()) {
    fmt::print(stderr, "results of an older run are kept as {}\n", opened.kept.string());
  }
  if (options.resume && !opened.resumed) {
    fmt::print(stderr, "--resume: {} has no results yet; all are computed\n", options.out);
  }
  return std::make_shared<RunRecorder>(opened.database, opened.file);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What is known when `done` of `all` experiments are, taking it that each takes as long; empty
// before the first.
std::string time_left(double elapsed, std::size_t done, std::size_t all) {
  if (done == 0) return "";
  const double left = elapsed / static_cast<double>(done) * static_cast<double>(all - done);
  return fmt::format(" ({:.0f} s so far, about {:.0f} s left)", elapsed, left);
}

int run_experiments(RunOptions options) {
  drop_repeated(options.selection.scenes);
  drop_repeated(options.names);
  const std::vector<std::size_t> chosen = check(options);
  // A limit on the size of files is reported as an error of writing instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  std::optional<tbb::global_control> limit;
  if (options.threads) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(*options.threads));
  }
  const FolderLock lock(options.out);
  const auto recorder = open_recorder(options);
  const ExperimentContext context(options.selection, options.out, recorder);
  const auto run_start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Experiment& experiment = *all_experiments()[chosen[i]];
    const std::string name(experiment.name), question(experiment.question);
    const auto start = std::chrono::steady_clock::now();
    fmt::print(stderr, "[{}/{}] {}: {}{}\n", i + 1, chosen.size(), name, question,
               time_left(seconds_since(run_start), i, chosen.size()));
    recorder->begin({name, question, run_command(options.selection, name), "", 0, false},
                    static_cast<std::int64_t>(chosen[i]));
    experiment.run(context);
    recorder->finish(seconds_since(start));
    context.tell_files();
  }
  write_report(recorder->store(), options.out);
  write_results_readme(recorder->store(), options.out);
  fmt::print(stderr, "all done in {:.0f} s\n", seconds_since(run_start));
  if (!options.selection.json) fmt::print("  in {}: README.md, {}\n", options.out, kReportFile);
  return kExitOk;
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, run_experiments, "run", "Run experiments; write tables and pictures",
      R"(Printed are each experiment's finding and where its results are. Tables are written as
Markdown, CSV and LaTeX, plots as SVG, PDF and PNG, pictures as PNG and EXR, each experiment's
into a folder of its own, and everything into DIR/results.sqlite, piece by piece: a run that was interrupted is finished by the same command
with --resume. See `clipscope table` and `clipscope diff`.)");
  command.add_option("experiment", options.names,
                     "Names of experiments (see `clipscope list experiments`) [all]");
  add_scene_options(command, options.selection);
  add_contestant_options(command, options.selection);
  command.add_flag("--pictures", options.selection.pictures,
                   "hard_cases: also a picture (SVG) of every case that a clipper fails on");
  add_option(command, "--out", options.out, "DIR", "Folder for the results [results]");
  command.add_flag("--resume", options.resume,
                   "Go on with the run that was interrupted in --out; takes the same options");
  command
      .add_option("--threads", options.threads,
                  "Threads to use at most; the results do not depend on it [all processors]")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  command.add_flag("--tables", options.selection.tables, "Print every table, too");
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
