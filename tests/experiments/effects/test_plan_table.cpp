// SPDX-License-Identifier: GPL-3.0-or-later
//
// What scenes call for.
#include "tests/catch.hpp"
#include "tests/experiments/effects/planned.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::effects;

namespace {

std::string called_for(const std::vector<PlannedView>& views, const std::string& effect) {
  for (const PlanLine& line : plan_lines(views)) {
    if (line.effect == effect) return line.called_for;
  }
  return "there is no such effect";
}

}  // namespace

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

TEST_CASE("effects: a matrix as given calls for what the frustum calls for whose rows it has") {
  Selection selection;
  selection.quick = true;
  for (const char* name : {"teapot", "corridor", "overlay"}) {
    NeededScene needed = load_needed_scene(selection, name);
    const std::vector<PlannedView> by_frustum = plan_views(needed, {}, 500);
    for (View& view : needed.scene.views) {
      view.matrix = clipscope::rows_of(clipscope::Projection<float>(view.frustum));
      view.frustum = {.depth = view.frustum.depth};
    }
    const std::vector<PlannedView> by_matrix = plan_views(needed, {}, 500);
    for (std::size_t v = 0; v < by_matrix.size(); ++v) {
      INFO(name << ", view " << v);
      CHECK(called_for_in_short(std::span(&by_matrix[v], 1)) ==
            called_for_in_short(std::span(&by_frustum[v], 1)));
      CHECK(by_matrix[v].facts.w_ratio() == by_frustum[v].facts.w_ratio());
    }
  }
}
