// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/effects/planned_scene.hpp"

#include <algorithm>
#include <array>

#include "experiments/measure/batches.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/families.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kRun = 1024;  // triangles of a big mesh that stay together

// 600 times as far away as the teapot is high, through a lens that just takes it in.
Scene telephoto(const SceneOptions& options) {
  Scene scene{.name = "telephoto", .description = "the teapot from afar", .mesh = {}, .views = {}};
  scene.mesh = teapot_mesh(options.quick ? 5 : 10);
  const Box box = bounding_box(scene.mesh);
  const double size = glm::length(box.size()), distance = 600 * box.size().y;
  const double degrees = 57.3 * size / distance;
  for (const auto& [label, direction] :
       {std::pair{"front", glm::dvec3(0, 0.2, 1)}, std::pair{"side", glm::dvec3(1, 0.2, 0)}}) {
    const glm::dvec3 eye = box.centre() + distance * glm::normalize(direction);
    scene.views.push_back(
        {label, look_at(eye, box.centre(), {0, 1, 0}),
         perspective_frustum(degrees, 16.0 / 9.0, distance - size, distance + size)});
  }
  return scene;
}

// 96 x 48 glyphs, two triangles each, that fill the window to its border.
Scene overlay(const SceneOptions& options) {
  Scene scene{.name = "overlay", .description = "glyphs over a window", .mesh = {}, .views = {}};
  const int columns = options.quick ? 48 : 96, rows = columns / 2;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double x = double(i) / columns * 16, y = double(j) / rows * 8;
      const double right = double(i + 1) / columns * 16, top = double(j + 1) / rows * 8;
      add_sheet(scene.mesh,
                {.corners = {{{x, y, -1}, {right, y, -1}, {right, top, -1}, {x, top, -1}}}});
    }
  }
  View& view = scene.views.emplace_back();
  view.label = "window";
  view.frustum = {.kind = ProjectionKind::parallel,
                  .left = 0,
                  .right = 16,
                  .bottom = 0,
                  .top = 8,
                  .near = 0,
                  .far = 2};
  return scene;
}

// Three vertices of its own for each triangle, with the attributes of the first.
Scene flat_terrain(const SceneOptions& options) {
  Scene scene = make_builtin_scene("terrain", options);
  scene.name = "flat_terrain";
  scene.description = "the terrain with one colour per triangle";
  Mesh flat;
  for (const auto& triangle : scene.mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(flat.positions.size());
    for (const std::uint32_t corner : triangle) {
      flat.positions.push_back(scene.mesh.positions[corner]);
      flat.attributes.push_back(scene.mesh.attributes[triangle[0]]);
    }
    for (float& a : flat.attributes.back()) a += 0.0f;  // no -0
    flat.attributes[first] = flat.attributes[first + 1] = flat.attributes.back();
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  scene.mesh = std::move(flat);
  return scene;
}

std::vector<SceneTriangle> triangles_in_runs(const Scene& scene, const View& view,
                                             std::size_t limit) {
  const std::size_t all = scene.mesh.triangles.size();
  const std::size_t count = limit == 0 ? all : std::min(all, limit);
  std::vector<SceneTriangle> triangles(count);
  const std::size_t runs = (count + kRun - 1) / kRun;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t begin = run * count / runs, end = (run + 1) * count / runs;
    const std::size_t first = count == all ? begin : run * (all - (end - begin)) / runs;
    view_triangles(scene, view, first, std::span(triangles).subspan(begin, end - begin));
  }
  return triangles;
}

}  // namespace

std::vector<std::string> lean_scene_names() { return {"telephoto", "overlay", "flat_terrain"}; }

NeededScene load_needed_scene(const Selection& selection, const std::string& name) {
  const SceneOptions options{.seed = selection.seed, .quick = selection.quick};
  if (name == "telephoto") return {.scene = telephoto(options)};
  if (name == "overlay") return {.scene = overlay(options), .depth = false};
  if (name == "flat_terrain") return {.scene = flat_terrain(options)};
  return {.scene = load_selected_scene(selection, name)};
}

std::vector<PlannedView> plan_views(const NeededScene& needed, const PlanSettings& settings,
                                    std::size_t limit) {
  std::vector<PlannedView> planned;
  for (const View& view : needed.scene.views) {
    std::vector<SceneTriangle> triangles = triangles_in_runs(needed.scene, view, limit);
    const std::span<const SceneTriangle> all(triangles);
    const SceneFacts<float> facts(projection_of<float>(view), all, attribute_facts(all),
                                  {.guard_band = settings.guard_band});
    const Plan<float> plan(facts, {.tolerance = settings.tolerance, .depth = needed.depth});
    planned.push_back({view, std::move(triangles), facts, plan, settings.tolerance});
  }
  return planned;
}

}  // namespace clipscope::experiments
