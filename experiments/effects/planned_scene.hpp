// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes with what is needed of them, and the plan of each of their views.
#pragma once

#include <string>
#include <vector>

#include "experiments/commands/selection.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/effects/plan.hpp"

namespace clipscope::experiments {

// A scene and what the one who draws it asks for beyond the picture's outline.
struct NeededScene {
  Scene scene;
  bool depth = true;  // somebody reads z
};

// Scenes of this experiment, which call for little:
//   telephoto     the teapot from afar: all of it inside, w nearly constant
//   overlay       a parallel projection of glyphs up to the window's border; nobody reads depth
//   flat_terrain  the terrain with one colour per triangle
std::vector<std::string> lean_scene_names();

// One of these, or what load_selected_scene takes. Errors: InputError, UsageError.
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

}  // namespace clipscope::experiments
