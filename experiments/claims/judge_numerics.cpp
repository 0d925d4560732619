// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/claims/judges.hpp"

namespace clipscope::experiments {
namespace {

double violations(const Results& results, const std::string& form, const std::string& property,
                  const std::string& arithmetic) {
  double sum = 0;
  for (const double v :
       results.numbers("depth_monotone", "violations",
                       {{"form", form}, {"property", property}, {"arithmetic", arithmetic}})) {
    sum += v;
  }
  return sum;
}

double failures(const Results& results, const std::string& clipper, const std::string& scalar) {
  return results.number("hard_cases", "failures",
                        {{"primitive", "triangle"}, {"clipper", clipper}, {"scalar", scalar}});
}

}  // namespace

Finding judge_w_plane_prevents(const Results& results) {
  const auto sum = [&](const std::string& column, const std::string& clipper) {
    double total = 0;
    for (const double n : results.numbers("w_sign_prevented", column, {{"clipper", clipper}})) {
      total += n;
    }
    return total;
  };
  const double without = sum("zero_w", kClipSpace),
               with = sum("zero_w", "homogeneous/w_first_1e-5");
  double lost = 0;
  for (const double percent : results.numbers("w_sign_epsilon", "lost_percent",
                                              {{"clipper", "homogeneous/w_first_1e-5"}})) {
    lost = std::max(lost, percent);
  }
  std::string because = fmt::format(
      "Divisions by w = 0 in float: {:.0f} triangles without it, {:.0f} with it; near the eye it "
      "cuts "
      "away up to {:.3g} % of what is visible.",
      without, with, lost);
  if (with > 0) return {ClaimVerdict::refuted, because};
  if (without == 0) {
    return {ClaimVerdict::refuted,
            "There is none to prevent after a cut by all planes. " + because};
  }
  if (lost == 0) return {ClaimVerdict::confirmed, because};
  return {ClaimVerdict::conditional, "Nothing visible is nearer than 1e-5. " + because};
}

Finding judge_near_first(const Results& results) {
  const auto all = [&](const std::string& column) {
    return results.number("plane_order", column, {{"set", "all"}});
  };
  const double mixed = all("exact_mixed_w"), wrong = all("exact_wrong");
  const double first = all("float_wrong_near_first"), last = all("float_wrong_near_last");
  const std::string because = fmt::format(
      "Of {:.0f} triangles with some w <= 0 exact arithmetic gets {:.0f} wrong in some order; in "
      "float "
      "{:.0f} are wrong with near first, {:.0f} with near last.",
      mixed, wrong, first, last);
  if (wrong > 0) return {ClaimVerdict::confirmed, because};
  if (first < last) return {ClaimVerdict::conditional, "Arithmetic rounds. " + because};
  return {ClaimVerdict::refuted, "Any order does it before the divide. " + because};
}

Finding judge_any_order(const Results& results) {
  const auto all = [&](const std::string& column) {
    return results.number("plane_order", column, {{"set", "all"}});
  };
  const double exact = all("exact_differs"), rounded = all("float_differs");
  const std::string because = fmt::format(
      "The order changes {:.0f} of {:.0f} exact results, and {:.1f} % of those in float, by up to "
      "{:.3g} "
      "px.",
      exact, all("exact_triangles"), all("float_differs_percent"), all("max_px"));
  if (exact > 0) return {ClaimVerdict::refuted, because};
  if (rounded == 0) return {ClaimVerdict::confirmed, because};
  return {ClaimVerdict::conditional, "Arithmetic is exact. " + because};
}

Finding judge_linear_depth(const Results& results) {
  const double order = violations(results, "linear", "monotone", "exact");
  const double straight = violations(results, "linear", "lines stay straight", "exact");
  const double bent = violations(results, "quadratic", "lines stay straight", "exact");
  const double wrong = violations(results, "quadratic", "nearer wins", "exact");
  const bool holds = order == 0 && straight == 0 && bent > 0;
  return {
      holds ? ClaimVerdict::confirmed : ClaimVerdict::refuted,
      fmt::format("Exactly: the linear form breaks the order {:.0f} times and bends {:.0f} edges; "
                  "the quadratic one bends {:.0f}, and shows the farther of two edges {:.0f} "
                  "times.",
                  order, straight, bent, wrong)};
}

Finding judge_reversed_depth(const Results& results) {
  const auto lost = [&](const std::string& convention, const std::string& buffer,
                        const std::string& ratio) {
    const RowKey key = {{"convention", convention},
                        {"buffer", buffer},
                        {"transform", "float"},
                        {"far_near_ratio", ratio}};
    return results.number("depth", "misordered_percent", key) +
           results.number("depth", "tied_percent", key);
  };
  std::vector<std::string> texts;
  std::size_t as_good = 0;
  bool better = false;
  const std::vector<std::string> ratios = results.texts("depth", "far_near_ratio");
  for (const std::string& ratio : ratios) {
    const double reversed = lost("reversed", "float32", ratio);
    const double gl = lost("gl", "float32", ratio), zero = lost("zero_to_one", "float32", ratio);
    as_good += reversed <= gl && reversed <= zero;
    better = better || (reversed < gl && reversed < zero);
    texts.push_back(fmt::format("{} {:.3g}/{:.3g}/{:.3g}", ratio, reversed, zero, gl));
  }
  return {better ? verdict_of(as_good, ratios.size()) : ClaimVerdict::refuted,
          fmt::format("Neighbours not told apart in order, in % of a float buffer, reversed/[0, "
                      "1]/[-1, 1] by far/near: {}.",
                      fmt::join(texts, "; "))};
}

Finding judge_w_plane_harmless(const Results& results) {
  const double plain = failures(results, kClipSpace, "float");
  const double wide = failures(results, "homogeneous/w_first_1_16384", "float");
  const double narrow = failures(results, "homogeneous/w_first_1e-5", "float");
  const bool harmless = wide <= plain && narrow <= plain;
  return {
      harmless ? ClaimVerdict::confirmed : ClaimVerdict::refuted,
      fmt::format("Float fails on {:.0f} hard cases without it, on {:.0f} with w >= 1/16384 and "
                  "on {:.0f} with w >= 1e-5.",
                  plain, wide, narrow)};
}

}  // namespace clipscope::experiments
