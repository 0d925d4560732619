// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plots, drawn by gnuplot as SVG, PDF and PNG: lines, points with intervals, and bars by category.
//
// Colours are those of Okabe and Ito, "Color Universal Design", 2008, which colour-blind people
// tell apart; marks and dashes differ as well, so that a plot can be read in grey.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/table/row.hpp"

namespace clipscope::experiments {

enum class Marks { line, points, line_and_points, steps };

// One curve, cloud or set of bars. Points that are not finite, or not positive on a logarithmic
// axis, are left out.
struct Series {
  std::string name;  // in the key; empty: not in the key
  std::vector<double> x = {}, y = {};
  std::vector<double> low = {}, high = {};  // interval of y; empty, or one per point
  std::vector<std::string> labels = {};     // text beside the points; empty, or one per point
  Marks marks = Marks::line_and_points;
  bool muted = false;  // grey: there to compare with

  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
  void add(double at, const MedianInterval& value) {
    x.push_back(at);
    add_bar(value);
  }
  // One more category of a set of bars; without a figure there is no bar.
  void add_bar(std::optional<double> value) { y.push_back(value.value_or(kNoBar)); }
  void add_bar(const std::optional<MedianInterval>& value) {
    y.push_back(value ? value->median : kNoBar);
    low.push_back(value ? value->low : kNoBar);
    high.push_back(value ? value->high : kNoBar);
  }

  static constexpr double kNoBar = std::numeric_limits<double>::quiet_NaN();
};

struct Axis {
  std::string label;  // with its unit
  bool logarithmic = false;
  std::optional<double> from = {}, to = {};  // default: what the points ask for
  std::string lowest = {};  // the name of the lowest labelled tic, in place of its number
};

struct Plot {
  std::string name;     // stem of the files
  std::string title;    // one line
  std::string caption;  // what is to be seen, one or two sentences
  Axis x, y;
  std::vector<Series> series = {};
  // Names along x. If there are any, each series is a set of bars and has one y per category; its x
  // is not read.
  std::vector<std::string> categories = {};
};

// Adds a set of bars: over each category the figure, a number or an interval, of the first row that
// has it and the values (see find_row); none where there is no such row.
template <class Row, class Figure, class Category, class... Conditions>
Series& add_bars(Plot& plot, std::string_view name, const std::vector<Row>& rows,
                 const Figure& figure, Category category, const Conditions&... conditions) {
  using Value = std::remove_cvref_t<std::invoke_result_t<const Figure&, const Row&>>;
  Series& series = plot.series.emplace_back(Series{.name = std::string(name)});
  for (const std::string& c : plot.categories) {
    const Row* row = find_row(rows, category, c, conditions...);
    std::optional<typename OptionalOf<Value>::type> bar;
    if (row != nullptr) bar = std::invoke(figure, *row);
    series.add_bar(bar);
  }
  return series;
}

// Writes name.svg, name.pdf and name.png into the directory, each complete or not at all. Throws
// OutputError where gnuplot is missing, fails, or the files can't be written.
void write_plot(const Plot& plot, const std::filesystem::path& directory);

}  // namespace clipscope::experiments
