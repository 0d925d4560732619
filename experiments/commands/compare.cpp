// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope compare: every clipper and scalar on the same triangles, how right and how fast.
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/contestants/columns.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/measuring.hpp"
#include "experiments/scenes/mesh_edges.hpp"
#include "experiments/survey/accuracy.hpp"
#include "experiments/survey/contest_clock.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr std::size_t kTimedTriangles = 20000;  // per scene

struct CompareOptions {
  Selection selection;
  GuestOptions guests;
  std::optional<std::string> out;
};

struct CompareRow {
  std::string clipper, scalar;
  AccuracyFigures accuracy;
  std::optional<Timing> timing;
  std::optional<std::string> refused;

  static constexpr std::array<std::string_view, 3> kNotes = {
      "Wrong: triangles that look it: not the right vertices, or one of them 1/256 px off or more.",
      kAccuracyNote,
      "x textbook: how many times faster than textbook in float, median of ratios within a round; intervals cover 95 %."};
  static constexpr auto columns() {
    using R = CompareRow;
    using A = AccuracyFigures;
    // The verdict first, so that it stands beside the contestant on a terminal.
    return std::tuple(
        contestant_columns(&R::clipper, &R::scalar),
        group(&R::accuracy,
              std::tuple_cat(std::tuple(derived("wrong", "wrong", &A::wrong)), A::px_columns())),
        group(&R::timing),
        group(&R::accuracy, std::tuple_cat(A::outcome_columns(), A::other_columns())),
        column("timing_refused", "not timed because", &R::refused));
  }
};

// Clippers that start from a frustum have no answer where a matrix is given. Says who was left out;
// empty if nobody was. Errors: UsageError if nobody is left.
std::string leave_out_frustum_clippers(const Selection& selection, Contestants& contestants) {
  if (!selection.camera.matrix) return "";
  std::vector<std::string_view> left_out;
  std::erase_if(contestants, [&](const Contestant* c) {
    if (c->takes_clip_space) return false;
    left_out.push_back(c->clipper);
    return true;
  });
  left_out.erase(std::unique(left_out.begin(), left_out.end()), left_out.end());
  if (contestants.empty()) {
    usage_error("--clipper: {} start from a frustum, so a --matrix is not applicable",
                fmt::join(left_out, ", "));
  }
  const std::string truth = "Truth: the matrix as given, in exact arithmetic.";
  if (left_out.empty()) return truth;
  return fmt::format("{} Not applicable, since they start from a frustum: {}.", truth,
                     fmt::join(left_out, ", "));
}

// All scenes go into one tally and one timing per contestant.
int compare_contestants(CompareOptions options) {
  load_guests(options.guests, options.selection);
  const Selection& selection = options.selection;
  if (selection.realtime) measure_in_real_time();
  Contestants contestants = selected_contestants(selection);
  const std::string left_out = leave_out_frustum_clippers(selection, contestants);
  std::vector<AccuracyTally> tallies(contestants.size());
  std::vector<SampledView> views;
  std::vector<std::string> cracks;  // that the meshes have by themselves
  bool in_double = false;           // somebody gets a mesh in double
  const AccuracyOptions accuracy{.triangles_per_view = selection.sample, .in_double = true};
  const std::vector<std::string> names = scene_names(selection);
  for (const std::string& name : names) {
    const Scene scene = load_selected_scene(selection, name);
    in_double = in_double || std::ranges::any_of(contestants, [&](const Contestant* c) {
                  return takes_doubles(*c->format, scene);
                });
    if (const MeshEdges edges = edges_of(scene.mesh); edges.may_crack()) {
      cracks.push_back(
          fmt::format("{} as given has {}: a picture may crack there however it is clipped.",
                      scene.name, crack_text(edges)));
    }
    Progress progress(fmt::format("compare on {}", scene.name), sampled_triangles(scene, accuracy));
    measure_accuracy(scene, contestants, accuracy, tallies, progress);
    std::ranges::move(sampled_views(scene, kTimedTriangles / names.size()),
                      std::back_inserter(views));
  }
  const std::vector<Timing> timings =
      time_contestants(batches_of(views), contestants, find_contestant("textbook", "float"),
                       {.rounds = selection.quick ? 9 : 25});
  TableOf<CompareRow> table(
      "compare", fmt::format("Clippers against the exact reference on {}", fmt::join(names, ", ")));
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Timing& timing = timings[i];
    table.add({std::string(contestants[i]->clipper), std::string(contestants[i]->scalar()),
               AccuracyFigures(tallies[i]), if_timed(timing),
               timing.is_timed() ? std::nullopt : std::optional(timing.refused)});
  }
  for (const std::string& note : cracks) table.add_note(note);
  if (in_double) {
    table.add_note(
        "Scalars beyond float are given, and judged by, positions in double, as the file has them.");
  }
  if (!left_out.empty()) table.add_note(left_out);
  table.add_note(timing_description());
  const std::string busy = busy_text(interruptions_so_far());
  if (!busy.empty()) table.add_note(busy);
  print_table(table, selection.json, options.out);
  return kExitOk;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, compare_contestants, "compare",
                  "One table: outcomes, errors and time of every clipper and scalar");
  add_scene_options(command, options.selection);
  add_contestant_options(command, options.selection);
  add_guest_options(command, options.guests);
  add_guest_space_option(command, options.guests);
  add_realtime_option(command, options.selection);
  add_out_option(command, options.out);
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
