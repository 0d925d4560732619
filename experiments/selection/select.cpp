// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/selection/select.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <string>

#include "experiments/contestants/spoken.hpp"
#include "experiments/guests/seeded.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/warning.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/recentre.hpp"

namespace clipscope::experiments {
namespace {

bool matches(std::string_view pattern, std::string_view name) {
  const std::string p(pattern);
  const std::string n(name);
  if (fnmatch(p.c_str(), n.c_str(), 0) == 0) return true;
  return n.starts_with(p + "/") || n.ends_with("/" + p);
}

constexpr std::array<std::string_view, 4> kPrimitives = {"polygons", "points", "segments",
                                                         "triangles"};

std::vector<std::string_view> matching_clippers(std::string_view pattern, int vertices) {
  const std::vector<std::string_view> names = clipper_names(vertices);
  std::vector<std::string_view> matching;
  for (const std::string_view name : names) {
    if (name == pattern) return {name};
    if (matches(pattern, name)) matching.push_back(name);
  }
  if (matching.empty()) {
    throw UsageError(fmt::format("--clipper: no clipper of {} matches '{}'; there are: {}",
                                 kPrimitives[static_cast<std::size_t>(vertices)], pattern,
                                 fmt::join(names, ", ")));
  }
  return matching;
}

void check_scalar(std::string_view scalar) {
  const std::vector<std::string_view> names = scalar_names();
  if (std::ranges::find(names, scalar) == names.end()) {
    throw UsageError(fmt::format("--scalar: no scalar is called '{}'; there are: {}", scalar,
                                 fmt::join(names, ", ")));
  }
}

// Those that are not there yet, in those of the scalars that they compute in.
void add_guests(const Selection& selection, const std::vector<std::string>& scalars, int vertices,
                Contestants& all) {
  for (const std::string_view guest : selection.guests) {
    for (const std::string& scalar : scalars) {
      const Contestant* found = find_in_contract(guest, scalar, Contract::full, vertices);
      if (found != nullptr && std::ranges::find(all, found) == all.end()) all.push_back(found);
    }
  }
}

}  // namespace

std::vector<std::string_view> clipper_names(int vertices) {
  std::vector<std::string_view> names;
  for (const Contestant& c : all_contestants()) {
    if (c.contract != Contract::full || c.vertices != vertices) continue;
    if (std::ranges::find(names, c.clipper) == names.end()) names.push_back(c.clipper);
  }
  return names;
}

std::vector<std::string_view> scalar_names() {
  std::vector<std::string_view> names;
  for_each_type(AllScalars{}, [&]<class T>() { names.push_back(kFormat<T>.name); });
  return names;
}

const Contestant* find_in_contract(std::string_view clipper, std::string_view scalar,
                                   Contract contract, int vertices) {
  const auto found = std::ranges::find_if(all_contestants(), [&](const Contestant& c) {
    return c.clipper == clipper && c.scalar() == scalar && c.contract == contract &&
           c.vertices == vertices;
  });
  return found == all_contestants().end() ? nullptr : &*found;
}

Contestants select_contestants(std::string_view clipper_pattern,
                               const std::vector<std::string>& scalars, int vertices) {
  Contestants selected;
  std::ranges::for_each(scalars, check_scalar);
  for (const std::string& scalar : scalars) add_if_seeded(clipper_pattern, scalar);
  for (const std::string_view clipper : matching_clippers(clipper_pattern, vertices)) {
    for (const std::string& scalar : scalars) {
      const Contestant* found = find_in_contract(clipper, scalar, Contract::full, vertices);
      if (found != nullptr) selected.push_back(found);
    }
  }
  if (selected.empty()) {
    throw UsageError(fmt::format("--clipper: '{}' does not exist in {}", clipper_pattern,
                                 fmt::join(scalars, ", ")));
  }
  return selected;
}

const Contestant& find_contestant(std::string_view clipper, std::string_view scalar, int vertices) {
  check_scalar(scalar);
  add_if_seeded(clipper, scalar);
  const std::vector<std::string_view> matching = matching_clippers(clipper, vertices);
  if (matching.size() > 1) {
    throw UsageError(fmt::format("--clipper: '{}' matches several clippers, name one of: {}",
                                 clipper, fmt::join(matching, ", ")));
  }
  const Contestant* found = find_in_contract(matching.front(), scalar, Contract::full, vertices);
  if (found == nullptr) {
    const std::string_view name = matching.front();
    throw UsageError(
        is_guest(name)
            ? fmt::format("--scalar: {} does not compute in {}", name, scalar)
            : fmt::format("--scalar: {} needs an operation that {} does not have", name, scalar));
  }
  return *found;
}

bool has_clipper(const Contestants& contestants, std::string_view clipper) {
  return std::ranges::any_of(contestants,
                             [&](const Contestant* c) { return c->clipper == clipper; });
}

Contestants stage_contestants(const StageInput& input) {
  Contestants all;
  for (const Contestant& c : all_contestants()) {
    if (!c.prepare_stage) continue;
    if (all.empty() || input.size(c.contract) > 0) all.push_back(&c);
  }
  return all;
}

Contestants stage_only_contestants(std::string_view clipper_pattern) {
  Contestants all;
  for (const Contestant& c : all_contestants()) {
    if (!c.prepare_stage || !matches(clipper_pattern, c.clipper)) continue;
    if (find_in_contract(c.clipper, c.scalar(), Contract::full) == nullptr) all.push_back(&c);
  }
  return all;
}

std::vector<std::string> scene_names(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  std::vector<std::string> names;
  for (const SceneInfo& info : builtin_scenes()) names.emplace_back(info.name);
  return names;
}

Scene load_selected_scene(const Selection& selection, const std::string& name) {
  const SceneOptions options{.seed = selection.seed, .quick = selection.quick};
  Scene scene = load_scene(name, options, selection.camera);
  if (selection.recentre) recentre(scene);
  std::ranges::for_each(scene.mesh.remarks, warn);
  const std::string lost = describe(lost_detail(scene.mesh), scene.name);
  if (!lost.empty()) warn(lost);
  return scene;
}

Contestants select_contestants(const Selection& selection, const std::vector<std::string>& scalars,
                               int vertices) {
  Contestants all = select_contestants(selection.clipper, scalars, vertices);
  add_guests(selection, scalars, vertices, all);
  return all;
}

Contestants selected_contestants(const Selection& selection, int vertices) {
  return select_contestants(selection, selection.scalars, vertices);
}

void check_scalars_of_guests(const Selection& selection) {
  for (const std::string_view guest : selection.guests) {
    const auto is_selected = [&](const Contestant& c) {
      return c.clipper == guest && std::ranges::count(selection.scalars, c.scalar()) > 0;
    };
    if (std::ranges::any_of(all_contestants(), is_selected)) continue;
    throw UsageError(fmt::format("--scalar: {} does not compute in {}", guest,
                                 fmt::join(selection.scalars, ", ")));
  }
}

Contestants named_contestants(const Selection& selection, std::span<const std::string_view> names) {
  if (selection.clipper != Selection{}.clipper) return selected_contestants(selection);
  Contestants all;
  for (const std::string_view name : names) {
    for (const Contestant* c : select_contestants(name, selection.scalars)) all.push_back(c);
  }
  add_guests(selection, selection.scalars, 3, all);
  return all;
}

}  // namespace clipscope::experiments
