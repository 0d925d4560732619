// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/args.h>

#include <algorithm>

#include "experiments/accuracy/rows.hpp"
#include "experiments/claims/claim.hpp"
#include "experiments/depth/rows.hpp"
#include "experiments/guard_band/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/plane_order/rows.hpp"
#include "experiments/w_sign/rows.hpp"

namespace clipscope::experiments::claims {
namespace {

// A count with at least one case.
const CountRow& count(const Results& results, const char* quantity) {
  const CountRow& row = results.row<CountRow>(&CountRow::quantity, quantity);
  if (row.cases > 0) return row;
  throw MissingFigure(fmt::format("table {} has no case of: {}", CountRow::kName, quantity));
}

using Quantities = std::vector<const char*>;

// Judges by cases that are against a claim: it holds under the condition where there are none of
// the first quantities, and always where there are none of the second either; the third are only
// told. In `figures` stand the count and the cases of each of them, one after the other.
auto by_counts(const Quantities& first, const Quantities& second, const Quantities& third,
               std::string_view condition, const char* figures) {
  return [=](const Results& results) {
    fmt::dynamic_format_arg_store<fmt::format_context> counts;
    const auto none_of = [&](const Quantities& quantities) {
      std::int64_t found = 0;
      for (const char* quantity : quantities) {
        const CountRow& row = count(results, quantity);
        counts.push_back(row.count);
        counts.push_back(row.cases);
        found += row.count;
      }
      return found == 0;
    };
    const bool holds = none_of(first), always = none_of(second) && holds;
    none_of(third);
    return true_only_when(condition, holds, always, "{}", fmt::vformat(figures, counts));
  };
}

Judgement parts(const Results& results) {
  const CountRow& convex = count(results, "a convex polygon leaves one that is not");
  const CountRow& several = count(results, "a concave polygon leaves several");
  return confirmed_if(
      convex.count == 0 && several.count > 0,
      "Convex polygons that left something not convex: {} of {}; concave ones that left several parts: {} of {}.",
      convex.count, convex.cases, several.count, several.cases);
}

Judgement sides_left(const Results& results) {
  using P = guard_band::PointsRow;
  using R = guard_band::PictureRow;
  const double differ = sum(results.figures<P>([](const P& row) { return row.tally.differ; }));
  const double drawn = sum(results.figures<P>([](const P& row) { return row.tally.drawn; }));
  const double unlike = std::ranges::max(results.figures<R>(
      [](const R& row) { return std::max(row.holes_px, row.extra_px); }, &R::vertices, "float"));
  return true_only_when(
      "Pixels next to edges may differ. ", differ == 0, differ == 0 && unlike == 0,
      "Of {:.0f} drawn points {:.0f} differ; float pictures with the sides left to scissoring miss or add at most {:.0f} px of the exact ones.",
      drawn, differ, unlike);
}

Judgement nine_vertices(const Results& results) {
  const CountRow& nine = count(results, "9 vertices");
  const CountRow& more = count(results, "more than 9 vertices");
  if (more.count == 0 && nine.count == 0) {
    throw MissingFigure("no case reached 9 vertices, so the bound was not tried");
  }
  return confirmed_if(more.count == 0, "{} of {} triangles left 9 vertices, {} of {} more.",
                      nine.count, nine.cases, more.count, more.cases);
}

Judgement same_result(const Results& results) {
  using R = accuracy::Row;
  const CountRow& view = count(results, "view/sutherland_hodgman differs");
  const CountRow& clip = count(results, "homogeneous/sutherland_hodgman differs");
  const auto largest_px = [&](std::string_view clipper) {
    const auto max_px = [](const R& row) {
      return row.figures.px ? std::optional(row.figures.px->max) : std::nullopt;
    };
    return std::ranges::max(results.figures<R>(max_px, &R::clipper, clipper, &R::scalar, "float"));
  };
  const double view_px = largest_px(kViewSpace), clip_px = largest_px(kClipSpace);
  const bool exactly = view.count == 0 && clip.count == 0;
  return true_only_when(
      "Arithmetic is exact. ", exactly, exactly && view_px == 0 && clip_px == 0,
      "Exactly: {} of {} triangles differ from the reference in view space, {} of {} in clip space. In float they are off by up to {:.3g} px and {:.3g} px.",
      view.count, view.cases, clip.count, clip.cases, view_px, clip_px);
}

Judgement point_at_eye(const Results& results) {
  const CountRow& as_claimed = count(results, "clip coordinates are (1, 1, -20/9, 0)");
  return confirmed_if(as_claimed.count == as_claimed.cases,
                      "The exact matrix gives (1, 1, -20/9, 0): w = 0.");
}

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
  const bool helps = with == 0 && without > 0;
  return true_only_when(
      "Nothing visible is nearer than 1e-5. ", helps, helps && lost == 0,
      "{}Divisions by w = 0 in float: {:.0f} triangles without it, {:.0f} with it; near the eye it cuts away up to {:.3g} % of what is visible.",
      with + without == 0 ? "There is none to prevent after a cut by all planes. " : "", without,
      with, lost);
}

Judgement near_first(const Results& results) {
  using R = plane_order::OrdersRow;
  const R& all = results.row<R>(&R::set, "all");
  const std::int64_t wrong = all.exact.wrong;
  const double first = all.in_float.wrong_near_first, last = all.in_float.wrong_near_last;
  const bool neither = wrong == 0 && first >= last;
  return true_only_when(
      "Arithmetic rounds. ", !neither, wrong > 0,
      "{}Of {} triangles with some w <= 0 exact arithmetic gets {} wrong in some order; in float {:.0f} are wrong with near first, {:.0f} with near last.",
      neither ? "Any order does it before the divide. " : "", all.exact.mixed_w, wrong, first,
      last);
}

Judgement any_order(const Results& results) {
  using R = plane_order::OrdersRow;
  const R& all = results.row<R>(&R::set, "all");
  const bool exactly = all.exact.differs == 0;
  return true_only_when(
      "Arithmetic is exact. ", exactly, exactly && all.in_float.differs == 0,
      "The order changes {} of {} exact results, and {:.1f} % of those in float, by up to {:.3g} px.",
      all.exact.differs, all.exact.triangles, all.in_float.differs_percent, all.in_float.max_px);
}

Judgement linear_depth(const Results& results) {
  using R = depth::FormRow;
  const auto violations = [&](depth::Form form, const char* property) {
    return sum(results.figures<R>(&R::violations, &R::form, form, &R::property, property,
                                  &R::arithmetic, "exact"));
  };
  const double order = violations(depth::Form::linear, "monotone");
  const double straight = violations(depth::Form::linear, "lines stay straight");
  const double bent = violations(depth::Form::quadratic, "lines stay straight");
  const double wrong = violations(depth::Form::quadratic, "nearer wins");
  return confirmed_if(
      order == 0 && straight == 0 && bent > 0,
      "Exactly: the linear form breaks the order {:.0f} times and bends {:.0f} edges; the quadratic one bends {:.0f}, and shows the farther of two edges {:.0f} times.",
      order, straight, bent, wrong);
}

Judgement reversed_depth(const Results& results) {
  using R = depth::PrecisionRow;
  const auto lost = [&](const char* convention, double ratio) {
    return results
        .row<R>(&R::convention, convention, &R::buffer, depth::Stored::float32, &R::transform,
                depth::Arithmetic::in_float, &R::far_near_ratio, ratio)
        .lost_percent();
  };
  Cases as_good;
  bool better = false;
  for (const double ratio : distinct(results.rows<R>(), &R::far_near_ratio)) {
    const double reversed = lost("reversed", ratio), zero = lost("zero_to_one", ratio);
    const double gl = lost("gl", ratio);
    as_good.add("", reversed <= gl && reversed <= zero,
                fmt::format("{} {:.3g}/{:.3g}/{:.3g}", ratio, reversed, zero, gl));
    better = better || (reversed < gl && reversed < zero);
  }
  Judgement judgement = as_good.judge(
      "",
      "Neighbours not told apart in order, in % of a float buffer, reversed/[0, 1]/[-1, 1] by far/near: {}.",
      as_good.figures("; "));
  if (!better) judgement.verdict = Verdict::refuted;
  return judgement;
}

Judgement w_plane_harmless(const Results& results) {
  using R = hard_cases::SummaryRow;
  const auto failures = [&](std::string_view clipper) {
    return results
        .row<R>(&R::primitive, Primitive::triangle, &R::clipper, clipper, &R::scalar, "float")
        .failures;
  };
  const std::int64_t plain = failures(kClipSpace), narrow = failures(kWPlane);
  const std::int64_t wide = failures("homogeneous/w_first_1_16384");
  return confirmed_if(
      wide <= plain && narrow <= plain,
      "Float fails on {} hard cases without it, on {} with w >= 1/16384 and on {} with w >= 1e-5.",
      plain, wide, narrow);
}

}  // namespace

std::vector<Claim> claims_about_geometry() {
  return {
      {5, "Inside is -w <= x, y, z <= w.", "claims",
       by_counts(
           {"disagrees, depth [-1, 1]"}, {"disagrees, depth [0, 1]", "disagrees, depth reversed"},
           {}, "Depth runs from -1 to 1. ",
           "Against the frustum it is wrong for {} of {} points with depth [-1, 1], {} of {} with [0, 1] and {} of {} with reversed depth, whose near and far are at 0 and w.")},
      {6,
       "Cutting edges in order and fanning keeps the winding, so back-face culling is unaffected.",
       "claims",
       by_counts(
           {"fan triangles wound the other way, cut in clip space"},
           {"fan triangles wound the other way, divided first"}, {},
           "The cut comes before the divide. ",
           "Wound against their triangle: {} of {} fan triangles cut before the divide, {} of {} cut after it (w of both signs).")},
      {8, "A triangle with one vertex outside one plane becomes two triangles.", "claims",
       by_counts(
           {"leaves anything else"}, {"leaves fewer: another vertex is on the plane"},
           {"leaves 4 vertices"}, "No other vertex lies on the plane. ",
           "{4} of {5} leave a quadrilateral, {2} fewer vertices since another lies on the plane, {0} anything else.")},
      {9, "Attributes are interpolated with the same t as positions.", "claims",
       by_counts(
           {"attribute at t in clip space is wrong"}, {"attribute at t after the divide is wrong"},
           {}, "The cut comes before the divide. ",
           "Wrong attributes: {} of {} with t of clip space, {} of {} with t after the divide.")},
      {10,
       "The side planes of the frustum have normals (-+cos(a/2), 0, sin(a/2)) with the vertical angle a of top and bottom.",
       "claims",
       by_counts(
           {"corners off the plane, aspect 1"}, {"corners off the plane, aspect not 1"}, {},
           "The aspect is 1. ",
           "Corners of the frustum off that plane: {} of {} at aspect 1, {} of {} at other aspects; there the horizontal angle is needed.")},
      {12, "Clipping plane after plane, each output the next input, is enough.", "claims",
       by_counts(
           {"homogeneous/sutherland_hodgman differs"}, {}, {}, "",
           "In exact arithmetic {} of {} visible triangles differ from the intersection of half-spaces.")},
      {16, "A convex polygon clips to at most one convex polygon; a concave one may yield several.",
       "claims", parts},
      {22,
       "For points only near and far are tested; for triangles and segments x and y may be left to the rasteriser.",
       "guard_band", sides_left},
      {24,
       "A straight line stays straight in clip space with the same t, so attributes cut there equal those cut in camera space.",
       "claims",
       by_counts(
           {"t in clip space is not t in view space"}, {},
           {"t after the divide is not t in view space"}, "",
           "t differs from view space for {} of {} edges in clip space (after the divide for {} of {}), in exact arithmetic.")},
      {25,
       "With the accept rule x + w >= 0 the denominator of t never vanishes, though x/w = -1 may have no solution.",
       "claims",
       by_counts(
           {"denominator 0"}, {}, {"denominator overflows"}, "",
           "Over floats of all exponents the denominator is 0 for {} of {} crossing edges and overflows for {} of {}; of exact numbers d0 > 0 > d1 makes d0 - d1 > 0.")},
      {26, "Six planes leave at most 9 vertices, 7 triangles.", "claims", nine_vertices},
      {27, "Clip-space and view-space clipping give the same result.", "claims", same_result},
      {28,
       "A point with z_view = 0, such as (1, 1, 0) with l = b = -1, r = t = 1, n = 1, f = 10, has clip coordinates (1, 1, -2.2222, 0) and can't be divided.",
       "claims", point_at_eye},
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
