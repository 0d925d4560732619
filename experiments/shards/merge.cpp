// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shards/merge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"

namespace clipscope::experiments {
namespace {

const std::string kShards(ShardRow::kName);
constexpr std::size_t kNamedShards = 12;  // of those that are missing

std::string shard_text(const ShardRow& row) { return fmt::format("{}/{}", row.shard, row.of); }

MergeSource opened(const std::string& folder) {
  MergeSource source{folder, ResultsStore(folder)};
  if (!source.store.has_table(kShards)) {
    throw InputError(fmt::format(
        "{}: holds no shard; what `clipscope sweep`, `hunt` and `run` leave with --shard i/N --out DIR is expected",
        folder));
  }
  source.info = source.store.run_info();
  source.experiments = source.store.experiments();
  source.shards = rows_of<ShardRow>(source.store.table(kShards));
  std::ranges::sort(source.shards, {}, &ShardRow::shard);
  const auto is_sound = [&](const ShardRow& row) {
    return 0 <= row.shard && row.shard < row.of && row.of == source.shards.front().of &&
           row.of <= static_cast<std::int64_t>(kMostShards);
  };
  if (source.shards.empty() || source.experiments.empty() ||
      !std::ranges::all_of(source.shards, is_sound)) {
    throw InputError(
        fmt::format("{}: is damaged: the table '{}' holds no shards", folder, kShards));
  }
  return source;
}

void check_finished(const MergeSource& source) {
  for (const ShardRow& row : source.shards) {
    const bool is_done = std::ranges::all_of(source.experiments, &StoredExperiment::finished);
    if (is_done && row.done == row.units) continue;
    throw UsageError(fmt::format(
        "{}: shard {} is not finished, {} of {} units are done; finish it with --resume: {} --shard {} --resume --out {}",
        source.folder.string(), shard_text(row), row.done, row.units,
        value_of(source.info, "command"), shard_text(row), source.folder.string()));
  }
}

// Both are of one sweep, but for the shard.
void check_alike(const MergeSource& a, const MergeSource& b) {
  RunInfo a_info = a.info, b_info = b.info;
  set_option(a_info, "shard", std::nullopt);
  set_option(b_info, "shard", std::nullopt);
  std::vector<std::string> differences = differences_of(a_info, b_info, "there", "here");
  if (a.experiments.front().name != b.experiments.front().name) {
    differences.push_back(
        fmt::format("{} there, {} here", a.experiments.front().name, b.experiments.front().name));
  }
  if (a.shards.front().of != b.shards.front().of) {
    differences.push_back(
        fmt::format("{} shards there, {} here", a.shards.front().of, b.shards.front().of));
  }
  if (differences.empty()) return;
  throw UsageError(fmt::format("{} and {} are not shards of the same work ({})", a.folder.string(),
                               b.folder.string(), fmt::join(differences, "; ")));
}

void check_no_overlap(const std::vector<MergeSource>& sources) {
  std::map<std::int64_t, const MergeSource*> owners;
  for (const MergeSource& source : sources) {
    for (const ShardRow& row : source.shards) {
      const auto [owner, is_new] = owners.try_emplace(row.shard, &source);
      if (is_new) continue;
      throw UsageError(fmt::format("shard {} is in {} and in {}; each may be there once",
                                   shard_text(row), owner->second->folder.string(),
                                   source.folder.string()));
    }
  }
}

std::vector<std::int64_t> missing_shards(const std::vector<MergeSource>& sources) {
  std::vector<bool> is_there(static_cast<std::size_t>(sources.front().shards.front().of));
  for (const MergeSource& source : sources) {
    for (const auto& [shard, of, units, done, seconds] : source.shards) {
      is_there[static_cast<std::size_t>(shard)] = true;
    }
  }
  std::vector<std::int64_t> missing;
  for (std::size_t i = 0; i < is_there.size(); ++i) {
    if (!is_there[i]) missing.push_back(static_cast<std::int64_t>(i));
  }
  return missing;
}

void check_no_gap(const std::vector<MergeSource>& sources) {
  std::vector<std::int64_t> missing = missing_shards(sources);
  if (missing.empty()) return;
  const std::size_t count = missing.size();
  missing.resize(std::min(count, kNamedShards));
  std::vector<std::string> folders;
  for (const MergeSource& source : sources) folders.push_back(source.folder.string());
  throw UsageError(fmt::format(
      "{} of {} shards are missing: {}{}; given were {}; --part merges some shards alone, for a tree of merges",
      count, sources.front().shards.front().of, fmt::join(missing, ", "),
      count > kNamedShards ? ", ..." : "", fmt::join(folders, ", ")));
}

}  // namespace

std::vector<MergeSource> open_sources(const std::vector<std::string>& folders, bool part) {
  std::vector<MergeSource> sources;
  for (const std::string& folder : folders) {
    sources.push_back(opened(folder));
    check_finished(sources.back());
    check_alike(sources.front(), sources.back());
  }
  check_no_overlap(sources);
  if (!part) check_no_gap(sources);
  std::ranges::sort(sources, {}, [](const MergeSource& s) { return s.shards.front().shard; });
  return sources;
}

bool is_whole(const std::vector<MergeSource>& sources) { return missing_shards(sources).empty(); }

TableOf<ShardRow> shards_in(const std::vector<MergeSource>& sources) {
  std::vector<ShardRow> rows;
  for (const MergeSource& source : sources) {
    rows.insert(rows.end(), source.shards.begin(), source.shards.end());
  }
  std::ranges::sort(rows, {}, &ShardRow::shard);
  TableOf<ShardRow> table;
  for (const ShardRow& row : rows) table.add(row);
  return table;
}

Table summed_table(const std::vector<MergeSource>& sources) {
  const MergeSource& first = sources.front();
  for (const StoredTable& table : first.store.tables()) {
    if (table.name == kShards) continue;
    for (const MergeSource& source : sources) {
      if (source.store.has_table(table.name)) continue;
      throw InputError(fmt::format("{}: has no table '{}', which {} has", source.folder.string(),
                                   table.name, first.folder.string()));
    }
    return first.store.table(table.name);
  }
  throw InputError(fmt::format("{}: has no table to be summed", first.folder.string()));
}

RunInfo merged_info(const std::vector<MergeSource>& sources) {
  RunInfo info = sources.front().info;
  set_option(info, "shard", is_whole(sources) ? std::nullopt : std::optional<std::string>("some"));
  return info;
}

void write_merged(const std::filesystem::path& folder, const std::vector<MergeSource>& sources,
                  const Table& table) {
  make_folder(folder);
  const FolderLock lock(folder);
  const OpenedStore opened = start_store(folder, merged_info(sources));
  tell_kept(opened);
  RunRecorder recorder(opened.database, opened.file);
  recorder.begin(sources.front().experiments.front(), 0);
  const TableOf<ShardRow> shards = shards_in(sources);
  double seconds = 0;
  for (const ShardRow& row : shards.rows()) seconds += row.seconds;
  recorder.replace({&shards, &table}, is_whole(sources));
  recorder.finish(seconds);
}

}  // namespace clipscope::experiments
