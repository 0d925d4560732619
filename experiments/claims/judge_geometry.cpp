// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/claims/judges.hpp"

namespace clipscope::experiments {
namespace {

struct Tally {
  double cases = 0, count = 0;

  bool none() const { return count == 0; }
  bool all() const { return count == cases; }
  std::string text() const { return fmt::format("{:.0f} of {:.0f}", count, cases); }
};

// A row of claims_counts with at least one case.
Tally tally(const Results& results, const std::string& quantity) {
  const Tally t{results.number(kCountsTable, "cases", {{"quantity", quantity}}),
                results.number(kCountsTable, "count", {{"quantity", quantity}})};
  if (t.cases == 0) throw MissingFigure(fmt::format("{}: no case of: {}", kCountsTable, quantity));
  return t;
}

double largest(const Results& results, const std::string& table, const std::string& column,
               const RowKey& key) {
  const std::vector<double> values = results.numbers(table, column, key);
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

namespace {

// What the correction takes in time, mix by mix.
std::string price_of_correction(const Results& results) {
  std::vector<std::string> parts;
  for (const std::string& mix : results.texts("cost", "mix")) {
    const auto ns = [&](const char* clipper) {
      return results.number("cost", "ns_per_triangle",
                            {{"mix", mix}, {"clipper", clipper}, {"scalar", "float"}});
    };
    parts.push_back(
        fmt::format("{} {:+.0f} %", mix, 100 * (ns("cvv/perspective") / ns("cvv/naive") - 1)));
  }
  return fmt::format("The correction changes the time by: {}.", fmt::join(parts, ", "));
}

}  // namespace

Finding judge_perspective(const Results& results) {
  const double affine = largest(results, "perspective_clip", "max_error",
                                {{"clipper", "cvv/naive"}, {"scalar", "exact"}});
  const double correct = largest(results, "perspective_clip", "max_error",
                                 {{"clipper", "cvv/perspective"}, {"scalar", "exact"}});
  const auto verdict = affine > 0 && correct == 0 ? ClaimVerdict::confirmed : ClaimVerdict::refuted;
  return {
      verdict,
      fmt::format("In exact arithmetic new vertices cut after the divide have attributes wrong by "
                  "up to {:.2g} of their range if they are interpolated as positions are, by "
                  "{:.2g} with a/w and 1/w. {}",
                  affine, correct, price_of_correction(results))};
}

Finding judge_inside(const Results& results) {
  const Tally gl = tally(results, "disagrees, depth [-1, 1]");
  const Tally zero = tally(results, "disagrees, depth [0, 1]");
  const Tally reversed = tally(results, "disagrees, depth reversed");
  const std::string because = fmt::format(
      "Against the frustum it is wrong for {} points with depth [-1, 1], {} with [0, 1] "
      "and {} with reversed depth, whose near and far are at 0 and w.",
      gl.text(), zero.text(), reversed.text());
  if (!gl.none()) return {ClaimVerdict::refuted, because};
  const bool always = zero.none() && reversed.none();
  return {always ? ClaimVerdict::confirmed : ClaimVerdict::conditional,
          always ? because : "Depth runs from -1 to 1. " + because};
}

Finding judge_winding(const Results& results) {
  const Tally in_order = tally(results, "fan triangles wound the other way, cut in clip space");
  const Tally naive = tally(results, "fan triangles wound the other way, divided first");
  const std::string because = fmt::format(
      "Wound against their triangle: {} fan triangles cut before the divide, {} cut after "
      "it (w of both signs).",
      in_order.text(), naive.text());
  if (!in_order.none()) return {ClaimVerdict::refuted, because};
  if (naive.none()) return {ClaimVerdict::confirmed, because};
  return {ClaimVerdict::conditional, "The cut comes before the divide. " + because};
}

Finding judge_two_triangles(const Results& results) {
  const Tally four = tally(results, "leaves 4 vertices");
  const Tally touching = tally(results, "leaves fewer: another vertex is on the plane");
  const Tally other = tally(results, "leaves anything else");
  const std::string because = fmt::format(
      "{} leave a quadrilateral, {:.0f} fewer vertices since another lies on the plane, {:.0f} "
      "anything else.",
      four.text(), touching.count, other.count);
  if (!other.none()) return {ClaimVerdict::refuted, because};
  if (touching.none()) return {ClaimVerdict::confirmed, because};
  return {ClaimVerdict::conditional, "No other vertex lies on the plane. " + because};
}

Finding judge_same_t(const Results& results) {
  const Tally before = tally(results, "attribute at t in clip space is wrong");
  const Tally after = tally(results, "attribute at t after the divide is wrong");
  const std::string because =
      fmt::format("Wrong attributes: {} with t of clip space, {} with t after the divide.",
                  before.text(), after.text());
  if (!before.none()) return {ClaimVerdict::refuted, because};
  if (after.none()) return {ClaimVerdict::confirmed, because};
  return {ClaimVerdict::conditional, "The cut comes before the divide. " + because};
}

Finding judge_side_normals(const Results& results) {
  const Tally square = tally(results, "corners off the plane, aspect 1");
  const Tally wide = tally(results, "corners off the plane, aspect not 1");
  const std::string because = fmt::format(
      "Corners of the frustum off that plane: {} at aspect 1, {} at other aspects; there "
      "the horizontal angle is needed.",
      square.text(), wide.text());
  if (!square.none()) return {ClaimVerdict::refuted, because};
  if (wide.none()) return {ClaimVerdict::confirmed, because};
  return {ClaimVerdict::conditional, "The aspect is 1. " + because};
}

Finding judge_plane_after_plane(const Results& results) {
  const Tally exact = tally(results, "homogeneous/sutherland_hodgman differs");
  const std::string because = fmt::format(
      "In exact arithmetic {} visible triangles differ from the intersection of half-spaces.",
      exact.text());
  return {exact.none() ? ClaimVerdict::confirmed : ClaimVerdict::refuted, because};
}

Finding judge_parts(const Results& results) {
  const Tally convex = tally(results, "a convex polygon leaves one that is not");
  const Tally several = tally(results, "a concave polygon leaves several");
  const bool holds = convex.none() && !several.none();
  return {holds ? ClaimVerdict::confirmed : ClaimVerdict::refuted,
          fmt::format("Convex polygons that left something not convex: {}; concave ones that left "
                      "several parts: {}.",
                      convex.text(), several.text())};
}

Finding judge_sides_left(const Results& results) {
  double differ = 0, points = 0, unlike = 0;
  for (const double n : results.numbers("guard_band_points", "differ", {})) differ += n;
  for (const double n : results.numbers("guard_band_points", "drawn", {})) points += n;
  for (const char* column : {"holes_px", "extra_px"}) {
    for (const double n : results.numbers("guard_band_pictures", column, {{"vertices", "float"}})) {
      unlike = std::max(unlike, n);
    }
  }
  const std::string because = fmt::format(
      "Of {:.0f} drawn points {:.0f} differ; float pictures with the sides left to scissoring miss "
      "or "
      "add at most {:.0f} px of the exact ones.",
      points, differ, unlike);
  if (differ == 0 && unlike == 0) return {ClaimVerdict::confirmed, because};
  if (differ > 0) return {ClaimVerdict::refuted, because};
  return {ClaimVerdict::conditional, "Pixels next to edges may differ. " + because};
}

Finding judge_straight_lines(const Results& results) {
  const Tally clip = tally(results, "t in clip space is not t in view space");
  const Tally ndc = tally(results, "t after the divide is not t in view space");
  return {clip.none() ? ClaimVerdict::confirmed : ClaimVerdict::refuted,
          fmt::format("t differs from view space for {} edges in clip space (after the divide for "
                      "{}), in exact arithmetic.",
                      clip.text(), ndc.text())};
}

Finding judge_denominator(const Results& results) {
  const Tally zero = tally(results, "denominator 0");
  const Tally infinite = tally(results, "denominator overflows");
  const std::string because = fmt::format(
      "Over floats of all exponents the denominator is 0 for {} crossing edges and "
      "overflows for {}; of exact numbers d0 > 0 > d1 makes d0 - d1 > 0.",
      zero.text(), infinite.text());
  return {zero.none() ? ClaimVerdict::confirmed : ClaimVerdict::refuted, because};
}

Finding judge_nine_vertices(const Results& results) {
  const Tally nine = tally(results, "9 vertices");
  const Tally more = tally(results, "more than 9 vertices");
  if (more.none() && nine.none()) {
    throw MissingFigure("no case reached 9 vertices, so the bound was not tried");
  }
  return {more.none() ? ClaimVerdict::confirmed : ClaimVerdict::refuted,
          fmt::format("{} triangles left 9 vertices, {} more.", nine.text(), more.text())};
}

Finding judge_same_result(const Results& results) {
  const Tally view = tally(results, "view/sutherland_hodgman differs");
  const Tally clip = tally(results, "homogeneous/sutherland_hodgman differs");
  const double view_px =
      largest(results, "accuracy", "max_px", {{"clipper", kViewSpace}, {"scalar", "float"}});
  const double clip_px =
      largest(results, "accuracy", "max_px", {{"clipper", kClipSpace}, {"scalar", "float"}});
  const std::string because = fmt::format(
      "Exactly: {} triangles differ from the reference in view space, {} in clip space. In float "
      "they "
      "are off by up to {:.3g} px and {:.3g} px.",
      view.text(), clip.text(), view_px, clip_px);
  if (!view.none() || !clip.none()) return {ClaimVerdict::refuted, because};
  if (view_px == 0 && clip_px == 0) return {ClaimVerdict::confirmed, because};
  return {ClaimVerdict::conditional, "Arithmetic is exact. " + because};
}

Finding judge_point_at_eye(const Results& results) {
  const Tally as_claimed = tally(results, "clip coordinates are (1, 1, -20/9, 0)");
  return {as_claimed.all() ? ClaimVerdict::confirmed : ClaimVerdict::refuted,
          "The exact matrix gives (1, 1, -20/9, 0): w = 0."};
}

}  // namespace clipscope::experiments
