// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which part of the plane a panel shows.
#include <algorithm>
#include <cmath>

#include "experiments/hard_cases/panel.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kFarthest = 1e150;  // coordinates beyond are left out of account
constexpr double kMargin = 0.12;     // of the window's size, on each side

struct Interval {
  double low = HUGE_VAL, high = -HUGE_VAL;

  double size() const { return std::max(high - low, 0.0); }
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

struct Window {
  Interval h, v;

  double size() const { return std::max(h.size(), v.size()); }
  void add(const std::array<double, 2>& p) {
    h.add(p[0]);
    v.add(p[1]);
  }
};

std::vector<std::array<double, 2>> planar(const ExactShape& shape, const PanelAxis& h,
                                          const PanelAxis& v) {
  std::vector<std::array<double, 2>> r;
  for (const ExactPosition& p : shape) {
    const double x = CGAL::to_double(p[static_cast<std::size_t>(h.coordinate)]);
    const double y = CGAL::to_double(p[static_cast<std::size_t>(v.coordinate)]);
    if (std::abs(x) < kFarthest && std::abs(y) < kFarthest) r.push_back({x, y});
  }
  return r;
}

std::vector<std::array<double, 2>> sorted(std::vector<std::array<double, 2>> points) {
  std::ranges::sort(points, {},
                    [](const auto& p) { return std::max(std::abs(p[0]), std::abs(p[1])); });
  return points;
}

void extend(Window& window, const std::vector<std::array<double, 2>>& points, double largest) {
  for (const auto& p : points) {
    Window larger = window;
    larger.add(p);
    if (larger.size() <= largest) window = larger;
  }
}

// The window of `must`, or if that is a single point, with the nearest vertex that isn't there too.
Window smallest_window(const std::vector<std::array<double, 2>>& must,
                       const std::vector<std::array<double, 2>>& may) {
  Window window;
  for (const auto& p : must) window.add(p);
  for (const auto& p : may) {
    if (window.size() > 0) break;
    window.add(p);
  }
  if (!(window.size() > 0)) {
    const double x = window.h.low <= window.h.high ? window.h.low : 0;
    const double y = window.v.low <= window.v.high ? window.v.low : 0;
    const double radius = std::max({1e-300, std::abs(x) / 4, std::abs(y) / 4, x == 0 ? 1.0 : 0.0});
    window.add({x - radius, y - radius});
    window.add({x + radius, y + radius});
  }
  return window;
}

void set_axis(PanelAxis& axis, const Interval& interval, double size) {
  const double middle = interval.low / 2 + interval.high / 2;
  // No smaller than what doubles tell apart.
  const double half = std::max(size * (0.5 + kMargin), std::abs(middle) * 1e-12);
  axis.low = middle - half;
  axis.high = middle + half;
}

}  // namespace

void fit_window(const WindowRequest& request, PanelAxis& horizontal, PanelAxis& vertical) {
  const auto must = planar(request.must, horizontal, vertical);
  const auto may = sorted(planar(request.may, horizontal, vertical));
  const Window smallest = smallest_window(must, may);
  Window window = smallest;
  Window with_rather = smallest;
  for (const auto& p : planar(request.rather, horizontal, vertical)) with_rather.add(p);
  if (with_rather.size() <= 4 * smallest.size()) window = with_rather;
  extend(window, may, 12 * smallest.size());
  double h = window.h.size(), v = window.v.size();
  const bool one_scale = !request.free_aspect || std::min(h, v) > std::max(h, v) / 20;
  if (one_scale || h == 0 || v == 0) h = v = window.size();
  set_axis(horizontal, window.h, h);
  set_axis(vertical, window.v, v);
}

}  // namespace clipscope::experiments
