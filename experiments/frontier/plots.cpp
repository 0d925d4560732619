// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "experiments/frontier/tables.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

struct PlottedPoint {
  std::string name;
  double ns, ns_low, ns_high, error;
  bool on_frontier;
};

// Without the folder, methods by their initials where they are well known.
std::string short_name(std::string clipper) {
  const std::string method = "sutherland_hodgman";
  if (const auto at = clipper.find(method); at != std::string::npos) {
    clipper.replace(at, method.size(), "s_h");
  }
  return clipper;
}

bool is_named_though_dominated(const std::string& clipper, const std::string& scalar) {
  constexpr std::array<std::string_view, 5> kNamed = {
      "textbook", "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first",
      "barycentric/distance_matrix"};
  if (clipper.find("batch") != std::string::npos) return true;
  return scalar == "float" && std::find(kNamed.begin(), kNamed.end(), clipper) != kNamed.end();
}

std::vector<PlottedPoint> plotted_points(const std::string& set, ErrorMeasure measure,
                                         const Table& frontier, const std::string& contract) {
  const FrontierKeys keys = frontier_keys(measure);
  std::vector<PlottedPoint> points;
  for (const RowView& row : rows_of(frontier)) {
    const std::string& standing = row.text(keys.on);
    if (row.text("set") != set || row.text("contract") != contract) continue;
    if (standing == "not timed") continue;
    const std::string &clipper = row.text("clipper"), &scalar = row.text("scalar");
    const bool named =
        contract != "full" || standing == "yes" || is_named_though_dominated(clipper, scalar);
    points.push_back({named ? short_name(clipper) + " " + scalar : "",
                      row.number("ns_per_triangle"), row.number("ns_low"), row.number("ns_high"),
                      row.number(keys.error), standing == "yes"});
  }
  std::stable_sort(points.begin(), points.end(), [](const PlottedPoint& a, const PlottedPoint& b) {
    return a.ns != b.ns ? a.ns < b.ns : a.error < b.error;
  });
  return points;
}

// Two decades beneath the smallest error that is not 0, so that the bottom line stands apart.
double floor_beneath(const std::vector<PlottedPoint>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const PlottedPoint& p : points) {
    if (p.error > 0) least = std::min(least, p.error);
  }
  if (!std::isfinite(least)) return 1;
  return std::pow(10.0, std::floor(std::log10(least)) - 2);
}

void add_point(Series& series, const PlottedPoint& point, double error, bool labelled) {
  series.x.push_back(point.ns);
  series.y.push_back(error);
  series.labels.push_back(labelled ? point.name : "");
}

// From the fastest to the slowest along the bottom, if anybody has no error. Points are sorted by time.
Series exact_line(const std::vector<PlottedPoint>& points, double floor) {
  Series line{.name = "", .x = {}, .y = {}, .marks = Marks::line, .muted = true};
  const bool any =
      std::any_of(points.begin(), points.end(), [](const PlottedPoint& p) { return p.error == 0; });
  if (!any) return line;
  line.x = {points.front().ns, points.back().ns};
  line.y = {floor, floor};
  line.labels = {"0: exact", ""};
  return line;
}

std::string error_label(ErrorMeasure measure) {
  switch (measure) {
    case ErrorMeasure::max_px: return "largest error [px]";
    case ErrorMeasure::misrounded: return "coordinates not correctly rounded [%]";
    default: return "triangles with wrong vertices [%]";
  }
}

std::string file_name(const std::string& set, ErrorMeasure measure, const std::string& contract) {
  const std::string of = contract == "full" ? set : set + "_" + contract;
  std::string name = fmt::format("frontier_{}_{}", of, error_measure_name(measure));
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '_'; }, '_');
  return name;
}

}  // namespace

Plot frontier_plot(const std::string& set, ErrorMeasure measure, const Table& frontier,
                   const std::string& contract) {
  const std::vector<PlottedPoint> points = plotted_points(set, measure, frontier, contract);
  const double floor = floor_beneath(points);
  Series line{.name = "not dominated", .x = {}, .y = {}};
  Series ties{
      .name = "as accurate, and not measurably slower", .x = {}, .y = {}, .marks = Marks::points};
  Series dominated{.name = "dominated", .x = {}, .y = {}, .marks = Marks::points, .muted = true};
  double least = std::numeric_limits<double>::infinity();
  for (const PlottedPoint& p : points) {
    const double error = p.error > 0 ? p.error : floor;
    if (!p.on_frontier) {
      add_point(dominated, p, error, true);
    } else if (p.error < least) {
      add_point(line, p, error, true);
      least = p.error;
    } else {
      add_point(ties, p, error, false);
    }
  }
  const Series exact = exact_line(points, floor);
  Plot plot{.name = file_name(set, measure, contract),
            .title = fmt::format("What accuracy costs in time: {}{}", set,
                                 contract == "full" ? "" : ", the stage by " + contract),
            .caption =
                "Each point is a clipper in a scalar; the line joins those that no other beats "
                "in both. An error of 0 is drawn on the bottom line, \"exact\".",
            .x = {.label = "time [ns per triangle]", .logarithmic = true},
            .y = {.label = error_label(measure), .logarithmic = true},
            .series = {dominated, line}};
  if (!exact.x.empty()) plot.series.insert(plot.series.begin(), exact);
  if (!ties.x.empty()) plot.series.push_back(ties);
  return plot;
}

}  // namespace clipscope::experiments
