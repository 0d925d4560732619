// SPDX-License-Identifier: GPL-3.0-or-later
//
// What compiler flags cost: who is timed, and beside what.
#include "experiments/cost/flags.hpp"

#include "experiments/cost/builds/build.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::cost;

namespace {

std::vector<FlagRow> measured(const std::string& mix) {
  const auto views = sampled_views(make_builtin_scene(mix, {.seed = 1, .quick = true}), 1500);
  TableOf<FlagRow> table;
  PieceRecord record;
  measure_flags(mix, views.front(), 5, table, record);
  return table.rows();
}

}  // namespace

TEST_CASE("cost flags: no flag changes a bit, but contraction into FMA") {
  const auto rows = measured("soup_straddling");
  REQUIRE(rows.size() == builds::runnable().size() * builds::runnable()[0].clippers().size());
  for (const FlagRow& row : rows) {
    INFO(row.clipper << " " << row.scalar << " " << row.flags);
    CHECK(row.triangles > 1000);
    if (row.flags.find("contract") == std::string::npos) CHECK(row.differ == 0);
  }
}

TEST_CASE("cost flags: a build is timed where its bits are those of the contestant") {
  bool some_differ = false;
  for (const FlagRow& row : measured("soup_straddling")) {
    INFO(row.clipper << " " << row.scalar << " " << row.flags);
    CHECK(row.ns.has_value() == (row.differ == 0));
    CHECK(row.ratio.has_value() == row.ns.has_value());
    some_differ = some_differ || row.differ > 0;
  }
  const bool contracts = std::ranges::any_of(builds::runnable(), [](const builds::Build& b) {
    return std::string_view(b.flags).find("contract") != std::string_view::npos;
  });
  CHECK(some_differ == contracts);
}

TEST_CASE("cost flags: the first build adds no flag and is what the others are compared with") {
  CHECK(std::string_view(builds::runnable()[0].flags).empty());
  for (const FlagRow& row : measured("soup")) {
    if (row.flags == kNoFlags) CHECK(row.ratio->median == 1);
  }
}
