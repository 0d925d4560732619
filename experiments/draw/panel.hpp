// SPDX-License-Identifier: GPL-3.0-or-later
//
// A panel of a picture: two coordinates of exact shapes in a window, with axes, and arrows towards
// the vertices that lie outside of it.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "experiments/draw/vector_page.hpp"
#include "reference/fraction.hpp"

namespace clipscope::experiments {

// (x, y, z, 1) in view space, (x, y, z, w) in clip space, (x, y, z, 1/w) in NDC. Rational, so that
// shapes with vertices at 1e37 and at 1e-40 can be cut to a window of any size without losing an
// edge.
using ExactPosition = std::array<reference::Rational, 4>;
using ExactShape = std::vector<ExactPosition>;

inline ExactPosition position_at(double x, double y, double z = 0, double w = 1) {
  using reference::Rational;
  return {Rational(x), Rational(y), Rational(z), Rational(w)};
}

// One coordinate of a position as one axis of a panel.
struct PanelAxis {
  std::size_t coordinate = 0;
  std::string name = "";
  bool reversed = false;  // grows to the left, or downwards
  double low = -1, high = 1;

  double size() const { return high - low; }
};

// A window that holds all of `must`; `rather` if that makes it at most 4 times as large; and,
// nearest first, those vertices of `may` that make it at most 12 times as large; with a margin.
// Both axes get the same scale for a square panel, unless `free_aspect` is set and one is at most a
// twentieth of the other.
struct WindowRequest {
  ExactShape must = {}, rather = {}, may = {};
  bool free_aspect = false;
};
void fit_window(const WindowRequest& request, PanelAxis& horizontal, PanelAxis& vertical);

class Panel {
 public:
  Panel(VectorPage& page, const Rect& frame, PanelAxis horizontal, PanelAxis vertical);

  const Rect& frame() const { return frame_; }
  const PanelAxis& horizontal() const { return horizontal_; }
  const PanelAxis& vertical() const { return vertical_; }
  // The larger side of the window.
  double extent() const { return std::max(horizontal_.size(), vertical_.size()); }
  bool holds(const ExactPosition& p) const;
  // Whether the part in the window is a line, or hardly wider than one.
  bool is_thin(const ExactShape& shape) const;
  // Where p is on the page; where p is outside of the window only the direction is right.
  Spot spot(const ExactPosition& p) const;

  // Convex polygons, segments and points, cut to the frame.
  void fill(const ExactShape& shape, Colour colour);
  void hatch(const ExactShape& shape, Colour colour);
  void stroke(const ExactShape& shape, const Pen& pen);

  // Frame, ticks and their numbers, names of the axes, the title above. Drawn after what it frames.
  void draw_axes(const std::string& title);

  // A line of text inside; the first one on top.
  void say(const std::string& text, Colour colour);

  struct Marker {
    ExactPosition position;
    std::string label;  // may be empty
    bool solid = false;
  };
  // A marker per vertex; labels of vertices at the same place are joined, and lie off the shape.
  // For vertices outside of the window an arrow at the frame. Returns the indices of these.
  std::vector<std::size_t> mark(std::span<const Marker> markers, Colour colour,
                                const ExactShape& shape);
  // Small squares, turned by 45 degrees if `diamonds`; nothing for vertices outside.
  void mark_squares(const ExactShape& shape, Colour colour, double radius, bool diamonds);
  // The middle of what is in the window, always inside of the frame: where arrows start, so that
  // they lie on the edges that leave the panel.
  Spot middle_of(const ExactShape& shape) const;
  // An arrow at the frame that leads from a spot of the panel towards p, which lies outside.
  // Returns a place beside it for a label.
  Spot point_at(const ExactPosition& p, Spot from, Colour colour);

 private:
  Spot spot_of(double along, double up) const;  // fractions of the frame
  std::vector<Spot> visible_part(const ExactShape& shape) const;
  void draw_ticks();

  VectorPage& page_;
  Rect frame_;
  PanelAxis horizontal_, vertical_;
  int lines_said_ = 0;
};

// "1e+37", "-0.25": at most so many significant digits, but all before the point up to a million.
std::string short_number(double value, int digits = 4);

}  // namespace clipscope::experiments
