// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sum of shards, from their folders: each a shard that is done, or what shards were merged into
// before, so that many shards can be merged as a tree.
//
// What is refused, with the folders' names: a shard that is not finished; one that is there twice
// or not at all; shards of another sweep, by its options, files or program.
//
// Whatever the number of shards and the order of folders, the table of the whole is the same to the
// byte: sums do not depend on the order, and of what is equally bad that of the lowest unit stays.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/shards/shard_store.hpp"
#include "experiments/store/results_store.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

// A folder that is merged, open.
struct MergeSource {
  std::filesystem::path folder;
  ResultsStore store;
  RunInfo info = {};
  std::vector<StoredExperiment> experiments = {};
  std::vector<ShardRow> shards = {};  // by number
};

// The folders, opened and checked, the lowest shard first. part: shards may be missing.
// Errors: InputError for a folder that holds no shard; UsageError for what is refused.
std::vector<MergeSource> open_sources(const std::vector<std::string>& folders, bool part);

// Whether every shard there is is in the sources.
bool is_whole(const std::vector<MergeSource>& sources);

// The shards of all sources, by number.
TableOf<ShardRow> shards_in(const std::vector<MergeSource>& sources);

// The only table beside `shards`, as the first of the sources has it. Errors: InputError if there
// is none or another one.
Table summed_table(const std::vector<MergeSource>& sources);

// A store in the folder with this table, and which shards are in it. An older store there is kept
// under its date. Errors: OutputError.
void write_merged(const std::filesystem::path& folder, const std::vector<MergeSource>& sources,
                  const Table& table);

// The same of the pieces of experiments (ExperimentContext::piece), which each stand in the store
// of one shard: all of them in one store, in their order, with their pictures. `run --resume` makes
// the rest of them. Errors: InputError if a piece is missing; OutputError.
void merge_pieces(const std::filesystem::path& folder, const std::vector<MergeSource>& sources);

// The info of the merged store.
RunInfo merged_info(const std::vector<MergeSource>& sources);

// Rows of the sources that are about the same, added up, in the order of the first source.
// Row: same_subject(a, b), operator+=; is_empty(row) of one that says nothing, which is left out of
// what is whole.
template <class Row>
Table sum_of(const std::vector<MergeSource>& sources) {
  const Table first = summed_table(sources);
  std::vector<Row> sum;
  for (const MergeSource& source : sources) {
    for (const Row& row : rows_of<Row>(source.store.table(first.name()))) {
      const auto known =
          std::ranges::find_if(sum, [&](const Row& r) { return same_subject(r, row); });
      if (known == sum.end()) {
        sum.push_back(row);
      } else {
        *known += row;
      }
    }
  }
  if (is_whole(sources)) std::erase_if(sum, [](const Row& row) { return is_empty(row); });
  Table table(first.name(), first.title(), first.columns());
  for (const std::string& note : first.notes()) table.add_note(note);
  for (const Row& row : sum) table.add_row(cells_of(row));
  return table;
}

}  // namespace clipscope::experiments
