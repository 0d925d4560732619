// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `clipscope run` does: a quick first pass over what the answers need, which are there within
// a minute or so, then the full pass over everything, whose page replaces that of the first.
//
// The first pass has a store and a page of its own in the folder first_pass of the run's folder;
// its run says "pass": "first". The page of the run leads there until the full pass writes it; the
// folder is removed then.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "experiments/report/experiment.hpp"
#include "experiments/report/report.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/shards/shard.hpp"

namespace clipscope::experiments::commands {

inline constexpr const char* kFirstPassFolder = "first_pass";

struct PlannedExperiment {
  const Experiment* experiment = nullptr;
  std::int64_t position = 0;  // among all
};

struct RunPlan {
  Selection selection;
  std::filesystem::path out;
  bool resume = false;
  Shard shard = {};       // does its pieces alone, and leaves tables and page to `merge`
  bool findings = false;  // print what each found, and where its files are
  PageForm page = PageForm::folder;
  std::vector<PlannedExperiment> experiments;
  std::vector<PlannedExperiment> first_pass = {};  // done quickly before; none: no first pass
};

// Progress goes to standard error, answers and findings to standard output. A run that is resumed
// has no first pass once its full pass has begun. Pre-condition: the folder exists and is locked.
// Errors: UsageError where a run can't be resumed; OutputError; those of the experiments.
void run_passes(const RunPlan& plan);

}  // namespace clipscope::experiments::commands
