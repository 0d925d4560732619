// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps of triangles through every clipper: an exhaustive lattice, or very many random triangles.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include "experiments/contestants/columns.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/sweep.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

struct SweepRow {
  std::string clipper, scalar;
  std::int64_t triangles = 0, failures = 0;
  std::array<std::int64_t, kViewOutcomes> outcomes{};
  double max_px = 0, max_ulp = 0, max_attribute = 0;
  std::string worst, failing;

  static constexpr std::array<std::string_view, 1> kNotes = {
      "Outcomes count triangles that are visible in truth or in the answer. `clipscope explain` takes the options and, on standard input, the numbers after the colon."};
  static constexpr auto columns() {
    using R = SweepRow;
    return std::tuple(
        contestant_columns(&R::clipper, &R::scalar), column("triangles", &R::triangles),
        column("failures", "fails", &R::failures),
        columns_of_array(&R::outcomes, kViewOutcomeNames), column("max_px", "max px", &R::max_px),
        column("max_ulp", "max ulp", &R::max_ulp),
        column("max_attribute", "max attr", &R::max_attribute),
        column("worst", "largest error on", &R::worst), column("failing", "fails on", &R::failing));
  }
};

// All classes of a named lattice (see catalogue/lattice.hpp); with --quick every 16th chunk of
// them: the table without rows, and its rows. Pre-condition: the name is one of lattice_names().
TableOf<SweepRow> lattice_table(const std::string& name, const Selection& selection);
void add_lattice(const std::string& name, const Selection& selection, TableOf<SweepRow>& table);

// So many random triangles, all in view space (even index) or clip space (odd): those of the sweep
// below. The same for a seed, an index and a count.
SweepChunk random_chunk(std::uint64_t seed, std::size_t index, std::size_t count);

// Random triangles, half in view space and half in clip space: anywhere, game-like, near planes,
// with mixed signs of w, over wide exponents. The same for a seed, whatever the number of threads.
TableOf<SweepRow> sweep_random(std::uint64_t triangles, const Selection& selection);

}  // namespace clipscope::experiments
