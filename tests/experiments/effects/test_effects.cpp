// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plans of scenes, the comparison that finds harm, and the timing beside the full pipeline.
#include "experiments/effects/harm.hpp"
#include "experiments/effects/plan_table.hpp"
#include "experiments/effects/tables.hpp"
#include "experiments/effects/time_planned.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

Selection quick() {
  Selection selection;
  selection.quick = true;
  return selection;
}

std::vector<PlannedView> planned(const std::string& name, const PlanSettings& settings = {}) {
  return plan_views(load_needed_scene(quick(), name), settings, 0);
}

std::string called_for(const std::vector<PlannedView>& views, const std::string& effect) {
  for (const PlanLine& line : plan_lines(views)) {
    if (line.effect == effect) return line.called_for;
  }
  return "there is no such effect";
}

}  // namespace

TEST_CASE("effects: no scene is changed by leaving out what it does not call for") {
  std::vector<std::string> names = scene_names(Selection{});
  for (const std::string& name : lean_scene_names()) names.push_back(name);
  for (const std::string& name : names) {
    CAPTURE(name);
    for (const PlannedView& view : planned(name)) {
      const Harm harm = harm_of(view.plan, view.triangles);
      CHECK(harm.polygons == view.triangles.size());
      CHECK(harm.changed == 0);
      CHECK(harm.attribute_error <= view.tolerance);
      CHECK(harm.attribute_error <= std::max<double>(view.plan.affine_error(), 1e-12));
    }
  }
}

TEST_CASE("effects: harm is found where triangles are not those that were planned for") {
  std::vector<PlannedView> views = planned("telephoto");
  REQUIRE(harm_of(views[0].plan, views[0].triangles).changed == 0);
  views[0].triangles[7][1].position[0] += 1000;
  views[0].triangles[9][0].position[2] = -1;  // w from far away to 1: nothing is affine any more
  const Harm harm = harm_of(views[0].plan, views[0].triangles);
  CHECK(harm.changed == 2);
  CHECK(harm.attribute_error > 0);
}

TEST_CASE("effects: a teapot from afar calls for transform, divide and depth alone") {
  const std::vector<PlannedView> views = planned("telephoto");
  CHECK(called_for_in_short(views) == "divide z");
  CHECK(called_for(views, "near plane") == "no");
  CHECK(called_for(views, "perspective correction") == "no");
  CHECK(called_for(planned("telephoto", {.tolerance = 0}), "perspective correction") == "yes");
}

TEST_CASE("effects: an overlay up to the border of a parallel projection calls for nothing") {
  CHECK(called_for_in_short(planned("overlay")) == "none");
}

TEST_CASE("effects: of an effect in some views only the number of views is told") {
  const std::vector<PlannedView> views = planned("teapot");
  REQUIRE(views.size() == 6);
  CHECK(called_for(views, "far plane") == "cut (1 of 6 views)");
  for (const PlanLine& line : plan_lines(views)) CHECK_FALSE(line.because.empty());
}

TEST_CASE("effects: a row needs no timing, and the finding is made of rows") {
  EffectTables tables;
  const Harm harm{.polygons = 10, .changed = 3, .attribute_error = 0.5};
  tables.add_row("wrong", "none", harm, nullptr);
  CHECK(finding_of(tables.times).find("changes 3 of 10 polygons") != std::string::npos);
  const PlannedTiming timing =
      time_planned(planned("overlay"), {.rounds = 3, .milliseconds_per_run = .1});
  CHECK(timing.full_samples.size() == 3);
  CHECK(timing.planned_ns.median > 0);
  CHECK(timing.to_full.low <= timing.to_full.high);
  tables.add_row("right", "none", {.polygons = 5}, &timing);
  CHECK(finding_of(tables.times).find("on right") != std::string::npos);
  CHECK(plot_of(tables.times).categories.size() == 2);
}
