// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `clipscope hunt` is asked, and one of its hunts: a contestant by a measure from a seed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/shard_options.hpp"
#include "experiments/hunt/hunt.hpp"
#include "experiments/hunt/rows.hpp"
#include "experiments/hunt/trophy.hpp"

namespace clipscope::experiments::commands {

struct HuntCommandOptions {
  Selection selection;
  GuestOptions guests;
  std::vector<std::string> measures = {"px"};
  hunt::HuntOptions hunt;
  bool without_catalogue = false;
  std::optional<std::string> out, corpus_out;
  std::uint64_t hunts = 1;  // of each clipper and measure, from as many seeds
  ShardOptions shard;

  // Whether hunts are stored one by one, so that they can be spread and resumed.
  bool is_spread() const { return shard.is_given || shard.resume || hunts > 1; }
};

struct HuntResult {
  const Contestant* contestant;
  hunt::Measure measure;
  hunt::Hunted hunted;
  std::optional<hunt::Trophy> worst, shrunk;
  std::string command;  // that finds the same

  std::string failing() const;
  double per_second() const {
    return hunted.seconds == 0 ? 0 : static_cast<double>(hunted.evaluations) / hunted.seconds;
  }
  std::string replay(const std::optional<hunt::Trophy>& trophy) const {
    return trophy ? hunt::replay_command(*contestant, trophy->cases) : "";
  }
};

// Tells on standard error how far it is.
HuntResult hunted_one(const Contestant& contestant, hunt::Measure measure,
                      hunt::HuntOptions options);
hunt::HuntRow row_of(const HuntResult& result);

// The command that makes all hunts again, without --shard and --out.
std::string whole_command(const HuntCommandOptions& options);

// All hunts of this shard, stored one by one in --out; those of a contestant and a measure are one
// row. Errors: UsageError without --evaluations; those of ShardStore.
void spread_hunts(const HuntCommandOptions& options, const Contestants& contestants,
                  const std::vector<hunt::Measure>& measures);

}  // namespace clipscope::experiments::commands
