// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of a run, read: one SQLite file per results folder, DIR/results.sqlite.
//
// What is read is what was committed: of a run in work or one that was killed, all that was
// finished. experiments/store/schema.hpp describes the tables of the file.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/store/piece_record.hpp"
#include "experiments/table/table.hpp"

namespace SQLite {
class Database;
}

namespace clipscope::experiments {

inline constexpr const char* kStoreFile = "results.sqlite";

// machine, measuring, compiler, flags, version, commit, seed, started (UTC, ISO 8601), options
// (JSON), command: in the order in which people read them.
using RunInfo = std::vector<std::pair<std::string, std::string>>;

// The value of a key; empty if there is none.
std::string value_of(const RunInfo& info, const std::string& key);

struct StoredExperiment {
  std::string name;      // its folder
  std::string question;  // one line
  std::string command;   // that does it again
  std::string finding;   // empty if there is none yet
  double seconds = 0;    // 0 if it isn't finished
  bool finished = false;
};

enum class FigureKind { plot, picture };

struct StoredFigure {
  FigureKind kind = FigureKind::plot;
  std::string file;  // relative to the results folder; of a plot the SVG, beside it a PDF and a PNG
  std::string title;    // empty for pictures
  std::string caption;  // what is to be seen
};

struct StoredTable {
  std::string name, experiment, title;
  std::size_t rows = 0;
  bool complete = false;  // false: the run ended, or is, between its pieces
};

class ResultsStore {
 public:
  // Opens the file, or that of the folder, to read it.
  // Errors: InputError with path and reason if there is none, if it is no store, or one of another
  // version.
  explicit ResultsStore(const std::filesystem::path& file_or_folder);
  // Reads through a connection that somebody else writes through.
  ResultsStore(std::shared_ptr<SQLite::Database> database, std::filesystem::path file);

  const std::filesystem::path& file() const { return file_; }

  // All following: InputError if the file is damaged.
  RunInfo run_info() const;
  // In the order of `clipscope list experiments`.
  std::vector<StoredExperiment> experiments() const;
  // In the order in which they were first stored, by experiment.
  std::vector<StoredTable> tables() const;
  bool has_table(const std::string& name) const;
  // The columns of that table; none if there is no such table.
  std::vector<Column> columns(const std::string& table_name) const;
  // With its title, notes, and values to the bit. Errors: UsageError listing the names if there is
  // none.
  Table table(const std::string& name) const;
  // Plots, then pictures.
  std::vector<StoredFigure> figures(const std::string& experiment) const;
  std::vector<WorstInput> worst_inputs(const std::string& experiment) const;
  // Runs under the clock of an experiment; of all of them if none is named.
  Interruptions interruptions(const std::string& experiment = "") const;

 private:
  template <class Row, std::size_t kColumns>
  std::vector<Row> read(const std::string& sql, const std::vector<Cell>& values = {}) const;

  std::shared_ptr<SQLite::Database> database_;
  std::filesystem::path file_;
};

}  // namespace clipscope::experiments
