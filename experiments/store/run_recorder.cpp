// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/run_recorder.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <strings.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "experiments/errors.hpp"
#include "experiments/store/database.hpp"
#include "experiments/store/date.hpp"
#include "experiments/store/schema.hpp"

namespace clipscope::experiments {
namespace {

// SQL does not tell "Cell" from "cell".
bool equal_in_sql(std::string_view a, std::string_view b) {
  return a.size() == b.size() && strncasecmp(a.data(), b.data(), a.size()) == 0;
}

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::ranges::any_of(names, [&](std::string_view n) { return equal_in_sql(n, name); });
}

// Binds the values to the statement's parameters in order and executes it.
template <class... Values>
void execute(SQLite::Statement& statement, const Values&... values) {
  int index = 0;
  (statement.bind(++index, values), ...);
  statement.exec();
  statement.reset();
}

template <class... Values>
void execute(SQLite::Database& database, const char* sql, const Values&... values) {
  SQLite::Statement statement(database, sql);
  execute(statement, values...);
}

void bind_cell_id(SQLite::Statement& statement, int index, std::optional<std::int64_t> cell) {
  if (cell) {
    statement.bind(index, *cell);
  } else {
    statement.bind(index);
  }
}

std::vector<std::string> sql_keys(const Table& table) {
  std::vector<std::string> keys;
  for (const Column& column : table.columns()) keys.push_back(sql_name(column.key));
  return keys;
}

// Does the work in a transaction; it counts as a whole or not at all.
template <class Work>
void in_transaction(SQLite::Database& database, Work&& work) {
  with_reasons<OutputError>(database, [&] {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    work();
    transaction.commit();
  });
}

}  // namespace

RunRecorder::RunRecorder() : RunRecorder(create_database({}, {}), {}) {
  begin({"unnamed", "", "", "", 0, false}, 0);
}

RunRecorder::RunRecorder(std::shared_ptr<SQLite::Database> database, std::filesystem::path file)
    : database_(std::move(database)), store_(database_, std::move(file)) {}

void RunRecorder::begin(const StoredExperiment& experiment, std::int64_t position) {
  experiment_ = experiment.name;
  restored_seconds_ = 0;
  rows_.clear();
  const auto stored = store_.experiments();
  was_finished_ = std::ranges::any_of(
      stored, [&](const StoredExperiment& e) { return e.name == experiment.name && e.finished; });
  if (was_finished_) return;
  in_transaction(*database_, [&] {
    execute(*database_,
            "INSERT INTO experiment(name, position, question, command, state) "
            "VALUES(?, ?, ?, ?, 'running') ON CONFLICT(name) DO NOTHING",
            experiment.name, position, experiment.question, experiment.command);
  });
}

void RunRecorder::finish(double seconds) {
  if (was_finished_) return;
  in_transaction(*database_, [&] {
    execute(*database_, "UPDATE experiment SET state = 'finished', seconds = ? WHERE name = ?",
            restored_seconds_ + seconds, experiment_);
  });
}

bool RunRecorder::has_pictures(std::int64_t cell, const std::filesystem::path& folder) const {
  SQLite::Statement pictures(*database_, "SELECT file FROM figure WHERE cell_id = ?");
  pictures.bind(1, cell);
  while (pictures.executeStep()) {
    std::error_code ignored;
    const std::string file = pictures.getColumn(0).getString();
    if (!std::filesystem::exists(folder / file, ignored)) return false;
  }
  return true;
}

bool RunRecorder::restore(const std::string& cell, std::initializer_list<Table*> tables,
                          const std::filesystem::path& folder) {
  return with_reasons<OutputError>(*database_, [&] {
    SQLite::Statement find(*database_,
                           "SELECT id, seconds FROM cell WHERE experiment = ? AND name = ?");
    find.bind(1, experiment_);
    find.bind(2, cell);
    if (!find.executeStep()) return false;
    const std::int64_t id = find.getColumn(0).getInt64();
    const double seconds = find.getColumn(1).getDouble();
    find.reset();
    if (!has_pictures(id, folder)) {
      in_transaction(*database_, [&] { execute(*database_, "DELETE FROM cell WHERE id = ?", id); });
      return false;
    }
    for (Table* table : tables) restore_rows(cell, id, *table);
    restored_seconds_ += seconds;
    return true;
  });
}

void RunRecorder::restore_rows(const std::string& name, std::int64_t cell, Table& table) {
  if (!store_.has_table(table.name())) return;  // no cell has added rows to it
  const std::size_t first = table.rows().size();
  SQLite::Statement rows(
      *database_, fmt::format("SELECT row_number, {} FROM {} WHERE cell_id = ? ORDER BY row_number",
                              fmt::join(sql_keys(table), ", "), sql_name(table.name())));
  rows.bind(1, cell);
  while (rows.executeStep()) {
    if (rows.getColumn(0).getInt64() != static_cast<std::int64_t>(table.rows().size())) {
      throw OutputError(
          fmt::format("{}: the rows of cell '{}' of {} stand elsewhere in table {} than they did; "
                      "run {} anew, without --resume",
                      store_.file().string(), name, experiment_, table.name(), experiment_));
    }
    std::vector<Cell> cells;
    for (int c = 1; c < rows.getColumnCount(); ++c) cells.push_back(cell_of(rows.getColumn(c)));
    table.add_row(std::move(cells));
  }
  rows_[table.name()].push_back({first, table.rows().size() - first});
}

void RunRecorder::record(const std::string& cell, std::initializer_list<Table*> tables,
                         const std::function<void(CellRecord&)>& work) {
  for (const Table* table : tables) check_names(*table);
  std::vector<std::size_t> before;
  for (const Table* table : tables) before.push_back(table->rows().size());
  CellRecord record;
  const auto start = std::chrono::steady_clock::now();
  work(record);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  in_transaction(*database_, [&] {
    const std::int64_t id = insert_cell(cell, seconds);
    insert_record(id, record);
    for (std::size_t i = 0; i < tables.size(); ++i) {
      const Table& table = **(tables.begin() + i);
      const Rows rows{before[i], table.rows().size() - before[i]};
      declare(table, false);
      insert_rows(table, rows, id);
      rows_[table.name()].push_back(rows);
    }
  });
}

std::int64_t RunRecorder::insert_cell(const std::string& name, double seconds) {
  execute(*database_, "INSERT INTO cell(experiment, name, seconds, finished) VALUES(?, ?, ?, ?)",
          experiment_, name, seconds, date_now());
  return database_->getLastInsertRowid();
}

void RunRecorder::insert_record(std::int64_t cell, const CellRecord& record) {
  SQLite::Statement sample(*database_,
                           "INSERT INTO sample(cell_id, series, unit, position, value) "
                           "VALUES(?, ?, ?, ?, ?)");
  for (const Samples& samples : record.samples) {
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
      sample.bind(1, cell);
      sample.bind(2, samples.series);
      sample.bind(3, samples.unit);
      sample.bind(4, static_cast<std::int64_t>(i));
      bind_cell(sample, 5, samples.values[i]);
      sample.exec();
      sample.reset();
    }
  }
  SQLite::Statement worst(*database_,
                          "INSERT INTO worst_input(cell_id, clipper, scalar, measure, input, "
                          "replay, error) VALUES(?, ?, ?, ?, ?, ?, ?)");
  for (const WorstInput& w : record.worst_inputs) {
    bind_cell(worst, 7, w.error);
    execute(worst, cell, w.clipper, w.scalar, w.measure, w.input, w.replay);
  }
  for (const Picture& picture : record.pictures) {
    insert_figure({FigureKind::picture, picture.file, "", picture.caption}, cell);
  }
}

void RunRecorder::check_names(const Table& table) const {
  const auto refuse = [&](const std::string& reason) {
    throw OutputError(
        fmt::format("table '{}' of experiment {}: {}", table.name(), experiment_, reason));
  };
  if (contains(kStoreTables, table.name()) || table.name().empty() ||
      equal_in_sql(table.name().substr(0, 7), "sqlite_")) {
    refuse("the results store needs that name for itself");
  }
  std::set<std::string> keys;
  for (const Column& column : table.columns()) {
    std::string key = column.key;
    std::ranges::transform(key, key.begin(), [](unsigned char c) { return std::tolower(c); });
    if (contains(kStoreColumns, key)) {
      refuse(fmt::format("the results store needs the column key '{}' for itself", column.key));
    }
    if (!keys.insert(key).second) refuse(fmt::format("has two columns '{}'", column.key));
  }
  for (const StoredTable& other : store_.tables()) {
    if (!equal_in_sql(other.name, table.name())) continue;
    if (other.experiment != experiment_) {
      refuse(fmt::format("experiment {} has a table of that name", other.experiment));
    }
    if (!std::ranges::equal(store_.columns(table.name()), table.columns(),
                            [](const Column& a, const Column& b) { return a.key == b.key; })) {
      refuse("was stored with other columns");
    }
  }
}

// Pre-condition: check_names.
void RunRecorder::create_table(const Table& table) {
  const std::vector<std::string> keys = sql_keys(table);
  // No types, so that a value stays what it is.
  database_->exec(
      fmt::format("CREATE TABLE {}({}, cell_id INTEGER REFERENCES cell(id) ON DELETE CASCADE, "
                  "row_number INTEGER PRIMARY KEY)",
                  sql_name(table.name()), fmt::join(keys, ", ")));
  SQLite::Statement insert(
      *database_,
      "INSERT INTO result_column(table_name, position, key, head, wrap) VALUES(?, ?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const Column& column : table.columns()) {
    execute(insert, table.name(), position++, column.key, column.head,
            static_cast<std::int64_t>(column.wrap));
  }
}

// Title and notes as they are now. complete: all rows are there.
void RunRecorder::declare(const Table& table, bool complete) {
  const bool is_new = !store_.has_table(table.name());
  execute(*database_,
          "INSERT INTO result_table(name, experiment, position, title, complete) "
          "VALUES(?, ?, (SELECT count(*) FROM result_table), ?, ?) ON CONFLICT(name) DO UPDATE "
          "SET title = excluded.title, complete = excluded.complete",
          table.name(), experiment_, table.title(), std::int64_t{complete});
  if (is_new) create_table(table);
  execute(*database_, "DELETE FROM note WHERE table_name = ?", table.name());
  SQLite::Statement insert(*database_,
                           "INSERT INTO note(table_name, position, text) VALUES(?, ?, ?)");
  std::int64_t position = 0;
  for (const std::string& note : table.notes()) execute(insert, table.name(), position++, note);
}

void RunRecorder::insert_rows(const Table& table, Rows rows, std::optional<std::int64_t> cell) {
  std::string parameters = "?, ?";
  for (std::size_t i = 0; i < table.columns().size(); ++i) parameters += ", ?";
  SQLite::Statement insert(
      *database_,
      fmt::format("INSERT INTO {}(row_number, cell_id, {}) VALUES({})", sql_name(table.name()),
                  fmt::join(sql_keys(table), ", "), parameters));
  for (std::size_t r = rows.first; r < rows.first + rows.count; ++r) {
    insert.bind(1, static_cast<std::int64_t>(r));
    bind_cell_id(insert, 2, cell);
    int index = 3;
    for (const Cell& value : table.rows()[r]) bind_cell(insert, index++, value);
    insert.exec();
    insert.reset();
  }
}

void RunRecorder::add(const Table& table) {
  check_names(table);
  in_transaction(*database_, [&] {
    declare(table, true);
    database_->exec(fmt::format("DELETE FROM {} WHERE cell_id IS NULL", sql_name(table.name())));
    std::size_t next = 0;
    for (const Rows& of_cell : rows_[table.name()]) {
      insert_rows(table, {next, of_cell.first - next}, std::nullopt);
      next = of_cell.first + of_cell.count;
    }
    insert_rows(table, {next, table.rows().size() - next}, std::nullopt);
  });
}

void RunRecorder::insert_figure(const StoredFigure& figure, std::optional<std::int64_t> cell) {
  SQLite::Statement insert(*database_,
                           "INSERT OR REPLACE INTO figure(cell_id, experiment, kind, file, title, "
                           "caption) VALUES(?, ?, ?, ?, ?, ?)");
  bind_cell_id(insert, 1, cell);
  insert.bind(2, experiment_);
  insert.bind(3, figure.kind == FigureKind::plot ? "plot" : "picture");
  insert.bind(4, figure.file);
  insert.bind(5, figure.title);
  insert.bind(6, figure.caption);
  insert.exec();
}

void RunRecorder::add(const StoredFigure& figure) {
  in_transaction(*database_, [&] { insert_figure(figure, std::nullopt); });
}

void RunRecorder::set_finding(const std::string& sentence) {
  in_transaction(*database_, [&] {
    execute(*database_, "UPDATE experiment SET finding = ? WHERE name = ?", sentence, experiment_);
  });
}

std::optional<Table> RunRecorder::added(const std::string& table_name) const {
  for (const StoredTable& table : store_.tables()) {
    if (table.name == table_name && table.complete) return store_.table(table_name);
  }
  return std::nullopt;
}

}  // namespace clipscope::experiments
