// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope plan: which effects a scene calls for, and why.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/effects/plan_table.hpp"
#include "experiments/errors.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {
namespace {

struct PlanCommand {
  Selection selection;
  PlanSettings settings;
  bool no_depth = false;
};

void add_rows(Table& table, std::span<const PlannedView> views) {
  for (const PlannedView& view : views) {
    for (const PlanLine& line : plan_lines(view)) {
      table.add_row({view.view.label, line.effect, line.called_for, line.because});
    }
  }
}

int print_plans(const PlanCommand& options) {
  nlohmann::json all = nlohmann::json::array();
  for (const std::string& name : scene_names(options.selection)) {
    NeededScene needed = load_needed_scene(options.selection, name);
    needed.depth = needed.depth && !options.no_depth;
    Table table("plan", fmt::format("Effects that {} calls for", needed.scene.name),
                {{"view", "view"},
                 {"effect", "effect"},
                 {"called_for", "called for?"},
                 {"because", "because"}});
    add_rows(table, plan_views(needed, options.settings, options.selection.sample));
    if (options.selection.json) {
      all.push_back(table.to_json());
    } else {
      fmt::print("{}\n", table.to_text());
    }
  }
  if (options.selection.json) fmt::print("{}\n", all.dump(2));
  return kExitOk;
}

}  // namespace

void add_plan_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("plan", "Which effects a scene calls for, and why");
  command->footer(
      "Each view is planned by itself. test: what is outside is dropped, nothing is cut; scissor: "
      "left\nto the guard band. Also scenes: telephoto, overlay, flat_terrain.");
  const auto options = std::make_shared<PlanCommand>();
  add_scene_options(*command, options->selection);
  command
      ->add_option("--tolerance", options->settings.tolerance,
                   "Largest error of an attribute without perspective correction [1/512]")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--guard-band", options->settings.guard_band,
                   "Somebody scissors: x and y may reach so many times w [1: nobody does]")
      ->check(CLI::Range(1.0, 1e6));
  command->add_flag("--no-depth", options->no_depth, "Nobody reads z");
  add_json_option(*command, options->selection);
  command->callback([&action, options] { action = [options] { return print_plans(*options); }; });
}

}  // namespace clipscope::experiments
