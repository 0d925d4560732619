// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a plug-in's own process costs: the same library both ways, in the same rounds.
#include "experiments/cost/plugin.hpp"

#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::cost;

TEST_CASE("cost plug-in: both ways leave the clipper's bits and are timed, in both scalars") {
  const auto views =
      sampled_views(make_builtin_scene("soup_straddling", {.seed = 1, .quick = true}), 1500);
  TableOf<PluginRow> table;
  PieceRecord record;
  measure_plugin("soup_straddling", views.front(), 5, table, record);
  const std::vector<PluginRow> rows = table.rows();
  REQUIRE(rows.size() == 4);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CAPTURE(i);
    CHECK(rows[i].scalar == (i < 2 ? "float" : "double"));
    CHECK(rows[i].way == (i % 2 == 0 ? kDirectCall : kThroughHost));
    CHECK(rows[i].triangles > 1000);
    REQUIRE(rows[i].ns.has_value());
    REQUIRE(rows[i].ratio.has_value());
    CHECK(rows[i].ns->median > 0);
    if (i % 2 == 0) CHECK(rows[i].ratio->median == 1);
  }
}
