// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panel of NDC, and what is too small to be seen in it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/contestants/scalars.hpp"
#include "experiments/hard_cases/case_sketch.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;

constexpr double kNdcLimit = 4;    // answers that are farther off are arrows
constexpr double kMostUlps = 1e6;  // more say nothing
constexpr double kVisiblePx = 64;  // larger errors need no magnification
constexpr double kLeastGrid = 6;   // px of the page between the lines of an ulp grid

Panel ndc_panel(const CaseSketch& s, const Rect& frame) {
  double half = 1.2;
  for (const ExactPosition& p : s.geometry.answer_ndc) {
    for (const std::size_t c : {0u, 1u}) {
      const double size = std::abs(CGAL::to_double(p[c]));
      if (size < kNdcLimit) half = std::max(half, 1.15 * size);
    }
  }
  return {s.page, frame, {0, "x", false, -half, half}, {1, "y", false, -half, half}};
}

// The vertices in front of the eye where they would be without any clipping, joined if all are there.
void draw_divided_input(CaseSketch& s, Panel& panel) {
  ExactShape divided;
  std::vector<Panel::Marker> markers;
  for (std::size_t i = 0; i < s.geometry.input_clip.size(); ++i) {
    const ExactPosition& p = s.geometry.input_clip[i];
    if (s.geometry.behind[i]) continue;
    divided.push_back({Rational(p[0] / p[3]), Rational(p[1] / p[3]), Rational(p[2] / p[3]), p[3]});
    if (panel.holds(divided.back())) markers.push_back({divided.back(), std::to_string(i)});
  }
  if (divided.size() == s.geometry.input_clip.size()) panel.stroke(divided, kDividedPen);
  panel.mark(markers, kBlack, s.geometry.visible_ndc.empty() ? divided : s.geometry.visible_ndc);
}

void draw_answer(Panel& panel, const ExactShape& shape) {
  panel.stroke(shape, kAnswerPen);
  panel.mark_squares(shape, kAnswer, 4, true);
}

std::string nothing_text(std::string_view what, std::size_t vertices, std::size_t needed) {
  if (vertices >= needed) return {};
  if (vertices == 0) return fmt::format("{}: nothing", what);
  return fmt::format("{}: only a {}", what, vertices == 1 ? "point" : "segment");
}

void say_what_is_missing(const CaseSketch& s, Panel& panel) {
  const CaseAnswer& answer = s.picture.answer;
  const TruthPolygon& truth = s.picture.truth;
  const std::string exact = nothing_text("exact", truth.exact.vertices.size(), truth.needed);
  if (!exact.empty()) panel.say(exact, kExactEdge);
  if (answer.comparison.outcome == Outcome::not_applicable) {
    panel.say("answer: not applicable", kAnswer);
    return;
  }
  const std::string found = nothing_text("answer", answer.polygon.size(), truth.needed);
  if (!found.empty()) panel.say(found, kAnswer);
  if (s.geometry.answer_not_finite > 0) {
    panel.say(fmt::format("{} vertices of the answer are not finite", s.geometry.answer_not_finite),
              kAnswer);
  }
}

// One unit in the last place of the scalar at |x|, where the answer's doubles hold its values exactly.
std::optional<double> ulp_in(const std::string& scalar, double x) {
  std::optional<double> ulp;
  for_each_type(AllScalars{}, [&]<class T>() {
    constexpr int kPrecision = ScalarTraits<T>::precision;
    if (ScalarTraits<T>::name == scalar && 0 < kPrecision && kPrecision <= 53) ulp = ulp_at<T>(x);
  });
  return ulp;
}

// The error in px and, unless they have no meaning as beside 0, in ulps.
std::string error_text(const CaseSketch& s, const ScreenError& error) {
  const std::string px = fmt::format("{} px apart", short_number(error.px, 3));
  std::string ulps;
  for (const std::size_t c : {0u, 1u}) {
    const auto ulp = ulp_in(s.picture.scalar, CGAL::to_double(error.exact[c]));
    const double off = std::abs(CGAL::to_double(Rational(error.answer[c] - error.exact[c])));
    if (!ulp || off > kMostUlps * *ulp) return px;
    ulps += fmt::format(", {} {} ulp", "xy"[c], short_number(off / *ulp, 3));
  }
  return px + ulps;
}

// Offsets from the exact vertex in px of the screen.
ExactShape magnified(const ScreenError& error, const ExactShape& shape) {
  ExactShape r;
  for (const ExactPosition& p : shape) {
    const auto offset = to_screen(error.exact, p);
    r.push_back({offset[0], offset[1], p[2], p[3]});
  }
  return r;
}

// The numbers of the scalar around the answer's vertex, as dense as they are at it. Whether there was
// room for any.
bool draw_ulp_grid(CaseSketch& s, Panel& panel, const ScreenError& error) {
  const ExactPosition answer = magnified(error, {error.answer}).front();
  bool drawn = false;
  for (const std::size_t c : {0u, 1u}) {
    const auto ulp = ulp_in(s.picture.scalar, CGAL::to_double(error.answer[c]));
    if (!ulp) return drawn;
    const double step = *ulp * (c == 0 ? kScreenWidth : kScreenHeight) / 2;
    const PanelAxis& axis = c == 0 ? panel.horizontal() : panel.vertical();
    const double side = c == 0 ? panel.frame().width : panel.frame().height;
    if (!(step / axis.size() * side >= kLeastGrid)) continue;
    drawn = true;
    const int lines = static_cast<int>(axis.size() / step) + 2;
    for (int k = -lines; k <= lines; ++k) {
      ExactPosition a = position_at(-4 * panel.extent(), -4 * panel.extent());
      ExactPosition b = position_at(4 * panel.extent(), 4 * panel.extent());
      a[c] = b[c] = answer[c] + Rational(k * step);
      panel.stroke({a, b}, {kGrid, 0.8});
    }
  }
  return drawn;
}

void draw_magnifier(CaseSketch& s, const Rect& frame, const ScreenError& error) {
  const double half = 2 * error.px;
  const double half_width = half * frame.width / frame.height;
  Panel panel(s.page, frame, {0, "px", false, -half_width, half_width},
              {1, "px", false, -half, half});
  draw_exact_result(panel, s.page, magnified(error, s.geometry.visible_ndc));
  if (draw_ulp_grid(s, panel, error)) {
    s.page.text({frame.x - 20, frame.bottom() + 42},
                fmt::format("grey lines: the numbers that {} can hold", s.picture.scalar),
                {.size = 11, .colour = kGrey});
  }
  panel.mark_squares(magnified(error, s.geometry.visible_ndc), kExactEdge, 4, false);
  draw_answer(panel, magnified(error, s.geometry.answer_ndc));
  panel.draw_axes("Magnified, " + error_text(s, error));
}

// Whether the answer's doubles show the error: those of wider scalars are rounded.
bool is_error_of_answer(const CaseSketch& s, const ScreenError& error) {
  return ulp_in(s.picture.scalar, 1).has_value() || error.px > kScreenWidth * 0x1p-53;
}

// What stands in the magnifier's place where there is none.
std::string unmagnified_text(const CaseSketch& s, const std::optional<ScreenError>& error) {
  if (s.geometry.visible_ndc.empty() || s.geometry.answer_ndc.empty()) return {};
  if (!error) return "Every vertex has the exact x and y.";
  if (!is_error_of_answer(s, *error))
    return "Every vertex has the exact x and y, rounded to double.";
  return fmt::format("Some vertex is {} px away from the nearest one of the other result.",
                     short_number(error->px, 3));
}

void draw_screen(CaseSketch& s, const Rect& frame) {
  Panel panel = ndc_panel(s, frame);
  const ExactShape square = {position_at(-1, -1), position_at(1, -1), position_at(1, 1),
                             position_at(-1, 1)};
  panel.fill(square, kVolumeFill);
  draw_exact_result(panel, s.page, s.geometry.visible_ndc);
  panel.stroke(square, kPlanePen);
  draw_divided_input(s, panel);
  panel.mark_squares(s.geometry.visible_ndc, kExactEdge, 3, false);
  draw_answer(panel, s.geometry.answer_ndc);
  const Spot middle = panel.middle_of(s.geometry.answer_ndc);
  for (const ExactPosition& p : s.geometry.answer_ndc) {
    if (!panel.holds(p)) panel.point_at(p, middle, kAnswer);
  }
  say_what_is_missing(s, panel);
  panel.draw_axes("NDC: after the divide");
}

}  // namespace

void draw_ndc(CaseSketch& s, Spot corner) {
  const Rect screen = {corner.x, corner.y, kLargePanel, kLargePanel};
  draw_screen(s, screen);
  const double top = screen.bottom() + kUnderPanel;
  const double height = 2 * kSmallPanel - kLargePanel;
  const std::optional<ScreenError> error = largest_screen_error(s.geometry);
  if (error && error->px <= kVisiblePx && is_error_of_answer(s, *error)) {
    draw_magnifier(s, {corner.x, top, kLargePanel, height}, *error);
    return;
  }
  const Lettering style = {.size = 13, .colour = kGrey};
  double y = top;
  for (const std::string& line : s.page.wrap(unmagnified_text(s, error), kLargePanel, 4, style)) {
    s.page.text({corner.x, y}, line, style);
    y += 18;
  }
}

}  // namespace clipscope::experiments
