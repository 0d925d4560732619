// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims: what textbooks and papers say about clipping, each with the verdict of this run's results.
#include <fmt/format.h>

#include "experiments/claims/claim.hpp"
#include "experiments/claims/clipless.hpp"
#include "experiments/claims/counts.hpp"
#include "experiments/claims/judges.hpp"
#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kSize = 4000;  // random inputs per counting task, about
constexpr std::size_t kQuickSize = 400;

Table count_cases(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table table(kCountsTable, "Exact cases for and against claims of geometry",
              {{"claim", "claim"},
               {"title", "about"},
               {"quantity", "quantity"},
               {"cases", "cases"},
               {"count", "count"}});
  Progress progress("claims", counting_tasks().size());
  for (const CountingTask& task : counting_tasks()) {
    context.cell(fmt::format("claim {}", task.claim), {&table}, [&](CellRecord&) {
      const std::size_t size = selection.quick ? kQuickSize : kSize;
      for (const ExactCount& c : task.run(selection.seed, size)) {
        table.add_row(
            {std::int64_t{task.claim}, std::string(task.title), c.quantity, c.cases, c.count});
      }
    });
    progress.advance();
  }
  table.add_note("Rational arithmetic on random input, many coordinates on planes and at w = 0.");
  return table;
}

Table rasterise_without_cutting(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table table("claims_clipless", "A picture by cutting, and by homogeneous edge functions alone",
              {{"scene", "scene"},
               {"clipped_ns", "cut [ns/tri]"},
               {"clipless_ns", "uncut [ns/tri]"},
               {"speedup", "x faster uncut"},
               {"speedup_low", "95 % low"},
               {"speedup_high", "high"},
               {"clipped_wrong_px", "cut: wrong [px]"},
               {"clipless_wrong_px", "uncut: wrong [px]"}});
  const std::vector<std::string> names =
      selection.scenes.empty() ? std::vector<std::string>{"teapot", "corridor", "floor"}
                               : selection.scenes;
  for (const std::string& name : names) {
    context.cell("clipless " + name, {&table}, [&](CellRecord&) {
      const Scene scene = load_selected_scene(selection, name);
      View view = scene.views.front();
      view.frustum.depth = DepthRange::minus_one_to_one;
      const ClipAndRasterise r = measure_clipless(scene, view, 960, 540, selection.quick ? 7 : 25);
      table.add_row({scene.name, r.clipped_ns.median, r.clipless_ns.median, r.speedup.median,
                     r.speedup.low, r.speedup.high, r.clipped_wrong_px, r.clipless_wrong_px});
    });
  }
  table.add_note(
      "First view of each scene, 960 x 540, float, one core. Wrong: covered, but not in the exact "
      "picture, or the other way round; pixel centres on edges count as covered here, so a few "
      "are.");
  table.add_note(machine_description());
  return table;
}

}  // namespace

void run_claims(const ExperimentContext& context) {
  context.emit(count_cases(context));
  context.emit(rasterise_without_cutting(context));
  // What every experiment of this run has left, those two tables included.
  const Results results([&](const std::string& name) { return context.emitted(name); });

  Table table("claims", "Claims about clipping and the verdict of this run",
              {{"number", "no"},
               {"claim", "claim", 32},
               {"verdict", "verdict"},
               {"because", "because", 34},
               {"experiment", "figures in"}});
  // In no cell: a resumed run may know more.
  std::array<int, 4> verdicts{};
  for (const Claim& claim : all_claims()) {
    const Finding finding = judge(claim, results);
    ++verdicts[static_cast<std::size_t>(finding.verdict)];
    table.add_row({std::int64_t{claim.number}, std::string(claim.statement),
                   std::string(verdict_text(finding.verdict)), finding.because,
                   std::string(claim.experiment)});
  }
  context.emit(table);
  context.finding(fmt::format(
      "Of {} claims {} are confirmed, {} true only under a condition, {} refuted, {} undecided for "
      "want of figures.",
      all_claims().size(), verdicts[0], verdicts[1], verdicts[2], verdicts[3]));
}

}  // namespace clipscope::experiments
