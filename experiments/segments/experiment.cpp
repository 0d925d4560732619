// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments: mixes x line clippers x scalars, timed side by side, judged, operations counted.
#include <fmt/format.h>

#include "experiments/errors.hpp"
#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/segments/judge.hpp"
#include "experiments/segments/operations.hpp"
#include "experiments/segments/summary.hpp"
#include "experiments/segments/tables.hpp"

namespace clipscope::experiments {
namespace {

struct Sizes {
  std::size_t segments, judged, counted;
  TimingOptions timing;
};

Sizes sizes_of(const Selection& selection) {
  Sizes sizes = selection.quick ? Sizes{2000, 600, 600, {9, 0.3, 32}}
                                : Sizes{20000, 8000, 8000, {31, 1.0, 256}};
  if (selection.sample != 0) sizes.judged = sizes.counted = selection.sample;
  return sizes;
}

// Those that the pattern and the scalars select; none where the pattern means triangles only.
std::vector<SegmentContestant> contestants_of(const std::string& clippers,
                                              const std::vector<std::string>& scalars) {
  try {
    return select_contestants<2>(clippers, scalars);
  } catch (const UsageError&) {
    select_contestants<3>(clippers, scalars);
    return {};
  }
}

// What slower scalars would tell is known: they are the reference. They are run if no other is chosen.
std::vector<std::string> timed_scalars(const Selection& selection) {
  std::vector<std::string> fast;
  for (const std::string& scalar : selection.scalars) {
    if (scalar == "float" || scalar == "double") fast.push_back(scalar);
  }
  return fast.empty() ? selection.scalars : fast;
}

std::vector<const Contestant<Counted, 2>*> counting_contestants(const std::string& clippers) {
  std::vector<const Contestant<Counted, 2>*> r;
  for (const auto& any : contestants_of(clippers, {std::string(ScalarTraits<Counted>::name)})) {
    r.push_back(std::get<const Contestant<Counted, 2>*>(any));
  }
  return r;
}

SegmentMix load_mix(const Selection& selection, const std::string& name, std::size_t size) {
  if (selection.scenes.empty()) return make_mix(name, size, selection.seed);
  return make_wireframe(load_selected_scene(selection, name), size);
}

}  // namespace

void run_segments(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const auto contestants = contestants_of(selection.clipper, timed_scalars(selection));
  const auto counted = counting_contestants(selection.clipper);
  const Sizes sizes = sizes_of(selection);
  Table times = segment_times_table(), operations = operations_table(),
        intersections = intersection_table();

  const auto names = selection.scenes.empty() ? builtin_mixes() : selection.scenes;
  Progress progress("segments", names.size());
  for (const std::string& name : names) {
    context.cell(name, {&times, &operations}, [&](CellRecord& record) {
      const SegmentMix mix = load_mix(selection, name, sizes.segments);
      const auto tallies = judge_segments(mix, contestants, sizes.judged);
      const auto timings = measure_segment_time(mix, contestants, sizes.timing);
      for (std::size_t i = 0; i < contestants.size(); ++i) {
        add_time(mix, contestants[i], timings[i], tallies[i], times, record);
      }
      const auto counts = count_operations(mix, counted, sizes.counted);
      for (std::size_t i = 0; i < counted.size(); ++i) {
        add_operations(mix, *counted[i], counts[i], operations);
      }
    });
    progress.advance();
  }
  context.cell("intersection", {&intersections}, [&](CellRecord&) {
    for (const IntersectionCost& cost : intersection_costs()) add_intersection(cost, intersections);
  });

  times.add_note(fmt::format("Seed {}; {} segments a mix, at most {} of each view judged.",
                             selection.seed, sizes.segments, sizes.judged));
  times.add_note(machine_description());
  context.emit(times);
  context.emit(operations);
  context.emit(intersections);
  if (const auto plot = time_plot(times)) context.emit(*plot);
  if (const auto plot = divisions_plot(operations)) context.emit(*plot);
  context.finding(segments_finding(times, operations, intersections));
}

}  // namespace clipscope::experiments
