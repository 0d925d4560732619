// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/run_recorder.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/store/database.hpp"
#include "experiments/store/schema.hpp"

namespace clipscope::experiments {
namespace {

// Does the work in a transaction; it counts as a whole or not at all.
template <class Work>
void in_transaction(SQLite::Database& database, Work&& work) {
  with_reasons<OutputError>(database, [&] {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    work();
    transaction.commit();
  });
}

std::int64_t as_count(std::size_t number) { return static_cast<std::int64_t>(number); }

}  // namespace

RunRecorder::RunRecorder() : RunRecorder(create_database({}, {}), {}) {
  begin({"unnamed", "", "", "", 0, false}, 0);
}

RunRecorder::RunRecorder(std::shared_ptr<SQLite::Database> database, std::filesystem::path file)
    : database_(std::move(database)), store_(database_, std::move(file)) {}

void RunRecorder::write(const std::string& sql, const Cells& values) {
  in_transaction(*database_, [&] { execute(*database_, sql, values); });
}

void RunRecorder::begin(const StoredExperiment& experiment, std::int64_t position) {
  experiment_ = experiment.name;
  restored_seconds_ = 0;
  rows_.clear();
  next_piece_ = 0;
  position_ = position;
  was_finished_ = false;
  for (const StoredExperiment& e : store_.experiments()) {
    was_finished_ |= e.name == experiment_ && e.finished;
  }
  if (was_finished_) return;
  write(
      "INSERT INTO experiment(name, position, question, command, state) VALUES(?, ?, ?, ?, 'running') ON CONFLICT(name) DO NOTHING",
      {experiment.name, position, experiment.question, experiment.command});
}

void RunRecorder::keep_to_pieces(std::size_t index, std::size_t count) {
  piece_index_ = index;
  piece_count_ = count;
}

void RunRecorder::finish(double seconds) {
  if (was_finished_) return;
  write("UPDATE experiment SET state = 'finished', seconds = ? WHERE name = ?",
        {restored_seconds_ + seconds, experiment_});
}

bool RunRecorder::restore(const std::string& piece, std::initializer_list<Table*> tables,
                          const std::filesystem::path& folder) {
  return with_reasons<OutputError>(*database_, [&] {
    const auto found =
        rows(*database_, "SELECT id, seconds FROM cell WHERE experiment = ? AND name = ?",
             {experiment_, piece});
    if (found.empty()) return false;
    const Cell& id = found[0][0];
    for (const auto& file :
         rows<std::string, 1>(*database_, "SELECT file FROM figure WHERE cell_id = ?", {id})) {
      std::error_code ignored;
      if (std::filesystem::exists(folder / file, ignored)) continue;
      write("DELETE FROM cell WHERE id = ?", {id});
      return false;
    }
    for (Table* table : tables) restore_rows(piece, id, *table);
    restored_seconds_ += std::get<double>(found[0][1]);
    return true;
  });
}

void RunRecorder::restore_rows(const std::string& piece, const Cell& id, Table& table) {
  if (!store_.has_table(table.name())) return;  // no piece has added rows to it
  const std::size_t first = table.rows().size();
  for (Cells& cells :
       rows(*database_,
            fmt::format("SELECT {}, row_number FROM {} WHERE cell_id = ? ORDER BY row_number",
                        sql_keys(table), double_quoted(table.name())),
            {id})) {
    if (cells.back() != Cell(as_count(table.rows().size()))) {
      throw OutputError(fmt::format(
          "{}: the rows of piece '{}' of {} stand elsewhere in table {} than they did; run {} anew, without --resume",
          store_.file().string(), piece, experiment_, table.name(), experiment_));
    }
    cells.pop_back();
    table.add_row(std::move(cells));
  }
  rows_[table.name()].push_back({first, table.rows().size() - first});
}

void RunRecorder::record(const std::string& piece, std::initializer_list<Table*> tables,
                         const std::function<void(PieceRecord&)>& work) {
  std::vector<std::size_t> before;
  for (const Table* table : tables) {
    check_names(*table);
    before.push_back(table->rows().size());
  }
  PieceRecord record;
  const auto start = std::chrono::steady_clock::now();
  work(record);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  in_transaction(*database_, [&] {
    insert(*database_, "cell", {number_of_piece(), experiment_, piece, time.count(), date_now()});
    const std::int64_t id = database_->getLastInsertRowid();
    insert_record(record, id);
    for (auto first = before.begin(); const Table* table : tables) {
      const Rows rows{*first, table->rows().size() - *first};
      declare(*table, false);
      insert_rows(*table, rows, id);
      rows_[table->name()].push_back(rows);
      ++first;
    }
  });
}

// The same in every part of a run, so that parts can be put together; else the next one.
Cell RunRecorder::number_of_piece() const {
  constexpr std::int64_t kMostPieces = 1'000'000;  // of an experiment
  if (!is_part()) return {};
  return position_ * kMostPieces + as_count(next_piece_);
}

void RunRecorder::insert_record(const PieceRecord& record, const Cell& id) {
  for (const auto& [series, unit, values] : record.samples) {
    std::int64_t position = 0;
    for (const double value : values) {
      insert(*database_, "sample", {id, series, unit, position++, value});
    }
  }
  for (const WorstInput& w : record.worst_inputs) {
    insert(*database_, "worst_input",
           {id, w.clipper, w.scalar, w.measure, w.error, w.input, w.replay});
  }
  for (const Picture& picture : record.pictures) {
    insert_figure({FigureKind::picture, picture.file, "", picture.caption}, id);
  }
}

void RunRecorder::insert_figure(const StoredFigure& figure, const Cell& id) {
  const char* kind = figure.kind == FigureKind::plot ? "plot" : "picture";
  execute(
      *database_,
      "INSERT OR REPLACE INTO figure(cell_id, experiment, kind, file, title, caption) VALUES(?, ?, ?, ?, ?, ?)",
      {id, experiment_, kind, figure.file, figure.title, figure.caption});
}

void RunRecorder::add(const StoredFigure& figure) {
  in_transaction(*database_, [&] { insert_figure(figure, {}); });
}

void RunRecorder::check_names(const Table& table) const {
  const auto refuse = [&](const std::string& reason) {
    throw OutputError(
        fmt::format("table '{}' of experiment {}: {}", table.name(), experiment_, reason));
  };
  // SQL compares names without regard to their case.
  const std::string name = lower_case(table.name());
  if (std::string_view(kSchema).find("CREATE TABLE " + name + "(") != std::string_view::npos ||
      name.empty() || name.starts_with("sqlite_")) {
    refuse("the results store needs that name for itself");
  }
  std::set<std::string> keys;
  for (const Column& column : table.columns()) {
    const std::string key = lower_case(column.key);
    if (key == "cell_id" || key == "row_number") {
      refuse(fmt::format("the results store needs the column key '{}' for itself", column.key));
    }
    if (!keys.insert(key).second) refuse(fmt::format("has two columns '{}'", column.key));
  }
  for (const StoredTable& other : store_.tables()) {
    if (lower_case(other.name) != name) continue;
    if (other.experiment != experiment_) {
      refuse(fmt::format("experiment {} has a table of that name", other.experiment));
    }
    if (!std::ranges::equal(store_.columns(other.name), table.columns(), {}, &Column::key,
                            &Column::key)) {
      refuse("was stored with other columns");
    }
  }
}

// Pre-condition: check_names.
void RunRecorder::create_table(const Table& table) {
  // No types, so that a value stays what it is.
  execute(
      *database_,
      fmt::format(
          "CREATE TABLE {}({}, cell_id INTEGER REFERENCES cell(id) ON DELETE CASCADE, row_number INTEGER PRIMARY KEY)",
          double_quoted(table.name()), sql_keys(table)));
  std::int64_t position = 0;
  for (const auto& [key, head, wrap] : table.columns()) {
    insert(*database_, "result_column", {table.name(), position++, key, head, as_count(wrap)});
  }
}

// Title and notes as they are now. complete: all rows are there.
void RunRecorder::declare(const Table& table, bool complete) {
  const bool is_new = !store_.has_table(table.name());
  execute(
      *database_,
      "INSERT INTO result_table(name, experiment, position, title, complete) VALUES(?, ?, (SELECT count(*) FROM result_table), ?, ?) ON CONFLICT(name) DO UPDATE SET title = excluded.title, complete = excluded.complete",
      {table.name(), experiment_, table.title(), std::int64_t{complete}});
  if (is_new) create_table(table);
  execute(*database_, "DELETE FROM note WHERE table_name = ?", {table.name()});
  std::int64_t position = 0;
  for (const std::string& note : table.notes()) {
    insert(*database_, "note", {table.name(), position++, note});
  }
}

void RunRecorder::insert_rows(const Table& table, Rows rows, const Cell& id) {
  for (std::size_t r = rows.first; r < rows.first + rows.count; ++r) {
    Cells cells = table.rows()[r];
    cells.insert(cells.end(), {id, as_count(r)});
    insert(*database_, table.name(), cells);
  }
}

void RunRecorder::add(const Table& table) {
  check_names(table);
  in_transaction(*database_, [&] {
    declare(table, true);
    execute(*database_, "DELETE FROM " + double_quoted(table.name()) + " WHERE cell_id IS NULL");
    std::size_t next = 0;
    for (const Rows& of_cell : rows_[table.name()]) {
      insert_rows(table, {next, of_cell.first - next}, {});
      next = of_cell.first + of_cell.count;
    }
    insert_rows(table, {next, table.rows().size() - next}, {});
  });
}

void RunRecorder::replace(std::initializer_list<const Table*> tables, bool complete) {
  for (const Table* table : tables) check_names(*table);
  in_transaction(*database_, [&] {
    for (const Table* table : tables) {
      declare(*table, complete);
      execute(*database_, "DELETE FROM " + double_quoted(table->name()));
      insert_rows(*table, {0, table->rows().size()}, {});
    }
  });
}

void RunRecorder::set_finding(const std::string& sentence) {
  write("UPDATE experiment SET finding = ? WHERE name = ?", {sentence, experiment_});
}

std::optional<Table> RunRecorder::added(const std::string& table_name) const {
  for (const StoredTable& table : store_.tables()) {
    if (table.name == table_name && table.complete) return store_.table(table_name);
  }
  return std::nullopt;
}

}  // namespace clipscope::experiments
