// SPDX-License-Identifier: GPL-3.0-or-later
//
// Experiments: one folder each, each answering one question with tables and pictures.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/report/plot.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/table/table.hpp"

namespace clipscope::experiments {

class RunRecorder;  // experiments/store/run_recorder.hpp

// What an experiment is given and where its results go.
class ExperimentContext {
 public:
  // results: the folder of the run. The recorder says which experiment it is. Without one the files
  // are written, and all else is kept in memory.
  ExperimentContext(Selection selection, std::filesystem::path results,
                    std::shared_ptr<RunRecorder> recorder = nullptr);

  const Selection& selection() const { return selection_; }
  // The folder of the experiment's files, in that of the run and called as the experiment is.
  std::filesystem::path out() const;

  // One piece of the experiment's work, done once per run. What `work` adds to the tables and to
  // its record is stored in one transaction when it returns. A resumed run that finds the piece
  // stored puts its rows into the tables and does not call `work`.
  // name: unique within the experiment; the same for the same options.
  // Pre-condition: `work` has no effect but on those tables, its record and pictures in out().
  void piece(const std::string& name, std::initializer_list<Table*> tables,
             const std::function<void(PieceRecord&)>& work) const;

  // Writes the table's files at once and prints it where that was asked for (Selection::tables, or
  // as one line of JSON).
  void emit(const Table& table) const;
  // Draws the plot. Made anew from tables by a resumed run, so it belongs after the pieces.
  void emit(const Plot& plot) const;
  // Several of either, one after the other.
  template <class First, class Second, class... Rest>
  void emit(const First& first, const Second& second, const Rest&... rest) const {
    emit(first);
    emit(second, rest...);
  }
  // Notes that a file was written: NAME.EXT, or NAME.{EXT,EXT} for several.
  void emit_file(const std::filesystem::path& path) const;
  // Says on standard output which files were written since this was last called.
  void tell_files() const;
  // One or two sentences that answer the experiment's question, with the figures that decide it.
  // Where it timed something while the machine was busy, that is added.
  void finding(const std::string& sentence) const;
  // Runs under the clock of the experiment that a table belongs to; none if there is no such table.
  Interruptions interruptions(const std::string& table_name) const;

  // A table that an experiment of this run has emitted; nothing if none did.
  std::optional<Table> emitted(const std::string& table_name) const;

 private:
  // A file of out(), as the store names it.
  std::string in_results(const std::string& file) const;

  Selection selection_;
  std::filesystem::path results_;
  std::shared_ptr<RunRecorder> recorder_;
  mutable std::vector<std::string> written_;  // names in out() that were not told yet
};

// Each folder of a question defines one in its namespace, as
// `extern constinit const Experiment kExperiment`.
struct Experiment {
  std::string_view name;      // its folder
  std::string_view question;  // one line
  void (*run)(const ExperimentContext&);
};

}  // namespace clipscope::experiments
