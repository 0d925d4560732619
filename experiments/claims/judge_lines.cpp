// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "experiments/claims/judges.hpp"

namespace clipscope::experiments {
namespace {

const std::string kCohenSutherland = "homogeneous/cohen_sutherland";
const std::string kLiangBarsky = "homogeneous/liang_barsky";

}  // namespace

Finding judge_line_outcodes(const Results& results) {
  const auto figure = [&](const std::string& column, const std::string& mix) {
    return results.number("segments_operations", column,
                          {{"mix", mix}, {"clipper", kCohenSutherland}});
  };
  const double rejected = figure("rejected_percent", "window_1_64");
  const double free = rejected * figure("rejected_free_percent", "window_1_64") / 100;
  const double cuts = figure("divisions_per_shortened", "cross_several");
  const double ends = figure("moved_ends_per_shortened", "cross_several");
  const bool rejects_most = free > 50, repeats = cuts > ends;
  const std::string because = fmt::format(
      "Through a window of 1/64 it rejects {:.1f} % of all segments without an "
      "intersection; across several planes it computes {:.2f} for {:.2f} ends that move.",
      free, cuts, ends);
  if (rejects_most && repeats) return {ClaimVerdict::confirmed, because};
  if (rejects_most || repeats) {
    return {ClaimVerdict::conditional,
            (rejects_most ? "Of its first half. " : "Of its second half. ") + because};
  }
  return {ClaimVerdict::refuted, because};
}

Finding judge_liang_barsky(const Results& results) {
  const auto speedup = [&](const std::string& column, const std::string& mix) {
    return results.number("segments", column,
                          {{"mix", mix}, {"clipper", kLiangBarsky}, {"scalar", "float"}});
  };
  const auto most = [&](const std::string& column) {
    const std::vector<double> values =
        results.numbers("segments_operations", column, {{"clipper", kLiangBarsky}});
    return *std::max_element(values.begin(), values.end());
  };
  const double inside = speedup("speedup_to_cohen_sutherland", "inside");
  const double outside = speedup("speedup_to_cohen_sutherland", "outside");
  const bool as_cheap =
      speedup("speedup_high", "inside") >= 1 && speedup("speedup_high", "outside") >= 1;
  const double accepted = most("divisions_per_accepted"), rejected = most("divisions_per_rejected");
  const bool divides_only = accepted == 0 && rejected == 0;
  const std::string because = fmt::format(
      "Its speed is {:.2f} times that of Cohen-Sutherland inside and {:.2f} times outside "
      "(float); divisions per accepted segment at most {:.2f}, per rejected {:.2f}.",
      inside, outside, accepted, rejected);
  if (as_cheap && divides_only) return {ClaimVerdict::confirmed, because};
  if (as_cheap) return {ClaimVerdict::conditional, "Of acceptance and rejection. " + because};
  if (divides_only) return {ClaimVerdict::conditional, "Of divisions, not of time. " + because};
  return {ClaimVerdict::refuted, because};
}

Finding judge_plane_segment(const Results& results) {
  const std::string table = "segments_intersection";
  const std::vector<std::string> forms = results.texts(table, "form");
  const auto figure = [&](const std::string& form, const std::string& column) {
    return results.number(table, column, {{"form", form}});
  };
  std::size_t normalised = 0, cheap = 0;
  bool general = false;
  for (const std::string& form : forms) {
    const double products = figure(form, "multiplications"), quotients = figure(form, "divisions");
    if (form.starts_with("any plane")) {
      general = products == 6 && quotients == 1;
    } else if (form.find("frustum in view space") == std::string::npos) {
      ++normalised;
      cheap += products == 0 && quotients == 1;
    }
  }
  if (normalised == 0) throw MissingFigure(fmt::format("table {} has no normalised form", table));
  const bool holds = general && cheap == normalised;
  const std::string& any = forms.front();
  return {holds ? ClaimVerdict::confirmed : ClaimVerdict::refuted,
          fmt::format("Counted: {:.0f} multiplications and {:.0f} division for any plane; {} of {} "
                      "normalised forms take no multiplication and 1 division.",
                      figure(any, "multiplications"), figure(any, "divisions"), cheap, normalised)};
}

}  // namespace clipscope::experiments
