// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cost: mixes of triangles x clippers x scalars, timed side by side, operations counted, and where
// the time goes; then the same for clippers that are a stage of a renderer.
#include <fmt/format.h>

#include "experiments/cost/flags.hpp"
#include "experiments/cost/plugin.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/survey/contest_clock.hpp"

namespace clipscope::experiments::cost {
namespace {

constexpr std::size_t kTriangles = 20000;  // per mix
constexpr std::size_t kQuickTriangles = 2000;

// Runs the clippers of the contestants in the counting scalar, those that there are in it.
void count_operations(const std::string& mix, std::span<const Batch> batches,
                      const Contestants& contestants, TableOf<OperationsRow>& table) {
  double triangles = 0;
  for (const Batch& batch : batches) triangles += static_cast<double>(batch.size());
  const auto per_triangle = [&](std::uint64_t n) { return static_cast<double>(n) / triangles; };
  for (const std::string_view clipper : clipper_names()) {
    const Contestant* counting = find_in_contract(clipper, kFormat<Counted>.name, Contract::full);
    if (counting == nullptr || !has_clipper(contestants, clipper)) continue;
    const std::unique_ptr<Runner> runner = counting->prepare(batches);
    operation_counts() = {};
    for (std::size_t b = 0; b < batches.size(); ++b) runner->clip(b, 0, batches[b].size());
    const OperationCounts sum = operation_counts();
    table.add({mix, std::string(clipper), per_triangle(sum.additions),
               per_triangle(sum.multiplications), per_triangle(sum.divisions),
               per_triangle(sum.comparisons)});
  }
}

std::vector<Row> time_full(const std::string& mix, std::span<const SampledView> views,
                           const Contestants& contestants, const ContestClock& clock,
                           PieceRecord& record) {
  const std::vector<Timing> timings =
      time_contestants(batches_of(views), contestants, find_contestant("textbook", "float"), clock);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Contestant& c = *contestants[i];
    rows.push_back({mix, std::string(c.clipper), std::string(c.scalar()), if_timed(timings[i])});
    record.add(fmt::format("{} {} {}", mix, c.clipper, c.scalar()), timings[i]);
  }
  return rows;
}

std::string run_full(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const Contestants contestants = selected_contestants(selection);
  const ContestClock clock = contest_clock(selection.quick);
  TableOf<Row> times;
  TableOf<OperationsRow> operations;
  TableOf<SplitRow> split;
  // The soups are the mixes; any scene that the user names is one, too.
  const std::vector<std::string> names =
      selection.scenes_or({"soup", "soup_inside", "soup_outside", "soup_straddling", "soup_behind",
                           "soup_several_planes"});
  Progress progress("cost", names.size());
  for (const std::string& name : names) {
    context.piece("mix " + name, {&times, &operations, &split}, [&](PieceRecord& record) {
      const Scene scene = load_selected_scene(selection, name);
      const auto views = sampled_views(scene, selection.quick ? kQuickTriangles : kTriangles);
      const auto rows = time_full(scene.name, views, contestants, clock, record);
      for (const Row& row : rows) times.add(row);
      count_operations(scene.name, batches_of(views), contestants, operations);
      measure_split(views, rows, clock.rounds, split, record);
    });
    progress.advance();
  }
  times.add_note(timing_description());
  operations.add_note(machine_description());
  split.add_note(timing_description());
  TableOf<SpaceRow> spaces;
  for (const SpaceRow& row : space_rows(times.rows(), operations.rows())) spaces.add(row);
  context.emit(times, operations, spaces, split, time_plot(times.rows()));
  if (!split.rows().empty()) context.emit(split_plot(split.rows()));
  return space_finding(spaces.rows());
}

GrowthOptions growth_options(const Selection& selection) {
  GrowthOptions options{.seed = selection.seed, .clock = stage_clock(selection.quick)};
  options.clock.rounds = std::min(options.clock.rounds, static_cast<int>(kLeastRounds));
  options.clock.check = {.triangles = 8192, .exact = selection.quick ? 8u : 64u};
  if (selection.quick) {
    options.soup = 40'000;
    options.most = 100'000;
    options.attribute_soup = 10'000;
    options.crossing = 32;
  }
  return options;
}

void run_growth(const ExperimentContext& context) {
  TableOf<GrowthRow> growth;
  for (const Growing growing : kGrowing) {
    context.piece(fmt::format("growth {}", name_of(growing)), {&growth}, [&](PieceRecord& record) {
      measure_growth(growing, growth_options(context.selection()), growth, record);
    });
  }
  growth.add_note(timing_description());
  context.emit(growth);
  for (const Growing growing : kGrowing) {
    const Plot plot = growth_plot(growth.rows(), growing);
    if (!plot.series.empty()) context.emit(plot);
  }
}

void run(const ExperimentContext& context) {
  const std::string full = run_full(context), stage = run_stage(context);
  run_growth(context);
  run_flags(context);
  run_plugin(context);
  context.finding(full + (stage.empty() ? "" : " " + stage));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "cost", "How long does each clipper take, by mix of triangles and scalar, against textbook?",
    run};

}  // namespace clipscope::experiments::cost
