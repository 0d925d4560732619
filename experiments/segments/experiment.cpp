// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments: mixes x line clippers x scalars, timed side by side, judged, operations counted.
#include <fmt/format.h>

#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/segments/rows.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/survey/verdicts.hpp"

namespace clipscope::experiments::segments {
namespace {

// None where the pattern means triangles only.
Contestants contestants_of(const Selection& selection, const std::vector<std::string>& scalars) {
  const Contestants contestants = case_contestants(Primitive::segment, selection, scalars);
  if (contestants.empty()) select_contestants(selection.clipper, scalars);
  return contestants;
}

// What slower scalars would tell is known: they are right. They are run if no other is chosen.
std::vector<std::string> timed_scalars(const Selection& selection) {
  std::vector<std::string> fast = selection.scalars;
  std::erase_if(fast, [](const std::string& s) { return s != "float" && s != "double"; });
  return fast.empty() ? selection.scalars : fast;
}

Mix load_mix(const Selection& selection, const std::string& name, std::size_t size) {
  if (selection.scenes.empty()) return make_mix(name, size, selection.seed);
  return make_wireframe(load_selected_scene(selection, name), size);
}

void record_worst(const Contestant& contestant, const Tally& tally, PieceRecord& record) {
  const auto add = [&](const std::string& replay, const std::string& measure, double error) {
    if (replay.empty()) return;
    record.worst_inputs.push_back(worst_input(contestant, replay, measure, error, "clip"));
  };
  add(tally.worst, "position_px", tally.max_px);
  add(tally.failing, fmt::format("outcome_{}", name_of(tally.failing_outcome())),
      static_cast<double>(tally.failures));
}

void add_rows(const Mix& mix, const Contestants& contestants, std::span<const Tally> tallies,
              std::span<const Timing> timings, TableOf<TimeRow>& table, PieceRecord& record) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Contestant& c = *contestants[i];
    const Tally& tally = tallies[i];
    table.add({.mix = mix.name,
               .clipper = std::string(c.clipper),
               .scalar = std::string(c.scalar()),
               .timing = if_timed(timings[i]),
               .visible = sum_of(tally.outcomes),
               .wrong = tally.failures,
               .wrong_kinds = wrong_kinds(tally),
               .max_px = tally.max_px,
               .max_ulp = tally.max_ulp});
    record.add(fmt::format("{} {} {}", mix.name, c.clipper, c.scalar()), timings[i], "segment");
    record_worst(c, tally, record);
  }
}

// Through the contract, from view space to NDC.
struct Mixes {
  TableOf<TimeRow> times;
  TableOf<OperationsRow> operations;
};

Mixes measure_mixes(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const Contestants contestants = contestants_of(selection, timed_scalars(selection));
  const Contestants counted = contestants_of(selection, {std::string(kFormat<Counted>.name)});
  const std::size_t size = selection.quick ? 2000 : 20000;    // segments of a mix
  const std::size_t judged = selection.sample_or(600, 8000);  // of these, in each view
  Mixes tables;
  const std::vector<std::string> names = selection.scenes_or(builtin_mixes());
  Progress progress("segments", names.size());
  for (const std::string& name : names) {
    context.piece(name, {&tables.times, &tables.operations}, [&](PieceRecord& record) {
      const Mix mix = load_mix(selection, name, size), sample = thinned(mix, judged);
      add_rows(mix, contestants, judge(sample, contestants),
               time_clippers(mix, contestants, contest_clock(selection.quick)), tables.times,
               record);
      for (const OperationsRow& row : count_operations(sample, counted)) tables.operations.add(row);
    });
    progress.advance();
  }
  tables.times.add_note(fmt::format("Seed {}; {} segments a mix, at most {} of each view judged.",
                                    selection.seed, size, judged));
  tables.times.add_note(timing_description());
  return tables;
}

TableOf<IntersectionRow> count_intersections(const ExperimentContext& context) {
  TableOf<IntersectionRow> table;
  context.piece("intersection", {&table}, [&](PieceRecord&) {
    for (const IntersectionRow& row : intersection_costs()) table.add(row);
  });
  return table;
}

TableOf<PlaneRow> measure_plane(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const Contestants contestants =
      contestants_in(Contract::plane, selection.clipper, timed_scalars(selection));
  const std::size_t size = selection.quick ? 2000 : 20000;
  const std::size_t judged = selection.sample_or(400, 4000);
  TableOf<PlaneRow> table;
  if (contestants.empty()) return table;
  Progress progress("segments in the plane", plane_mixes().size());
  for (const std::string& name : plane_mixes()) {
    context.piece("plane " + name, {&table}, [&](PieceRecord&) {
      const ClipSegments mix = make_plane_mix(name, size, selection.seed);
      for (const PlaneRow& row :
           measure_in_plane(mix, contestants, judged, contest_clock(selection.quick))) {
        table.add(row);
      }
    });
    progress.advance();
  }
  table.add_note(fmt::format("Seed {}; {} segments a mix, {} judged and counted.", selection.seed,
                             size, judged));
  table.add_note(timing_description());
  return table;
}

TableOf<HardRow> judge_hard_sets(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Contestants contestants;
  for (const Contract contract : {Contract::plane, Contract::full}) {
    for (const Contestant* c :
         contestants_in(contract, selection.clipper, timed_scalars(selection))) {
      contestants.push_back(c);
    }
  }
  TableOf<HardRow> table;
  Progress progress("hard sets of segments", hard_sets().size());
  for (const std::string& name : hard_sets()) {
    context.piece("hard " + name, {&table}, [&](PieceRecord&) {
      const ClipSegments set = make_hard_set(name, selection.sample_or(500, 5000), selection.seed);
      for (const HardRow& row : judge_hard_set(set, contestants)) table.add(row);
    });
    progress.advance();
  }
  return table;
}

// The contest in a convex window, a piece for each number of edges; returns its finding.
std::string run_convex(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::size_t size = selection.quick ? 2000 : 20000;
  const std::size_t judged = selection.sample_or(60, 1000);
  TableOf<ConvexRow> table;
  for (const int edges : kConvexEdges) {
    context.piece(fmt::format("convex_{}", edges), {&table}, [&](PieceRecord& record) {
      const ConvexCase input = make_convex_case(edges, size, selection.seed);
      for (const ConvexRow& row : measure_convex(input, judged, contest_clock(selection.quick))) {
        table.add(row);
        if (!row.timing) continue;
        record.add(fmt::format("convex {} {}", edges, row.method), *row.timing, "segment");
      }
    });
  }
  table.add_note(fmt::format("Seed {}; {} segments, {} judged.", selection.seed, size, judged));
  table.add_note(timing_description());
  context.emit(table);
  const Plot plot = convex_plot(table.rows());
  if (!plot.series.empty()) context.emit(plot);
  return convex_finding(table.rows());
}

void run(const ExperimentContext& context) {
  const Mixes mixes = measure_mixes(context);
  const TableOf<IntersectionRow> intersections = count_intersections(context);
  const TableOf<PlaneRow> plane = measure_plane(context);
  const TableOf<HardRow> hard = judge_hard_sets(context);
  const auto& [times, operations] = mixes;
  TableOf<SegmentFrontierRow> frontier;
  for (const SegmentFrontierRow& row : segment_frontier(times.rows(), hard.rows())) {
    frontier.add(row);
  }
  context.emit(times, operations, intersections, plane, hard, frontier);
  for (const Plot& plot : {time_plot(times.rows()), divisions_plot(operations.rows()),
                           frontier_plot(frontier.rows())}) {
    if (!plot.series.empty()) context.emit(plot);
  }
  context.finding(finding(times.rows(), operations.rows()) + frontier_finding(frontier.rows()) +
                  run_convex(context));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "segments", "Which line clipper is fastest, which divides least, and which is right?", run};

}  // namespace clipscope::experiments::segments
