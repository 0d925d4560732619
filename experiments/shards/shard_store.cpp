// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shards/shard_store.hpp"

#include <fmt/format.h>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"

namespace clipscope::experiments {
namespace {

const std::filesystem::path& made(const std::filesystem::path& folder) {
  make_folder(folder);
  return folder;
}

}  // namespace

RunInfo spread_info(RunInfo info, const Shard& shard) {
  std::erase_if(info, [](const auto& entry) {
    return entry.first == "machine" || entry.first == "measuring";
  });
  set_option(info, "shard", text_of(shard));
  return info;
}

ShardStore::ShardStore(const std::filesystem::path& folder, const SpreadWork& work, bool resume)
    : lock_(made(folder)), shard_(work.shard) {
  const RunInfo info = spread_info(work.info, work.shard);
  const OpenedStore opened = resume ? resume_store(folder, info) : start_store(folder, info);
  tell_kept(opened);
  recorder_.emplace(opened.database, opened.file);
  recorder_->begin(work.experiment, 0);
  row_ = {static_cast<std::int64_t>(shard_.index), static_cast<std::int64_t>(shard_.count),
          static_cast<std::int64_t>(work.units)};
  if (!recorder_->store().has_table(std::string(ShardRow::kName))) return;
  const std::vector<ShardRow> rows =
      rows_of<ShardRow>(recorder_->store().table(std::string(ShardRow::kName)));
  if (rows.size() != 1 || rows[0].units != row_.units || rows[0].done > row_.units) {
    throw InputError(
        fmt::format("{}: is damaged: the table '{}' does not speak of {} units of shard {}",
                    opened.file.string(), ShardRow::kName, row_.units, text_of(shard_)));
  }
  row_ = rows[0];
  seconds_before_ = row_.seconds;
}

std::optional<Table> ShardStore::sum(const std::string& table_name) const {
  if (!recorder_->store().has_table(table_name)) return std::nullopt;
  return recorder_->store().table(table_name);
}

double ShardStore::seconds_here() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ShardStore::replace(const Table& sum, std::size_t done, bool complete) {
  row_.done = static_cast<std::int64_t>(done);
  row_.seconds = seconds_before_ + seconds_here();
  TableOf<ShardRow> shards;
  shards.add(row_);
  recorder_->replace({&shards, &sum}, complete);
}

void ShardStore::keep(const Table& sum, std::size_t done) { replace(sum, done, false); }

void ShardStore::finish(const Table& sum, const Table& whole) {
  const bool complete = shard_.is_whole();
  replace(complete ? whole : sum, static_cast<std::size_t>(row_.units), complete);
  recorder_->finish(row_.seconds);
}

}  // namespace clipscope::experiments
