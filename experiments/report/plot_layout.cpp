// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/plot_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kCanvasWidth = 800;
constexpr double kAreaHeight = 380;
constexpr double kEdge = 14;       // free at the canvas's border
constexpr double kTicRoom = 12;    // an outward tic and a blank
constexpr double kKeyGap = 22;     // between entries
constexpr double kThinning = 0.3;  // px; a point nearer to the last drawn one says nothing new
constexpr std::size_t kFewPoints = 400;

void check(const Plot& plot) {
  for (const Series& s : plot.series) {
    const std::size_t points = s.y.size();
    const auto fits = [&](std::size_t size) { return size == 0 || size == points; };
    const bool complete =
        plot.categories.empty() ? s.x.size() == points : plot.categories.size() == points;
    if (!complete || !fits(s.low.size()) || s.low.size() != s.high.size() ||
        !fits(s.labels.size())) {
      throw std::invalid_argument(
          fmt::format("plot {}: the columns of series '{}' differ in length", plot.name, s.name));
    }
  }
}

double bar_middle(const Plot& plot, std::size_t series, std::size_t category) {
  const auto count = static_cast<double>(plot.series.size());
  const double step = kGroupWidth / count;
  return static_cast<double>(category) + step * (static_cast<double>(series) - (count - 1) / 2);
}

std::vector<DrawnPoint> drawn_points(const Plot& plot, std::size_t index) {
  const Series& series = plot.series[index];
  const Scale x{.logarithmic = plot.x.logarithmic, .tics = {}};
  const Scale y{.logarithmic = plot.y.logarithmic, .tics = {}};
  std::vector<DrawnPoint> points;
  bool gap = true;
  for (std::size_t i = 0; i < series.y.size(); ++i) {
    const bool bar = !plot.categories.empty();
    DrawnPoint point{
        .x = bar ? bar_middle(plot, index, i) : series.x[i], .y = series.y[i], .label = {}};
    if ((!bar && !x.can_show(point.x)) || !y.can_show(point.y)) {
      gap = true;
      continue;
    }
    point.low = point.high = point.y;
    if (!series.low.empty() && std::isfinite(series.low[i]) && std::isfinite(series.high[i])) {
      point.low = series.low[i];
      point.high = series.high[i];
      point.has_interval = true;
    }
    if (!series.labels.empty()) point.label = series.labels[i];
    point.begins = gap;
    gap = false;
    points.push_back(std::move(point));
  }
  return points;
}

// Scales that hold all that is drawn.
void set_scales(const Plot& plot, PlotLayout& layout) {
  std::vector<double> x, y;
  for (const auto& points : layout.points) {
    for (const DrawnPoint& p : points) {
      x.push_back(p.x);
      y.insert(y.end(), {p.y, p.low, p.high});
    }
  }
  const bool bars = !plot.categories.empty();
  layout.y = make_scale(plot.y, y, {.bars = bars, .most_tics = 7});
  // Intervals that reach to 0 or less end where a logarithmic axis ends.
  for (auto& points : layout.points) {
    for (DrawnPoint& p : points) {
      if (!layout.y.can_show(p.low)) p.low = layout.y.low;
      if (!layout.y.can_show(p.high)) p.high = layout.y.low;
    }
  }
  if (bars) {
    layout.x.low = -0.6;
    layout.x.high = static_cast<double>(plot.categories.size()) - 0.4;
    layout.bar_width = kGroupWidth / static_cast<double>(plot.series.size());
  } else {
    layout.x = make_scale(plot.x, x, {.bars = false, .most_tics = 8});
  }
}

// Lines of words, none wider than the canvas allows; bold letters are a tenth wider.
void place_title(const std::string& title, PlotLayout& layout, double& top) {
  const double most = (kCanvasWidth - 2 * kEdge) / (1.1 * text_width("x", kTitleSize));
  for (const std::string& line : wrapped(title, static_cast<std::size_t>(most))) {
    if (line.find_first_not_of(" \n\t") == std::string::npos) continue;
    layout.title.push_back({line, kEdge, top + kLineHeight / 2});
    top += kLineHeight;
  }
}

double key_sample(const Plot& plot, const Series& series) {
  if (!plot.categories.empty()) return 18;
  return series.marks == Marks::points ? 12 : 32;
}

// The key: names in rows above the axes, as many in each as fit.
void place_key(const Plot& plot, PlotLayout& layout, double& top) {
  double x = kEdge;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const std::string& name = plot.series[i].name;
    if (name.empty()) continue;
    const double sample = key_sample(plot, plot.series[i]);
    const double width = sample + kKeyBlank + text_width(name, kFontSize);
    if (x > kEdge && x + width > kCanvasWidth - kEdge) {
      x = kEdge;
      top += kLineHeight;
    }
    layout.key.push_back({i, {name, x + sample + kKeyBlank, top + kLineHeight / 2}, sample});
    x += width + kKeyGap;
  }
  if (!layout.key.empty()) top += kLineHeight;
}

// Names along x: whether they must be slanted, the height that they take, and how far they push the
// area's left side, since slanted ones reach to the left.
double place_categories(const Plot& plot, PlotLayout& layout) {
  const auto count = static_cast<double>(plot.categories.size());
  const double room = (layout.area.right - layout.area.left) / (count + 0.2);
  double widest = 0;
  for (const std::string& name : plot.categories) {
    widest = std::max(widest, text_width(name, kFontSize));
  }
  layout.slanted = widest > room - 6;
  if (!layout.slanted) return kLineHeight;
  const double angle = kCategoryAngle * std::numbers::pi / 180;
  double left = layout.area.left;
  for (std::size_t i = 0; i < plot.categories.size(); ++i) {
    const double reach = text_width(plot.categories[i], kFontSize) * std::cos(angle);
    left = std::max(left, kEdge / 2 + reach - room * (static_cast<double>(i) + 0.6));
  }
  layout.area.left = std::min(left, kCanvasWidth / 2);
  return widest * std::sin(angle) + kLineHeight;
}

// The area's sides, its lower edge and the canvas's height: by what the axes' names and tics need.
void place_area(const Plot& plot, double top, PlotLayout& layout) {
  double tics = 0;
  for (const Tic& tic : layout.y.tics) tics = std::max(tics, text_width(tic.label, kFontSize));
  const double name = plot.y.label.empty() ? 0 : kLineHeight + 8;
  layout.area.left = kEdge + name + tics + kTicRoom;
  layout.area.right = kCanvasWidth - kEdge - 12;
  layout.area.top = top;
  layout.area.bottom = top + kAreaHeight;
  const double names = plot.categories.empty() ? kLineHeight : place_categories(plot, layout);
  layout.y_label_x = layout.area.left - kTicRoom - tics - name / 2 - 2;
  layout.height = layout.area.bottom + kTicRoom + names +
                  (plot.x.label.empty() ? 0 : kLineHeight + 4) + kEdge / 2;
}

// Curves as many small boxes, marks as one each.
std::vector<LabelBox> obstacles(const Plot& plot, const PlotLayout& layout) {
  std::vector<LabelBox> boxes;
  const auto add = [&](double x, double y, double reach) {
    boxes.push_back({x - reach, y - reach, x + reach, y + reach});
  };
  for (std::size_t i = 0; i < layout.points.size(); ++i) {
    const Marks marks = plot.series[i].marks;
    const auto& points = layout.points[i];
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double x = layout.x_px(points[k].x), y = layout.y_px(points[k].y);
      if (marks == Marks::points || marks == Marks::line_and_points) add(x, y, 5);
      if (marks == Marks::points || points[k].begins) continue;
      const double from_x = layout.x_px(points[k - 1].x), from_y = layout.y_px(points[k - 1].y);
      const int pieces =
          std::clamp(static_cast<int>(std::hypot(x - from_x, y - from_y) / 6), 1, 100);
      for (int j = 0; j < pieces; ++j) {
        const double t = (j + 0.5) / pieces;
        const double shown = marks == Marks::steps ? from_y : from_y + t * (y - from_y);
        add(from_x + t * (x - from_x), shown, 2);
      }
    }
  }
  return boxes;
}

void place_point_labels(const Plot& plot, PlotLayout& layout) {
  const bool bars = !plot.categories.empty();
  std::vector<PointLabel> wanted;
  std::vector<std::string> texts;
  for (const auto& points : layout.points) {
    for (const DrawnPoint& p : points) {
      const double x = layout.x_px(p.x), y = layout.y_px(bars ? std::max(p.y, p.high) : p.y);
      const LabelBox& a = layout.area;
      if (p.label.empty() || x < a.left || x > a.right || y < a.top || y > a.bottom) continue;
      wanted.push_back({x, y, text_width(p.label, kLabelSize), kLabelSize + 2, bars});
      texts.push_back(p.label);
    }
  }
  if (wanted.empty()) return;
  const LabelBox area{layout.area.left + 3, layout.area.top - 4, kCanvasWidth - 4,
                      layout.area.bottom - 3};
  const auto places =
      place_labels(wanted, bars ? std::vector<LabelBox>() : obstacles(plot, layout), area);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const LabelBox& box = places[i]->box;
    const double x = wanted[i].x, y = wanted[i].y;
    const PlacedText text{texts[i], box.left, (box.top + box.bottom) / 2};
    layout.labels.push_back({text, places[i]->distant, x, y, std::clamp(x, box.left, box.right),
                             std::clamp(y, box.top, box.bottom)});
  }
}

// Leaves out points of long curves that lie on the last one drawn.
void thin(PlotLayout& layout) {
  for (auto& points : layout.points) {
    if (points.size() < kFewPoints) continue;
    std::vector<DrawnPoint> kept;
    bool gap = false;
    for (DrawnPoint& p : points) {
      gap = gap || p.begins;
      const bool new_place = kept.empty() || gap || !p.label.empty() ||
                             std::abs(layout.x_px(p.x) - layout.x_px(kept.back().x)) > kThinning ||
                             std::abs(layout.y_px(p.y) - layout.y_px(kept.back().y)) > kThinning;
      if (!new_place) continue;
      p.begins = gap;
      gap = false;
      kept.push_back(std::move(p));
    }
    points = std::move(kept);
  }
}

}  // namespace

PlotLayout lay_out(const Plot& plot) {
  check(plot);
  PlotLayout layout;
  layout.width = kCanvasWidth;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    layout.points.push_back(drawn_points(plot, i));
  }
  set_scales(plot, layout);
  double top = kEdge / 2;
  place_title(plot.title, layout, top);
  top += 4;
  place_key(plot, layout, top);
  place_area(plot, top + 10, layout);
  thin(layout);
  place_point_labels(plot, layout);
  return layout;
}

}  // namespace clipscope::experiments
