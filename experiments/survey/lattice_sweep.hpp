// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps of triangles through every clipper: an exhaustive lattice, or very many random triangles.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/columns.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/sweep.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

struct SweepRow {
  std::string clipper, scalar;
  Tally tally;

  static constexpr std::array<std::string_view, 2> kNotes = {
      "Outcomes count triangles that are visible in truth or in the answer; columns of ulp those with the right vertices, by the largest error of theirs. Coordinates are x, y, z and 1/w of the exact vertices, misrounded those that are not the nearest number of the scalar.",
      "`clipscope explain` takes the options and, on standard input, the numbers after the colon."};
  static constexpr auto columns() {
    using R = SweepRow;
    return std::tuple(contestant_columns(&R::clipper, &R::scalar), group(&R::tally));
  }
  // Of the same contestant on other triangles.
  SweepRow& operator+=(const SweepRow& other) {
    tally += other.tally;
    return *this;
  }
};
inline bool same_subject(const SweepRow& a, const SweepRow& b) {
  return a.clipper == b.clipper && a.scalar == b.scalar;
}
// Of a clipper that takes no triangle there.
inline bool is_empty(const SweepRow& row) { return row.tally.primitives == 0; }

// What a sweep goes through, and the table that tells of it.
struct SweepPlan {
  std::string name, title;  // of the table
  std::vector<std::string> notes = {};
  SweepSource source = {};

  // Without rows.
  TableOf<SweepRow> table() const;
};

// All classes of a named lattice (see catalogue/lattice.hpp); with --quick every 16th chunk of
// them. Pre-condition: the name is one of lattice_names().
SweepPlan lattice_plan(const std::string& name, const Selection& selection);

// Random triangles, half in view space and half in clip space: anywhere, game-like, near planes,
// with mixed signs of w, over wide exponents. The same for a seed, whatever the number of threads.
SweepPlan random_plan(std::uint64_t triangles, const Selection& selection);

// So many random triangles, all in view space (even index) or clip space (odd): those of the sweep
// above. The same for a seed, an index and a count.
SweepChunk random_chunk(std::uint64_t seed, std::size_t index, std::size_t count);

// Those of the selection in float and double. Errors: UsageError.
Contestants swept_contestants(const Selection& selection);

// A row for each contestant, with nothing in it.
std::vector<SweepRow> empty_rows(const Contestants& contestants);
// Adds some chunks of the plan to the rows of the contestants.
void sweep(const SweepPlan& plan, ChunkNumbers chunks, const Contestants& contestants,
           Progress& progress, std::vector<SweepRow>& rows);

// The plan's table, with a row for each contestant that takes some of its chunks.
TableOf<SweepRow> whole_table(const SweepPlan& plan, const std::vector<SweepRow>& rows);

// The whole sweep.
TableOf<SweepRow> sweep(const SweepPlan& plan, const Selection& selection);

}  // namespace clipscope::experiments
