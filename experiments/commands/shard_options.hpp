// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of work that can be spread over many processes: --shard, --resume, --threads.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <tbb/global_control.h>

#include "experiments/shards/shard_store.hpp"

namespace clipscope::experiments::commands {

struct ShardOptions {
  Shard shard;
  bool is_given = false;  // --shard
  bool resume = false;
  std::optional<int> threads;
};

// --shard i/N and --resume.
void add_shard_options(CLI::App& command, ShardOptions& options);
// --threads N.
void add_threads_option(CLI::App& command, std::optional<int>& threads);

// Errors: UsageError if --shard or --resume is given without a folder.
void check_has_folder(const ShardOptions& options, const std::optional<std::string>& out);

// While it lives, no more threads are used than were asked for.
class ThreadLimit {
 public:
  explicit ThreadLimit(const std::optional<int>& threads) {
    if (!threads) return;
    limit_.emplace(tbb::global_control::max_allowed_parallelism,
                   static_cast<std::size_t>(*threads));
  }

 private:
  std::optional<tbb::global_control> limit_;
};

// One line on standard output about a shard that is done and stored.
void tell_shard(const Shard& shard, const std::string& folder);

}  // namespace clipscope::experiments::commands
