// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the line clippers' tables, and what is measured for them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/segments/mixes.hpp"
#include "experiments/survey/contest_clock.hpp"
#include "experiments/survey/sweep.hpp"
#include "experiments/table/row.hpp"
#include "spaces/counting.hpp"

namespace clipscope::experiments::segments {

// The time of a contestant on a mix, and what is wrong.
struct TimeRow {
  std::string mix, clipper, scalar;
  std::optional<Timing> timing = {};
  std::int64_t visible = 0, wrong = 0;
  std::string wrong_kinds = {};
  double max_px = 0, max_ulp = 0;

  static constexpr std::string_view kName = "segments";
  static constexpr std::string_view kTitle =
      "Line clippers: time per segment and what is wrong, four attributes";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "x CS: how many times faster than homogeneous/cohen_sutherland in float on the same segments in the same round; median and 95 % interval. Not timed (-): the answers break the promise.",
      "Visible, wrong, max: of the judged segments, against the exact answer. Wrong is anything but the right ends within 1/256 px on 3840 x 2160; max over segments with the right ends."};
  static constexpr auto columns() {
    using R = TimeRow;
    return std::tuple(column("mix", &R::mix), contestant_columns(&R::clipper, &R::scalar),
                      group(&R::timing, Timing::columns("ns_per_segment", "ns/segment",
                                                        "speedup_to_cohen_sutherland", "x CS")),
                      column("visible", &R::visible), column("wrong", &R::wrong),
                      column("wrong_kinds", "how wrong", &R::wrong_kinds),
                      column("max_px", "max [px]", &R::max_px),
                      column("max_ulp", "max [ulp]", &R::max_ulp));
  }
};

// The operations of a clipper on a mix, per segment, and its divisions by what becomes of a
// segment. A figure about no segments is empty.
struct OperationsRow {
  using Figure = std::optional<double>;

  std::string mix, clipper;
  Figure additions, multiplications, divisions, comparisons, cut_divisions;
  Figure rejected_percent, rejected_free_percent, rejected_undivided_percent;
  Figure divisions_per_accepted, divisions_per_rejected, divisions_per_shortened;
  Figure moved_ends_per_shortened;

  static constexpr std::string_view kName = "segments_operations";
  static constexpr std::string_view kTitle =
      "Line clippers: operations per segment, divisions by its fate";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Cut /: all divisions but the four per vertex of the perspective divide: one for each intersection or parameter; after the divide (cvv, window) one more for the attributes of each new end. Rejected: of all segments, in exact arithmetic; no cut /, no /: of these, without a cut division, without any division. Ends moved: of a shortened segment, exactly."};
  static constexpr auto columns() {
    using R = OperationsRow;
    return std::tuple(
        column("mix", &R::mix), column("clipper", &R::clipper),
        column("additions", "+ -", &R::additions),
        column("multiplications", "*", &R::multiplications),
        column("divisions", "/", &R::divisions), column("comparisons", &R::comparisons),
        column("cut_divisions", "cut /", &R::cut_divisions),
        column("rejected_percent", "rejected [%]", &R::rejected_percent),
        column("rejected_free_percent", "of these no cut / [%]", &R::rejected_free_percent),
        column("rejected_undivided_percent", "no / at all [%]", &R::rejected_undivided_percent),
        column("divisions_per_accepted", "cut / accepted", &R::divisions_per_accepted),
        column("divisions_per_rejected", "cut / rejected", &R::divisions_per_rejected),
        column("divisions_per_shortened", "cut / shortened", &R::divisions_per_shortened),
        column("moved_ends_per_shortened", "ends moved", &R::moved_ends_per_shortened));
  }
};

// One segment against one plane, the building block (spaces/plane_segment.hpp), in one of the forms
// that a plane can have.
struct IntersectionRow {
  std::string form;
  OperationCounts cut = {};                 // to find the parameter where the plane cuts
  std::uint64_t divisions_uncut = 0;        // where it does not
  std::uint64_t point_multiplications = 0;  // the new point, without attributes

  static constexpr std::string_view kName = "segments_intersection";
  static constexpr std::string_view kTitle =
      "One segment against one plane: operations by the plane's form";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "To find the parameter where the plane cuts the segment; / uncut: where it does not. The new point costs one multiplication per coordinate more, in any form."};
  static constexpr auto columns() {
    using R = IntersectionRow;
    using O = OperationCounts;
    return std::tuple(column("form", "form of the plane", &R::form),
                      group(&R::cut, std::tuple(column("additions", "+ -", &O::additions),
                                                column("multiplications", "*", &O::multiplications),
                                                column("divisions", "/", &O::divisions),
                                                column("comparisons", &O::comparisons))),
                      column("divisions_uncut", "/ uncut", &R::divisions_uncut),
                      column("point_multiplications", "* of the point", &R::point_multiplications));
  }
};

// One tally per contestant, in their order; the same whatever the number of threads.
std::vector<Tally> judge(const Mix& mix, const Contestants& contestants);

// "3 missing, 1 visible": the failures by kind; empty if there are none.
std::string wrong_kinds(const Tally& tally);

// One timing per contestant, in ns per segment, against homogeneous/cohen_sutherland in float.
std::vector<Timing> time_clippers(const Mix& mix, const Contestants& contestants,
                                  const ContestClock& clock);

// One row per contestant. Pre-condition: they compute in the scalar counting.
std::vector<OperationsRow> count_operations(const Mix& mix, const Contestants& contestants);

// One row per form of the plane: the most that any of many random segments costs.
std::vector<IntersectionRow> intersection_costs();

// What is said of the line clippers at the end, from the rows of their tables alone.

// Time per segment by mix, in the scalar of the first row. Without series if nothing was timed.
Plot time_plot(const std::vector<TimeRow>& times);

// Divisions that cut, per segment by mix. Without series if there is no row.
Plot divisions_plot(const std::vector<OperationsRow>& operations);

// Who is the fastest on most mixes, and what Cohen-Sutherland saves and wastes.
std::string finding(const std::vector<TimeRow>& times,
                    const std::vector<OperationsRow>& operations);

}  // namespace clipscope::experiments::segments
