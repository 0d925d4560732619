// SPDX-License-Identifier: GPL-3.0-or-later
//
// The comparison of planned polygons with full ones.
#include "experiments/effects/rows.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/effects/planned.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::effects;

TEST_CASE("effects: no scene is changed by leaving out what it does not call for") {
  for (const std::string& name : needed_scene_names(Selection{})) {
    CAPTURE(name);
    for (const PlannedView& view : planned(name)) {
      const Harm harm = harm_of(view);
      CHECK(harm.polygons == view.triangles.size());
      CHECK(harm.changed == 0);
      CHECK(harm.broken.empty());
      CHECK(harm.attribute_error <= view.tolerance);
      CHECK(harm.attribute_error <= std::max<double>(view.plan.affine_error(), 1e-12));
    }
  }
}

TEST_CASE("effects: harm is found where triangles are not those that were planned for") {
  std::vector<PlannedView> views = planned("telephoto");
  REQUIRE(harm_of(views[0]).changed == 0);
  views[0].triangles[7][1].position[0] += 1000;
  views[0].triangles[9][0].position[2] = -1;  // w from far away to 1: nothing is affine any more
  const Harm harm = harm_of(views[0]);
  CHECK(harm.changed == 2);
  CHECK(harm.attribute_error > 0);
}

TEST_CASE("effects: harm is summed over views, and told where it is too large") {
  Harm all{.polygons = 10, .changed = 0, .attribute_error = 0.25};
  CHECK(all.text(0.5).empty());
  CHECK_FALSE(all.text(0.125).empty());
  all += {.polygons = 5, .changed = 2, .attribute_error = 0.125};
  CHECK(all.polygons == 15);
  CHECK(all.attribute_error == 0.25);
  CHECK_THAT(all.text(0.5), Catch::Contains("2 of 15 polygons are changed"));
}
