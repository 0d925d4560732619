// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/campaigns.hpp"

#include "experiments/machine/errors.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::worst_cases;

TEST_CASE("campaigns: those kept are of contestants that there are, by commands that there are") {
  const Campaigns kept = builtin_campaigns();
  REQUIRE(kept.commands.size() >= 3);
  REQUIRE(kept.counts.size() >= kept.commands.size());
  for (const CampaignCommandRow& row : kept.commands) {
    CHECK(row.command.starts_with("clipscope sweep "));
    CHECK(row.shards > 0);
    CHECK(row.minutes > 0);
  }
  const Contestants all = selected_contestants({});
  for (const CampaignRow& row : kept.counts) {
    INFO(row.inputs << ": " << row.clipper << " in " << row.scalar);
    CHECK(std::ranges::any_of(all, [&](const Contestant* contestant) {
      return contestant->clipper == row.clipper && contestant->scalar() == row.scalar;
    }));
    CHECK(std::ranges::any_of(kept.commands, [&](const CampaignCommandRow& command) {
      return command.inputs == row.inputs;
    }));
    CHECK(row.misrounded <= row.coordinates);
  }
}

TEST_CASE(
    "campaigns: no number of the correctly rounded clippers was misrounded, of 10^9 and more") {
  std::int64_t coordinates = 0;
  for (const CampaignRow& row : builtin_campaigns().counts) {
    if (!row.clipper.starts_with("barycentric/correctly_rounded")) continue;
    CHECK(row.misrounded == 0);
    CHECK(row.wrong == 0);
    coordinates += row.coordinates;
  }
  CHECK(coordinates >= 1000000000);
}

TEST_CASE("campaigns: what is none is refused by the name of its file") {
  for (const char* text : {"", "{}", R"({"commands": [], "counts": [{"clipper": 3}]})"}) {
    CHECK_THROWS_AS(read_campaigns("mine.json", text), InputError);
    try {
      read_campaigns("mine.json", text);
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).starts_with("mine.json: "));
    }
  }
}
