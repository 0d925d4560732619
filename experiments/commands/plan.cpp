// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope plan: which effects a scene calls for, and why.
#include "experiments/commands/options.hpp"
#include "experiments/effects/plan_table.hpp"
#include "experiments/table/json_text.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::commands {
namespace {

struct PlanCommand {
  Selection selection;
  effects::PlanSettings settings;
  bool no_depth = false;
};

struct PlanRow {
  std::string view;
  effects::PlanLine line;

  static constexpr auto columns() {
    return std::tuple(column("view", &PlanRow::view), group(&PlanRow::line));
  }
};

int print_plans(const PlanCommand& options) {
  const Selection& selection = options.selection;
  nlohmann::json all = nlohmann::json::array();
  for (const std::string& name : scene_names(selection)) {
    effects::NeededScene needed = effects::load_needed_scene(selection, name);
    needed.depth = needed.depth && !options.no_depth;
    const auto views = effects::plan_views(needed, options.settings, selection.sample);
    if (!selection.json) {
      print_table(effects::plan_matrix(needed.scene.name, views), false);
      continue;
    }
    TableOf<PlanRow> table("plan", fmt::format("Effects that {} calls for", needed.scene.name));
    for (const auto& view : views) {
      for (const auto& line : effects::plan_lines(view)) table.add({view.view.label, line});
    }
    all.push_back(table.to_json());
  }
  if (selection.json) fmt::print("{}\n", json_text(all, 2));
  return kExitOk;
}

}  // namespace

void add_plan_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, print_plans, "plan", "Which effects a scene calls for, and why",
      R"(Each view is planned by itself. test: what is outside is dropped, nothing is cut; scissor: left
to the guard band. Also scenes: telephoto, overlay, flat_terrain.)");
  add_scene_options(command, options.selection);
  command
      .add_option("--tolerance", options.settings.tolerance,
                  "Largest error of an attribute without perspective correction [1/512]")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--guard-band", options.settings.guard_band,
                  "Somebody scissors: x and y may reach so many times w [1: nobody does]")
      ->check(CLI::Range(1.0, 1e6));
  command.add_flag("--no-depth", options.no_depth, "Nobody reads z");
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
