// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope sweep: very many triangles through every clipper, random ones or an exhaustive lattice.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "experiments/catalogue/lattice.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/hard_cases/lattice_sweep.hpp"

namespace clipscope::experiments {
namespace {

struct SweepOptions {
  Selection selection;
  std::uint64_t triangles = 1'000'000;
  std::string lattice;  // empty: random triangles
  std::optional<std::string> out;
};

int run_sweep(const SweepOptions& options) {
  const Table table = options.lattice.empty() ? sweep_random(options.triangles, options.selection)
                                              : sweep_lattice(options.lattice, options.selection);
  if (options.out) table.write(*options.out);
  fmt::print("{}\n", options.selection.json ? table.to_json().dump(2) : table.to_text());
  return kExitOk;
}

}  // namespace

void add_sweep_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "sweep", "Very many triangles, random or an exhaustive lattice, through every clipper");
  command->footer(
      "Random triangles give a lower bound of the worst error, a lattice all there is on it.\n"
      "Lattices: small (0.6 million classes of triangles), medium (2.7), full (53; about an "
      "hour).");
  const auto options = std::make_shared<SweepOptions>();
  options->selection.scalars = {"float"};
  command->add_option("--triangles", options->triangles, "Random triangles [1000000]")
      ->check(CLI::PositiveNumber);
  std::vector<std::string> names;
  for (const std::string_view name : lattice_names()) names.emplace_back(name);
  command->add_option("--lattice", options->lattice, "An exhaustive lattice instead")
      ->check(CLI::IsMember(names));
  command->add_option("--seed", options->selection.seed, "Seed of the random triangles [1]");
  command->add_flag("--quick", options->selection.quick, "Every 16th part of the lattice");
  add_contestant_options(*command, options->selection);
  command
      ->add_option("--out", options->out,
                   "Also write the table as Markdown, CSV and LaTeX into this folder")
      ->type_name("DIR");
  add_json_option(*command, options->selection);
  command->callback([&action, options] { action = [options] { return run_sweep(*options); }; });
}

}  // namespace clipscope::experiments
