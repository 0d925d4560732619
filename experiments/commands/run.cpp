// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope run: the experiments.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <set>

#include "experiments/commands/commands.hpp"
#include "experiments/errors.hpp"
#include "experiments/experiment.hpp"
#include "experiments/report/report.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/store/run_identity.hpp"
#include "experiments/store/run_recorder.hpp"

namespace clipscope::experiments {
namespace {

struct RunOptions {
  Selection selection = default_run_selection();
  std::vector<std::string> names;
  std::string out = "results";
  bool resume = false;
  std::optional<int> threads;
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

// A scene named twice is run once.
void drop_repeated(std::vector<std::string>& names) {
  std::set<std::string> seen;
  std::erase_if(names, [&](const std::string& name) { return !seen.insert(name).second; });
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
             "Tables and pictures written by `clipscope run`, and all results in one SQLite file, "
             "`results.sqlite`.\n");
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

std::string time_left(double elapsed, std::size_t done, std::size_t all) {
  if (done == all) return "";
  const double left = elapsed / static_cast<double>(done) * static_cast<double>(all - done);
  return fmt::format("; {:.0f} s in all, about {:.0f} s more if the others take as long each",
                     elapsed, left);
}

int run_experiments(const RunOptions& options) {
  const std::vector<const Experiment*> chosen = check(options);
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
    const Experiment& experiment = *chosen[i];
    const auto start = std::chrono::steady_clock::now();
    fmt::print(stderr, "[{}/{}] {}: {}\n", i + 1, chosen.size(), experiment.name,
               experiment.question);
    const std::string name(experiment.name);
    recorder->begin({name, std::string(experiment.question), run_command(options.selection, name),
                     "", 0, false},
                    &experiment - all_experiments().data());
    experiment.run(context);
    recorder->finish(seconds_since(start));
    fmt::print(stderr, "[{}/{}] {}: done in {:.0f} s{}\n", i + 1, chosen.size(), name,
               seconds_since(start), time_left(seconds_since(run_start), i + 1, chosen.size()));
  }
  write_report(recorder->store(), options.out);
  context.emit_file(context.out() / kReportFile);
  return kExitOk;
}

void add_run_options(CLI::App& command, RunOptions& options) {
  command.add_option("experiment", options.names,
                     "Names of experiments (see `clipscope list experiments`) [all]");
  add_scene_options(command, options.selection);
  add_contestant_options(command, options.selection);
  command.add_flag("--pictures", options.selection.pictures,
                   "hard_cases: also a picture (SVG) of every case that a clipper fails on");
  command.add_option("--out", options.out, "Folder for the results [results]")->type_name("DIR");
  command.add_flag("--resume", options.resume,
                   "Go on with the run that was interrupted in --out; takes the same options");
  command
      .add_option("--threads", options.threads,
                  "Threads to use at most; the results do not depend on it [all processors]")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  add_json_option(command, options.selection);
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("run", "Run experiments; write tables and pictures");
  command->footer(
      "Tables are printed and written as Markdown, CSV and LaTeX, plots as SVG, PDF and PNG, "
      "pictures\n"
      "as PNG and EXR, and everything into DIR/results.sqlite, piece by piece: a run that was\n"
      "interrupted is finished by the same command with --resume. See `clipscope table` and\n"
      "`clipscope diff`.");
  const auto options = std::make_shared<RunOptions>();
  add_run_options(*command, *options);
  command->callback([&action, options] {
    drop_repeated(options->selection.scenes);
    drop_repeated(options->names);
    action = [options] { return run_experiments(*options); };
  });
}

}  // namespace clipscope::experiments
