// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope compare: every clipper and scalar on the same triangles, right and wrong, fast and slow.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/measure/accuracy.hpp"
#include "experiments/measure/accuracy_table.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/timing.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTimedTriangles = 20000;  // per scene

void add_timing_columns(std::vector<Column>& columns) {
  columns.insert(columns.end(), {{"ns_per_triangle", "ns/tri"},
                                 {"ns_low", "95 % low"},
                                 {"ns_high", "high"},
                                 {"speedup_to_textbook", "x textbook"},
                                 {"speedup_low", "x low"},
                                 {"speedup_high", "x high"},
                                 {"timing_refused", "not timed because"}});
}

std::vector<Cell> timing_cells(const Timing& timing) {
  if (!timing.refused.empty()) return {{}, {}, {}, {}, {}, {}, timing.refused};
  return {timing.ns.median,
          timing.ns.low,
          timing.ns.high,
          timing.speedup.median,
          timing.speedup.low,
          timing.speedup.high,
          {}};
}

// All scenes go into one tally and one timing per contestant.
int compare_contestants(const Selection& selection, const std::optional<std::string>& out) {
  const std::vector<AnyContestant> contestants = selected_contestants(selection);
  std::vector<AccuracyTally> tallies(contestants.size());
  std::vector<TimedBatch> batches;
  const AccuracyOptions options{.triangles_per_view = selection.sample};
  const std::vector<std::string> names = scene_names(selection);
  for (const std::string& name : names) {
    const Scene scene = load_selected_scene(selection, name);
    Progress progress(fmt::format("compare on {}", scene.name), sampled_triangles(scene, options));
    measure_accuracy(scene, contestants, options, tallies, progress);
    for (TimedBatch& batch : timed_batches(scene, kTimedTriangles / names.size())) {
      batches.push_back(std::move(batch));
    }
  }
  const std::vector<Timing> timings =
      measure_time(batches, contestants, {.rounds = selection.quick ? 9 : 25});

  std::vector<Column> columns = accuracy_columns();
  add_timing_columns(columns);
  Table table("compare",
              fmt::format("Clippers against the exact reference on {}", fmt::join(names, ", ")),
              columns);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    std::vector<Cell> cells = accuracy_cells(contestants[i], tallies[i]);
    for (Cell& cell : timing_cells(timings[i])) cells.push_back(std::move(cell));
    table.add_row(std::move(cells));
  }
  add_accuracy_notes(table);
  table.add_note(
      "x textbook: how many times faster than textbook in float, median of ratios within a "
      "round; intervals cover 95 %.");
  table.add_note(machine_description());
  if (out) table.write(*out);
  fmt::print("{}\n", selection.json ? table.to_json().dump(2) : table.to_text());
  return kExitOk;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "compare", "One table: outcomes, errors and time of every clipper and scalar");
  const auto selection = std::make_shared<Selection>();
  const auto out = std::make_shared<std::optional<std::string>>();
  add_scene_options(*command, *selection);
  add_contestant_options(*command, *selection);
  command
      ->add_option("--out", *out,
                   "Also write the table as Markdown, CSV and LaTeX into this folder")
      ->type_name("DIR");
  add_json_option(*command, *selection);
  command->callback([&action, selection, out] {
    action = [selection, out] { return compare_contestants(*selection, *out); };
  });
}

}  // namespace clipscope::experiments
