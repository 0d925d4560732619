// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where everything in a plot goes: settled here, so that gnuplot only draws and all file formats agree.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/report/plot.hpp"
#include "experiments/report/plot_axis.hpp"
#include "experiments/report/plot_labels.hpp"

namespace clipscope::experiments {

inline constexpr double kFontSize = 14;     // px
inline constexpr double kTitleSize = 16;    // px
inline constexpr double kLabelSize = 12;    // px, texts beside points
inline constexpr double kLineHeight = 20;   // px
inline constexpr double kKeyBlank = 8;      // px, between a name in the key and its sample
inline constexpr double kGroupWidth = 0.8;  // of a category's room, all its bars
inline constexpr double kCategoryAngle =
    35;  // degrees, of category names that are too long to lie flat

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
  bool empty() const;  // no point can be shown
};

// Pre-condition: every series has as many x as y (bars: as many y as there are categories), and either
// none or as many interval ends and labels; else std::invalid_argument names the series.
PlotLayout lay_out(const Plot& plot);

}  // namespace clipscope::experiments
