// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hunts of many seeds: each is a unit of work, which any process may do.
#include "experiments/commands/hunt_result.hpp"
#include "experiments/commands/options.hpp"

namespace clipscope::experiments::commands {
namespace {

using hunt::HuntRow;

// One of the hunts.
struct HuntUnit {
  const Contestant* contestant;
  hunt::Measure measure;
  std::uint64_t seed;
  std::size_t row;  // that it belongs to
};

std::vector<HuntUnit> all_hunts(const HuntCommandOptions& options, const Contestants& contestants,
                                const std::vector<hunt::Measure>& measures) {
  std::vector<HuntUnit> all;
  std::size_t row = 0;
  for (const Contestant* contestant : contestants) {
    for (const hunt::Measure measure : measures) {
      for (std::uint64_t i = 0; i < options.hunts; ++i) {
        all.push_back({contestant, measure, options.selection.seed + i, row});
      }
      ++row;
    }
  }
  return all;
}

std::vector<HuntRow> rows_without_hunts(const std::vector<HuntUnit>& units) {
  std::vector<HuntRow> rows;
  for (const HuntUnit& unit : units) {
    if (unit.row < rows.size()) continue;
    HuntRow& row = rows.emplace_back();
    row.clipper = unit.contestant->clipper;
    row.scalar = unit.contestant->scalar();
    row.measure = name_of(unit.measure);
    row.hunts = 0;
  }
  return rows;
}

TableOf<HuntRow> hunts_table(const std::vector<HuntRow>& rows) {
  TableOf<HuntRow> table;
  for (const HuntRow& row : rows) table.add(row);
  return table;
}

SpreadWork spread_work(const HuntCommandOptions& options, std::size_t units) {
  const std::string command = whole_command(options);
  RunInfo info = run_info_of(options.selection, command);
  // All that decides the hunts is in the command.
  set_option(info, "hunt", command);
  return {{std::string(HuntRow::kName), "On which input is a clipper worst?", command, ""},
          info,
          options.shard.shard,
          units};
}

HuntRow row_of_unit(const HuntCommandOptions& options, const HuntUnit& unit) {
  hunt::HuntOptions hunt = options.hunt;
  hunt.seed = unit.seed;
  HuntRow row = row_of(hunted_one(*unit.contestant, unit.measure, hunt));
  row.evaluations_per_second.reset();  // not the same in another process
  row.seed = static_cast<std::int64_t>(unit.seed);
  return row;
}

}  // namespace

void spread_hunts(const HuntCommandOptions& options, const Contestants& contestants,
                  const std::vector<hunt::Measure>& measures) {
  check_has_folder(options.shard, options.out);
  if (!options.out) usage_error("--hunts: takes --out DIR, the folder that they are stored in");
  if (!options.hunt.evaluations) {
    usage_error(
        "--hunts, --shard: take --evaluations N; how many go into a time is not the same everywhere");
  }
  if (options.corpus_out) {
    usage_error("--corpus-out: not with --hunts or --shard; `clipscope promote` does it later");
  }
  const std::vector<HuntUnit> all = all_hunts(options, contestants, measures);
  const std::vector<std::size_t> mine = options.shard.shard.units(all.size());
  ShardStore store(*options.out, spread_work(options, mine.size()), options.shard.resume);
  const std::string name(HuntRow::kName);
  const std::optional<Table> stored = store.sum(name);
  std::vector<HuntRow> rows = stored ? rows_of<HuntRow>(*stored) : rows_without_hunts(all);
  for (std::size_t done = store.done(); done < mine.size(); ++done) {
    const HuntUnit& unit = all[mine[done]];
    rows[unit.row] += row_of_unit(options, unit);
    store.keep(hunts_table(rows), done + 1);
  }
  const TableOf<HuntRow> table = hunts_table(rows);
  store.finish(table, table);
  if (options.shard.shard.is_whole()) {
    print_table(table, options.selection.json, options.out);
  } else {
    tell_shard(options.shard.shard, *options.out);
  }
}

}  // namespace clipscope::experiments::commands
