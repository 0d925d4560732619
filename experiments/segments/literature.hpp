// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published line clippers against each other: in the plane, where their papers time them, on
// hard sets, and who is beaten in time and wrong answers.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/segments/clip_segments.hpp"
#include "experiments/segments/rows.hpp"
#include "experiments/survey/pareto.hpp"

namespace clipscope::experiments::segments {

inline constexpr std::string_view kPlaneBaseline = "window/cohen_sutherland";

// A method in the plane on a mix: its time, its operations and what is wrong.
struct PlaneRow {
  using Figure = std::optional<double>;

  std::string mix;
  std::optional<int> year = {};
  std::string clipper, scalar;
  std::optional<Timing> timing = {};
  Figure additions = {}, multiplications = {}, divisions = {}, comparisons = {};  // per segment
  std::int64_t visible = 0, wrong = 0;
  std::string wrong_kinds = {};
  double max_px = 0;

  static constexpr std::string_view kName = "segments_plane";
  static constexpr std::string_view kTitle =
      "Line clippers in the plane, as published: time and operations per segment";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Two points and the window in, two points out: no depth, no attributes, no divide. box_K: both ends uniform in a square whose side is K times the window's; the other mixes hold what exact arithmetic says of their segments. x CS: how many times faster than window/cohen_sutherland in the plane, in the same scalar and round.",
      "Not timed (-): the answers break the promise. Operations: of the counting scalar. Visible, wrong, max: of the judged segments, against the exact answer, on a window of 3840 x 2160 px."};
  static constexpr auto columns() {
    using R = PlaneRow;
    return std::tuple(column("mix", &R::mix), column("year", &R::year),
                      contestant_columns(&R::clipper, &R::scalar),
                      group(&R::timing, Timing::columns("ns_per_segment", "ns/segment",
                                                        "speedup_to_cohen_sutherland", "x CS")),
                      column("additions", "+ -", &R::additions),
                      column("multiplications", "*", &R::multiplications),
                      column("divisions", "/", &R::divisions),
                      column("comparisons", &R::comparisons), column("visible", &R::visible),
                      column("wrong", &R::wrong),
                      column("wrong_kinds", "how wrong", &R::wrong_kinds),
                      column("max_px", "max [px]", &R::max_px));
  }
};

// What a contestant makes of a hard set.
struct HardRow {
  std::string set;
  Contract contract = Contract::full;
  std::optional<int> year = {};
  std::string clipper, scalar;
  std::int64_t segments = 0, wrong = 0;
  std::string wrong_kinds = {}, first = {};

  static constexpr std::string_view kName = "segments_hard";
  static constexpr std::string_view kTitle = "Line clippers on hard sets: what is wrong";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Contract plane: the method alone in two dimensions; full: clip space in, NDC out. Wrong: anything but the right ends within 1/256 px on 3840 x 2160; nothing where something is visible, however short, and something where nothing is are wrong. First: such a segment, to be replayed with clipscope explain."};
  static constexpr auto columns() {
    using R = HardRow;
    return std::tuple(column("set", &R::set), column("contract", &R::contract),
                      column("year", &R::year), contestant_columns(&R::clipper, &R::scalar),
                      column("segments", &R::segments), column("wrong", &R::wrong),
                      column("wrong_kinds", "how wrong", &R::wrong_kinds),
                      column("first", &R::first));
  }
};

// Time and errors of the clippers from view space to NDC, and who is beaten in both.
struct SegmentFrontierRow {
  std::string clipper, scalar;
  std::optional<MedianInterval> ns = {};
  double hard_wrong_percent = 0;
  Standing standing = Standing::unranked;
  std::optional<std::string> dominated_by = {};

  static constexpr std::string_view kName = "segments_frontier";
  static constexpr std::string_view kTitle =
      "Line clippers: time and wrong answers, and who is beaten in both";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Time: the geometric mean over the mixes of table segments; its interval is that of the mixes' intervals. Wrong: of all hard sets together (segments_hard, contract full). Frontier: nobody is at most as slow, at most as often wrong, and better in one of the two."};
  static constexpr auto columns() {
    using R = SegmentFrontierRow;
    return std::tuple(contestant_columns(&R::clipper, &R::scalar),
                      interval("ns_per_segment", "ns", "ns/segment", &R::ns),
                      column("hard_wrong_percent", "hard wrong [%]", &R::hard_wrong_percent),
                      column("on_frontier", "frontier", &R::standing),
                      column("dominated_by", "by", &R::dominated_by));
  }
};

// The contestants of a contract in the scalars, as far as --clipper has them: full or plane.
Contestants contestants_in(Contract contract, const std::string& clipper_pattern,
                           const std::vector<std::string>& scalars);

// One row per contestant of the plane: at most `judged` segments are judged, and counted.
std::vector<PlaneRow> measure_in_plane(const ClipSegments& mix, const Contestants& contestants,
                                       std::size_t judged, const ContestClock& clock);

// One row per contestant that takes the set: those of the plane only where it lies in the plane.
std::vector<HardRow> judge_hard_set(const ClipSegments& set, const Contestants& contestants);

// What is made of these tables alone.

// Of all hard sets together; none where the contestant was not judged.
std::optional<double> wrong_percent(const std::vector<HardRow>& hard, Contract contract,
                                    const std::string& clipper, const std::string& scalar);

std::vector<SegmentFrontierRow> segment_frontier(const std::vector<TimeRow>& times,
                                                 const std::vector<HardRow>& hard);
Plot frontier_plot(const std::vector<SegmentFrontierRow>& rows);

// Who is the fastest and who is least often wrong, behind a blank; empty if nobody was timed.
std::string frontier_finding(const std::vector<SegmentFrontierRow>& rows);

}  // namespace clipscope::experiments::segments
