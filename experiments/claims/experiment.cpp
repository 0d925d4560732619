// SPDX-License-Identifier: GPL-3.0-or-later
//
// What textbooks and papers say about clipping, each claim with the verdict of this run's results.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/claims/ranking.hpp"
#include "experiments/claims/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"

namespace clipscope::experiments::claims {

std::vector<Claim> all_claims() {
  std::vector<Claim> all = claims_about_cost();
  for (const auto list : {claims_about_segments, claims_about_geometry, claims_about_rounding,
                          claims_of_the_literature}) {
    std::ranges::move(list(), std::back_inserter(all));
  }
  std::ranges::sort(all, {}, &Claim::number);
  return all;
}

namespace {

TableOf<CountRow> count_all(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<CountingTask> tasks = counting_tasks();
  TableOf<CountRow> counts;
  Progress progress("claims", tasks.size());
  for (const CountingTask& task : tasks) {
    context.piece(fmt::format("claim {}", task.claim), {&counts}, [&](PieceRecord&) {
      const std::size_t size = selection.quick ? 400 : 4000;
      for (const CountRow& row : count_cases(task, selection.seed, size)) counts.add(row);
    });
    progress.advance();
  }
  return counts;
}

TableOf<PictureRow> draw_without_cutting(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<PictureRow> pictures;
  for (const std::string& name : selection.scenes_or({"teapot", "corridor", "floor"})) {
    context.piece("clipless " + name, {&pictures}, [&](PieceRecord&) {
      const Scene scene = load_selected_scene(selection, name);
      View view = scene.views.front();
      view.frustum.depth = DepthRange::minus_one_to_one;
      pictures.add(time_clipless(scene, view, {}, selection.quick ? 7 : 25));
    });
  }
  pictures.add_note(timing_description());
  return pictures;
}

void run(const ExperimentContext& context) {
  context.emit(count_all(context));
  context.emit(draw_without_cutting(context));
  // What every experiment of this run has left, those two tables included.
  std::map<std::string, std::optional<Table>> known;
  const Results::Source tables = [&](const std::string& name) {
    if (!known.contains(name)) known[name] = context.emitted(name);
    return known.at(name);
  };
  const RunsBehind runs = [&](const std::string& name) { return context.interruptions(name); };

  TableOf<Row> table;
  TableOf<Evidence> decisive;
  // This belongs to no piece: a resumed run may know more.
  for (const Claim& claim : all_claims()) {
    const Judgement judgement = judge(claim, tables, runs);
    table.add({claim.number, std::string(claim.statement), judgement.verdict, judgement.because,
               std::string(claim.experiment)});
    for (Evidence evidence : judgement.evidence) {
      evidence.claim = claim.number;
      decisive.add(evidence);
    }
  }
  const std::string machine =
      fmt::format("Times were measured on {} ({}).", machine_name(), measuring_conditions());
  table.add_note(machine);
  decisive.add_note(machine);
  context.emit(table, decisive);
  context.finding(finding_text(table.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "claims", "Which claims about clipping do the results confirm, which do they refute?", run};

}  // namespace clipscope::experiments::claims
