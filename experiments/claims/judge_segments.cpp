// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims about line clippers: what they accept, reject and divide.
#include <algorithm>

#include "experiments/claims/claim.hpp"
#include "experiments/claims/speed.hpp"
#include "experiments/segments/rows.hpp"

namespace clipscope::experiments::claims {
namespace {

Judgement line_outcodes(const Results& results) {
  using R = segments::OperationsRow;
  const auto figure = [&](std::optional<double> R::*member, const char* mix) {
    return results.figures<R>(member, &R::mix, mix, &R::clipper, "homogeneous/cohen_sutherland")
        .front();
  };
  const double rejected = figure(&R::rejected_percent, "window_1_64");
  const double free = rejected * figure(&R::rejected_free_percent, "window_1_64") / 100;
  const double cuts = figure(&R::divisions_per_shortened, "cross_several") /
                      figure(&R::moved_ends_per_shortened, "cross_several");
  const std::vector<Evidence> evidence = {
      decided("window_1_64", "segments rejected without an intersection", free, "%", above(50)),
      decided("cross_several", "intersections computed for each end that moves", cuts, "",
              above(1))};
  const bool rejects = *evidence[0].holds, repeats = *evidence[1].holds;
  return judged(
      evidence, rejects || repeats,
      {fmt::format(
           "A small window rejects {} % of all segments at once, and across several planes {} intersections are computed for each end that moves.",
           number_text(free), number_text(cuts)),
       rejects
           ? fmt::format(
                 "It speaks of rejecting alone; shortening takes {} intersections for each end that moves.",
                 number_text(cuts))
           : fmt::format(
                 "It speaks of shortening alone; a small window rejects {} % of all segments at once.",
                 number_text(free)),
       fmt::format(
           "A small window rejects {} % of all segments at once, and shortening takes {} intersections for each end that moves.",
           number_text(free), number_text(cuts))});
}

Judgement liang_barsky(const Results& results) {
  using R = segments::OperationsRow;
  constexpr std::string_view kClipper = "homogeneous/liang_barsky";
  const auto speed = [&](const char* mix) {
    return decided(mix, "speed over that of Cohen-Sutherland",
                   speed_of<segments::TimeRow>(results, mix, kClipper), "times", not_below(1));
  };
  const auto divisions = [&](std::optional<double> R::*member, const char* what) {
    return decided("all mixes", what,
                   std::ranges::max(results.figures<R>(member, &R::clipper, kClipper)),
                   "per segment", exactly(0));
  };
  const std::vector<Evidence> evidence = {
      speed("inside"), speed("outside"),
      divisions(&R::divisions_per_accepted, "most divisions of any mix to accept"),
      divisions(&R::divisions_per_rejected, "most divisions of any mix to reject")};
  const bool as_cheap = *evidence[0].holds && *evidence[1].holds;
  const bool divides_only = *evidence[2].holds && *evidence[3].holds;
  const double slower = 1 / std::min(evidence[0].figure, evidence[1].figure);
  const std::string most = number_text(std::max(evidence[2].figure, evidence[3].figure));
  return judged(
      evidence, as_cheap || divides_only,
      {"Liang-Barsky accepts and rejects as fast as Cohen-Sutherland, and without a division.",
       as_cheap
           ? fmt::format(
                 "It speaks of time alone; to accept or reject Liang-Barsky divides up to {} times per segment.",
                 most)
           : fmt::format(
                 "It speaks of divisions alone; to accept or reject Liang-Barsky takes up to {} times as long.",
                 number_text(slower)),
       fmt::format(
           "To accept or reject Liang-Barsky takes up to {} times as long as Cohen-Sutherland, and divides up to {} times per segment.",
           number_text(slower), most)});
}

Judgement plane_segment(const Results& results) {
  std::vector<Evidence> evidence;
  std::size_t normalised = 0, general = 0;
  for (const auto& [form, cut, uncut, point] : results.rows<segments::IntersectionRow>()) {
    const bool is_general = form.starts_with("any plane");
    const auto multiplications = static_cast<double>(cut.multiplications);
    if (!is_general && form.find("frustum in view space") != std::string::npos) {
      evidence.push_back(told(form, "multiplications", multiplications, "each"));
      continue;
    }
    ++(is_general ? general : normalised);
    evidence.push_back(
        decided(form, "multiplications", multiplications, "each", exactly(is_general ? 6 : 0)));
    evidence.push_back(
        decided(form, "divisions", static_cast<double>(cut.divisions), "each", exactly(1)));
  }
  if (normalised == 0 || general == 0) {
    throw MissingFigure(
        "table segments_intersection lacks the general form or the normalised ones");
  }
  return judged(std::move(evidence), false,
                {"The operations counted are those claimed, in every normalised form.", "",
                 "The operations counted are not those claimed, in one form or more."});
}

}  // namespace

std::vector<Claim> claims_about_segments() {
  return {
      {13,
       "Cohen-Sutherland rejects most segments without any intersection when the window is small; it repeats work when a segment must be shortened several times.",
       "segments", line_outcodes},
      {14, "Liang-Barsky accepts and rejects as cheaply, and divides only when it shortens.",
       "segments", liang_barsky},
      {18,
       "A general plane-segment intersection costs 6 multiplications and 1 division; in a normalised (also oblique) volume 1 division.",
       "segments", plane_segment}};
}

}  // namespace clipscope::experiments::claims
