// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds: scenes of objects x kinds of bounding volume: what they settle, exactly judged, and the time
// saved.
#include <fmt/format.h>

#include "experiments/bounds/report.hpp"
#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

// In float: the bounds are held to what a float clipper sees. By default one with outcodes of its own,
// which reject and accept cheaply, so that what bounds save is not overstated.
std::vector<const Contestant<float>*> clippers_of(const Selection& selection) {
  const std::string pattern =
      selection.clipper == "*" ? "homogeneous/sutherland_hodgman" : selection.clipper;
  std::vector<const Contestant<float>*> clippers;
  for (const AnyContestant& any : select_contestants(pattern, {"float"})) {
    clippers.push_back(std::get<const Contestant<float>*>(any));
  }
  return clippers;
}

BoundsOptions options_of(const Selection& selection) {
  BoundsOptions options = selection.quick ? BoundsOptions{9, 4000} : BoundsOptions{31, 100000};
  if (selection.sample != 0) options.judged_triangles = selection.sample;
  return options;
}

}  // namespace

void run_bounds(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const BoundsOptions options = options_of(selection);
  Table table = bounds_table();
  const std::vector<ObjectSceneName> names = object_scenes(selection);
  Progress progress("bounds", names.size());
  for (const ObjectSceneName& name : names) {
    context.cell(fmt::format("{} by {}", name.scene, name.most), {&table}, [&](CellRecord& record) {
      const ObjectScene scene = load_object_scene(selection, name);
      for (const Contestant<float>* clipper : clippers_of(selection)) {
        for (const BoundResult& result : measure_bounds(scene, *clipper, options)) {
          add_bound(scene, *clipper, result, table, record);
        }
      }
    });
    progress.advance();
  }
  table.add_note(
      fmt::format("Seed {}; about {} triangles of each view judged exactly, if it has so many.",
                  selection.seed, options.judged_triangles));
  table.add_note(machine_description());
  context.emit(table);
  if (const auto plot = settled_plot(table)) context.emit(*plot);
  if (const auto plot = speedup_plot(table)) context.emit(*plot);
  context.finding(bounds_finding(table));
}

}  // namespace clipscope::experiments
