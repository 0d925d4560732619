// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/rows.hpp"

#include <algorithm>
#include <map>

#include "experiments/catalogue/catalogue.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

using reference::Bug;

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

TEST_CASE("mutants: the textbook clipper without a bug equals the reference on the catalogue") {
  CHECK(caught_by(Bug::none, builtin_catalogue()).empty());
}

TEST_CASE("mutants: each bug is caught by triangles in clip space alone") {
  std::vector<HardCase> triangles;
  std::ranges::copy_if(builtin_catalogue(), std::back_inserter(triangles), [](const HardCase& c) {
    return c.primitive == Primitive::triangle && c.space == Space::clip;
  });
  const std::vector<MutantRow> rows = mutant_rows(triangles);
  REQUIRE(rows.size() == reference::all_bugs().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const reference::BugInfo& info = reference::all_bugs()[i];
    CAPTURE(info.name);
    const std::vector<std::string> names = caught_by(info.bug, triangles);
    CHECK_FALSE(names.empty());
    CHECK(rows[i].bug == info.summary);
    CHECK(rows[i].caught_by == static_cast<std::int64_t>(names.size()));
    CHECK(contains(names, rows[i].sharpest));
  }
}

// For each bug a case that says why it is one. These must not get lost.
const std::map<Bug, std::string> kSharpCases = {
    {Bug::epsilon_in_denominator, "scale/sweep_1e-10"},
    {Bug::absolute_w, "from_the_field/chromium_infinity_y_1"},
    {Bug::w_sign_ignored, "w_sign/all_behind"},
    {Bug::w_plane_left_out, "w_sign/minus_m"},
    {Bug::w_plane_epsilon, "from_the_field/w_plane_1e_minus_5"},
    {Bug::plane_epsilon, "planes_touched/ulp_outside_side"},
    {Bug::open_volume, "depth/full_screen_near_zero"},
    {Bug::far_end_weighted, "planes_touched/misses_by_corner"},
    {Bug::nearer_end_swapped, "far/diagonal_2_pow_24"},
    {Bug::near_side_flipped, "planes_touched/edge_on_edge"},
    {Bug::attributes_in_ndc, "user_planes/perspective"},
    {Bug::attribute_axis_of_clip_space, "user_planes/perspective"},
    {Bug::inv_w_linear, "segments/to_infinity"},
    {Bug::depth_from_zero, "depth/full_screen_near"},
    {Bug::rejects_without_common_plane, "planes_touched/covers"},
    {Bug::drops_whole, "user_planes/one"},
    {Bug::last_edge_left_out, "user_planes/one"},
    {Bug::eight_vertices, "planes_touched/nine_gon"},
    {Bug::closed_sides, "half_open/triangle_in_right"},
    {Bug::opposite_sides_open, "half_open/triangle_in_left"},
    {Bug::skips_left, "slivers_and_slopes/is_segment"},
    {Bug::skips_right, "from_the_field/piglit_strip_1"},
    {Bug::skips_bottom, "far/diagonal_2_pow_24"},
    {Bug::skips_top, "planes_touched/misses_by_corner"},
    {Bug::skips_near, "depth/citra_outside"},
    {Bug::skips_far, "depth/just_beyond_far"},
};

TEST_CASE("mutants: each bug is caught by the case that was made for it") {
  CHECK(reference::all_bugs().size() == kSharpCases.size());
  for (const reference::BugInfo& info : reference::all_bugs()) {
    CAPTURE(info.name);
    CHECK(contains(caught_by(info.bug, builtin_catalogue()), kSharpCases.at(info.bug)));
  }
}

TEST_CASE("mutants: room for eight vertices is enough but for three cases") {
  CHECK(caught_by(Bug::eight_vertices, builtin_catalogue()) ==
        std::vector<std::string>{"planes_touched/nine_gon", "polygons/hexagon_to_dodecagon",
                                 "user_planes/eight"});
}

// Two contestants on three cases: the first fails on two, the second is not asked the last one.
struct Example {
  std::vector<HardCase> cases = std::vector<HardCase>(3);
  CaseSet set{Primitive::segment, {}, case_contestants(Primitive::segment, "*", {"float"})};
  Verdicts verdicts = Verdicts(3, std::vector<CaseVerdict>(2));

  Example() {
    set.contestants.resize(2);
    for (std::size_t i = 0; i < 3; ++i) {
      cases[i].name = "theme/" + std::to_string(i);
      set.cases.push_back(&cases[i]);
    }
    verdicts[0][0].comparison = {.outcome = Outcome::visible, .position_px = 2, .attribute = 3};
    verdicts[2][0].comparison.outcome = Outcome::missing;
    verdicts[1][1].promise = {PromiseVerdict::broken, 7, "too far off"};
    verdicts[2][1].comparison.outcome = Outcome::not_applicable;
  }
};

TEST_CASE("rows: the matrix has a letter for each clipper, in the column of its scalar") {
  const Example e;
  Table table = matrix_table(e.set, {"float", "double"});
  add_matrix(e.set, e.verdicts, {"float", "double"}, table);
  CHECK(table.name() == "hard_cases_segments");
  REQUIRE(table.rows().size() == 3);
  CHECK(table.rows()[0] == std::vector<Cell>{"theme/0", "rejected", "v=", "  "});
  CHECK(table.rows()[2] == std::vector<Cell>{"theme/2", "rejected", "M-", "  "});
}

TEST_CASE("rows: a summary counts what was asked, failures and broken promises") {
  const Example e;
  TableOf<SummaryRow> table;
  add_rows(e.set, e.verdicts, table);
  const std::vector<SummaryRow> rows = table.rows();
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].primitive == Primitive::segment);
  CHECK(rows[0].clipper == e.set.contestants[0]->clipper);
  CHECK(rows[0].cases == 3);
  CHECK(rows[0].failures == 2);
  CHECK(rows[0].failing == "theme/0, theme/2");
  CHECK(rows[1].cases == 2);
  CHECK(rows[1].failures == 0);
  CHECK(rows[1].promises_broken == 1);
}

TEST_CASE("rows: a verdict has errors where the vertices are the right ones") {
  const Example e;
  TableOf<VerdictRow> table;
  add_rows(e.set, e.verdicts, table);
  const std::vector<VerdictRow> rows = table.rows();
  REQUIRE(rows.size() == 6);
  REQUIRE(rows[0].errors);
  CHECK(rows[0].errors->position_px == 2);
  CHECK(rows[0].errors->attribute == 3);
  CHECK(rows[3].broken_promise == "too far off");
  CHECK_FALSE(rows[4].errors);
  CHECK(rows[5].outcome == Outcome::not_applicable);
}

TEST_CASE("rows: only triangles have backward errors") {
  Example e;
  TableOf<FamilyRow> table;
  add_rows(e.set, std::vector<FamilyTally>{{.variants = 5}, {.largest_ulps = 2.5}}, table);
  CHECK_FALSE(table.rows()[0].tally.largest_ulps);
  CHECK(table.rows()[0].tally.variants == 5);
  CHECK(table.rows()[1].tally.largest_ulps == 2.5);
}

}  // namespace
}  // namespace clipscope::experiments::hard_cases
