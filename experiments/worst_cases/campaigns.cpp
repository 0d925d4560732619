// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/campaigns.hpp"

#include <nlohmann/json.hpp>

#include "experiments/machine/errors.hpp"
#include "experiments/worst_cases/kept.hpp"

namespace clipscope::experiments::worst_cases {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CampaignRow, inputs, clipper, scalar, answers, wrong,
                                   coordinates, misrounded)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CampaignCommandRow, inputs, command, commit, shards, minutes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Campaigns, commands, counts)

Campaigns read_campaigns(std::string_view file, std::string_view text) {
  try {
    return nlohmann::json::parse(text).get<Campaigns>();
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string(file) + ": these are no campaigns: " + error.what());
  }
}

Campaigns builtin_campaigns() {
  constexpr std::string_view kFile = "campaigns.json";
  return read_campaigns(kFile, kept_text(kFile));
}

}  // namespace clipscope::experiments::worst_cases
