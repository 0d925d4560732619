// SPDX-License-Identifier: GPL-3.0-or-later
//
// What compiler flags cost, and whether they change a bit.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/clock/clock.hpp"
#include "experiments/contestants/columns.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/table/row.hpp"
#include "experiments/table/statistics.hpp"

namespace clipscope::experiments::cost {

inline constexpr const char* kNoFlags = "none";

struct FlagRow {
  std::string mix, clipper, scalar;
  std::string flags;                       // added to those of contestants
  std::int64_t triangles = 0, differ = 0;  // compared with the contestant; with other bits
  std::optional<MedianInterval> ns = {}, ratio = {};

  static constexpr std::string_view kName = "cost_flags";
  static constexpr std::string_view kTitle =
      "What compiler flags cost: the same sources compiled once more with each";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "View space in, NDC polygons out, four attributes. First those of contestants, which are what a renderer compiles with (see flags below), then with what is named added to them. time / unflagged: in the same round.",
      "other bits: triangles whose polygon differs in some bit from that of the contestant. A build that has any is not timed (-)."};
  static constexpr auto columns() {
    using R = FlagRow;
    return std::tuple(column("mix", &R::mix), contestant_columns(&R::clipper, &R::scalar),
                      column("flags", &R::flags), column("triangles", &R::triangles),
                      column("other_bits", "other bits", &R::differ),
                      interval("ns_per_triangle", "ns", "ns/tri", &R::ns),
                      interval("time_ratio", "ratio", "time / unflagged", &R::ratio));
  }
};

// A row for each clipper and build on the triangles of a view.
void measure_flags(const std::string& mix, const SampledView& view, int rounds,
                   TableOf<FlagRow>& table, PieceRecord& record);

// Emits the table.
void run_flags(const ExperimentContext& context);

}  // namespace clipscope::experiments::cost
