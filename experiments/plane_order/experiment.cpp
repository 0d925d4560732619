// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plane order: sets of triangles x all 720 orders x exact, float and double; and the time of two of them.
#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/plane_order/tables.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTimedTriangles = 20000;

struct Sizes {
  std::size_t rounded, exact;  // triangles per set
};

Sizes sizes_of(const Selection& selection) {
  if (selection.sample != 0) return {selection.sample, selection.sample / 10 + 1};
  return selection.quick ? Sizes{250, 20} : Sizes{2500, 250};
}

SetResult measure_set(const Selection& selection, const std::string& name) {
  const Sizes sizes = sizes_of(selection);
  SetResult result{make_set(selection, name, sizes.rounded), {}, {}, {}};
  result.exact = measure_exact(result.set, sizes.exact);
  result.in_float = measure_rounded<float>(result.set);
  result.in_double = measure_rounded<double>(result.set);
  return result;
}

std::vector<std::string> mixes(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"soup", "soup_straddling", "soup_behind"};
}

// Clippers that differ in little but the order in which planes cut.
std::vector<AnyContestant> timed_contestants() {
  std::vector<AnyContestant> all;
  for (const char* clipper : {"homogeneous/sutherland_hodgman", "homogeneous/near_last",
                              "homogeneous/w_first_0", "homogeneous/pipeline"}) {
    for (const char* scalar : {"float", "double"}) {
      all.push_back(find_contestant(clipper, scalar));
    }
  }
  return all;
}

}  // namespace

void run_plane_order(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table orders = orders_table(), classes = classes_table(), times = order_times_table();
  const std::vector<std::string> sets = set_names(selection);
  Progress progress("plane_order", sets.size() + mixes(selection).size());
  for (const std::string& name : sets) {
    context.cell(name, {&orders, &classes}, [&](CellRecord& record) {
      const SetResult result = measure_set(selection, name);
      if (result.set.triangles.empty()) return;
      add_set(result, orders);
      add_classes(result, classes);
      add_worst(result, record);
    });
    progress.advance();
  }
  for (const std::string& mix : mixes(selection)) {
    context.cell("time on " + mix, {&times}, [&](CellRecord& record) {
      const Scene scene = load_selected_scene(selection, mix);
      const std::vector<AnyContestant> contestants = timed_contestants();
      const TimingOptions options{.rounds = selection.quick ? 9 : 41};
      const auto timings =
          measure_time(timed_batches(scene, kTimedTriangles), contestants, options);
      add_times(mix, contestants, timings, times, record);
    });
    progress.advance();
  }
  Table all_orders = with_all(orders);
  for (Table* table : {&all_orders, &classes, &times}) {
    table->add_note(fmt::format("Seed {}. {}", selection.seed, machine_description()));
    context.emit(*table);
  }
  context.emit(wrong_plot(classes));
  context.emit(intersections_plot(classes));
  context.finding(orders_finding(all_orders, times));
}

}  // namespace clipscope::experiments
