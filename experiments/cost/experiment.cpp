// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cost: mixes of triangles x clippers x scalars, timed side by side, and operations counted.
#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/timing.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTriangles = 20000;  // per mix

// The soups are the mixes; any scene that the user names is one, too.
std::vector<std::string> mixes(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"soup", "soup_inside", "soup_outside", "soup_straddling", "soup_behind"};
}

void time_mix(const Scene& scene, const Selection& selection, Table& table) {
  const std::vector<AnyContestant> contestants = selected_contestants(selection);
  const TimingOptions options{.rounds = selection.quick ? 9 : 31};
  const auto timings = measure_time(timed_batches(scene, kTriangles), contestants, options);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Timing& t = timings[i];
    std::vector<Cell> cells = {scene.name, std::string(clipper_name(contestants[i])),
                               std::string(scalar_name(contestants[i]))};
    if (t.refused.empty()) {
      cells.insert(cells.end(), {t.ns.median, t.ns.low, t.ns.high, t.speedup.median, t.speedup.low,
                                 t.speedup.high});
    } else {
      cells.resize(table.columns().size());
    }
    table.add_row(std::move(cells));
  }
}

// Operations per triangle: what a clipper costs, machine and compiler aside.
void count_mix(const Scene& scene, const Selection& selection, Table& table) {
  for (const AnyContestant& any : select_contestants(selection.clipper, {"counting"})) {
    const Contestant<Counted>& contestant = *std::get<const Contestant<Counted>*>(any);
    PolygonStream<Counted, kSceneAttributes> out;
    OperationCounts sum;
    double triangles = 0;
    for (const TimedBatch& batch : timed_batches(scene, kTriangles)) {
      const auto input = triangles_cast<Counted>(batch.triangles);
      const auto projection = projection_of<Counted>(batch.view);
      operation_counts() = {};
      contestant.view(projection, input, out);
      const OperationCounts& counted = operation_counts();
      sum.additions += counted.additions;
      sum.multiplications += counted.multiplications;
      sum.divisions += counted.divisions;
      sum.comparisons += counted.comparisons;
      triangles += static_cast<double>(input.size());
    }
    const auto per_triangle = [&](std::uint64_t n) { return static_cast<double>(n) / triangles; };
    table.add_row({scene.name, std::string(contestant.name), per_triangle(sum.additions),
                   per_triangle(sum.multiplications), per_triangle(sum.divisions),
                   per_triangle(sum.comparisons)});
  }
}

}  // namespace

void run_cost(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table times("cost", "Time per triangle, view space in, NDC polygons out, four attributes",
              {{"mix", "mix"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_textbook", "x textbook"},
               {"speedup_low", "95 % low"},
               {"speedup_high", "high"}});
  Table operations("cost_operations", "Operations per triangle, by kind",
                   {{"mix", "mix"},
                    {"clipper", "clipper"},
                    {"additions", "+ -"},
                    {"multiplications", "*"},
                    {"divisions", "/"},
                    {"comparisons", "comparisons"}});
  const std::vector<std::string> names = mixes(selection);
  Progress progress("cost", names.size());
  for (const std::string& name : names) {
    const Scene scene = load_selected_scene(selection, name);
    time_mix(scene, selection, times);
    count_mix(scene, selection, operations);
    progress.advance();
  }
  times.add_note(
      "x textbook: how many times faster than textbook in float on the same triangles in the "
      "same round; median and 95 % interval. Not timed (-): the answers break the promise.");
  times.add_note(machine_description());
  context.emit(times);
  context.emit(operations);
}

}  // namespace clipscope::experiments
