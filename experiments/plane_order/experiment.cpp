// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plane order: sets of triangles x all 720 orders x exact, float and double; clippers timed.
#include <fmt/format.h>

#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/plane_order/rows.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/survey/contest_clock.hpp"

namespace clipscope::experiments::plane_order {
namespace {

// Clippers that differ in little but the order of the planes: near first, near last and others.
constexpr std::array<std::string_view, 4> kClippers = {
    "homogeneous/sutherland_hodgman", "homogeneous/near_last", "homogeneous/w_first_0",
    "homogeneous/pipeline"};

// The triangle on which near last is farthest from near first.
void record_worst(const TriangleSet& set, const RoundedOrders& rounded, PieceRecord& record) {
  if (rounded.near_last_px == 0) return;
  const std::string input = hex_line(set.triangles[rounded.farthest].triangle, 0);
  record.worst_inputs.push_back(
      {std::string(kClippers[1]), std::string(rounded.scalar), "moved_px", rounded.near_last_px,
       input,
       fmt::format(
           "for c in {} {}; do echo '{}' | clipscope clip --clipper $c --space clip --depth {} --scalar {} --hex; done",
           kClippers[0], kClippers[1], input, depth_option(set.depth), rounded.scalar)});
}

void time_orders(const std::string& mix, const Scene& scene, int rounds, TableOf<TimeRow>& table,
                 PieceRecord& record) {
  Selection in_both;
  in_both.scalars = {"float", "double"};
  const Contestants contestants = named_contestants(in_both, kClippers);
  const auto views = sampled_views(scene, 20000);
  const auto timings =
      time_contestants(batches_of(views), contestants, *contestants.front(), {.rounds = rounds});
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Timing &timing = timings[i], &near_first = timings[i % 2];  // of the same scalar
    TimeRow row{mix, std::string(contestants[i]->clipper), std::string(contestants[i]->scalar())};
    if (timing.is_timed() && near_first.is_timed()) {
      row.ns = timing.ns;
      row.ratio = median_interval(ratios(timing.samples_ns, near_first.samples_ns));
    }
    table.add(row);
    record.add(fmt::format("{} {} {}", mix, row.clipper, row.scalar), timing);
  }
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<OrdersRow> orders;
  TableOf<ClassRow> classes;
  TableOf<TimeRow> times;
  const std::size_t sample = selection.sample;  // triangles per set
  const std::size_t rounded = selection.sample_or(250, 2500);
  const std::size_t exact = sample != 0 ? sample / 10 + 1 : selection.quick ? 20 : 250;
  const std::vector<std::string> sets = set_names(selection);
  const auto timed = selection.scenes_or({"soup", "soup_straddling", "soup_behind"});
  Progress progress("plane_order", sets.size() + timed.size());
  for (const std::string& name : sets) {
    context.piece(name, {&orders, &classes}, [&](PieceRecord& record) {
      const TriangleSet set = make_set(selection, name, rounded);
      if (set.triangles.empty()) return;
      const auto in_float = measure_rounded<float>(set), in_double = measure_rounded<double>(set);
      orders.add(orders_row(name, measure_exact(set, exact), in_float, in_double));
      for (const RoundedOrders* r : {&in_float, &in_double}) {
        for (const ClassRow& row : class_rows(name, *r)) classes.add(row);
        record_worst(set, *r, record);
      }
    });
    progress.advance();
  }
  for (const std::string& mix : timed) {
    context.piece("time on " + mix, {&times}, [&](PieceRecord& record) {
      time_orders(mix, load_selected_scene(selection, mix), selection.quick ? 9 : 41, times,
                  record);
    });
    progress.advance();
  }
  const OrdersRow all = total(orders.rows());
  orders.add(all);
  for (Table* table : std::initializer_list<Table*>{&orders, &classes, &times}) {
    table->add_note(fmt::format("Seed {}. {}", selection.seed, timing_description()));
    context.emit(*table);
  }
  context.emit(wrong_plot(classes.rows()), intersections_plot(classes.rows()));
  context.finding(finding(all, times.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "plane_order", "Does the order of the planes matter: for the result, the error, the time?",
    run};

}  // namespace clipscope::experiments::plane_order
