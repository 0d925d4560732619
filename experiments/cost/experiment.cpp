// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cost: mixes of triangles x clippers x scalars, timed side by side, operations counted, and where the
// time goes: transform, cut, divide; then the same for clippers that are a stage of a renderer.
#include <fmt/format.h>

#include "experiments/cost/split.hpp"
#include "experiments/cost/stage.hpp"
#include "experiments/cost/tables.hpp"
#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/timing.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTriangles = 20000;  // per mix
constexpr std::size_t kQuickTriangles = 2000;

// The soups are the mixes; any scene that the user names is one, too.
std::vector<std::string> mixes(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"soup", "soup_inside", "soup_outside", "soup_straddling", "soup_behind"};
}

void record_samples(const std::string& mix, std::span<const AnyContestant> contestants,
                    std::span<const Timing> timings, std::span<const Split> splits,
                    CellRecord& record) {
  constexpr const char* kUnit = "ns per triangle";
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (!timings[i].refused.empty()) continue;
    record.samples.push_back(
        {fmt::format("{} {} {}", mix, clipper_name(contestants[i]), scalar_name(contestants[i])),
         kUnit, timings[i].samples_ns});
  }
  for (const Split& split : splits) {
    for (const SplitPart& part : split.parts) {
      record.samples.push_back(
          {fmt::format("{} {} {} {}", mix, split.clipper, split.scalar, part.name), kUnit,
           part.samples_ns});
    }
  }
}

}  // namespace

void run_cost(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<AnyContestant> contestants = selected_contestants(selection);
  const TimingOptions options{.rounds = selection.quick ? 5 : 31,
                              .milliseconds_per_run = selection.quick ? 0.3 : 2.0,
                              .checked_triangles = selection.quick ? 24u : 256u};
  Table times = cost_table(), operations = cost_operations_table(), split = cost_split_table();
  const std::vector<std::string> names = mixes(selection);
  Progress progress("cost", names.size());
  for (const std::string& name : names) {
    context.cell("mix " + name, {&times, &operations, &split}, [&](CellRecord& record) {
      const Scene scene = load_selected_scene(selection, name);
      const std::vector<TimedBatch> batches =
          timed_batches(scene, selection.quick ? kQuickTriangles : kTriangles);
      const std::vector<Timing> timings = measure_time(batches, contestants, options);
      const std::vector<Split> splits =
          measure_split(batches, contestants, timings, options.rounds);
      add_cost_rows(scene.name, contestants, timings, times);
      add_operation_rows(scene.name, batches, contestants, operations);
      add_split_rows(scene.name, splits, split);
      record_samples(scene.name, contestants, timings, splits, record);
    });
    progress.advance();
  }
  for (Table* table : {&times, &operations, &split}) {
    table->add_note(machine_description());
    context.emit(*table);
  }
  context.emit(cost_plot(times));
  if (!split.rows().empty()) context.emit(split_plot(split));
  const std::string stage = run_stage(context);
  context.finding(cost_finding(times, operations) + (stage.empty() ? "" : " " + stage));
}

}  // namespace clipscope::experiments
