// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/effects/plan_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <utility>

#include "experiments/report/table.hpp"

namespace clipscope::experiments {
namespace {

// Near first, as the planes cut.
constexpr std::array<std::pair<Plane, const char*>, kPlanes> kPlaneEffects = {
    {{Plane::near, "near plane"},
     {Plane::far, "far plane"},
     {Plane::left, "left side"},
     {Plane::right, "right side"},
     {Plane::bottom, "bottom side"},
     {Plane::top, "top side"}}};

PlanLine line(std::string effect, bool called_for, std::string because) {
  return {std::move(effect), called_for ? "yes" : "no", std::move(because), called_for};
}

PlanLine plane_line(std::string effect, PlaneEffect what, const char* unused) {
  static constexpr std::array<const char*, 4> kCalledFor = {"no", "test", "scissor", "cut"};
  static constexpr std::array<const char*, 4> kBecause = {
      "", "some triangles lie beyond, none crosses", "crossed, but within the guard band",
      "some triangle may cross it"};
  const auto i = static_cast<std::size_t>(what);
  return {std::move(effect), kCalledFor[i], i == 0 ? unused : kBecause[i], static_cast<int>(i)};
}

const char* unused_plane(const ClipVolume& volume, Plane plane) {
  const bool is_depth = plane == Plane::near || plane == Plane::far;
  return volume.depth_clamp && is_depth ? "depth is clamped"
                                        : "no vertex of what is left is outside";
}

PlanLine w_guard_line(const PlannedView& view) {
  const bool is_clamped = view.plan.projection().volume.depth_clamp;
  return line("w guard", view.plan.effects().w_guard(),
              view.facts.has_bad_w() ? "some w may be 0, negative or not finite"
              : is_clamped           ? "depth is clamped and may overflow"
                                     : "w > 0 at every vertex of what is left");
}

PlanLine divide_line(const PlannedView& view) {
  return line("divide by w", view.plan.effects().divide(),
              view.facts.has_unit_w() ? "w = 1 at every vertex" : "perspective");
}

PlanLine perspective_line(const PlannedView& view, float tolerance) {
  const double error = view.plan.affine_error();
  const bool called_for = view.plan.effects().perspective();
  std::string because;
  if (view.facts.has_unit_w()) {
    because = "w = 1 at every vertex";
  } else if (view.facts.attributes().flat) {
    because = "constant over each triangle";
  } else if (!std::isfinite(error)) {
    because = "w of some triangle reaches 0";
  } else {
    because = fmt::format("affine error up to {}, tolerance {}", format_number(error),
                          format_number(tolerance));
  }
  return line("perspective correction", called_for, because);
}

PlanLine interpolation_line(const PlannedView& view) {
  const EffectSet& e = view.plan.effects();
  const bool cuts = e.has_plane(PlaneEffect::cut);
  return line("attributes of new vertices", e.interpolation(),
              !cuts                          ? "no triangle is cut"
              : view.facts.attributes().flat ? "constant over each triangle"
                                             : "a cut makes vertices, and attributes vary");
}

}  // namespace

std::vector<PlanLine> plan_lines(const PlannedView& view) {
  const EffectSet& e = view.plan.effects();
  const ClipVolume& volume = view.plan.projection().volume;
  std::vector<PlanLine> lines;
  for (const auto& [plane, name] : kPlaneEffects) {
    lines.push_back(plane_line(name, e.plane(plane), unused_plane(volume, plane)));
  }
  lines.push_back(
      plane_line("user planes", e.user_planes(),
                 volume.clip_distances == 0 ? "there is none" : "every clip distance is >= 0"));
  lines.push_back(w_guard_line(view));
  lines.push_back(divide_line(view));
  lines.push_back(perspective_line(view, view.tolerance));
  lines.push_back(line("depth", e.depth(), e.depth() ? "it is read" : "nobody reads it"));
  lines.push_back(interpolation_line(view));
  const LookOptions<float>& look = view.facts.options();
  lines.push_back(line("segments", look.segments > 0,
                       look.segments > 0 ? "the scene has some" : "the scene has none"));
  lines.push_back(line("points", look.points > 0,
                       look.points > 0 ? "the scene has some" : "the scene has none"));
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

std::string called_for_in_short(std::span<const PlannedView> views) {
  EffectSet e = views.front().plan.effects();
  for (const PlannedView& view : views) e = e | view.plan.effects();
  const auto is_used = [&](Plane p) { return e.plane(p) != PlaneEffect::none; };
  std::vector<const char*> words;
  const auto add = [&](bool called_for, const char* word) {
    if (called_for) words.push_back(word);
  };
  add(is_used(Plane::near), "near");
  add(is_used(Plane::far), "far");
  add(is_used(Plane::left) || is_used(Plane::right) || is_used(Plane::bottom) ||
          is_used(Plane::top),
      "sides");
  add(e.user_planes() != PlaneEffect::none, "user");
  add(e.w_guard(), "w");
  add(e.divide(), "divide");
  add(e.perspective(), "1/w");
  add(e.depth(), "z");
  add(e.interpolation(), "attributes");
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, " "));
}

}  // namespace clipscope::experiments
