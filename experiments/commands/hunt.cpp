// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope hunt: on which input is a clipper worst?
#include "experiments/hunt/hunt.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/hunt_result.hpp"
#include "experiments/commands/measure_option.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/hunt/rows.hpp"
#include "experiments/hunt/trophy.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/store/run_recorder.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments::commands {
namespace {

using hunt::Hunted;
using hunt::HuntRow;
using hunt::Measure;
using hunt::replay_command;
using hunt::Trophy;

// Those of --clipper, and the guests.
Contestants hunted_contestants(HuntCommandOptions& options) {
  load_guests(options.guests, options.selection);
  const Selection& selection = options.selection;
  if (!selection.clipper.empty()) return selected_contestants(selection);
  if (selection.guests.empty()) {
    usage_error("--clipper: the name of a clipper is missing, or --plugin or --program with yours");
  }
  Contestants guests;
  for (const std::string_view guest : selection.guests) {
    for (const std::string& scalar : selection.scalars) {
      const Contestant* found = find_in_contract(guest, scalar, Contract::full);
      if (found != nullptr) guests.push_back(found);
    }
  }
  return guests;
}

// --- What was found ------------------------------------------------------------------------------

void print_trophy(const HuntResult& r, const std::optional<Trophy>& trophy) {
  fmt::print("{}{}\n", cases_text(*trophy), r.replay(trophy));
}

void print(const HuntResult& r) {
  fmt::print("{}: ", name_of(*r.contestant));
  if (r.worst) {
    fmt::print("{} {:.6g}, a lower bound of the worst\n", name_of(r.measure), r.worst->value);
  } else {
    fmt::print("no {} was found; that is no proof that there is none\n", name_of(r.measure));
  }
  fmt::print("{} evaluations, {:.0f} a second; the same again:\n  {}\n", r.hunted.evaluations,
             r.per_second(), r.command);
  if (r.worst) {
    fmt::print("the worst:\n");
    print_trophy(r, r.worst);
    fmt::print("shrunk, with {} {:.6g}:\n", name_of(r.measure), r.shrunk->value);
    print_trophy(r, r.shrunk);
  }
  for (std::size_t i = 0; i < kOutcomes; ++i) {
    if (!r.hunted.failing[i]) continue;
    fmt::print("met on the way: {}\n  {}\n", kOutcomeNames[i],
               replay_command(*r.contestant, {*r.hunted.failing[i]}));
  }
  fmt::print("\n");
}

nlohmann::json json_of(const HuntResult& r, const std::optional<Trophy>& trophy) {
  if (!trophy) return nullptr;
  const nlohmann::json value =
      std::isfinite(trophy->value) ? nlohmann::json(trophy->value) : nlohmann::json("inf");
  return {{"value", value}, {"case", cases_text(*trophy)}, {"replay", r.replay(trophy)}};
}

nlohmann::json json_of(const HuntResult& r) {
  nlohmann::json failing = nlohmann::json::object();
  for (std::size_t i = 0; i < kOutcomes; ++i) {
    if (!r.hunted.failing[i]) continue;
    failing[std::string(kOutcomeNames[i])] = replay_command(*r.contestant, {*r.hunted.failing[i]});
  }
  return {{"clipper", r.contestant->clipper},
          {"scalar", r.contestant->scalar()},
          {"measure", name_of(r.measure)},
          {"bound", "lower"},
          {"evaluations", r.hunted.evaluations},
          {"evaluations_per_second", r.per_second()},
          {"command", r.command},
          {"worst", json_of(r, r.worst)},
          {"shrunk", json_of(r, r.shrunk)},
          {"failing", failing}};
}

// --- Where it goes -------------------------------------------------------------------------------

// The results as a store; nothing without a folder.
class HuntStore {
 public:
  HuntStore(const HuntCommandOptions& options) {
    if (!options.out) return;
    make_folder(*options.out);
    lock_.emplace(*options.out);
    const std::string command = whole_command(options);
    const RunInfo info = run_info_of(options.selection, command);
    const OpenedStore opened = start_store(*options.out, info);
    tell_kept(opened);
    recorder_.emplace(opened.database, opened.file);
    recorder_->begin({"hunt", "On which input is a clipper worst?", command, ""}, 0);
  }

  void add(const HuntResult& r) {
    if (!recorder_) return;
    const HuntRow row = row_of(r);
    recorder_->record(
        fmt::format("{} {}", name_of(*r.contestant), row.measure), {&table_},
        [&](PieceRecord& record) {
          table_.add(row);
          if (!r.worst) return;
          record.worst_inputs.push_back({row.clipper, row.scalar, row.measure, row.worst,
                                         row.replay.substr(0, row.replay.find(" | ")), row.replay});
        });
  }
  void finish(double seconds) {
    if (!recorder_) return;
    recorder_->add(table_);
    recorder_->finish(seconds);
  }

 private:
  TableOf<HuntRow> table_;
  std::optional<FolderLock> lock_;
  std::optional<RunRecorder> recorder_;
};

void append_cases(const std::string& file, const std::vector<HardCase>& cases) {
  for (const HardCase& c : cases) {
    fmt::print(stderr, "added to {}: {}\n", file, append_case(file, c).name);
  }
}

int run_hunt(HuntCommandOptions options) {
  const std::vector<Measure> measures = measures_of(options.measures);
  const Contestants contestants = hunted_contestants(options);
  options.hunt.catalogue = !options.without_catalogue;
  options.hunt.seed = options.selection.seed;
  if (!options.guests.space.empty()) {
    options.hunt.space = options.guests.space == "view" ? Space::view : Space::clip;
  }
  const ThreadLimit limit(options.shard.threads);
  if (options.is_spread()) {
    spread_hunts(options, contestants, measures);
    return kExitOk;
  }
  HuntStore store(options);
  nlohmann::json hunts = nlohmann::json::array();
  double seconds = 0;
  for (const Contestant* contestant : contestants) {
    for (const Measure measure : measures) {
      const HuntResult result = hunted_one(*contestant, measure, options.hunt);
      seconds += result.hunted.seconds;
      store.add(result);
      if (options.corpus_out && result.shrunk) {
        append_cases(*options.corpus_out, result.shrunk->cases);
      }
      if (options.selection.json) {
        hunts.push_back(json_of(result));
      } else {
        print(result);
      }
    }
  }
  store.finish(seconds);
  if (options.selection.json) fmt::print("{}\n", json_text(nlohmann::json{{"hunts", hunts}}, 2));
  return kExitOk;
}

}  // namespace

std::vector<Measure> measures_of(const std::vector<std::string>& names) {
  constexpr auto kNames = names_of(Measure{});
  std::vector<Measure> measures;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(kNames, name);
    if (found == kNames.end()) {
      usage_error("--measure: '{}' given, expected {}", name, fmt::join(kNames, ", "));
    }
    measures.push_back(static_cast<Measure>(found - kNames.begin()));
  }
  return measures;
}

void add_measure_option(CLI::App& command, std::vector<std::string>& measures,
                        const std::string& usual) {
  add_option(command, "--measure", measures, "LIST",
             fmt::format("Of what the worst is wanted: {}, separated by commas [{}]",
                         fmt::join(names_of(Measure{}), ", "), usual))
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_hunt_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, run_hunt, "hunt", "Search for the input on which a clipper is worst",
      R"(A search by chance, mutation and hill climbing over the bits of floats; what it finds is a lower
bound. Printed are the worst, the command that shows it, and what is left of it when it is shrunk:
the measure stays at least half of the worst. The same seed and number of evaluations find the
same, whatever the number of threads.
Measures: px, ulp and depth, position errors where the vertices are the right ones, of depth in ulp
of 1; attribute, relative to the largest one; containment, how far something reaches out of the
volume, in NDC; crack, in px between two triangles that share an edge; crash, no answer or one with
NaN or infinity.
Examples:
  clipscope hunt --clipper homogeneous/sutherland_hodgman --measure px --seconds 60
  clipscope hunt --plugin ./libmine.so --measure crash,containment --corpus-out mine.cases)");
  options.selection.scalars = {"float"};
  options.selection.clipper.clear();
  add_contestant_options(command, options.selection);
  add_guest_options(command, options.guests);
  command
      .add_option(
          "--space", options.guests.space,
          "Triangles in view space or in clip space alone; a program takes these alone [both, of a program clip]")
      ->check(CLI::IsMember({"view", "clip"}));
  command.add_flag(
      "--plain", options.hunt.plain,
      "Clip against six closed planes alone: no depth clamp, clip distances, open sides");
  add_measure_option(command, options.measures, "px");
  CLI::Option* const evaluations = add_option(command, "--evaluations", options.hunt.evaluations,
                                              "N", "Triangles to try, instead of a time")
                                       ->check(CLI::PositiveNumber);
  add_option(command, "--seconds", options.hunt.seconds, "N",
             fmt::format("Time for each clipper and measure [{:g}]", options.hunt.seconds))
      ->check(CLI::PositiveNumber)
      ->excludes(evaluations);
  command.add_option("--seed", options.selection.seed, "Seed of the search [1]");
  command.add_flag("--without-catalogue", options.without_catalogue,
                   "Begin with random triangles alone, not with the hard cases, too");
  command.add_flag(
      "--in-domain", options.hunt.in_domain,
      "px, ulp, depth and attribute: only triangles that the bounds of `verify` speak of, whose numbers stay in the format and whose visible part keeps away from the eye");
  add_option(command, "--corpus-out", options.corpus_out, "FILE",
             "Add the shrunk cases to this file of cases");
  add_option(command, "--out", options.out, "DIR",
             "Store the results in this folder, for `clipscope promote` and `clipscope table`");
  add_option(
      command, "--hunts", options.hunts, "N",
      "Hunts of each clipper and measure, from this seed and the next ones; the worst counts [1]")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
  add_shard_options(command, options.shard);
  add_threads_option(command, options.shard.threads);
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
