// SPDX-License-Identifier: GPL-3.0-or-later
//
// Campaigns: sweeps that take longer than a run, made once over many processors
// (experiments/cluster/), and what they counted. They are part of the program, as the records are;
// `.ci/keep_campaigns` writes the file from their results.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/columns.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::worst_cases {

// What a campaign counted of one contestant.
struct CampaignRow {
  std::string inputs, clipper, scalar;
  std::int64_t answers = 0, wrong = 0, coordinates = 0, misrounded = 0;

  double misrounded_percent() const {
    return 100.0 * static_cast<double>(misrounded) / static_cast<double>(coordinates);
  }

  static constexpr std::string_view kName = "worst_cases_campaigns";
  static constexpr std::string_view kTitle =
      "Sweeps over many processors: what was wrong, and what was not rounded right";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Made once, and not again by this run; the table worst_cases_campaign_commands says how.",
      "Wrong: visible triangles that look wrong. Misrounded: coordinates of the exact vertices for which the answer has not the nearest number of the scalar. A stage answers in each contract and build."};
  static constexpr auto columns() {
    using R = CampaignRow;
    return std::tuple(column("inputs", "inputs", &R::inputs, 24),
                      contestant_columns(&R::clipper, &R::scalar), column("answers", &R::answers),
                      column("wrong", &R::wrong), column("coordinates", &R::coordinates),
                      column("misrounded", &R::misrounded),
                      derived("misrounded_percent", "%", &R::misrounded_percent));
  }
};

// How a campaign was made.
struct CampaignCommandRow {
  std::string inputs, command, commit;
  std::int64_t shards = 0;
  double minutes = 0;  // of all shards together

  static constexpr std::string_view kName = "worst_cases_campaign_commands";
  static constexpr std::string_view kTitle = "How the sweeps over many processors were made";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "`experiments/cluster/spread here RESULTS SHARDS COMMAND` does one again; any number of shards and processors gives the same counts."};
  static constexpr auto columns() {
    using R = CampaignCommandRow;
    return std::tuple(column("inputs", "inputs", &R::inputs, 24), column("shards", &R::shards),
                      column("minutes", "minutes, all shards", &R::minutes),
                      column("commit", &R::commit), column("command", "command", &R::command, 40));
  }
};

struct Campaigns {
  std::vector<CampaignCommandRow> commands;
  std::vector<CampaignRow> counts;
};

// file: its name, for errors. Errors: InputError naming the file, where its text is no list of
// campaigns.
Campaigns read_campaigns(std::string_view file, std::string_view text);

// As they were when the program was built.
Campaigns builtin_campaigns();

}  // namespace clipscope::experiments::worst_cases
