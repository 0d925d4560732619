// SPDX-License-Identifier: GPL-3.0-or-later
//
// History: what was published since 1968 beside what this run measured of it.
#include "experiments/report/experiment.hpp"
#include "experiments/history/rows.hpp"
#include "experiments/machine/measuring.hpp"

namespace clipscope::experiments::history {
namespace {

void run(const ExperimentContext& context) {
  const Results results([&](const std::string& name) { return context.emitted(name); });
  TableOf<Row> table;
  // This belongs to no piece: a resumed run may know more.
  for (const Row& row : history(results)) table.add(row);
  context.emit(table);
  for (const Field field : {Field::plane, Field::segments, Field::triangles}) {
    const Plot plot = history_plot(table.rows(), field);
    if (!plot.series.empty()) context.emit(plot);
  }
  Interruptions runs;  // behind what it was made of
  for (const char* times : {"segments_plane", "segments", "cost"}) {
    runs = runs + context.interruptions(times);
  }
  const std::string busy = busy_text(runs);
  context.finding(finding(table.rows()) + (busy.empty() ? "" : " " + busy));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "history", "What did each published method bring, in speed and in right answers?", run};

}  // namespace clipscope::experiments::history
