// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/results_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "experiments/machine/errors.hpp"
#include "experiments/store/database.hpp"

namespace clipscope::experiments {
namespace {

std::filesystem::path store_of(const std::filesystem::path& file_or_folder) {
  std::error_code ignored;
  return std::filesystem::is_directory(file_or_folder, ignored) ? file_or_folder / kStoreFile
                                                                : file_or_folder;
}

void require_table(const ResultsStore& store, const std::filesystem::path& file,
                   const std::string& name) {
  if (store.has_table(name)) return;
  std::vector<std::string> names;
  for (const StoredTable& table : store.tables()) names.push_back(table.name);
  // A damaged index does not find what a look at every row does.
  if (std::ranges::find(names, name) != names.end()) {
    throw InputError(fmt::format("{}: is damaged: it lists the table '{}', which can't be found",
                                 file.string(), name));
  }
  throw UsageError(fmt::format("{}: has no table '{}'; it has: {}", file.string(), name,
                               fmt::join(names, ", ")));
}

}  // namespace

std::string value_of(const RunInfo& info, const std::string& key) {
  const auto found = std::ranges::find(info, key, &RunInfo::value_type::first);
  return found == info.end() ? "" : found->second;
}

ResultsStore::ResultsStore(const std::filesystem::path& file_or_folder)
    : ResultsStore(open_database(store_of(file_or_folder)), store_of(file_or_folder)) {}

ResultsStore::ResultsStore(std::shared_ptr<SQLite::Database> database, std::filesystem::path file)
    : database_(std::move(database)), file_(std::move(file)) {}

template <class Row, std::size_t kColumns>
std::vector<Row> ResultsStore::read(const std::string& sql, const Cells& values) const {
  return with_reasons<InputError>(*database_,
                                  [&] { return rows<Row, kColumns>(*database_, sql, values); });
}

RunInfo ResultsStore::run_info() const {
  return read<RunInfo::value_type, 2>("SELECT key, value FROM run ORDER BY rowid");
}

std::vector<StoredExperiment> ResultsStore::experiments() const {
  return read<StoredExperiment, 6>(
      "SELECT name, question, command, finding, seconds, state = 'finished' FROM experiment ORDER BY position, name");
}

std::vector<StoredTable> ResultsStore::tables() const {
  auto tables = read<StoredTable, 5>(
      "SELECT t.name, t.experiment, t.title, 0, t.complete FROM result_table t JOIN experiment e ON e.name = t.experiment ORDER BY e.position, t.position");
  for (StoredTable& table : tables) {
    table.rows = read<std::size_t, 1>("SELECT count(*) FROM " + double_quoted(table.name)).front();
  }
  return tables;
}

bool ResultsStore::has_table(const std::string& name) const {
  return !read<int, 1>("SELECT 1 FROM result_table WHERE name = ?", {name}).empty();
}

std::vector<Column> ResultsStore::columns(const std::string& table_name) const {
  return read<Column, 3>(
      "SELECT key, head, wrap FROM result_column WHERE table_name = ? ORDER BY position",
      {table_name});
}

Table ResultsStore::table(const std::string& name) const {
  require_table(*this, file_, name);
  const char* titles = "SELECT name, title FROM result_table WHERE name = ?";
  const auto [stored_name, title] = read<RunInfo::value_type, 2>(titles, {name}).front();
  Table table(stored_name, title, columns(name));
  with_reasons<InputError>(*database_, [&] {
    for (Cells& row : rows(*database_, fmt::format("SELECT {} FROM {} ORDER BY row_number",
                                                   sql_keys(table), double_quoted(table.name())))) {
      table.add_row(std::move(row));
    }
  });
  const char* notes = "SELECT text FROM note WHERE table_name = ? ORDER BY position";
  for (const std::string& note : read<std::string, 1>(notes, {name})) table.add_note(note);
  return table;
}

std::vector<StoredFigure> ResultsStore::figures(const std::string& experiment) const {
  return read<StoredFigure, 4>(
      "SELECT kind = 'picture', file, title, caption FROM figure WHERE experiment = ? ORDER BY kind = 'picture', rowid",
      {experiment});
}

std::vector<WorstInput> ResultsStore::worst_inputs(const std::string& experiment) const {
  return read<WorstInput, 6>(
      "SELECT clipper, scalar, measure, error, input, replay FROM worst_input w JOIN cell c ON c.id = w.cell_id WHERE c.experiment = ? ORDER BY w.rowid",
      {experiment});
}

Interruptions ResultsStore::interruptions(const std::string& experiment) const {
  const auto sums = read<double, 1>(
      "SELECT total(s.value) FROM sample s JOIN cell c ON c.id = s.cell_id WHERE s.series = ? AND ? IN ('', c.experiment) GROUP BY s.position ORDER BY s.position",
      {kRunSeries, experiment});
  if (sums.size() != 5) return {};
  const auto count = [&](std::size_t i) {
    if (std::abs(sums[i]) < 0x1p63) return static_cast<std::int64_t>(sums[i]);
    throw InputError(fmt::format("{}: is damaged: {} given as a number of runs under the clock",
                                 file_.string(), sums[i]));
  };
  return {count(0), count(1), count(2), sums[3], sums[4]};
}

}  // namespace clipscope::experiments
