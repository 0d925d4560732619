// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope sweep: very many triangles through every clipper, random ones or an exhaustive lattice.
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "experiments/catalogue/lattice.hpp"
#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/commands/shard_options.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/survey/lattice_sweep.hpp"
#include "experiments/survey/stage_sweep.hpp"

namespace clipscope::experiments::commands {
namespace {

struct SweepOptions {
  Selection selection;
  GuestOptions guests;
  std::uint64_t triangles = 1'000'000;
  std::string lattice;  // empty: random triangles
  bool stage = false;   // clippers that are a stage of a renderer
  std::optional<std::string> out;
  ShardOptions shard;

  bool is_random() const { return lattice.empty(); }
};

// The command that does the same, without --shard and --out.
std::string sweep_command(const SweepOptions& options) {
  const Selection& selection = options.selection;
  std::string command = "clipscope sweep";
  if (options.is_random()) {
    command += fmt::format(" --triangles {} --seed {}", options.triangles, selection.seed);
  } else {
    command += fmt::format(" --lattice {}", options.lattice);
  }
  if (options.stage) command += " --stage";
  if (selection.quick) command += " --quick";
  command += fmt::format(" --scalar {}", fmt::join(selection.scalars, ","));
  if (selection.clipper != "*") command += " --clipper " + shell_word(selection.clipper);
  return command + command_options(options.guests);
}

SpreadWork spread_work(const SweepOptions& options, std::size_t units) {
  const std::string command = sweep_command(options);
  RunInfo info = run_info_of(options.selection, command);
  if (options.is_random()) {
    set_option(info, "triangles", std::to_string(options.triangles));
  } else {
    set_option(info, "lattice", options.lattice);
  }
  if (options.stage) set_option(info, "stage", "true");
  return {{"sweep", "What does each clipper get wrong on very many triangles?", command, ""},
          info,
          options.shard.shard,
          units};
}

// A sweep, whatever its rows are.
template <class Row>
struct AnySweep {
  TableOf<Row> table;  // without rows
  std::size_t chunks;
  std::vector<Row> rows;  // of all contestants, with nothing in them
  // Adds some chunks to the rows.
  std::function<void(ChunkNumbers, Progress&, std::vector<Row>&)> add;

  TableOf<Row> table_of(const std::vector<Row>& some) const {
    TableOf<Row> filled = table;
    for (const Row& row : some) filled.add(row);
    return filled;
  }
  // Without the contestants that take none of the triangles.
  TableOf<Row> whole() const {
    std::vector<Row> some = rows;
    std::erase_if(some, [](const Row& row) { return is_empty(row); });
    return table_of(some);
  }
  // As a shard's store holds them.
  void restore(const std::optional<Table>& stored) {
    if (!stored) return;
    for (const Row& row : rows_of<Row>(*stored)) {
      const auto same = [&](const Row& r) { return same_subject(r, row); };
      const auto found = std::ranges::find_if(rows, same);
      if (found != rows.end()) *found = row;
    }
  }
};

AnySweep<SweepRow> sweep_of_plan(const SweepPlan& plan, const Selection& selection) {
  const Contestants contestants = swept_contestants(selection);
  return {plan.table(), plan.source.chunks, empty_rows(contestants),
          [=](ChunkNumbers chunks, Progress& progress, std::vector<SweepRow>& rows) {
            sweep(plan, chunks, contestants, progress, rows);
          }};
}

AnySweep<StageSweepRow> sweep_of_stages(std::uint64_t triangles, const Selection& selection) {
  const Contestants contestants = stage_sweep_contestants(selection.clipper);
  return {stage_sweep_table(triangles, selection.seed), stage_sweep_chunks(triangles),
          empty_stage_rows(contestants),
          [=, seed = selection.seed](ChunkNumbers chunks, Progress& progress,
                                     std::vector<StageSweepRow>& rows) {
            sweep_stage(triangles, seed, chunks, contestants, progress, rows);
          }};
}

// Does the chunks of the shard; with a folder the sum is stored after each window of them.
template <class Row>
void do_chunks(const SweepOptions& options, AnySweep<Row>& swept) {
  constexpr std::size_t kNeighbours = 2;  // random chunks are of view and clip space in turn
  const Shard& shard = options.shard.shard;
  const std::vector<std::size_t> chunks = shard.units(swept.chunks, kNeighbours);
  std::optional<ShardStore> store;
  if (options.out) {
    store.emplace(*options.out, spread_work(options, chunks.size()), options.shard.resume);
    swept.restore(store->sum(swept.table.name()));
  }
  std::size_t done = store ? store->done() : 0;
  const std::string& name = swept.table.name();
  Progress progress(shard.is_whole() ? name : fmt::format("{} {}", name, text_of(shard)),
                    chunks.size() - done);
  while (done < chunks.size()) {
    const std::size_t count = std::min(kChunksAtOnce, chunks.size() - done);
    swept.add(ChunkNumbers(chunks).subspan(done, count), progress, swept.rows);
    done += count;
    if (store) store->keep(swept.table_of(swept.rows), done);
  }
  if (store) store->finish(swept.table_of(swept.rows), swept.whole());
}

template <class Row>
int do_sweep(const SweepOptions& options, AnySweep<Row> swept) {
  do_chunks(options, swept);
  if (options.shard.shard.is_whole()) {
    print_table(swept.whole(), options.selection.json, options.out);
  } else {
    tell_shard(options.shard.shard, *options.out);
  }
  return kExitOk;
}

int run_sweep(SweepOptions options) {
  check_has_folder(options.shard, options.out);
  if (options.stage && !options.is_random()) {
    usage_error("--stage: goes through random triangles; --lattice {} was given", options.lattice);
  }
  load_guests(options.guests, options.selection);
  const ThreadLimit limit(options.shard.threads);
  const Selection& selection = options.selection;
  if (options.stage) return do_sweep(options, sweep_of_stages(options.triangles, selection));
  const SweepPlan plan = options.is_random() ? random_plan(options.triangles, selection)
                                             : lattice_plan(options.lattice, selection);
  return do_sweep(options, sweep_of_plan(plan, selection));
}

}  // namespace

void add_sweep_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, run_sweep, "sweep",
      "Very many triangles, random or a whole lattice, through every clipper",
      R"(Random triangles give a lower bound of the worst error, a lattice all there is on it.
Lattices: small (0.6 million classes of triangles), medium (2.7), full (53). All clippers in float
and double take 40 s of one processor for small, 3 minutes for medium, an hour for full.
With --out the sum so far is stored after every few thousand triangles: who is killed goes on
with --resume. With --shard i/N as well, N processes on any machines each do a part:
  for i in 0 1 2; do clipscope sweep --lattice small --shard $i/3 --out shard$i; done
  clipscope merge whole shard0 shard1 shard2)");
  options.selection.scalars = {"float"};
  command.add_option("--triangles", options.triangles, "Random triangles [1000000]")
      ->check(CLI::PositiveNumber);
  const std::vector<std::string> names(lattice_names().begin(), lattice_names().end());
  command.add_option("--lattice", options.lattice, "An exhaustive lattice instead")
      ->check(CLI::IsMember(names));
  command.add_flag(
      "--stage", options.stage,
      "Clippers that are a stage of a renderer, clip space in and out, in every contract and build");
  command.add_option("--seed", options.selection.seed, "Seed of the random triangles [1]");
  command.add_flag("--quick", options.selection.quick, "Every 16th part of the lattice");
  add_contestant_options(command, options.selection);
  add_guest_options(command, options.guests);
  add_guest_space_option(command, options.guests);
  add_option(
      command, "--out", options.out, "DIR",
      "Store the results in this folder, and write the table there as Markdown, CSV and LaTeX");
  add_shard_options(command, options.shard);
  add_threads_option(command, options.shard.threads);
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
