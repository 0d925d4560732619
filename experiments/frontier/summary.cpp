// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "experiments/contestants/spoken.hpp"

namespace clipscope::experiments::frontier {
namespace {

struct PlottedPoint {
  std::string name;
  double ns, error;
  bool on_frontier, is_guest;
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

std::vector<PlottedPoint> plotted_points(const std::vector<Row>& rows, const PlottedFrontier& of) {
  std::vector<PlottedPoint> points;
  for (const Row& row : rows_where(rows, &Row::set, of.set, &Row::contract, of.contract)) {
    const std::optional<double> error = row.error(of.measure);
    if (!row.timing || !error || !row.is_main()) continue;
    const bool on_frontier = row.place(of.measure).standing == Standing::frontier;
    const bool named = of.contract != Contract::full || on_frontier || is_guest(row.clipper) ||
                       is_named_though_dominated(row.clipper, row.scalar);
    points.push_back({named ? short_name(row.clipper) + " " + row.scalar : "",
                      row.timing->ns.median, *error, on_frontier, is_guest(row.clipper)});
  }
  std::ranges::stable_sort(points, {},
                           [](const PlottedPoint& p) { return std::pair(p.ns, p.error); });
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
  series.add(point.ns, error);
  series.labels.push_back(labelled ? point.name : "");
}

// From the fastest to the slowest along the bottom, if anybody has no error. Points are sorted by
// time.
Series exact_line(const std::vector<PlottedPoint>& points, double floor) {
  Series line{.name = "", .marks = Marks::line, .muted = true};
  if (std::ranges::find(points, 0, &PlottedPoint::error) == points.end()) return line;
  line.x = {points.front().ns, points.back().ns};
  line.y = {floor, floor};
  line.labels = {"0: exact", ""};
  return line;
}

// The label of the axis of errors.
constexpr std::array kErrorLabels = {"largest error [px]", "coordinates not correctly rounded [%]",
                                     "triangles with wrong vertices [%]"};

std::string file_name(const PlottedFrontier& of) {
  std::string name = "frontier_" + of.set;
  if (of.contract != Contract::full) name += "_" + std::string(name_of(of.contract));
  name += "_" + std::string(name_of(of.measure));
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '_'; }, '_');
  return name;
}

}  // namespace

Plot frontier_plot(const std::vector<Row>& rows, const PlottedFrontier& of) {
  const std::vector<PlottedPoint> points = plotted_points(rows, of);
  const double floor = floor_beneath(points);
  Series line{.name = "not dominated"};
  Series ties{.name = "as accurate, and not measurably slower", .marks = Marks::points};
  Series guests{.name = "brought by you", .marks = Marks::points};
  Series dominated{.name = "dominated", .marks = Marks::points, .muted = true};
  double least = std::numeric_limits<double>::infinity();
  for (const PlottedPoint& p : points) {
    const double error = p.error > 0 ? p.error : floor;
    if (p.is_guest) add_point(guests, p, error, true);  // over the point that it is anyway
    if (!p.on_frontier) {
      add_point(dominated, p, error, !p.is_guest);
    } else if (p.error < least) {
      add_point(line, p, error, !p.is_guest);
      least = p.error;
    } else {
      add_point(ties, p, error, false);
    }
  }
  const Series exact = exact_line(points, floor);
  const std::string stage =
      of.contract == Contract::full
          ? ""
          : fmt::format(", the stage by {} from memory", name_of(of.contract));
  Plot plot{
      .name = file_name(of),
      .title = fmt::format("What accuracy costs in time: {}{}", of.set, stage),
      .caption =
          "Each point is a clipper in a scalar; the line joins those that no other beats in both. An error of 0 is drawn on the bottom line, \"exact\".",
      .x = {.label = "time [ns per triangle]", .logarithmic = true},
      .y = {.label = kErrorLabels[static_cast<std::size_t>(of.measure)], .logarithmic = true},
      .series = {dominated, line}};
  if (!exact.x.empty()) plot.series.insert(plot.series.begin(), exact);
  for (const Series& series : {ties, guests}) {
    if (!series.x.empty()) plot.series.push_back(series);
  }
  return plot;
}

}  // namespace clipscope::experiments::frontier
