// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it costs that a plug-in lives in a process of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/contestants/columns.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/table/row.hpp"
#include "experiments/table/statistics.hpp"

namespace clipscope::experiments::cost {

inline constexpr std::string_view kDirectCall = "called directly",
                                  kThroughHost = "through its host";

struct PluginRow {
  std::string mix, clipper, scalar;
  std::string way;
  std::int64_t triangles = 0;
  std::optional<MedianInterval> ns = {}, ratio = {};

  static constexpr std::string_view kName = "cost_plugin";
  static constexpr std::string_view kTitle =
      "What a process of its own costs a plug-in: called directly and through its host";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "homogeneous/sutherland_hodgman as a plug-in, one library loaded both ways, in calls of 1,024 triangles. View space in, NDC polygons out, four attributes; both leave the bits of the clipper, or are not timed (-). time / direct: in the same round. Through the host a call waits on a second processor: with one alone it costs two switches of the process."};
  static constexpr auto columns() {
    using R = PluginRow;
    return std::tuple(column("mix", &R::mix), contestant_columns(&R::clipper, &R::scalar),
                      column("way", "call", &R::way), column("triangles", &R::triangles),
                      interval("ns_per_triangle", "ns", "ns/tri", &R::ns),
                      interval("ratio_to_direct", "ratio", "time / direct", &R::ratio));
  }
};

// Two rows for each scalar on the triangles of a view. Errors: GuestError, where our own plug-in is
// not where the program is.
void measure_plugin(const std::string& mix, const SampledView& view, int rounds,
                    TableOf<PluginRow>& table, PieceRecord& record);

// Emits the table.
void run_plugin(const ExperimentContext& context);

}  // namespace clipscope::experiments::cost
