// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of a run, written as its experiments get them, one experiment after the other.
//
// Each call commits one transaction and is on the disk when it returns; a process killed in between
// loses what it had not finished. For one thread.
#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/store/piece_record.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

class RunRecorder {
 public:
  // In memory, for an experiment without a name.
  RunRecorder();
  // Pre-condition: the database is a store (see database.hpp).
  RunRecorder(std::shared_ptr<SQLite::Database> database, std::filesystem::path file);

  const ResultsStore& store() const { return store_; }
  // The name of the one in work.
  const std::string& experiment() const { return experiment_; }

  // All following: OutputError with path and reason if the store can't be written; nothing is
  // changed then.

  // What follows belongs to this experiment. position: where it stands among the experiments.
  void begin(const StoredExperiment& experiment, std::int64_t position);
  // It is done; seconds: since begin.
  void finish(double seconds);

  // From now on the run does every count-th piece of each experiment, from piece `index` on.
  void keep_to_pieces(std::size_t index, std::size_t count);
  // Whether it does some pieces alone: then its tables are parts.
  bool is_part() const { return piece_count_ > 1; }
  // Asked once for each piece, in their order: whether this run does it.
  bool takes_next_piece() { return next_piece_++ % piece_count_ == piece_index_; }

  // If the experiment has the piece: adds its rows to the tables. A piece whose pictures are gone
  // from the folder is forgotten.
  bool restore(const std::string& piece, std::initializer_list<Table*> tables,
               const std::filesystem::path& folder);
  // Does the work, then stores the rows that it added to the tables, and its record.
  // Errors: OutputError for a table or column whose name the store needs itself, a table of another
  // experiment's, and columns that aren't what they were.
  void record(const std::string& piece, std::initializer_list<Table*> tables,
              const std::function<void(PieceRecord&)>& work);

  // The whole table: rows that belong to no piece, title and notes, too.
  void add(const Table& table);
  // All rows of these tables anew, in one transaction. complete: as StoredTable has it.
  // Pre-condition: no piece has rows in them.
  void replace(std::initializer_list<const Table*> tables, bool complete);
  void add(const StoredFigure& figure);
  void set_finding(const std::string& sentence);

  // A table that was added as a whole, by this process or one before it.
  std::optional<Table> added(const std::string& table_name) const;

 private:
  struct Rows {  // of a table, that a piece has added
    std::size_t first, count;
  };

  // id: the piece; empty for what belongs to none.
  void write(const std::string& sql, const std::vector<Cell>& values);
  void restore_rows(const std::string& piece, const Cell& id, Table& table);
  Cell number_of_piece() const;
  void insert_record(const PieceRecord& record, const Cell& id);
  void insert_figure(const StoredFigure& figure, const Cell& id);
  void insert_rows(const Table& table, Rows rows, const Cell& id);
  void create_table(const Table& table);
  void declare(const Table& table, bool complete);
  void check_names(const Table& table) const;

  std::shared_ptr<SQLite::Database> database_;
  ResultsStore store_;
  std::string experiment_;
  bool was_finished_ = false;
  std::int64_t position_ = 0;
  std::size_t piece_index_ = 0, piece_count_ = 1, next_piece_ = 0;
  double restored_seconds_ = 0;                    // of pieces, spent before this process
  std::map<std::string, std::vector<Rows>> rows_;  // by table: the rows that pieces have added
};

}  // namespace clipscope::experiments
