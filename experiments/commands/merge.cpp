// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope merge: one result from the folders of shards.
#include "experiments/shards/merge.hpp"

#include "experiments/commands/options.hpp"
#include "experiments/hunt/rows.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/survey/lattice_sweep.hpp"
#include "experiments/survey/stage_sweep.hpp"

namespace clipscope::experiments::commands {
namespace {

struct MergeOptions {
  std::string out;
  std::vector<std::string> folders;
  bool part = false;
  Selection selection;  // --json
};

// Of sweeps and hunts rows are added up.
Table summed(const std::vector<MergeSource>& sources) {
  const std::string name = summed_table(sources).name();
  if (name == hunt::HuntRow::kName) return sum_of<hunt::HuntRow>(sources);
  if (name == StageSweepRow::kName) return sum_of<StageSweepRow>(sources);
  return sum_of<SweepRow>(sources);
}

bool is_of_pieces(const std::vector<MergeSource>& sources) {
  const std::string& name = sources.front().experiments.front().name;
  return name != "sweep" && name != hunt::HuntRow::kName;
}

// What is still to be done with the pieces of a run, if all are there.
void tell_run(const std::vector<MergeSource>& sources, const std::string& out) {
  if (!is_whole(sources)) return;
  std::string command = value_of(sources.front().info, "command"), names;
  for (const StoredExperiment& e : sources.front().experiments) names += " " + e.name;
  command.insert(std::string("clipscope run").size(), names);
  fmt::print("all pieces are in {}; its tables are made by:\n  {} --resume --out {}\n", out,
             command, shell_word(out));
}

int run_merge(const MergeOptions& options) {
  const std::vector<MergeSource> sources = open_sources(options.folders, options.part);
  std::error_code ignored;
  for (const MergeSource& source : sources) {
    if (std::filesystem::equivalent(source.folder, options.out, ignored)) {
      usage_error("{}: is merged, and can't be the folder that is written", options.out);
    }
  }
  if (is_of_pieces(sources)) {
    merge_pieces(options.out, sources);
    tell_run(sources, options.out);
    return kExitOk;
  }
  const Table table = summed(sources);
  write_merged(options.out, sources, table);
  if (is_whole(sources)) {
    print_table(table, options.selection.json, options.out);
  } else {
    fmt::print("some of {} shards are merged: {}\n", sources.front().shards.front().of,
               options.out);
  }
  return kExitOk;
}

}  // namespace

void add_merge_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, run_merge, "merge", "Make one result of the shards of a sweep, a hunt or a run",
      R"(The shards may come in any order; the table is that of `--shard 0/1` to the byte. Refused are, by
name, shards that are not finished, that are there twice or not at all, and those of another sweep
or program. With --part some shards are merged alone, and the results are merged again: a tree.)");
  add_option(command, "out", options.out, "OUT", "Folder that the result is stored in")->required();
  add_option(command, "shards", options.folders, "DIR", "Folders of shards, or of merged ones")
      ->required();
  command.add_flag("--part", options.part, "Merge though shards are missing, for a tree of merges");
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
