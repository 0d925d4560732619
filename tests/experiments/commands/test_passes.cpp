// SPDX-License-Identifier: GPL-3.0-or-later
//
// The passes of a run, over experiments that only say how they were asked.
#include <fmt/format.h>

#include "experiments/commands/passes.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/report/report.hpp"
#include "experiments/store/run_folder.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

using namespace clipscope::experiments;
using commands::kFirstPassFolder;
using commands::RunPlan;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> g_asked;  // "one quick"
fs::path g_out;
std::string g_page_in_full_pass;  // what the page of the run was while the full pass was in work
bool g_fails_in_full_pass = false;

void note(const ExperimentContext& context, const char* name) {
  const bool quick = context.selection().quick;
  g_asked.push_back(fmt::format("{} {}", name, quick ? "quick" : "full"));
  if (!quick) g_page_in_full_pass = read(g_out / kReportFile);
  context.finding(fmt::format("It is {}.", quick ? "roughly so" : "so"));
}

const Experiment kOne{"one", "What is one?",
                      [](const ExperimentContext& context) { note(context, "one"); }};
const Experiment kTwo{"two", "What is two?", [](const ExperimentContext& context) {
                        note(context, "two");
                        const bool full = !context.selection().quick;
                        if (full && g_fails_in_full_pass) throw OutputError("the disk is full");
                      }};

RunPlan plan_in(const Folder& folder) {
  g_asked.clear();
  g_page_in_full_pass.clear();
  g_fails_in_full_pass = false;
  g_out = folder.path();
  return {.selection = default_run_selection(),
          .out = g_out,
          .experiments = {{&kOne, 0}, {&kTwo, 1}},
          .first_pass = {{&kTwo, 1}}};
}

std::vector<std::string> asked_by(const RunPlan& plan) {
  g_asked.clear();
  run_passes(plan);
  return g_asked;
}

}  // namespace

TEST_CASE("passes: what the answers need is asked quickly, then everything in full") {
  const Folder folder;
  CHECK(asked_by(plan_in(folder)) == std::vector<std::string>{"two quick", "one full", "two full"});
}

TEST_CASE("passes: until the full page is written, that of the first pass is led to") {
  const Folder folder;
  run_passes(plan_in(folder));
  CHECK(contains(g_page_in_full_pass, "first_pass/report.html"));
  const std::string page = read(folder.path() / kReportFile);
  CHECK(contains(page, "It is so."));
  CHECK_FALSE(contains(page, "It is roughly so."));
  CHECK_FALSE(fs::exists(folder.path() / kFirstPassFolder));
}

TEST_CASE("passes: a first pass has a store of its own that says what it is") {
  const Folder folder;
  RunPlan plan = plan_in(folder);
  g_fails_in_full_pass = true;
  CHECK_THROWS_AS(run_passes(plan), OutputError);
  const RunInfo first = ResultsStore(folder.path() / kFirstPassFolder).run_info();
  CHECK(value_of(first, "pass") == "first");
  CHECK(value_of(ResultsStore(folder.path()).run_info(), "pass").empty());
  CHECK(contains(read(folder.path() / kFirstPassFolder / kReportFile), "It is roughly so."));
}

TEST_CASE("passes: a run that is resumed in its full pass has no second first pass") {
  const Folder folder;
  RunPlan plan = plan_in(folder);
  g_fails_in_full_pass = true;
  CHECK_THROWS_AS(run_passes(plan), OutputError);
  g_fails_in_full_pass = false;
  plan.resume = true;
  CHECK(asked_by(plan) == std::vector<std::string>{"one full", "two full"});
  CHECK_FALSE(fs::exists(folder.path() / kFirstPassFolder));
  CHECK(contains(read(folder.path() / kReportFile), "It is so."));
}

TEST_CASE("passes: who wants no first pass has none") {
  const Folder folder;
  RunPlan plan = plan_in(folder);
  plan.first_pass.clear();
  CHECK(asked_by(plan) == std::vector<std::string>{"one full", "two full"});
}
