// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds: scenes of objects x kinds of bounding volume: what they settle, exactly judged, and the
// time saved.
#include <fmt/format.h>

#include "experiments/bounds/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"

namespace clipscope::experiments::bounds {
namespace {

// In float: the bounds are held to what a float clipper sees. By default one with outcodes of its
// own, which reject and accept cheaply, so that what bounds save is not overstated.
Contestants clippers_of(const Selection& selection) {
  Selection chosen = selection;
  if (chosen.clipper == "*") chosen.clipper = "homogeneous/sutherland_hodgman";
  return select_contestants(chosen, {"float"});
}

Options options_of(const Selection& selection) {
  Options options = selection.quick ? Options{9, 4000} : Options{31, 100000};
  if (selection.sample != 0) options.judged_triangles = selection.sample;
  return options;
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const Options options = options_of(selection);
  TableOf<Row> table;
  const std::vector<ObjectSceneName> names = object_scenes(selection);
  Progress progress("bounds", names.size());
  for (const ObjectSceneName& name : names) {
    context.piece(
        fmt::format("{} by {}", name.scene, name.most), {&table}, [&](PieceRecord& record) {
          const ObjectScene scene = load_object_scene(selection, name);
          for (const Contestant* clipper : clippers_of(selection)) {
            for (const Result& result : measure(scene, *clipper, options)) {
              table.add(row_of(scene, *clipper, result));
              const std::string series = fmt::format("{}, {}, {}, {}", scene.scene.name,
                                                     scene.object, result.bound, clipper->clipper);
              record.add(series + ", without", result.without);
              record.add(series + ", with", result.with);
            }
          }
        });
    progress.advance();
  }
  table.add_note(
      fmt::format("Seed {}; about {} triangles of each view judged exactly, if it has so many.",
                  selection.seed, options.judged_triangles));
  table.add_note(timing_description());
  context.emit(table);
  const std::vector<Row> rows = table.rows();
  if (!rows.empty()) context.emit(settled_plot(rows), speedup_plot(rows));
  context.finding(finding(rows));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "bounds",
    "How much do bounding volumes settle before any triangle is cut, and is nothing lost?", run};

}  // namespace clipscope::experiments::bounds
