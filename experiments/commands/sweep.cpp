// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope sweep: very many triangles through every clipper, random ones or an exhaustive lattice.
#include <optional>

#include "experiments/catalogue/lattice.hpp"
#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/survey/lattice_sweep.hpp"

namespace clipscope::experiments::commands {
namespace {

struct SweepOptions {
  Selection selection;
  GuestOptions guests;
  std::uint64_t triangles = 1'000'000;
  std::string lattice;  // empty: random triangles
  std::optional<std::string> out;
};

int run_sweep(SweepOptions options) {
  load_guests(options.guests, options.selection);
  const Selection& selection = options.selection;
  const bool random = options.lattice.empty();
  TableOf<SweepRow> table = random ? sweep_random(options.triangles, selection)
                                   : lattice_table(options.lattice, selection);
  if (!random) add_lattice(options.lattice, selection, table);
  print_table(table, selection.json, options.out);
  return kExitOk;
}

}  // namespace

void add_sweep_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, run_sweep, "sweep",
      "Very many triangles, random or a whole lattice, through every clipper",
      R"(Random triangles give a lower bound of the worst error, a lattice all there is on it.
Lattices: small (0.6 million classes of triangles), medium (2.7), full (53; about an hour).)");
  options.selection.scalars = {"float"};
  command.add_option("--triangles", options.triangles, "Random triangles [1000000]")
      ->check(CLI::PositiveNumber);
  const std::vector<std::string> names(lattice_names().begin(), lattice_names().end());
  command.add_option("--lattice", options.lattice, "An exhaustive lattice instead")
      ->check(CLI::IsMember(names));
  command.add_option("--seed", options.selection.seed, "Seed of the random triangles [1]");
  command.add_flag("--quick", options.selection.quick, "Every 16th part of the lattice");
  add_contestant_options(command, options.selection);
  add_guest_options(command, options.guests);
  add_guest_space_option(command, options.guests);
  add_out_option(command, options.out);
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
