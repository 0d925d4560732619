// SPDX-License-Identifier: GPL-3.0-or-later
//
// Experiments: one folder each beside this file, each answering one question with tables and pictures.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "experiments/commands/selection.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

class RunRecorder;  // experiments/store/run_recorder.hpp

// What an experiment is given and where its results go.
class ExperimentContext {
 public:
  // Without a store: the files are written, all else is kept in memory.
  ExperimentContext(Selection selection, std::filesystem::path out);
  // The recorder says which experiment it is.
  ExperimentContext(Selection selection, std::filesystem::path out,
                    std::shared_ptr<RunRecorder> recorder);

  const Selection& selection() const { return selection_; }
  // The folder for pictures.
  const std::filesystem::path& out() const { return out_; }

  // One piece of the experiment's work, done once per run. What `work` adds to the tables and to its
  // record is stored in one transaction when it returns. A resumed run that finds the cell stored puts
  // its rows into the tables and does not call `work`.
  // name: unique within the experiment; the same for the same options.
  // Pre-condition: `work` has no effect but on those tables, its record and picture files.
  void cell(const std::string& name, std::initializer_list<Table*> tables,
            const std::function<void(CellRecord&)>& work) const;

  // Writes the table's files at once and prints it (as one line of JSON if that was asked for).
  void emit(const Table& table) const;
  // Draws the plot and says on standard output that its files were written. Made anew from tables by a
  // resumed run, so it belongs after the cells.
  void emit(const Plot& plot) const;
  // Says on standard output that a file was written.
  void emit_file(const std::filesystem::path& path) const;
  // One or two sentences that answer the experiment's question, with the figures that decide it.
  void finding(const std::string& sentence) const;

  // A table that an experiment of this run has emitted; nothing if none did.
  std::optional<Table> emitted(const std::string& table_name) const;

 private:
  Selection selection_;
  std::filesystem::path out_;
  std::shared_ptr<RunRecorder> recorder_;
};

struct Experiment {
  std::string_view name;      // its folder
  std::string_view question;  // one line
  void (*run)(const ExperimentContext&);
};

// In the order in which `clipscope run` runs them.
std::span<const Experiment> all_experiments();

void run_accuracy(const ExperimentContext& context);
void run_attributes(const ExperimentContext& context);
void run_bounds(const ExperimentContext& context);
void run_budget(const ExperimentContext& context);
void run_claims(const ExperimentContext& context);
void run_cost(const ExperimentContext& context);
void run_depth(const ExperimentContext& context);
void run_effects(const ExperimentContext& context);
void run_frontier(const ExperimentContext& context);
void run_guard_band(const ExperimentContext& context);
void run_hard_cases(const ExperimentContext& context);
void run_perspective(const ExperimentContext& context);
void run_pictures(const ExperimentContext& context);
void run_plane_order(const ExperimentContext& context);
void run_segments(const ExperimentContext& context);
void run_w_sign(const ExperimentContext& context);
void run_watertight(const ExperimentContext& context);

}  // namespace clipscope::experiments
