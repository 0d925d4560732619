// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panels of view space and clip space.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "experiments/hard_cases/case_sketch.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;

constexpr double kFarthest = 1e39;  // beyond all floats

std::string coordinates_text(const ExactPosition& p, const PanelAxis& a, const PanelAxis& b) {
  const auto one = [&](const PanelAxis& axis) {
    const double value = CGAL::to_double(p[static_cast<std::size_t>(axis.coordinate)]);
    return fmt::format("{} = {}", "xyzw"[axis.coordinate], short_number(value, 3));
  };
  return fmt::format("{}, {}", one(a), one(b));
}

// Beneath the panel, as many as fit in two lines.
void note_outside(CaseSketch& s, const Rect& frame, const std::vector<std::string>& notes) {
  if (notes.empty()) return;
  const Lettering style = {.size = 11, .colour = kGrey};
  const std::string text = fmt::format("outside the panel: {}", fmt::join(notes, "; "));
  double y = frame.bottom() + 42;
  for (const std::string& line : s.page.wrap(text, frame.width + kTickRoom - 14, 2, style)) {
    s.page.text({frame.x - 20, y}, line, style);
    y += 13;
  }
}

// Returns a note on each vertex outside of the panel.
std::vector<std::string> draw_input(CaseSketch& s, Panel& panel, const ExactShape& shape) {
  panel.stroke(shape, kInputPen);
  std::vector<Panel::Marker> markers;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    markers.push_back({shape[i], std::to_string(i), s.geometry.behind[i]});
  }
  std::vector<std::string> notes;
  for (const std::size_t i : panel.mark(markers, kBlack, shape)) {
    notes.push_back(fmt::format("{} at {}", i,
                                coordinates_text(shape[i], panel.horizontal(), panel.vertical())));
  }
  return notes;
}

struct ViewPanel {
  Rect frame;
  PanelAxis horizontal, vertical;
  ExactShape (*frustum)(const HardCase&, double);
  std::string title;
};

void fit_view_window(const CaseSketch& s, ViewPanel& p) {
  const HardCase& c = s.picture.hard_case;
  HardCase cut = c;  // the near plane is of interest even if depth is clamped
  cut.volume.depth_clamp = false;
  const ExactShape frustum = p.frustum(cut, kFarthest);
  WindowRequest request{.must = s.geometry.visible_view, .may = s.geometry.input_view};
  request.free_aspect = true;
  request.must.insert(request.must.end(), frustum.begin(), frustum.begin() + 2);
  if (c.frustum.kind == ProjectionKind::perspective) request.must.push_back(position_at(0, 0));
  if (!c.frustum.infinite_far) request.rather.assign(frustum.begin() + 2, frustum.end());
  fit_window(request, p.horizontal, p.vertical);
}

// An infinite volume goes on far beyond the panel.
double farthest_depth(const HardCase& c, const Panel& panel) {
  const bool endless = c.frustum.infinite_far || c.volume.depth_clamp;
  return endless ? std::min(100 * (panel.extent() + std::abs(c.frustum.near)), kFarthest)
                 : kFarthest;
}

// Of the vertices, and of the far plane.
std::vector<std::string> view_notes(const HardCase& c, const Panel& panel,
                                    const ExactShape& frustum) {
  if (c.volume.depth_clamp || panel.holds(frustum[2]) || panel.holds(frustum[3])) return {};
  if (c.frustum.infinite_far) return {"the far plane at infinity"};
  return {fmt::format("the far plane at z = {}", short_number(-c.frustum.far))};
}

void draw_view_panel(CaseSketch& s, ViewPanel p) {
  const HardCase& c = s.picture.hard_case;
  fit_view_window(s, p);
  Panel panel(s.page, p.frame, p.horizontal, p.vertical);
  const bool perspective = c.frustum.kind == ProjectionKind::perspective;
  const ExactShape frustum = p.frustum(c, farthest_depth(c, panel));
  panel.fill(frustum, kVolumeFill);
  if (perspective) {
    const double far = 4 * panel.extent();
    panel.hatch({position_at(-far, -far), position_at(far, far), position_at(far, far, far),
                 position_at(-far, -far, far)},
                kHatch);
  }
  draw_exact_result(panel, s.page, s.geometry.visible_view);
  panel.stroke(frustum, kPlanePen);
  if (perspective && panel.holds(position_at(0, 0)))
    draw_eye(s.page, panel.spot(position_at(0, 0)));
  std::vector<std::string> notes = view_notes(c, panel, frustum);
  std::ranges::move(draw_input(s, panel, s.geometry.input_view), std::back_inserter(notes));
  note_outside(s, panel.frame(), notes);
  panel.draw_axes(p.title);
}

// The half-plane of one coordinate and w: inside is between the lines w = ±c; for depth from 0 to 1
// between c = 0 and c = w; with depth clamp z does not count.
struct ClipLines {
  double low = -1, high = 1;  // inside is low w <= c <= high w
  std::string title;
};

ClipLines clip_lines(const HardCase& hard_case, int coordinate) {
  const char name = "xyz"[coordinate];
  if (coordinate == 2 && hard_case.volume.depth_clamp) {
    return {0, 0, "Clip space: z and w (depth clamp)"};
  }
  if (coordinate == 2 && hard_case.volume.depth != DepthRange::minus_one_to_one) {
    return {0, 1, "Clip space: inside is 0 ≤ z ≤ w"};
  }
  return {-1, 1, fmt::format("Clip space: inside is −w ≤ {} ≤ w", name)};
}

Panel clip_panel(const CaseSketch& s, const Rect& frame, int coordinate) {
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

// A point of the half-plane.
ExactPosition half_plane_point(int coordinate, double c, double w) {
  ExactPosition p = position_at(0, 0, 0, w);
  p[static_cast<std::size_t>(coordinate)] = Rational(c);
  return p;
}

void draw_clip_lines(CaseSketch& s, Panel& panel, const ClipLines& lines, int coordinate) {
  const double far = 4 * panel.extent();
  const auto point = [&](double c, double w) { return half_plane_point(coordinate, c, w); };
  for (const double slope : {lines.low, lines.high}) {
    if (lines.low < lines.high) {
      panel.stroke({point(-slope * far, -far), point(slope * far, far)}, kPlanePen);
    }
  }
  panel.stroke({point(-far, 0), point(far, 0)}, {kBlack, 1, 2});
  if (panel.holds(position_at(0, 0, 0, 0))) {
    s.page.text({panel.frame().x + 5, panel.frame().bottom() - 6}, "w < 0",
                {.size = 11, .colour = kGrey, .halo = true});
  }
}

}  // namespace

// The exact result: an area, or what is left of it on a line or in a point.
void draw_exact_result(Panel& panel, VectorPage& page, const ExactShape& shape) {
  if (shape.size() == 1 && panel.holds(shape.front())) {
    page.circle(panel.spot(shape.front()), 7, kExactFill, kExactPen);
  }
  if (panel.is_thin(shape)) {
    panel.stroke(shape, kExactThinPen);
  } else {
    panel.fill(shape, kExactFill);
    panel.stroke(shape, kExactPen);
  }
}

void draw_eye(VectorPage& page, Spot at) {
  page.circle(at, 5, {0xffffff}, {kGrey, 1});
  page.circle(at, 1.5, kGrey, {kGrey, 1});
}

void draw_view_space(CaseSketch& s, Spot corner) {
  const auto [x, y] = corner;
  draw_view_panel(s, {{x, y, kSmallPanel, kSmallPanel},
                      {.coordinate = 0, .name = "x"},
                      {.coordinate = 2, .name = "z", .reversed = true},
                      frustum_from_above,
                      "View space from above"});
  draw_view_panel(s, {{x, y + kSmallPanel + kUnderPanel, kSmallPanel, kSmallPanel},
                      {.coordinate = 2, .name = "z", .reversed = true},
                      {.coordinate = 1, .name = "y"},
                      frustum_from_the_side,
                      "View space from the side"});
}

void draw_clip_space(CaseSketch& s, Spot corner, int coordinate) {
  Panel panel = clip_panel(s, {corner.x, corner.y, kSmallPanel, kSmallPanel}, coordinate);
  const ClipLines lines = clip_lines(s.picture.hard_case, coordinate);
  const double far = 4 * panel.extent();
  const auto point = [&](double c, double w) { return half_plane_point(coordinate, c, w); };
  if (lines.low < lines.high) {
    panel.fill({point(0, 0), point(lines.low * far, far), point(lines.high * far, far)},
               kVolumeFill);
  } else {
    panel.fill({point(-far, 0), point(far, 0), point(far, far), point(-far, far)}, kVolumeFill);
  }
  panel.hatch({point(-far, 0), point(far, 0), point(far, -far), point(-far, -far)}, kHatch);
  draw_exact_result(panel, s.page, s.geometry.visible_clip);
  draw_clip_lines(s, panel, lines, coordinate);
  note_outside(s, panel.frame(), draw_input(s, panel, s.geometry.input_clip));
  panel.draw_axes(lines.title);
}

}  // namespace clipscope::experiments
