// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/effects/plan_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/report/outcode_text.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments::effects {
namespace {

constexpr std::size_t kRun = 1024;  // triangles of a big mesh that stay together

// 600 times as far away as the teapot is high, through a lens that just takes it in.
Scene telephoto(const SceneOptions& options) {
  Scene scene{"telephoto", "the teapot from afar", teapot_mesh(options.quick ? 5 : 10), {}};
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
  Scene scene{"overlay", "glyphs over a window", {}, {}};
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
  view.frustum = {ProjectionKind::parallel, 0, 16, 0, 8, 0, 2};  // from, to in x, y and depth
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
    auto attributes = scene.mesh.attributes[triangle[0]];
    for (float& a : attributes) a += 0.0f;  // no -0
    for (const std::uint32_t corner : triangle) {
      flat.positions.push_back(scene.mesh.positions[corner]);
      flat.attributes.push_back(attributes);
    }
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

PlanLine plane_line(const std::string& effect, PlaneEffect what, const char* unused) {
  static constexpr std::array<std::pair<const char*, const char*>, 4> kTexts = {
      {{"no", nullptr},
       {"test", "some triangles lie beyond, none crosses"},
       {"scissor", "crossed, but within the guard band"},
       {"cut", "some triangle may cross it"}}};
  const auto& [called_for, because] = kTexts[static_cast<std::size_t>(what)];
  return {effect, called_for, because == nullptr ? unused : because, static_cast<int>(what)};
}

std::string perspective_reason(const PlannedView& view) {
  const double error = view.plan.affine_error();
  if (view.facts.has_unit_w()) return "w = 1 at every vertex";
  if (view.facts.attributes().flat) return "constant over each triangle";
  if (!std::isfinite(error)) return "w of some triangle reaches 0";
  return fmt::format("affine error up to {}, tolerance {}", format_number(error),
                     format_number(view.tolerance));
}

// "near plane, far plane (no vertex of what is left is outside); points (the scene has none)".
std::string by_reason(std::span<const PlanLine* const> lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += (text.empty() ? "" : text.ends_with(')') ? "; " : ", ") + lines[i]->effect;
    const bool goes_on = i + 1 < lines.size() && lines[i + 1]->because == lines[i]->because;
    if (!goes_on) text += " (" + lines[i]->because + ")";
  }
  return text;
}

}  // namespace

std::vector<std::string> needed_scene_names(const Selection& selection) {
  std::vector<std::string> names = scene_names(selection);
  if (selection.scenes.empty()) names.insert(names.end(), {"telephoto", "overlay", "flat_terrain"});
  return names;
}

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
    const LookOptions<float> look{.guard_band = settings.guard_band};
    const AttributeFacts<float> attributes = attribute_facts(all);
    const SceneFacts<float> facts =
        view.matrix
            ? SceneFacts<float>({.depth = view.frustum.depth}, *view.matrix, all, attributes, look)
            : SceneFacts<float>(Projection<float>(view.frustum), all, attributes, look);
    const Plan<float> plan(facts, {.tolerance = settings.tolerance, .depth = needed.depth});
    planned.push_back({view, std::move(triangles), facts, plan, settings.tolerance});
  }
  return planned;
}

std::vector<PlanLine> plan_lines(const PlannedView& view) {
  const EffectSet& e = view.plan.effects();
  const SceneFacts<float>& facts = view.facts;
  const ClipVolume& volume = view.plan.projection().volume;
  std::vector<PlanLine> lines;
  for (const Plane plane : kPlaneOrder<PlaneOrder::near_first>) {
    const bool is_depth = plane == Plane::near || plane == Plane::far;
    const bool is_clamped = (planes_of(volume) & bit(plane)) == 0;
    lines.push_back(
        plane_line(plane_text(plane) + (is_depth ? " plane" : " side"), e.plane(plane),
                   is_clamped ? "depth is clamped" : "no vertex of what is left is outside"));
  }
  lines.push_back(
      plane_line("user planes", e.user_planes(),
                 volume.clip_distances == 0 ? "there is none" : "every clip distance is >= 0"));
  const auto add = [&](const char* effect, bool called_for, std::string because) {
    lines.push_back({effect, called_for ? "yes" : "no", std::move(because), called_for});
  };
  add("w guard", e.w_guard(),
      facts.has_bad_w()    ? "some w may be 0, negative or not finite"
      : volume.depth_clamp ? "depth is clamped and may overflow"
                           : "w > 0 at every vertex of what is left");
  add("divide by w", e.divide(), facts.has_unit_w() ? "w = 1 at every vertex" : "perspective");
  add("perspective correction", e.perspective(), perspective_reason(view));
  add("depth", e.depth(), e.depth() ? "it is read" : "nobody reads it");
  add("attributes of new vertices", e.interpolation(),
      !e.has_plane(PlaneEffect::cut) ? "no triangle is cut"
      : facts.attributes().flat      ? "constant over each triangle"
                                     : "a cut makes vertices, and attributes vary");
  for (const auto& [name, count] : {std::pair{"segments", facts.options().segments},
                                    std::pair{"points", facts.options().points}}) {
    add(name, count > 0, count > 0 ? "the scene has some" : "the scene has none");
  }
  return lines;
}

std::vector<PlanLine> plan_lines(std::span<const PlannedView> views) {
  std::vector<PlanLine> most = plan_lines(views.front());
  std::vector<std::size_t> calling(most.size(), 0);
  for (const PlannedView& view : views) {
    const std::vector<PlanLine> lines = plan_lines(view);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      calling[i] += lines[i].rank > 0;
      if (lines[i].rank > most[i].rank) most[i] = lines[i];
    }
  }
  for (std::size_t i = 0; i < most.size(); ++i) {
    if (calling[i] > 0 && calling[i] < views.size()) {
      most[i].called_for += fmt::format(" ({} of {} views)", calling[i], views.size());
    }
  }
  return most;
}

Table plan_matrix(const std::string& scene, std::span<const PlannedView> views) {
  std::vector<Column> columns = {{"effect", "effect"}};
  std::vector<std::vector<PlanLine>> lines;
  for (const PlannedView& view : views) {
    columns.push_back({view.view.label, view.view.label});
    lines.push_back(plan_lines(view));
  }
  columns.push_back({"because", "because"});
  Table table("plan", fmt::format("Effects that {} calls for, by view", scene), columns);
  std::vector<const PlanLine*> uncalled;
  for (std::size_t i = 0; i < lines[0].size(); ++i) {
    const auto most = std::ranges::max_element(
        lines, {}, [i](const std::vector<PlanLine>& of_view) { return of_view[i].rank; });
    const PlanLine& line = (*most)[i];
    if (line.rank == 0) {
      uncalled.push_back(&line);
      continue;
    }
    std::vector<Cell> cells = {line.effect};
    for (const auto& of_view : lines) cells.emplace_back(of_view[i].called_for);
    cells.emplace_back(line.because);
    table.add_row(std::move(cells));
  }
  if (!uncalled.empty()) table.add_note("Called for by no view: " + by_reason(uncalled) + ".");
  return table;
}

std::string called_for_in_short(std::span<const PlannedView> views) {
  EffectSet e = views.front().plan.effects();
  for (const PlannedView& view : views) e = e | view.plan.effects();
  const auto some = [&](auto... planes) { return ((e.plane(planes) != PlaneEffect::none) || ...); };
  std::vector<const char*> words;
  for (const auto& [called_for, word] :
       {std::pair{some(Plane::near), "near"}, std::pair{some(Plane::far), "far"},
        std::pair{some(Plane::left, Plane::right, Plane::bottom, Plane::top), "sides"},
        std::pair{e.user_planes() != PlaneEffect::none, "user"}, std::pair{e.w_guard(), "w"},
        std::pair{e.divide(), "divide"}, std::pair{e.perspective(), "1/w"},
        std::pair{e.depth(), "z"}, std::pair{e.interpolation(), "attributes"}}) {
    if (called_for) words.push_back(word);
  }
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, " "));
}

}  // namespace clipscope::experiments::effects
