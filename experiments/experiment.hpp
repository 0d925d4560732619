// SPDX-License-Identifier: GPL-3.0-or-later
//
// Experiments: one folder each beside this file, each answering one question with tables and pictures.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "experiments/commands/selection.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// What an experiment is given and where its results go.
class ExperimentContext {
 public:
  ExperimentContext(Selection selection, std::filesystem::path out);

  const Selection& selection() const { return selection_; }
  // The folder for pictures.
  const std::filesystem::path& out() const { return out_; }

  // Writes the table's files at once and prints it (as one line of JSON if that was asked for).
  void emit(const Table& table) const;
  // Says on standard output that a file was written.
  void emit_file(const std::filesystem::path& path) const;

 private:
  Selection selection_;
  std::filesystem::path out_;
};

struct Experiment {
  std::string_view name;      // its folder
  std::string_view question;  // one line
  void (*run)(const ExperimentContext&);
};

// In the order in which `clipscope run` runs them.
std::span<const Experiment> all_experiments();

void run_accuracy(const ExperimentContext& context);
void run_budget(const ExperimentContext& context);
void run_cost(const ExperimentContext& context);
void run_hard_cases(const ExperimentContext& context);
void run_pictures(const ExperimentContext& context);
void run_w_sign(const ExperimentContext& context);

}  // namespace clipscope::experiments
