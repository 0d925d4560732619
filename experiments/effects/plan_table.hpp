// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes with what is needed of them, the plan of each of their views, and a plan as people read
// it: effect, called for?, because.
#pragma once

#include <span>

#include "experiments/scenes/scene.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/table/row.hpp"
#include "spaces/effects/plan.hpp"

namespace clipscope::experiments::effects {

// A scene and what the one who draws it asks for beyond the picture's outline.
struct NeededScene {
  Scene scene;
  bool depth = true;  // somebody reads z
};

// What was selected, or all built-in scenes and those of this experiment, which call for little:
//   telephoto     the teapot from afar: all of it inside, w nearly constant
//   overlay       a parallel projection of glyphs up to the window's border; nobody reads depth
//   flat_terrain  the terrain with one colour per triangle
std::vector<std::string> needed_scene_names(const Selection& selection);

// One of this experiment's, or what load_selected_scene takes. Errors: InputError, UsageError.
NeededScene load_needed_scene(const Selection& selection, const std::string& name);

struct PlanSettings {
  float tolerance = PlanOptions<float>{}.tolerance;
  float guard_band = 1;
};

// A view's triangles in the mesh's order (of a big mesh evenly spaced runs of them) and its plan.
struct PlannedView {
  View view;
  std::vector<SceneTriangle> triangles;
  SceneFacts<float> facts;
  Plan<float> plan;
  float tolerance;
};

// Plans each view by itself. `limit`: triangles per view at most; 0: all.
std::vector<PlannedView> plan_views(const NeededScene& needed, const PlanSettings& settings,
                                    std::size_t limit);

struct PlanLine {
  std::string effect;
  // "no", "yes"; of a plane "no", "test" (what is outside is dropped, nothing is cut), "scissor"
  // (left to a guard band) or "cut".
  std::string called_for;
  std::string because;
  int rank = 0;  // 0 for "no"; the more, the more work

  static constexpr auto columns() {
    return std::tuple(column("effect", &PlanLine::effect),
                      column("called_for", "called for?", &PlanLine::called_for),
                      column("because", &PlanLine::because));
  }
};

// One line per effect, always the same effects in the same order.
std::vector<PlanLine> plan_lines(const PlannedView& view);

// The lines of all views of a scene as one: of each effect the line of the view that calls for
// most, with the number of views that call for it.
std::vector<PlanLine> plan_lines(std::span<const PlannedView> views);

// The same for people: effects that some view calls for as rows, views as columns, and the reason
// of the view that calls for most. The other effects are named in a note. Pre-condition: the scene
// has a view.
Table plan_matrix(const std::string& scene, std::span<const PlannedView> views);

// The effects that some view calls for, in few words: "near sides w 1/w".
std::string called_for_in_short(std::span<const PlannedView> views);

}  // namespace clipscope::experiments::effects
