// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/draw/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace clipscope::experiments {
namespace {

using reference::Rational;
using reference::round_to;
using reference::to_rational;

constexpr double kOverhang = 0.1;  // of the window: cut shapes end so far outside the frame
constexpr double kTickText = 11, kLabelText = 12;
constexpr double kSamePlace = 11;    // px
constexpr double kThin = 2;          // px
constexpr double kFarthest = 1e150;  // coordinates beyond are drawn there, and fit no window
constexpr double kMargin = 0.12;     // of the window's size, on each side
constexpr Colour kFrame = {0x444444}, kTick = {0x444444}, kWhite = {0xffffff};

using PlanarPoint = std::array<Rational, 2>;
using PlanarShape = std::vector<PlanarPoint>;

// The part where coordinate c is at least (or at most) the bound: Sutherland and Hodgman.
PlanarShape cut(const PlanarShape& shape, std::size_t c, const Rational& bound, bool at_least) {
  const auto distance = [&](const PlanarPoint& p) {
    return at_least ? Rational(p[c] - bound) : Rational(bound - p[c]);
  };
  PlanarShape r;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const PlanarPoint &a = shape[i], &b = shape[(i + 1) % shape.size()];
    const Rational da = distance(a), db = distance(b);
    if (da >= 0) r.push_back(a);
    if ((da >= 0) == (db >= 0)) continue;
    const Rational t = da / (da - db);
    r.push_back({Rational(a[0] + t * (b[0] - a[0])), Rational(a[1] + t * (b[1] - a[1]))});
  }
  return r;
}

// The position along an axis: 0 at its low end, 1 at its high one.
Rational fraction_along(const PanelAxis& axis, const ExactPosition& p) {
  const Rational low = to_rational(axis.low), high = to_rational(axis.high);
  const Rational t = (p[axis.coordinate] - low) / (high - low);
  return axis.reversed ? Rational(1 - t) : t;
}

double clamped(const Rational& value) {
  return std::clamp(round_to<double>(value), -kFarthest, kFarthest);
}

double distance(Spot a, Spot b) { return std::hypot(b.x - a.x, b.y - a.y); }

// A vector of length 1, upwards if the two spots are hardly apart.
Spot direction(Spot from, Spot to) {
  const double length = distance(from, to);
  return length > 3 ? Spot{(to.x - from.x) / length, (to.y - from.y) / length} : Spot{0, -1};
}

struct PlacedLabel {
  Spot at;
  bool outside;
  std::string text;
};

void add_label(std::vector<PlacedLabel>& labels, const PlacedLabel& label) {
  const auto same = std::ranges::find_if(labels, [&](const PlacedLabel& l) {
    return l.outside == label.outside && distance(l.at, label.at) < kSamePlace;
  });
  if (same == labels.end()) {
    labels.push_back(label);
  } else {
    same->text += "," + label.text;
  }
}

void draw_label(VectorPage& page, const Rect& frame, const PlacedLabel& label, Spot away) {
  const double r = label.outside ? 0 : 13;
  const Lettering style = {
      .size = kLabelText + 1, .bold = true, .anchor = Anchor::middle, .halo = true};
  const double half = page.text_width(label.text, style) / 2 + 2;
  const double shift = label.outside ? 0 : away.x * std::max(half - 6, 0.0);
  const double x = label.at.x + r * away.x + shift, y = label.at.y + r * away.y;
  page.text({std::clamp(x, frame.x + half, frame.right() - half),
             std::clamp(y, frame.y + 9, frame.bottom() - 9) + 4.5},
            label.text, style);
}

// Upwards from the line that the labelled vertices lie on, if they do.
std::optional<Spot> normal_of(const std::vector<PlacedLabel>& labels) {
  if (labels.size() < 2) return std::nullopt;
  const auto farthest = std::ranges::max_element(
      labels, {}, [&](const PlacedLabel& l) { return distance(l.at, labels[0].at); });
  const Spot u = direction(labels[0].at, farthest->at);
  return u.x < 0 || (u.x == 0 && u.y < 0) ? Spot{-u.y, u.x} : Spot{u.y, -u.x};
}

// The distance between ticks: 1, 2 or 5 times a power of ten, giving three to six of them.
double tick_step(double size) {
  const double raw = size / 5;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10 * power;
}

std::vector<double> ticks_of(const PanelAxis& axis) {
  const double step = tick_step(axis.size());
  std::vector<double> ticks;
  if (!(step > 0) || !std::isfinite(step)) return ticks;
  for (double k = std::ceil(axis.low / step); k * step <= axis.high && ticks.size() < 12; ++k) {
    ticks.push_back(k == 0 ? 0 : k * step);
  }
  return ticks;
}

// ---- Which part of the plane a panel shows ------------------------------------------------------

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
  void add(Spot p) {
    h.add(p.x);
    v.add(p.y);
  }
};

// The spots by their distance from the origin, the nearest first.
std::vector<Spot> planar(const ExactShape& shape, const PanelAxis& h, const PanelAxis& v) {
  std::vector<Spot> points;
  for (const ExactPosition& p : shape) {
    const Spot at = {round_to<double>(p[h.coordinate]), round_to<double>(p[v.coordinate])};
    if (std::abs(at.x) < kFarthest && std::abs(at.y) < kFarthest) points.push_back(at);
  }
  std::ranges::sort(points, {}, [](Spot p) { return std::max(std::abs(p.x), std::abs(p.y)); });
  return points;
}

// The window of `must`, or if that is a single point, with the nearest vertex that isn't there too.
Window smallest_window(std::span<const Spot> must, std::span<const Spot> may) {
  Window window;
  for (const Spot p : must) window.add(p);
  for (const Spot p : may) {
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
  const auto may = planar(request.may, horizontal, vertical);
  const Window smallest = smallest_window(must, may);
  Window window = smallest;
  for (const Spot p : planar(request.rather, horizontal, vertical)) window.add(p);
  if (window.size() > 4 * smallest.size()) window = smallest;
  for (const Spot p : may) {
    Window larger = window;
    larger.add(p);
    if (larger.size() <= 12 * smallest.size()) window = larger;
  }
  double h = window.h.size(), v = window.v.size();
  const bool one_scale = !request.free_aspect || std::min(h, v) > std::max(h, v) / 20;
  if (one_scale || h == 0 || v == 0) h = v = window.size();
  set_axis(horizontal, window.h, h);
  set_axis(vertical, window.v, v);
}

std::string short_number(double value, int digits) {
  const double size = std::abs(value);
  if (size >= 1 && size < 1e6) digits = std::max(digits, static_cast<int>(std::log10(size)) + 1);
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);
}

Panel::Panel(VectorPage& page, const Rect& frame, PanelAxis horizontal, PanelAxis vertical)
    : page_(page),
      frame_(frame),
      horizontal_(std::move(horizontal)),
      vertical_(std::move(vertical)) {}

Spot Panel::spot_of(double along, double up) const {
  return {frame_.x + frame_.width * along, frame_.bottom() - frame_.height * up};
}

Spot Panel::spot(const ExactPosition& p) const {
  return spot_of(clamped(fraction_along(horizontal_, p)), clamped(fraction_along(vertical_, p)));
}

bool Panel::holds(const ExactPosition& p) const {
  const Spot s = spot(p);
  return s.x >= frame_.x && s.x <= frame_.right() && s.y >= frame_.y && s.y <= frame_.bottom();
}

std::vector<Spot> Panel::visible_part(const ExactShape& shape) const {
  PlanarShape planar;
  for (const ExactPosition& p : shape) {
    planar.push_back({fraction_along(horizontal_, p), fraction_along(vertical_, p)});
  }
  for (const std::size_t c : {0u, 1u}) {
    planar = cut(planar, c, Rational(-kOverhang), true);
    planar = cut(planar, c, Rational(1 + kOverhang), false);
  }
  std::vector<Spot> spots;
  for (const PlanarPoint& p : planar) {
    spots.push_back(spot_of(round_to<double>(p[0]), round_to<double>(p[1])));
  }
  return spots;
}

bool Panel::is_thin(const ExactShape& shape) const {
  const std::vector<Spot> spots = visible_part(shape);
  double area = 0, length = 0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot &a = spots[i], &b = spots[(i + 1) % spots.size()];
    area += (a.x * b.y - a.y * b.x) / 2;
    length += distance(a, b) / 2;
  }
  return std::abs(area) < kThin * length;
}

void Panel::fill(const ExactShape& shape, Colour colour) {
  page_.clipped(frame_, [&] { page_.fill(visible_part(shape), colour); });
}

void Panel::hatch(const ExactShape& shape, Colour colour) {
  page_.clipped(frame_, [&] { page_.hatch(visible_part(shape), colour); });
}

void Panel::stroke(const ExactShape& shape, const Pen& pen) {
  page_.clipped(frame_, [&] { page_.stroke(visible_part(shape), pen, shape.size() > 2); });
}

void Panel::draw_ticks() {
  Lettering style = {.size = kTickText, .anchor = Anchor::middle, .colour = kTick};
  const auto place = [](const PanelAxis& axis, double tick) {
    const double t = (tick - axis.low) / axis.size();
    return axis.reversed ? 1 - t : t;
  };
  std::vector<double> ticks = ticks_of(horizontal_);
  if (horizontal_.reversed) std::ranges::reverse(ticks);
  double free_from = frame_.x - 20;
  for (const double tick : ticks) {
    const auto [x, y] = spot_of(place(horizontal_, tick), 0);
    page_.stroke(std::array{Spot{x, y}, Spot{x, y + 4}}, {kTick}, false);
    const std::string text = fmt::format("{:.5g}", tick);
    const double half = page_.text_width(text, style) / 2;
    if (x - half < free_from) continue;
    page_.text({x, y + 15}, text, style);
    free_from = x + half + 6;
  }
  style.anchor = Anchor::right;
  for (const double tick : ticks_of(vertical_)) {
    const auto [x, y] = spot_of(0, place(vertical_, tick));
    page_.stroke(std::array{Spot{x - 4, y}, Spot{x, y}}, {kTick}, false);
    page_.text({x - 6, y + 4}, fmt::format("{:.5g}", tick), style);
  }
}

void Panel::draw_axes(const std::string& title) {
  const Rect& f = frame_;
  page_.stroke(f.corners(), {kFrame}, true);
  draw_ticks();
  page_.text({f.centre().x, f.bottom() + 29}, horizontal_.name,
             {.size = kLabelText, .bold = true, .anchor = Anchor::middle});
  page_.text({f.x - 7, f.y - 7}, vertical_.name,
             {.size = kLabelText, .bold = true, .anchor = Anchor::right});
  page_.text({f.x, f.y - 7}, title, {.size = 13, .bold = true});
}

void Panel::say(const std::string& text, Colour colour) {
  const double y = frame_.y + 14 + 15 * lines_said_++;
  page_.text({frame_.centre().x, y}, text,
             {.size = 13, .bold = true, .anchor = Anchor::middle, .colour = colour, .halo = true});
}

Spot Panel::middle_of(const ExactShape& shape) const {
  const std::vector<Spot> spots = visible_part(shape);
  if (spots.empty()) return frame_.centre();
  Spot sum;
  for (const Spot& s : spots) sum = {sum.x + s.x, sum.y + s.y};
  const auto n = static_cast<double>(spots.size());
  return {std::clamp(sum.x / n, frame_.x + 5, frame_.right() - 5),
          std::clamp(sum.y / n, frame_.y + 5, frame_.bottom() - 5)};
}

Spot Panel::point_at(const ExactPosition& p, Spot from, Colour colour) {
  const Spot target = spot(p);
  const double length = distance(from, target);
  const Spot u = {(target.x - from.x) / length, (target.y - from.y) / length};
  // How far it is to the frame in that direction.
  const double reach_x = ((u.x < 0 ? frame_.x : frame_.right()) - from.x) / u.x;
  const double reach_y = ((u.y < 0 ? frame_.y : frame_.bottom()) - from.y) / u.y;
  const double reach = u.x == 0 ? reach_y : u.y == 0 ? reach_x : std::min(reach_x, reach_y);
  const auto along = [&](double distance, double aside) {
    const double r = reach - distance;
    return Spot{from.x + r * u.x - aside * u.y, from.y + r * u.y + aside * u.x};
  };
  page_.stroke(std::array{along(22, 0), along(9, 0)}, {colour, 2}, false);
  page_.fill(std::array{along(2, 0), along(11, 4.5), along(11, -4.5)}, colour);
  return along(14, u.x < 0 ? 13 : -13);
}

std::vector<std::size_t> Panel::mark(std::span<const Marker> markers, Colour colour,
                                     const ExactShape& shape) {
  std::vector<PlacedLabel> labels;
  std::vector<std::size_t> outside;
  const Spot middle = middle_of(shape);
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const Marker& m = markers[i];
    if (holds(m.position)) {
      const Spot s = spot(m.position);
      page_.circle(s, 4, m.solid ? colour : kWhite, {colour, 1.5});
      add_label(labels, {s, false, m.label});
    } else {
      add_label(labels, {point_at(m.position, middle, colour), true, m.label});
      outside.push_back(i);
    }
  }
  const std::optional<Spot> beside = is_thin(shape) ? normal_of(labels) : std::nullopt;
  for (const PlacedLabel& label : labels) {
    draw_label(page_, frame_, label, beside.value_or(direction(middle, label.at)));
  }
  return outside;
}

void Panel::mark_squares(const ExactShape& shape, Colour colour, double radius, bool diamonds) {
  for (const ExactPosition& p : shape) {
    if (!holds(p)) continue;
    const Spot s = spot(p);
    const double r = diamonds ? radius * 1.4 : radius, o = diamonds ? 0 : radius;
    const std::array corners = {Spot{s.x - r, s.y - o}, Spot{s.x + o, s.y - r},
                                Spot{s.x + r, s.y + o}, Spot{s.x - o, s.y + r}};
    if (diamonds) {
      page_.stroke(corners, {colour, 1.5}, true);
    } else {
      page_.fill(corners, colour);
    }
  }
}

}  // namespace clipscope::experiments
