// SPDX-License-Identifier: GPL-3.0-or-later
//
// Would the catalogue notice a bug?
#include "experiments/catalogue/mutation_table.hpp"

#include <algorithm>
#include <map>

#include "experiments/catalogue/catalogue.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
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
  for (const MutationRow& row : mutation_table(triangles)) {
    CAPTURE(row.name);
    CHECK_FALSE(row.caught_by.empty());
    CHECK(contains(row.caught_by, row.sharpest));
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
    {Bug::skips_left, "slivers_and_slopes/is_segment"},
    {Bug::skips_right, "from_the_field/piglit_strip_1"},
    {Bug::skips_bottom, "far/diagonal_2_pow_24"},
    {Bug::skips_top, "planes_touched/misses_by_corner"},
    {Bug::skips_near, "depth/citra_outside"},
    {Bug::skips_far, "depth/just_beyond_far"},
};

TEST_CASE("mutants: each bug is caught by the case that was made for it") {
  const std::vector<MutationRow> rows = mutation_table(builtin_catalogue());
  CHECK(rows.size() == kSharpCases.size());
  for (const MutationRow& row : rows) {
    CAPTURE(row.name);
    CHECK(contains(row.caught_by, kSharpCases.at(row.bug)));
  }
}

TEST_CASE("mutants: room for eight vertices is enough but for three cases") {
  CHECK(caught_by(Bug::eight_vertices, builtin_catalogue()) ==
        std::vector<std::string>{"planes_touched/nine_gon", "polygons/hexagon_to_dodecagon",
                                 "user_planes/eight"});
}

}  // namespace
}  // namespace clipscope::experiments
