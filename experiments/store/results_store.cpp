// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/results_store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/errors.hpp"
#include "experiments/store/database.hpp"

namespace clipscope::experiments {
namespace {

std::filesystem::path store_of(const std::filesystem::path& file_or_folder) {
  std::error_code ignored;
  return std::filesystem::is_directory(file_or_folder, ignored) ? file_or_folder / kStoreFile
                                                                : file_or_folder;
}

std::string text(const SQLite::Statement& row, int column) {
  return row.getColumn(column).getString();
}

// Calls take(row) for each row of the query. Errors: InputError.
template <class Take>
void for_each_row(const SQLite::Database& database, const std::string& query,
                  const std::vector<std::string>& parameters, Take&& take) {
  with_reasons<InputError>(database, [&] {
    SQLite::Statement statement(database, query);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      statement.bind(static_cast<int>(i) + 1, parameters[i]);
    }
    while (statement.executeStep()) take(statement);
  });
}

std::vector<Column> columns_of(const SQLite::Database& database, const std::string& table) {
  std::vector<Column> columns;
  for_each_row(database,
               "SELECT key, head, wrap FROM result_column WHERE table_name = ? ORDER BY position",
               {table}, [&](const SQLite::Statement& row) {
                 columns.push_back({text(row, 0), text(row, 1),
                                    static_cast<std::size_t>(row.getColumn(2).getInt64())});
               });
  return columns;
}

void read_rows(const SQLite::Database& database, Table& table) {
  std::vector<std::string> keys;
  for (const Column& column : table.columns()) keys.push_back(sql_name(column.key));
  for_each_row(database,
               fmt::format("SELECT {} FROM {} ORDER BY row_number", fmt::join(keys, ", "),
                           sql_name(table.name())),
               {}, [&](const SQLite::Statement& row) {
                 std::vector<Cell> cells;
                 for (int c = 0; c < row.getColumnCount(); ++c) {
                   cells.push_back(cell_of(row.getColumn(c)));
                 }
                 table.add_row(std::move(cells));
               });
}

}  // namespace

ResultsStore::ResultsStore(const std::filesystem::path& file_or_folder)
    : ResultsStore(open_database(store_of(file_or_folder)), store_of(file_or_folder)) {}

ResultsStore::ResultsStore(std::shared_ptr<SQLite::Database> database, std::filesystem::path file)
    : database_(std::move(database)), file_(std::move(file)) {}

RunInfo ResultsStore::run_info() const {
  RunInfo info;
  for_each_row(
      *database_, "SELECT key, value FROM run ORDER BY rowid", {},
      [&](const SQLite::Statement& row) { info.emplace_back(text(row, 0), text(row, 1)); });
  return info;
}

std::vector<StoredExperiment> ResultsStore::experiments() const {
  std::vector<StoredExperiment> experiments;
  for_each_row(
      *database_,
      "SELECT name, question, command, ifnull(finding, ''), ifnull(seconds, 0.0), "
      "state = 'finished' FROM experiment ORDER BY position, name",
      {}, [&](const SQLite::Statement& row) {
        experiments.push_back({text(row, 0), text(row, 1), text(row, 2), text(row, 3),
                               row.getColumn(4).getDouble(), row.getColumn(5).getInt() != 0});
      });
  return experiments;
}

std::vector<StoredTable> ResultsStore::tables() const {
  std::vector<StoredTable> tables;
  for_each_row(*database_,
               "SELECT t.name, t.experiment, t.title, t.complete FROM result_table t "
               "JOIN experiment e ON e.name = t.experiment ORDER BY e.position, t.position",
               {}, [&](const SQLite::Statement& row) {
                 tables.push_back(
                     {text(row, 0), text(row, 1), text(row, 2), 0, row.getColumn(3).getInt() != 0});
               });
  for (StoredTable& table : tables) {
    for_each_row(*database_, "SELECT count(*) FROM " + sql_name(table.name), {},
                 [&](const SQLite::Statement& row) {
                   table.rows = static_cast<std::size_t>(row.getColumn(0).getInt64());
                 });
  }
  return tables;
}

std::vector<std::string> ResultsStore::table_names(const std::string& experiment) const {
  std::vector<std::string> names;
  for_each_row(*database_, "SELECT name FROM result_table WHERE experiment = ? ORDER BY position",
               {experiment}, [&](const SQLite::Statement& row) { names.push_back(text(row, 0)); });
  return names;
}

std::vector<Column> ResultsStore::columns(const std::string& table_name) const {
  return columns_of(*database_, table_name);
}

bool ResultsStore::has_table(const std::string& name) const {
  bool found = false;
  for_each_row(*database_, "SELECT 1 FROM result_table WHERE name = ?", {name},
               [&](const SQLite::Statement&) { found = true; });
  return found;
}

Table ResultsStore::table(const std::string& name) const {
  if (!has_table(name)) {
    std::vector<std::string> names;
    for (const StoredTable& table : tables()) names.push_back(table.name);
    throw UsageError(fmt::format("{}: has no table '{}'; it has: {}", file_.string(), name,
                                 fmt::join(names, ", ")));
  }
  std::string stored_name, title;
  for_each_row(*database_, "SELECT name, title FROM result_table WHERE name = ?", {name},
               [&](const SQLite::Statement& row) {
                 stored_name = text(row, 0);
                 title = text(row, 1);
               });
  Table table(stored_name, title, columns(name));
  read_rows(*database_, table);
  for_each_row(*database_, "SELECT text FROM note WHERE table_name = ? ORDER BY position", {name},
               [&](const SQLite::Statement& row) { table.add_note(text(row, 0)); });
  return table;
}

std::vector<StoredFigure> ResultsStore::figures(const std::string& experiment) const {
  std::vector<StoredFigure> figures;
  for_each_row(
      *database_,
      "SELECT kind = 'plot', file, title, caption FROM figure WHERE experiment = ? "
      "ORDER BY kind = 'picture', rowid",
      {experiment}, [&](const SQLite::Statement& row) {
        figures.push_back({row.getColumn(0).getInt() != 0 ? FigureKind::plot : FigureKind::picture,
                           text(row, 1), text(row, 2), text(row, 3)});
      });
  return figures;
}

std::vector<WorstInput> ResultsStore::worst_inputs(const std::string& experiment) const {
  std::vector<WorstInput> inputs;
  for_each_row(*database_,
               "SELECT w.clipper, w.scalar, w.measure, w.error, w.input, w.replay "
               "FROM worst_input w JOIN cell c ON c.id = w.cell_id WHERE c.experiment = ? "
               "ORDER BY w.rowid",
               {experiment}, [&](const SQLite::Statement& row) {
                 const Cell error = cell_of(row.getColumn(3));
                 const auto* number = std::get_if<double>(&error);
                 inputs.push_back({text(row, 0), text(row, 1), text(row, 2),
                                   number != nullptr ? *number : 0.0, text(row, 4), text(row, 5)});
               });
  return inputs;
}

}  // namespace clipscope::experiments
