// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps of random clip-space triangles through the clippers that are a stage of a renderer, in
// every contract and build (contestants/contract.hpp), against the exact answer (T_clip).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/selection/select.hpp"
#include "experiments/survey/sweep.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

struct StageSweepRow {
  std::string clipper, build, contract;
  std::int64_t triangles = 0, visible = 0, wrong = 0;
  std::int64_t coordinates = 0, misrounded = 0;
  double max_px = 0;
  std::optional<std::int64_t> worst_chunk;
  std::string worst;

  static constexpr std::string_view kName = "sweep_stage";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Wrong: visible triangles that look wrong. Coordinates are x, y, z and w in clip space of the exact vertices of visible triangles, misrounded those that are not the nearest float.",
      "`clipscope explain` takes the options and, on standard input, the numbers after the colon."};
  static constexpr auto columns() {
    using R = StageSweepRow;
    return std::tuple(column("clipper", &R::clipper), column("build", &R::build),
                      column("contract", &R::contract), column("triangles", &R::triangles),
                      column("visible", &R::visible), column("wrong", &R::wrong),
                      column("coordinates", &R::coordinates), column("misrounded", &R::misrounded),
                      column("max_px", "max px", &R::max_px),
                      column("worst_chunk", "chunk", &R::worst_chunk),
                      column("worst", "largest error on", &R::worst));
  }
  // Of the same contestant on other triangles.
  StageSweepRow& operator+=(const StageSweepRow& other);
};
inline bool same_subject(const StageSweepRow& a, const StageSweepRow& b) {
  return a.clipper == b.clipper && a.build == b.build && a.contract == b.contract;
}
inline bool is_empty(const StageSweepRow& row) { return row.triangles == 0; }

// Those whose clipper matches the pattern. Errors: UsageError if none does.
Contestants stage_sweep_contestants(const std::string& clipper_pattern);

// How many chunks so many triangles make.
std::size_t stage_sweep_chunks(std::uint64_t triangles);

// The table without rows.
TableOf<StageSweepRow> stage_sweep_table(std::uint64_t triangles, std::uint64_t seed);

// A row for each contestant, with nothing in it.
std::vector<StageSweepRow> empty_stage_rows(const Contestants& contestants);

// Adds some chunks of so many random triangles to the rows of the contestants.
void sweep_stage(std::uint64_t triangles, std::uint64_t seed, ChunkNumbers chunks,
                 const Contestants& contestants, Progress& progress,
                 std::vector<StageSweepRow>& rows);

}  // namespace clipscope::experiments
