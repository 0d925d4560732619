// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a shard has found so far, in a results store (experiments/store/): the sum of its units, and
// how many of them are in it.
//
// Each `keep` is one transaction that replaces the sum, so that the store does not grow with the
// number of units, and a process that is killed loses what it did since the last one.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "experiments/shards/shard.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/store/run_recorder.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

// A shard whose units are in the sum of a folder: of one shard, or of several that were merged.
struct ShardRow {
  std::int64_t shard = 0, of = 1;
  std::int64_t units = 0, done = 0;
  double seconds = 0;  // that the units which are done took

  static constexpr std::string_view kName = "shards", kTitle = "Shards in these results";
  static constexpr auto columns() {
    using R = ShardRow;
    return std::tuple(column("shard", &R::shard), column("of", &R::of), column("units", &R::units),
                      column("done", &R::done), column("seconds", &R::seconds));
  }
};

// What is spread.
struct SpreadWork {
  StoredExperiment experiment;
  RunInfo info;  // with all options that decide the results
  Shard shard;
  std::size_t units = 0;  // of this shard
};

// What a run is recorded with of which each shard is a part: the machine is left out, since nothing
// that is spread depends on it, and a shard may go on elsewhere.
RunInfo spread_info(RunInfo info, const Shard& shard);

class ShardStore {
 public:
  // resume: goes on with what is in the folder, if anything is. Errors: those of start_store and
  // resume_store; OutputError if another process writes there.
  ShardStore(const std::filesystem::path& folder, const SpreadWork& work, bool resume);

  // How many units are done, in their order.
  std::size_t done() const { return static_cast<std::size_t>(row_.done); }
  bool is_finished() const { return row_.done == row_.units; }
  // The sum so far; nothing if no unit is done.
  std::optional<Table> sum(const std::string& table_name) const;

  // The sum with so many units in it. Errors: OutputError.
  void keep(const Table& sum, std::size_t done);
  // All are done; `whole`, the table of the results, takes the place of the sum where the shard is
  // all there is.
  void finish(const Table& sum, const Table& whole);

 private:
  double seconds_here() const;
  void replace(const Table& sum, std::size_t done, bool complete);

  FolderLock lock_;
  Shard shard_;
  std::optional<RunRecorder> recorder_;
  ShardRow row_;
  double seconds_before_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace clipscope::experiments
