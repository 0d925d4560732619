// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/tables.hpp"

#include <algorithm>

#include "experiments/measure/batches.hpp"

namespace clipscope::experiments {
namespace {

OperationCounts counted_operations(const Contestant<Counted>& contestant,
                                   std::span<const TimedBatch> batches) {
  PolygonStream<Counted, kSceneAttributes> out;
  OperationCounts sum;
  for (const TimedBatch& batch : batches) {
    const auto input = simplices_cast<Counted>(batch.triangles);
    const auto projection = projection_of<Counted>(batch.view);
    out.clear();
    operation_counts() = {};
    contestant.view(projection, input, out);
    const OperationCounts& counted = operation_counts();
    sum.additions += counted.additions;
    sum.multiplications += counted.multiplications;
    sum.divisions += counted.divisions;
    sum.comparisons += counted.comparisons;
  }
  return sum;
}

}  // namespace

Table cost_table() {
  Table table("cost", "Time per triangle, view space in, NDC polygons out, four attributes",
              {{"mix", "mix"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_textbook", "x textbook"},
               {"speedup_low", "95 % low"},
               {"speedup_high", "high"}});
  table.add_note(
      "x textbook: how many times faster than textbook in float on the same triangles in the "
      "same round; median and 95 % interval. Not timed (-): the answers break the promise.");
  return table;
}

Table cost_operations_table() {
  return Table("cost_operations", "Operations per triangle, by kind",
               {{"mix", "mix"},
                {"clipper", "clipper"},
                {"additions", "+ -"},
                {"multiplications", "*"},
                {"divisions", "/"},
                {"comparisons", "comparisons"}});
}

Table cost_split_table() {
  Table table("cost_split", "Where the time goes: transform, cut, divide, in the clipper's order",
              {{"mix", "mix"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"part", "part"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"share_percent", "share %"},
               {"share_low", "95 % low"},
               {"share_high", "high"}});
  table.add_note(
      "Three runs side by side, each doing one step more; a part is the difference of two in the "
      "same "
      "round. The transform alone is that of positions. A processor overlaps one step with the "
      "next, "
      "which a run of the first alone can't show: a small or negative part is hidden behind the "
      "others.");
  return table;
}

void add_cost_rows(const std::string& mix, std::span<const AnyContestant> contestants,
                   std::span<const Timing> timings, Table& table) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Timing& t = timings[i];
    std::vector<Cell> cells = {mix, std::string(clipper_name(contestants[i])),
                               std::string(scalar_name(contestants[i]))};
    if (t.refused.empty()) {
      cells.insert(cells.end(), {t.ns.median, t.ns.low, t.ns.high, t.speedup.median, t.speedup.low,
                                 t.speedup.high});
    } else {
      cells.resize(table.columns().size());
    }
    table.add_row(std::move(cells));
  }
}

void add_operation_rows(const std::string& mix, std::span<const TimedBatch> batches,
                        std::span<const AnyContestant> selected, Table& table) {
  double triangles = 0;
  for (const TimedBatch& batch : batches) triangles += static_cast<double>(batch.triangles.size());
  for (const Contestant<Counted>& contestant : contestants<Counted>()) {
    const bool is_selected =
        std::any_of(selected.begin(), selected.end(),
                    [&](const AnyContestant& any) { return clipper_name(any) == contestant.name; });
    if (!is_selected) continue;
    const OperationCounts sum = counted_operations(contestant, batches);
    const auto per_triangle = [&](std::uint64_t n) { return static_cast<double>(n) / triangles; };
    table.add_row({mix, std::string(contestant.name), per_triangle(sum.additions),
                   per_triangle(sum.multiplications), per_triangle(sum.divisions),
                   per_triangle(sum.comparisons)});
  }
}

void add_split_rows(const std::string& mix, std::span<const Split> splits, Table& table) {
  for (const Split& split : splits) {
    for (const SplitPart& part : split.parts) {
      table.add_row({mix, split.clipper, split.scalar, std::string(part.name), part.ns.median,
                     part.ns.low, part.ns.high, part.share.median, part.share.low,
                     part.share.high});
    }
  }
}

}  // namespace clipscope::experiments
