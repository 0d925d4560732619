// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merging what experiments stored piece by piece: pieces keep their numbers, and stand in their
// order; nothing is added up.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <map>
#include <system_error>
#include <utility>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/shards/merge.hpp"
#include "experiments/store/database.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

const std::string kShardTable(ShardRow::kName);

struct OpenSource {
  const MergeSource* source;
  DatabasePointer database;
};

// Rows of one of the store's own tables; what is there already stays.
void copy_rows(const OpenSource& from, SQLite::Database& to, const std::string& table,
               const std::string& query) {
  for (const Cells& cells : rows(*from.database, query)) {
    std::string places;
    for (std::size_t i = 0; i < cells.size(); ++i) places += i == 0 ? "?" : ", ?";
    execute(to, fmt::format("INSERT OR IGNORE INTO {} VALUES({})", table, places), cells);
  }
}

// state: of the experiments in the merged store.
void copy_records(const OpenSource& from, SQLite::Database& to, const std::string& state) {
  const std::string other_tables = fmt::format("name <> '{}'", kShardTable);
  const std::string of_others = fmt::format("table_name <> '{}'", kShardTable);
  copy_rows(from, to, "experiment",
            fmt::format(
                "SELECT name, position, question, command, '{}', seconds, finding FROM experiment",
                state));
  copy_rows(from, to, "cell", "SELECT * FROM cell");
  copy_rows(from, to, "sample", "SELECT * FROM sample");
  copy_rows(from, to, "worst_input", "SELECT * FROM worst_input");
  copy_rows(from, to, "figure", "SELECT * FROM figure WHERE cell_id IS NOT NULL");
  copy_rows(from, to, "result_table",
            "SELECT name, experiment, position, title, 0 FROM result_table WHERE " + other_tables);
  copy_rows(from, to, "result_column", "SELECT * FROM result_column WHERE " + of_others);
  copy_rows(from, to, "note", "SELECT * FROM note WHERE " + of_others);
}

// The rows of a table of results, by piece, numbered anew.
void copy_results(const std::vector<OpenSource>& sources, SQLite::Database& to,
                  const std::string& table) {
  using Place = std::pair<std::int64_t, std::int64_t>;  // piece, row
  std::map<Place, Cells> in_order;
  const std::string query =
      fmt::format("SELECT * FROM {} WHERE cell_id IS NOT NULL", double_quoted(table));
  for (const OpenSource& from : sources) {
    const auto made = rows<std::string, 1>(
        *from.database, "SELECT sql FROM sqlite_master WHERE type = 'table' AND name = ?", {table});
    if (made.empty()) continue;  // none of the source's pieces has rows in it
    const bool is_new =
        rows(to, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?", {table}).empty();
    if (is_new) to.exec(made.front());
    for (Cells& cells : rows(*from.database, query)) {
      const Place place = {std::get<std::int64_t>(cells[cells.size() - 2]),
                           std::get<std::int64_t>(cells.back())};
      in_order.emplace(place, std::move(cells));
    }
  }
  std::int64_t number = 0;
  for (auto& [place, cells] : in_order) {
    cells.back() = number++;
    insert(to, table, cells);
  }
}

void copy_pictures(const OpenSource& from, const fs::path& folder) {
  for (const auto& file :
       rows<std::string, 1>(*from.database, "SELECT file FROM figure WHERE cell_id IS NOT NULL")) {
    const fs::path target = folder / file;
    make_folder(target.parent_path());
    std::error_code error;
    fs::copy_file(from.source->folder / file, target, fs::copy_options::overwrite_existing, error);
    if (error) {
      throw OutputError(fmt::format("{}: can't be copied to {}: {}",
                                    (from.source->folder / file).string(), target.string(),
                                    error.message()));
    }
  }
}

void copy_all(const std::vector<OpenSource>& sources, SQLite::Database& to, bool whole) {
  SQLite::Transaction transaction(to);
  for (const OpenSource& from : sources) copy_records(from, to, whole ? "running" : "finished");
  for (const auto& table : rows<std::string, 1>(to, "SELECT name FROM result_table")) {
    copy_results(sources, to, table);
  }
  transaction.commit();
}

}  // namespace

void merge_pieces(const fs::path& folder, const std::vector<MergeSource>& sources) {
  make_folder(folder);
  const FolderLock lock(folder);
  std::vector<OpenSource> open;
  for (const MergeSource& source : sources) {
    open.push_back({&source, open_database(source.store.file())});
    copy_pictures(open.back(), folder);
  }
  const OpenedStore merged = start_store(folder, merged_info(sources));
  tell_kept(merged);
  const bool whole = is_whole(sources);
  with_reasons<OutputError>(*merged.database, [&] { copy_all(open, *merged.database, whole); });
  if (whole) return;
  RunRecorder recorder(merged.database, merged.file);
  recorder.begin(sources.front().experiments.back(), 0);
  const TableOf<ShardRow> shards = shards_in(sources);
  recorder.replace({&shards}, false);
}

}  // namespace clipscope::experiments
