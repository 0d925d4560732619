// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/tables.hpp"

#include <fmt/format.h>

namespace clipscope::experiments {
namespace {

// Nothing to divide by: no figure.
Cell per(std::int64_t sum, std::int64_t count) {
  if (count == 0) return std::monostate();
  return static_cast<double>(sum) / static_cast<double>(count);
}

Cell percent(std::int64_t part, std::int64_t all) {
  if (all == 0) return std::monostate();
  return 100 * static_cast<double>(part) / static_cast<double>(all);
}

std::int64_t signed_count(std::uint64_t n) { return static_cast<std::int64_t>(n); }

void add_worst(const SegmentContestant& contestant, const SegmentTally& tally, CellRecord& record) {
  const std::string clipper(clipper_name<2>(contestant)), scalar(scalar_name<2>(contestant));
  const auto add = [&](const std::string& replay, const std::string& measure, double error) {
    if (replay.empty()) return;
    const std::size_t colon = replay.find(" : ");
    const std::string input = replay.substr(colon + 3);
    record.worst_inputs.push_back(
        {clipper, scalar, measure, error, input,
         fmt::format("echo '{}' | clipscope clip {} --clipper {} --scalar {}", input,
                     replay.substr(0, colon), clipper, scalar)});
  };
  add(tally.worst, "position_px", tally.max_px);
  add(tally.failing, std::string("outcome_") + std::string(outcome_name(tally.failing_outcome)),
      static_cast<double>(tally.wrong()));
}

}  // namespace

Table segment_times_table() {
  Table table("segments", "Line clippers: time per segment and what is wrong, four attributes",
              {{"mix", "mix"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"ns_per_segment", "ns/segment"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_cohen_sutherland", "x CS"},
               {"speedup_low", "x CS low"},
               {"speedup_high", "x CS high"},
               {"visible", "visible"},
               {"wrong", "wrong"},
               {"wrong_kinds", "how wrong"},
               {"max_px", "max [px]"},
               {"max_ulp", "max [ulp]"}});
  table.add_note(
      "x CS: how many times faster than homogeneous/cohen_sutherland in float on the same segments "
      "in the same round; median and 95 % interval. Not timed (-): the answers break the promise.");
  table.add_note(
      "Visible, wrong, max: of the judged segments, against the exact answer. Wrong is anything "
      "but the right ends within 1/256 px on 3840 x 2160; max over segments with the right ends.");
  return table;
}

void add_time(const SegmentMix& mix, const SegmentContestant& contestant, const Timing& timing,
              const SegmentTally& tally, Table& table, CellRecord& record) {
  const std::string clipper(clipper_name<2>(contestant)), scalar(scalar_name<2>(contestant));
  std::vector<Cell> cells = {mix.name, clipper, scalar};
  if (timing.refused.empty()) {
    cells.insert(cells.end(), {timing.ns.median, timing.ns.low, timing.ns.high,
                               timing.speedup.median, timing.speedup.low, timing.speedup.high});
    record.samples.push_back(
        {fmt::format("{} {} {}", mix.name, clipper, scalar), "ns/segment", timing.samples_ns});
  } else {
    cells.insert(cells.end(), 6, std::monostate());
  }
  cells.insert(cells.end(),
               {tally.visible(), tally.wrong(), tally.wrong_kinds(), tally.max_px, tally.max_ulp});
  table.add_row(std::move(cells));
  add_worst(contestant, tally, record);
}

Table operations_table() {
  Table table("segments_operations", "Line clippers: operations per segment, divisions by its fate",
              {{"mix", "mix"},
               {"clipper", "clipper"},
               {"additions", "+ -"},
               {"multiplications", "*"},
               {"divisions", "/"},
               {"comparisons", "comparisons"},
               {"cut_divisions", "cut /"},
               {"rejected_percent", "rejected [%]"},
               {"rejected_free_percent", "of these no cut / [%]"},
               {"rejected_undivided_percent", "no / at all [%]"},
               {"divisions_per_accepted", "cut / accepted"},
               {"divisions_per_rejected", "cut / rejected"},
               {"divisions_per_shortened", "cut / shortened"},
               {"moved_ends_per_shortened", "ends moved"}});
  table.add_note(
      "Cut /: all divisions but the four per vertex of the perspective divide: one for each "
      "intersection or parameter; after the divide (cvv, window) one more for the attributes of "
      "each new end. Rejected: of all segments, in exact arithmetic; no cut /, no /: of these, "
      "without a cut division, without any division. Ends moved: of a shortened segment, exactly.");
  return table;
}

void add_operations(const SegmentMix& mix, const Contestant<Counted, 2>& contestant,
                    const SegmentOperations& o, Table& table) {
  const auto each = [&](std::uint64_t n) { return per(signed_count(n), o.segments); };
  const std::int64_t cut =
      o.accepted.cut_divisions + o.rejected.cut_divisions + o.shortened.cut_divisions;
  table.add_row({mix.name, std::string(contestant.name), each(o.total.additions),
                 each(o.total.multiplications), each(o.total.divisions), each(o.total.comparisons),
                 per(cut, o.segments), percent(o.rejected.segments, o.segments),
                 percent(o.rejected.without_cut_division, o.rejected.segments),
                 percent(o.rejected.without_division, o.rejected.segments),
                 per(o.accepted.cut_divisions, o.accepted.segments),
                 per(o.rejected.cut_divisions, o.rejected.segments),
                 per(o.shortened.cut_divisions, o.shortened.segments),
                 per(o.ends_moved, o.shortened.segments)});
}

Table intersection_table() {
  Table table("segments_intersection",
              "One segment against one plane: operations by the plane's form",
              {{"form", "form of the plane"},
               {"additions", "+ -"},
               {"multiplications", "*"},
               {"divisions", "/"},
               {"comparisons", "comparisons"},
               {"divisions_uncut", "/ uncut"},
               {"point_multiplications", "* of the point"}});
  table.add_note(
      "To find the parameter where the plane cuts the segment; / uncut: where it does not. The "
      "new point costs one multiplication per coordinate more, in any form.");
  return table;
}

void add_intersection(const IntersectionCost& cost, Table& table) {
  table.add_row({cost.form, signed_count(cost.cut.additions),
                 signed_count(cost.cut.multiplications), signed_count(cost.cut.divisions),
                 signed_count(cost.cut.comparisons), signed_count(cost.divisions_uncut),
                 signed_count(cost.point_multiplications)});
}

}  // namespace clipscope::experiments
