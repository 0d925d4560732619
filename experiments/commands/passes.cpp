// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/passes.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <system_error>

#include "experiments/commands/run_text.hpp"
#include "experiments/commands/shard_options.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/results_readme.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/store/run_recorder.hpp"
#include "experiments/table/terminal.hpp"

namespace clipscope::experiments::commands {
namespace {

namespace fs = std::filesystem;

constexpr double kFullToFirst = 6;  // what a full pass takes of a first one's time; on two cores

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Some experiments, once.
struct Pass {
  const RunPlan& plan;
  const std::vector<PlannedExperiment>& experiments;
  Selection selection;
  fs::path out;
  std::string label;  // in front of its progress
  std::shared_ptr<RunRecorder> recorder = nullptr;
  std::map<std::string, double> expected_seconds = {};  // by experiment, as far as known
};

// How long the finished experiments of a run took.
std::map<std::string, double> seconds_of(const ResultsStore& store) {
  std::map<std::string, double> seconds;
  for (const StoredExperiment& e : store.experiments()) {
    if (e.finished) seconds[e.name] = e.seconds;
  }
  return seconds;
}

// What an older run with the same options took says how long this one will take.
void expect_as_before(const fs::path& kept, const RunInfo& now, Pass& pass) {
  try {
    const ResultsStore before(kept);
    if (value_of(before.run_info(), "options") != value_of(now, "options")) return;
    for (const auto& [name, seconds] : seconds_of(before)) pass.expected_seconds[name] = seconds;
  } catch (const InputError&) {  // it can't be read: then nothing is known of it
  }
}

// info: see run_info_of.
void open_recorder(const RunInfo& info, Pass& pass) {
  const std::string out = pass.out.string();
  const OpenedStore opened = pass.plan.resume ? resume_store(out, info) : start_store(out, info);
  tell_kept(opened);
  if (!opened.kept.empty()) expect_as_before(opened.kept, info, pass);
  if (pass.plan.resume && !opened.resumed) {
    fmt::print(stderr, "--resume: {} has no results yet; all are computed\n", out);
  }
  pass.recorder = std::make_shared<RunRecorder>(opened.database, opened.file);
}

std::string finding_of(const RunRecorder& recorder, const std::string& experiment) {
  for (const StoredExperiment& e : recorder.store().experiments()) {
    if (e.name == experiment) return e.finding;
  }
  return "";
}

void tell_findings(const Pass& pass, const ExperimentContext& context, const std::string& name) {
  if (!pass.plan.findings || pass.selection.json || !pass.plan.shard.is_whole()) return;
  clear_progress_line();
  fmt::print("{}\n{}", name, indented(finding_of(*pass.recorder, name)));
  context.tell_files();
}

// Of what nothing is known the average is expected.
std::vector<RunStep> steps_of(const Pass& pass) {
  double average = pass.expected_seconds.empty() ? 1 : 0;
  for (const auto& [name, seconds] : pass.expected_seconds) {
    average += seconds / static_cast<double>(pass.expected_seconds.size());
  }
  std::vector<RunStep> steps;
  for (const auto& [experiment, position] : pass.experiments) {
    const std::string name(experiment->name);
    const auto known = pass.expected_seconds.find(name);
    steps.push_back({name, known == pass.expected_seconds.end() ? average : known->second});
  }
  return steps;
}

// The run's own, and of a shard which one it is.
RunInfo info_of(const RunPlan& plan, const Selection& selection) {
  const RunInfo info = run_info_of(selection);
  return plan.shard.is_whole() ? info : spread_info(info, plan.shard);
}

// What `merge` asks of the folder of a shard that is done.
void tell_merge(const Pass& pass, double seconds) {
  const Shard& shard = pass.plan.shard;
  const auto done = static_cast<std::int64_t>(pass.experiments.size());
  TableOf<ShardRow> table;
  table.add({static_cast<std::int64_t>(shard.index), static_cast<std::int64_t>(shard.count), done,
             done, seconds});
  pass.recorder->replace({&table}, false);
  tell_shard(shard, pass.out.string());
}

// Returns how long it took.
double do_pass(const Pass& pass) {
  const ExperimentContext context(pass.selection, pass.out, pass.recorder);
  RunProgress progress(pass.label, steps_of(pass));
  for (const auto& [experiment, position] : pass.experiments) {
    const std::string name(experiment->name), question(experiment->question);
    const auto start = std::chrono::steady_clock::now();
    progress.show(question);
    pass.recorder->begin({name, question, run_command(pass.selection, name), "", 0, false},
                         position);
    experiment->run(context);
    pass.recorder->finish(seconds_since(start));
    progress.finish_step(seconds_since(start));
    tell_findings(pass, context, name);
  }
  if (!pass.plan.shard.is_whole()) return progress.elapsed();
  write_report(pass.recorder->store(), pass.out, pass.plan.page);
  write_results_readme(pass.recorder->store(), pass.out);
  return progress.elapsed();
}

// The answers of a pass, and how to ask further.
void tell_answers(const Pass& pass) {
  if (pass.plan.selection.json) return;
  fmt::print("{}", closing_text(pass.recorder->added("answers"),
                                (pass.plan.out / kReportFile).string(), pass.out.string()));
  std::fflush(stdout);
}

// What the times of the run are worth, where that is little.
void tell_if_busy(const Pass& pass) {
  const Interruptions runs = pass.recorder->store().interruptions();
  if (!runs.is_busy()) return;
  fmt::print(
      stderr,
      "The machine was busy: {}. Times and ratios may move, and claims that rest on them are not settled; run it again on a quiet machine{}.\n",
      runs.text(), pass.selection.realtime ? "" : ", or with --realtime");
}

// Until the full pass writes it, the page of the run is the one of the first pass.
void lead_to_first_pass(const fs::path& out) {
  write_file(out / kReportFile, fmt::format(R"(<!DOCTYPE html>
<meta charset="utf-8">
<meta http-equiv="refresh" content="0; url={0}/{1}">
<title>clipscope: first pass</title>
<p>The full pass is in work. <a href="{0}/{1}">The first pass</a> has answers already.</p>
)",
                                            kFirstPassFolder, kReportFile));
}

// What can't be removed does no harm.
void remove_first_pass(const fs::path& out) {
  std::error_code ignored;
  fs::remove_all(out / kFirstPassFolder, ignored);
}

// A quick pass in a folder of its own. Returns how long each experiment took. A run that is resumed
// has none once its full pass has begun.
std::map<std::string, double> make_first_pass(const RunPlan& plan) {
  if (plan.resume && fs::exists(plan.out / kStoreFile)) return {};
  Pass pass{plan, plan.first_pass, plan.selection, plan.out / kFirstPassFolder, "first pass"};
  pass.selection.quick = true;
  pass.selection.pictures = pass.selection.tables = pass.selection.json = false;
  if (!plan.resume) remove_first_pass(plan.out);
  write_file(pass.out / "README.md", "Quick results, until the full pass is done.\n");
  RunInfo info = run_info_of(pass.selection);
  info.emplace_back("pass", "first");
  open_recorder(info, pass);
  const double seconds = do_pass(pass);
  lead_to_first_pass(plan.out);
  if (!plan.selection.json) {
    fmt::print("First pass, of few triangles and rounds, after {:.0f} s; the full one follows.\n\n",
               seconds);
  }
  tell_answers(pass);
  return seconds_of(pass.recorder->store());
}

}  // namespace

void run_passes(const RunPlan& plan) {
  Pass pass{plan, plan.experiments, plan.selection, plan.out, "run"};
  if (!plan.first_pass.empty()) {
    pass.label = "full pass";
    pass.expected_seconds = make_first_pass(plan);
    for (auto& [name, seconds] : pass.expected_seconds) seconds *= kFullToFirst;
  }
  open_recorder(info_of(plan, pass.selection), pass);
  pass.recorder->keep_to_pieces(plan.shard.index, plan.shard.count);
  const double seconds = do_pass(pass);
  if (!plan.shard.is_whole()) return tell_merge(pass, seconds);
  remove_first_pass(plan.out);
  fmt::print(stderr, "all done in {:.0f} s\n", seconds);
  tell_answers(pass);
  tell_if_busy(pass);
}

}  // namespace clipscope::experiments::commands
