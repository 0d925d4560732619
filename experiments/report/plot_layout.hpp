// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where everything in a plot goes: settled here, so that gnuplot only draws and all file formats
// agree.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/report/plot.hpp"

namespace clipscope::experiments {

// Ranges and tics of a plot's axis, and where along it a value lies.
struct Tic {
  double at = 0;
  std::string label;  // UTF-8; empty: a minor tic
};

struct Scale {
  bool logarithmic = false;
  double low = 0, high = 1;  // low < high; both > 0 if logarithmic
  std::vector<Tic> tics;     // ascending, all in [low, high]

  // Whether a value has a place on the axis: finite, and positive if logarithmic. It may lie
  // outside [low, high].
  bool can_show(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
  // 0 at low, 1 at high. Pre-condition: can_show(value).
  double fraction(double value) const {
    if (!logarithmic) return (value - low) / (high - low);
    return std::log(value / low) / std::log(high / low);
  }
};

struct ScaleOptions {
  bool bars = false;          // from 0, or from a whole power of ten beneath the shortest bar
  std::size_t most_tics = 8;  // labelled ones; at least 3
};

// A scale that holds all values that can be shown, with some room about them, within the axis's own
// limits where it has any. Without a value that can be shown: [0, 1], or [1, 10] if logarithmic.
Scale make_scale(const Axis& axis, std::span<const double> values, const ScaleOptions& options);

// Places for texts beside the points of a plot, such that they cover neither each other nor points.
//
// Greedy, in the order given: each text takes the cheapest of some forty places about its point.
// Not optimal: a text for which every place is covered for more than a quarter by other texts gets
// none.

// All lengths in px, x to the right, y downward.
struct LabelBox {
  double left = 0, top = 0, right = 0, bottom = 0;
};

struct PointLabel {
  double x = 0, y = 0;  // the point
  double width = 0, height = 0;
  bool upward = false;  // above the point only: for bars
};

struct LabelPlace {
  LabelBox box;
  bool distant = false;  // wants a line to its point
};

// One place per label, or none; all within `area`. obstacles: what should not be covered (marks,
// curves).
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<PointLabel>& labels,
                                                    const std::vector<LabelBox>& obstacles,
                                                    const LabelBox& area);

// About how wide a text is in a sans-serif face [px], size: of the font [px].
double text_width(const std::string& text, double size);

inline constexpr double kFontSize = 14;       // px
inline constexpr double kTitleSize = 16;      // px
inline constexpr double kLabelSize = 12;      // px, texts beside points
inline constexpr double kLineHeight = 20;     // px
inline constexpr double kKeyBlank = 8;        // px, between a name in the key and its sample
inline constexpr double kGroupWidth = 0.8;    // of a category's room, all its bars
inline constexpr double kCategoryAngle = 35;  // degrees, of names that are too long to lie flat

// A point that can be shown. For bars x is the middle of the bar, categories being 0, 1, 2, ….
struct DrawnPoint {
  double x = 0, y = 0;
  double low = 0, high = 0;  // the interval, or both y
  bool has_interval = false;
  bool begins = false;  // the points before it that can't be shown leave a gap in the line
  std::string label;
};

// A text with the left end of its middle line at (x, y) [px].
struct PlacedText {
  std::string text;
  double x = 0, y = 0;
};

struct PlacedLabel {
  PlacedText text;
  bool distant = false;             // a line to its point is wanted
  double point_x = 0, point_y = 0;  // px
  double line_x = 0, line_y = 0;    // px, the text's end of that line
};

struct KeyEntry {
  std::size_t series = 0;
  PlacedText text;
  double sample = 0;  // px, the width of the piece of line, the mark or the bar left of it
};

// Lengths in px, y downward.
struct PlotLayout {
  double width = 0, height = 0;
  LabelBox area;         // within the axes
  double y_label_x = 0;  // the middle of the name of the y axis
  Scale x, y;
  double bar_width = 0;                         // in categories
  std::vector<std::vector<DrawnPoint>> points;  // per series
  std::vector<PlacedText> title;                // its lines
  std::vector<KeyEntry> key;
  std::vector<PlacedLabel> labels;
  bool slanted = false;  // category names

  double x_px(double value) const {
    return area.left + (area.right - area.left) * x.fraction(value);
  }
  double y_px(double value) const {
    return area.bottom - (area.bottom - area.top) * y.fraction(value);
  }
  // No point can be shown.
  bool empty() const { return std::ranges::all_of(points, &std::vector<DrawnPoint>::empty); }
};

// Pre-condition: every series has as many x as y (bars: as many y as there are categories), and
// either none or as many interval ends and labels; else std::invalid_argument names the series.
PlotLayout lay_out(const Plot& plot);

// Commands that write plot.svg, plot.pdf and plot.png into the folder that gnuplot runs in. Names
// and titles are quoted such that gnuplot takes nothing in them as a command or as markup; control
// characters become blanks.
std::string plot_script(const Plot& plot);

// A text as a string of gnuplot's, quotes included: all but letters, digits and little else as
// octal escapes.
std::string gnuplot_string(const std::string& text);

}  // namespace clipscope::experiments
