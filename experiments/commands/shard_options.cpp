// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/shard_options.hpp"

#include "experiments/commands/options.hpp"

namespace clipscope::experiments::commands {

void add_shard_options(CLI::App& command, ShardOptions& options) {
  const auto parse = [&](const std::string& text) {
    const std::optional<Shard> shard = parse_shard(text);
    if (!shard) {
      throw CLI::ValidationError(
          "--shard", fmt::format("'{}' given, i/N expected, with i from 0 to N - 1 and N up to {}",
                                 text, kMostShards));
    }
    options.shard = *shard;
    options.is_given = true;
  };
  command
      .add_option_function<std::string>(
          "--shard", parse,
          "Do part i of N alone, i from 0, and store it in --out; see `clipscope merge`")
      ->type_name("i/N");
  command.add_flag("--resume", options.resume,
                   "Go on with what was interrupted in --out; takes the same options");
}

void add_threads_option(CLI::App& command, std::optional<int>& threads) {
  add_option(command, "--threads", threads, "N",
             "Threads to use at most; the results do not depend on it [all processors]")
      ->check(CLI::Range(1, 4096));
}

void check_has_folder(const ShardOptions& options, const std::optional<std::string>& out) {
  if (out || (!options.is_given && !options.resume)) return;
  usage_error("--{}: takes --out DIR, the folder that it is stored in",
              options.resume ? "resume" : "shard");
}

void tell_shard(const Shard& shard, const std::string& folder) {
  fmt::print("shard {} is done: {}\n", text_of(shard), folder);
}

}  // namespace clipscope::experiments::commands
