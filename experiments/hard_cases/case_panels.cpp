// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/case_panels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace clipscope::experiments::hard_cases {
namespace {

using reference::Rational;

constexpr double kFarthest = 1e39;  // beyond all floats
constexpr double kNdcLimit = 4;     // answers that are farther off are arrows
constexpr double kMostUlps = 1e6;   // more say nothing
constexpr double kVisiblePx = 64;   // larger errors need no magnification
constexpr double kLeastGrid = 6;    // px of the page between the lines of an ulp grid

// The exact result: an area, or what is left of it on a line or in a point.
void draw_exact_result(CaseSketch& s, Panel& panel, const ExactShape& shape) {
  if (shape.size() == 1 && panel.holds(shape.front())) {
    s.page.circle(panel.spot(shape.front()), 7, kExactFill, kExactPen);
  }
  if (panel.is_thin(shape)) {
    panel.stroke(shape, kExactThinPen);
  } else {
    panel.fill(shape, kExactFill);
    panel.stroke(shape, kExactPen);
  }
}

// Lines of at most that width, downwards.
void write_lines(VectorPage& page, Spot at, const std::string& text, double width,
                 std::size_t max_lines, double line_height, const Lettering& style) {
  for (const std::string& line : page.wrap(text, width, max_lines, style)) {
    page.text(at, line, style);
    at.y += line_height;
  }
}

// ---- View space and clip space ------------------------------------------------------------------

// "x = 0.5", not to be broken.
std::string coordinate_text(const ExactPosition& p, const PanelAxis& axis) {
  const double value = nearest_double(p[axis.coordinate]);
  return fmt::format("{}\u00a0=\u00a0{}", "xyzw"[axis.coordinate], short_number(value, 3));
}

// The primitive; and notes beneath the panel, as many as fit in two lines: those given and one on
// each vertex outside.
void draw_input(CaseSketch& s, Panel& panel, const ExactShape& shape,
                std::vector<std::string> notes = {}) {
  panel.stroke(shape, kInputPen);
  std::vector<Panel::Marker> markers;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    markers.push_back({shape[i], std::to_string(i), s.geometry.behind[i]});
  }
  for (const std::size_t i : panel.mark(markers, kBlack, shape)) {
    notes.push_back(fmt::format("{} at {},\u00a0{}", i,
                                coordinate_text(shape[i], panel.horizontal()),
                                coordinate_text(shape[i], panel.vertical())));
  }
  if (notes.empty()) return;
  const Rect& frame = panel.frame();
  write_lines(s.page, {frame.x - 20, frame.bottom() + 42},
              fmt::format("outside the panel: {}", fmt::join(notes, "; ")),
              frame.width + kTickRoom - 14, 2, 13, {.size = 11, .colour = kGrey});
}

// outline: see frustum_outline.
void fit_view_window(const CaseSketch& s, std::size_t outline, PanelAxis& horizontal,
                     PanelAxis& vertical) {
  const HardCase& c = s.picture.hard_case;
  HardCase cut = c;  // the near plane is of interest even if depth is clamped
  cut.volume.depth_clamp = false;
  const ExactShape frustum = frustum_outline(cut, kFarthest, outline);
  WindowRequest request{
      .must = s.geometry.visible_view, .may = s.geometry.input_view, .free_aspect = true};
  request.must.insert(request.must.end(), frustum.begin(), frustum.begin() + 2);
  if (c.frustum.kind == ProjectionKind::perspective) request.must.push_back(position_at(0, 0));
  if (!c.frustum.infinite_far) request.rather.assign(frustum.begin() + 2, frustum.end());
  fit_window(request, horizontal, vertical);
}

// An infinite volume goes on far beyond the panel.
double farthest_depth(const HardCase& c, const Panel& panel) {
  if (!c.frustum.infinite_far && !c.volume.depth_clamp) return kFarthest;
  return std::min(100 * (panel.extent() + std::abs(c.frustum.near)), kFarthest);
}

std::vector<std::string> far_plane_note(const HardCase& c, const Panel& panel,
                                        const ExactShape& frustum) {
  if (c.volume.depth_clamp || panel.holds(frustum[2]) || panel.holds(frustum[3])) return {};
  if (c.frustum.infinite_far) return {"the far plane at infinity"};
  return {fmt::format("the far plane at z\u00a0=\u00a0{}", short_number(-c.frustum.far))};
}

void draw_view_panel(CaseSketch& s, Spot corner, PanelAxis horizontal, PanelAxis vertical,
                     std::size_t outline, const char* title) {
  const HardCase& c = s.picture.hard_case;
  fit_view_window(s, outline, horizontal, vertical);
  Panel panel(s.page, {corner.x, corner.y, kSmallPanel, kSmallPanel}, horizontal, vertical);
  const bool perspective = c.frustum.kind == ProjectionKind::perspective;
  const ExactShape frustum = frustum_outline(c, farthest_depth(c, panel), outline);
  panel.fill(frustum, kVolumeFill);
  if (perspective) {
    const double far = 4 * panel.extent();
    panel.hatch({position_at(-far, -far), position_at(far, far), position_at(far, far, far),
                 position_at(-far, -far, far)},
                kHatch);
  }
  draw_exact_result(s, panel, s.geometry.visible_view);
  panel.stroke(frustum, kPlanePen);
  const ExactPosition eye = position_at(0, 0);
  if (perspective && panel.holds(eye)) draw_eye(s.page, panel.spot(eye));
  draw_input(s, panel, s.geometry.input_view, far_plane_note(c, panel, frustum));
  panel.draw_axes(title);
}

// The half-plane of one coordinate and w: inside is between the lines w = ±c; for depth from 0 to 1
// between c = 0 and c = w; with depth clamp z does not count.
struct ClipLines {
  double low = -1, high = 1;  // inside is low w <= c <= high w
  std::string title;

  bool are_there() const { return low < high; }
};

ClipLines clip_lines(const HardCase& hard_case, std::size_t coordinate) {
  if (coordinate == 2 && hard_case.volume.depth_clamp) {
    return {0, 0, "Clip space: z and w (depth clamp)"};
  }
  if (coordinate == 2 && hard_case.volume.depth != DepthRange::minus_one_to_one) {
    return {0, 1, "Clip space: inside is 0 ≤ z ≤ w"};
  }
  return {-1, 1, fmt::format("Clip space: inside is −w ≤ {} ≤ w", "xyz"[coordinate])};
}

Panel clip_panel(const CaseSketch& s, const Rect& frame, std::size_t coordinate) {
  PanelAxis horizontal{.coordinate = coordinate, .name = std::string(1, "xyz"[coordinate])};
  PanelAxis vertical{.coordinate = 3, .name = "w"};
  WindowRequest request{.must = s.geometry.visible_clip, .may = s.geometry.input_clip};
  request.must.push_back(position_at(0, 0, 0, 0));
  fit_window(request, horizontal, vertical);
  // The lines should be seen on both sides of w = 0.
  const double size = horizontal.size();
  vertical.low = std::min(vertical.low, -0.2 * size);
  vertical.high = std::max(vertical.high, vertical.low + size);
  const double more = vertical.size() - size;
  horizontal.low -= more / 2;
  horizontal.high += more / 2;
  return {s.page, frame, horizontal, vertical};
}

// ---- NDC ----------------------------------------------------------------------------------------

Panel ndc_panel(const CaseSketch& s, const Rect& frame) {
  double half = 1.2;
  for (const ExactPosition& p : s.geometry.answer_ndc) {
    for (const std::size_t c : {0u, 1u}) {
      const double size = std::abs(nearest_double(p[c]));
      if (size < kNdcLimit) half = std::max(half, 1.15 * size);
    }
  }
  return {s.page, frame, {0, "x", false, -half, half}, {1, "y", false, -half, half}};
}

// The vertices in front of the eye where they would be without any clipping, joined if all are
// there.
void draw_divided_input(const CaseSketch& s, Panel& panel) {
  ExactShape divided;
  std::vector<Panel::Marker> markers;
  for (std::size_t i = 0; i < s.geometry.input_clip.size(); ++i) {
    const ExactPosition& p = s.geometry.input_clip[i];
    if (s.geometry.behind[i]) continue;
    divided.push_back({p[0] / p[3], p[1] / p[3], p[2] / p[3], p[3]});
    if (panel.holds(divided.back())) markers.push_back({divided.back(), std::to_string(i)});
  }
  if (divided.size() == s.geometry.input_clip.size()) panel.stroke(divided, kDividedPen);
  panel.mark(markers, kBlack, s.geometry.visible_ndc.empty() ? divided : s.geometry.visible_ndc);
}

void draw_answer(Panel& panel, const ExactShape& shape) {
  panel.stroke(shape, kAnswerPen);
  panel.mark_squares(shape, kAnswer, 4, true);
}

void say_what_is_missing(const CaseSketch& s, Panel& panel) {
  const CasePicture& p = s.picture;
  const auto say = [&](const char* what, std::size_t vertices, Colour colour) {
    if (vertices >= p.truth.needed) return;
    const char* found = vertices == 0   ? "nothing"
                        : vertices == 1 ? "only a point"
                                        : "only a segment";
    panel.say(fmt::format("{}: {}", what, found), colour);
  };
  say("exact", p.truth.exact.vertices.size(), kExactEdge);
  if (p.comparison.outcome == Outcome::not_applicable) {
    panel.say("answer: not applicable", kAnswer);
    return;
  }
  say("answer", p.answer.size(), kAnswer);
  if (s.geometry.answer_not_finite > 0) {
    panel.say(fmt::format("{} vertices of the answer are not finite", s.geometry.answer_not_finite),
              kAnswer);
  }
}

// One unit in the last place of the scalar at |x|, where the answer's doubles hold its values
// exactly.
std::optional<double> ulp_in(const Format& format, const Rational& x) {
  if (format.is_exact() || format.precision > 53) return std::nullopt;
  return format.ulp_at(nearest_double(x));
}

// The error in px and, unless they have no meaning as beside 0, in ulps.
std::string error_text(const CaseSketch& s, const ScreenError& error) {
  const std::string px = fmt::format("{} px apart", short_number(error.px, 3));
  std::string ulps;
  for (const std::size_t c : {0u, 1u}) {
    const auto ulp = ulp_in(s.picture.format, error.exact[c]);
    const double off = std::abs(nearest_double(Rational(error.answer[c] - error.exact[c])));
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

// The numbers of the scalar around the answer's vertex, as dense as they are at it. Whether there
// was room for any.
bool draw_ulp_grid(const CaseSketch& s, Panel& panel, const ScreenError& error) {
  const ExactPosition answer = magnified(error, {error.answer}).front();
  const double far = 4 * panel.extent();
  bool drawn = false;
  for (const std::size_t c : {0u, 1u}) {
    const auto ulp = ulp_in(s.picture.format, error.answer[c]);
    if (!ulp) return drawn;
    const double step = *ulp * (c == 0 ? kScreenWidth : kScreenHeight) / 2;
    const PanelAxis& axis = c == 0 ? panel.horizontal() : panel.vertical();
    const double side = c == 0 ? panel.frame().width : panel.frame().height;
    if (!(step / axis.size() * side >= kLeastGrid)) continue;
    drawn = true;
    const int lines = static_cast<int>(axis.size() / step) + 2;
    for (int k = -lines; k <= lines; ++k) {
      ExactPosition a = position_at(-far, -far), b = position_at(far, far);
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
  const ExactShape exact = magnified(error, s.geometry.visible_ndc);
  draw_exact_result(s, panel, exact);
  if (draw_ulp_grid(s, panel, error)) {
    s.page.text({frame.x - 20, frame.bottom() + 42},
                fmt::format("grey lines: the numbers that {} can hold", s.picture.format.name),
                {.size = 11, .colour = kGrey});
  }
  panel.mark_squares(exact, kExactEdge, 4, false);
  draw_answer(panel, magnified(error, s.geometry.answer_ndc));
  panel.draw_axes("Magnified, " + error_text(s, error));
}

// Whether the answer's doubles show the error: those of wider scalars are rounded.
bool is_error_of_answer(const CaseSketch& s, const ScreenError& error) {
  return ulp_in(s.picture.format, 1).has_value() || error.px > kScreenWidth * 0x1p-53;
}

// What stands in the magnifier's place where there is none.
std::string unmagnified_text(const CaseSketch& s, const std::optional<ScreenError>& error) {
  if (s.geometry.visible_ndc.empty() || s.geometry.answer_ndc.empty()) return {};
  if (!error) return "Every vertex has the exact x and y.";
  if (!is_error_of_answer(s, *error)) {
    return "Every vertex has the exact x and y, rounded to double.";
  }
  return fmt::format("Some vertex is {} px away from the nearest one of the other result.",
                     short_number(error->px, 3));
}

void draw_screen(CaseSketch& s, const Rect& frame) {
  Panel panel = ndc_panel(s, frame);
  const ExactShape square = {position_at(-1, -1), position_at(1, -1), position_at(1, 1),
                             position_at(-1, 1)};
  panel.fill(square, kVolumeFill);
  draw_exact_result(s, panel, s.geometry.visible_ndc);
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

void draw_eye(VectorPage& page, Spot at) {
  page.circle(at, 5, {0xffffff}, {kGrey, 1});
  page.circle(at, 1.5, kGrey, {kGrey, 1});
}

void draw_view_space(CaseSketch& s, Spot corner) {
  const PanelAxis x{.coordinate = 0, .name = "x"}, y{.coordinate = 1, .name = "y"};
  const PanelAxis z{.coordinate = 2, .name = "z", .reversed = true};
  draw_view_panel(s, corner, x, z, 0, "View space from above");
  corner.y += kSmallPanel + kUnderPanel;
  draw_view_panel(s, corner, z, y, 1, "View space from the side");
}

void draw_clip_space(CaseSketch& s, Spot corner, std::size_t coordinate) {
  Panel panel = clip_panel(s, {corner.x, corner.y, kSmallPanel, kSmallPanel}, coordinate);
  const ClipLines lines = clip_lines(s.picture.hard_case, coordinate);
  const double far = 4 * panel.extent();
  const auto point = [&](double c, double w) {
    ExactPosition p = position_at(0, 0, 0, w);
    p[coordinate] = Rational(c);
    return p;
  };
  const ExactShape wedge = {point(0, 0), point(lines.low * far, far), point(lines.high * far, far)};
  const ExactShape half = {point(-far, 0), point(far, 0), point(far, far), point(-far, far)};
  panel.fill(lines.are_there() ? wedge : half, kVolumeFill);
  panel.hatch({point(-far, 0), point(far, 0), point(far, -far), point(-far, -far)}, kHatch);
  draw_exact_result(s, panel, s.geometry.visible_clip);
  if (lines.are_there()) {
    for (const double slope : {lines.low, lines.high}) {
      panel.stroke({point(-slope * far, -far), point(slope * far, far)}, kPlanePen);
    }
  }
  panel.stroke({point(-far, 0), point(far, 0)}, {kBlack, 1, 2});
  if (panel.holds(position_at(0, 0, 0, 0))) {
    s.page.text({panel.frame().x + 5, panel.frame().bottom() - 6}, "w < 0",
                {.size = 11, .colour = kGrey, .halo = true});
  }
  draw_input(s, panel, s.geometry.input_clip);
  panel.draw_axes(lines.title);
}

void draw_ndc(CaseSketch& s, Spot corner) {
  const Rect screen = {corner.x, corner.y, kLargePanel, kLargePanel};
  draw_screen(s, screen);
  const Rect beneath = {corner.x, screen.bottom() + kUnderPanel, kLargePanel,
                        2 * kSmallPanel - kLargePanel};
  const std::optional<ScreenError> error = largest_screen_error(s.geometry);
  if (error && error->px <= kVisiblePx && is_error_of_answer(s, *error)) {
    draw_magnifier(s, beneath, *error);
  } else {
    write_lines(s.page, {beneath.x, beneath.y}, unmagnified_text(s, error), kLargePanel, 4, 18,
                {.size = 13, .colour = kGrey});
  }
}

}  // namespace clipscope::experiments::hard_cases
