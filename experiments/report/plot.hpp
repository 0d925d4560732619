// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plots, drawn by gnuplot as SVG, PDF and PNG: lines, points with intervals, and bars by category.
//
// Colours are those of Okabe and Ito, "Color Universal Design", 2008, which colour-blind people tell
// apart; marks and dashes differ as well, so that a plot can be read in grey.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace clipscope::experiments {

enum class Marks { line, points, line_and_points, steps };

// One curve, cloud or set of bars. Points that are not finite, or not positive on a logarithmic axis,
// are left out.
struct Series {
  std::string name;  // in the key; empty: not in the key
  std::vector<double> x, y;
  std::vector<double> low = {}, high = {};  // interval of y; empty, or one per point
  std::vector<std::string> labels = {};     // text beside the points; empty, or one per point
  Marks marks = Marks::line_and_points;
  bool muted = false;  // grey: there to compare with
};

struct Axis {
  std::string label;  // with its unit
  bool logarithmic = false;
  std::optional<double> from = {}, to = {};  // default: what the points ask for
};

struct Plot {
  std::string name;     // stem of the files
  std::string title;    // one line
  std::string caption;  // what is to be seen, one or two sentences
  Axis x, y;
  std::vector<Series> series;
  // Names along x. If there are any, each series is a set of bars and has one y per category; its x is
  // not read.
  std::vector<std::string> categories = {};
};

// Writes name.svg, name.pdf and name.png into the directory, each complete or not at all. Throws
// OutputError where gnuplot is missing, fails, or the files can't be written.
void write_plot(const Plot& plot, const std::filesystem::path& directory);

}  // namespace clipscope::experiments
