// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims about rounding, w <= 0, the order of planes, and depth.
#include <algorithm>

#include "experiments/claims/claim.hpp"
#include "experiments/depth/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/plane_order/rows.hpp"
#include "experiments/w_sign/rows.hpp"

namespace clipscope::experiments::claims {
namespace {

constexpr std::string_view kWPlane = "homogeneous/w_first_1e-5";

Judgement w_plane_prevents(const Results& results) {
  using Prevented = w_sign::PreventedRow;
  using Epsilon = w_sign::EpsilonRow;
  const auto zero_w = [&](std::string_view clipper) {
    return sum(results.figures<Prevented>([](const Prevented& row) { return row.hazards.zero_w; },
                                          &Prevented::clipper, clipper));
  };
  const double without = zero_w(kClipSpace), with = zero_w(kWPlane);
  const double lost = std::max(0.0, std::ranges::max(results.figures<Epsilon>(
                                        [](const Epsilon& row) { return row.loss.lost_percent; },
                                        &Epsilon::clipper, kWPlane)));
  return judged(
      {decided("without the plane", "triangles divided by w = 0 in float", without, "", above(0)),
       decided("with the plane", "triangles divided by w = 0 in float", with, "", exactly(0)),
       decided("with the plane", "share of what is visible that it cuts away, near the eye", lost,
               "%", exactly(0))},
      with == 0 && without > 0,
      {fmt::format(
           "The plane spares all of {} triangles a division by zero, and cuts nothing away.",
           number_text(without)),
       fmt::format(
           "Nothing visible is nearer than the plane, which else cuts away up to {} % of what is visible.",
           number_text(lost)),
       with > 0 ? fmt::format("Even behind the plane {} triangles are divided by zero.",
                              number_text(with))
                : "Without the plane no triangle is divided by zero either."});
}

Judgement near_first(const Results& results) {
  using R = plane_order::OrdersRow;
  const R& all = results.row<R>(&R::set, "all");
  const auto first = static_cast<double>(all.in_float.wrong_near_first);
  const auto last = static_cast<double>(all.in_float.wrong_near_last);
  const auto wrong = static_cast<double>(all.exact.wrong);
  const std::vector<Evidence> evidence = {
      decided("exact arithmetic", "triangles that some order gets wrong", wrong,
              fmt::format("of {} with w <= 0", all.exact.mixed_w), above(0)),
      decided("float", "triangles wrong with near first, against near last", first, "",
              below(last))};
  return judged(
      evidence, wrong > 0 || first < last,
      {fmt::format(
           "Some order gets {} triangles wrong even in exact arithmetic, and near first the fewest in float.",
           number_text(wrong)),
       wrong > 0
           ? fmt::format(
                 "Arithmetic is exact, where some order gets {} triangles wrong; in float near first is no better than near last.",
                 number_text(wrong))
           : fmt::format(
                 "Arithmetic rounds; near first gets {} triangles wrong then, near last {}.",
                 number_text(first), number_text(last)),
       fmt::format(
           "Exact arithmetic gets no triangle wrong in any order; float gets {} wrong with near first and {} with near last.",
           number_text(first), number_text(last))});
}

Judgement any_order(const Results& results) {
  using R = plane_order::OrdersRow;
  const R& all = results.row<R>(&R::set, "all");
  const auto differs = static_cast<double>(all.exact.differs);
  return judged(
      {decided("exact arithmetic", "results that the order changes", differs,
               fmt::format("of {}", all.exact.triangles), exactly(0)),
       decided("float", "results that the order changes", static_cast<double>(all.in_float.differs),
               "", exactly(0)),
       told("float", "share of all results", all.in_float.differs_percent, "%"),
       told("float", "largest change", all.in_float.max_px, "px")},
      all.exact.differs == 0,
      {"The order changes no result, neither in exact arithmetic nor in float.",
       fmt::format(
           "Arithmetic is exact; in float the order changes {} % of the results, by up to {} px.",
           number_text(all.in_float.differs_percent), number_text(all.in_float.max_px)),
       fmt::format("Even in exact arithmetic the order changes {} results.",
                   number_text(differs))});
}

Judgement linear_depth(const Results& results) {
  using R = depth::FormRow;
  const auto violations = [&](depth::Form form, const char* property) {
    return sum(results.figures<R>(&R::violations, &R::form, form, &R::property, property,
                                  &R::arithmetic, "exact"));
  };
  const double order = violations(depth::Form::linear, "monotone");
  const double crooked = violations(depth::Form::linear, "lines stay straight");
  const double bent = violations(depth::Form::quadratic, "lines stay straight");
  const double wrong = violations(depth::Form::quadratic, "nearer wins");
  return judged(
      {decided("linear", "pairs of depths in the wrong order", order, "pairs", exactly(0)),
       decided("linear", "edges that are bent", crooked, "edges", exactly(0)),
       decided("quadratic", "edges that are bent", bent, "edges", above(0)),
       told("quadratic", "edges shown before a nearer one", wrong, "edges")},
      false,
      {fmt::format(
           "The linear form keeps the order and every edge straight, while the quadratic one bends {} edges and shows the farther of two {} times.",
           number_text(bent), number_text(wrong)),
       "",
       bent == 0 ? "The quadratic form bends no edge either."
                 : fmt::format("The linear form breaks the order {} times and bends {} edges.",
                               number_text(order), number_text(crooked))});
}

Judgement reversed_depth(const Results& results) {
  using R = depth::PrecisionRow;
  const auto lost = [&](const char* convention, double ratio) {
    return results
        .row<R>(&R::convention, convention, &R::buffer, depth::Stored::float32, &R::transform,
                depth::Arithmetic::in_float, &R::far_near_ratio, ratio)
        .lost_percent();
  };
  std::vector<Evidence> evidence;
  double largest = 0, gain = 0, others = 0;
  bool as_good = true;
  for (const double ratio : distinct(results.rows<R>(), &R::far_near_ratio)) {
    const double reversed = lost("reversed", ratio);
    const double zero = lost("zero_to_one", ratio), gl = lost("gl", ratio);
    evidence.push_back(decided(fmt::format("far/near {:.0f}", ratio),
                               "neighbours not told apart, against the better of the others",
                               reversed, "%", at_most(std::min(zero, gl))));
    as_good = as_good && *evidence.back().holds;
    largest = std::max(largest, reversed);
    others = std::max({others, zero, gl});
    gain = std::max(gain, std::min(zero, gl) - reversed);
  }
  evidence.push_back(decided("all far/near", "most that it gains on the better of the others", gain,
                             "%", above(0)));
  return judged(
      std::move(evidence), false,
      {fmt::format(
           "Reversed depth confuses {} in a float buffer, the other depth ranges up to {} % of them.",
           largest == 0 ? "no neighbours"
                        : fmt::format("at most {} % of the neighbours", number_text(largest)),
           number_text(others)),
       "",
       as_good
           ? "Reversed depth confuses as many neighbours as the other ranges."
           : fmt::format(
                 "Reversed depth confuses up to {} % of the neighbours, more than another range.",
                 number_text(largest))});
}

Judgement w_plane_harmless(const Results& results) {
  using R = hard_cases::SummaryRow;
  const auto failures = [&](std::string_view clipper) {
    const R& row = results.row<R>(&R::primitive, Primitive::triangle, &R::clipper, clipper,
                                  &R::scalar, "float");
    return static_cast<double>(row.failures);
  };
  const double plain = failures(kClipSpace), narrow = failures(kWPlane);
  const double wide = failures("homogeneous/w_first_1_16384");
  constexpr const char* kWhat = "hard cases that float fails on";
  return judged(
      {told("no such plane", kWhat, plain, "cases"),
       decided("w >= 1/16384", kWhat, wide, "cases", at_most(plain)),
       decided("w >= 1e-5", kWhat, narrow, "cases", at_most(plain))},
      false,
      {fmt::format("Float fails on {} hard cases without such a plane, and on no more with one.",
                   number_text(plain)),
       "",
       fmt::format("Float fails on {} hard cases without such a plane, and on up to {} with one.",
                   number_text(plain), number_text(std::max(narrow, wide)))});
}

}  // namespace

std::vector<Claim> claims_about_rounding() {
  return {
      {11, "An extra plane w = 1e-5 in front of the six prevents division by zero.", "w_sign",
       w_plane_prevents},
      {20, "w <= 0 must be dealt with first, and cutting the near plane first does it.",
       "plane_order", near_first},
      {21,
       "Any order gives the same result: points wrongly accepted by five planes fall at the near plane.",
       "plane_order", any_order},
      {23,
       "z' = ((f+n)/(f-n) z + 2fn/(n-f)) is linear in z and monotone after the divide, so it serves for depth; a z' quadratic in z does not.",
       "depth", linear_depth},
      {30,
       "Reversed depth with a float buffer is the more precise choice (Upchurch and Desbrun 2012).",
       "depth", reversed_depth},
      {33, "A plane w >= 1/16384 or w >= 1e-5 is harmless.", "hard_cases", w_plane_harmless}};
}

}  // namespace clipscope::experiments::claims
