// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace clipscope::experiments {
namespace {

using reference::Rational;
using reference::to_rational;

constexpr double kOverhang = 0.1;  // of the window: cut shapes end so far outside the frame
constexpr double kTickText = 11, kLabelText = 12;
constexpr double kSamePlace = 11;  // px
constexpr double kThin = 2;        // px
constexpr double kFarthest = 1e150;
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
  const Rational t = (p[static_cast<std::size_t>(axis.coordinate)] - low) / (high - low);
  return axis.reversed ? Rational(1 - t) : t;
}

double clamped(const Rational& value) {
  return std::clamp(CGAL::to_double(value), -kFarthest, kFarthest);
}

// A vector of length 1, upwards if the two spots are the same.
Spot direction(Spot from, Spot to) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  return length > 3 ? Spot{dx / length, dy / length} : Spot{0, -1};
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

std::string tick_text(double tick) { return fmt::format("{:.5g}", tick); }

std::vector<double> ticks_of(const PanelAxis& axis) {
  const double step = tick_step(axis.size());
  std::vector<double> ticks;
  if (!(step > 0) || !std::isfinite(step)) return ticks;
  for (double k = std::ceil(axis.low / step); k * step <= axis.high && ticks.size() < 12; ++k) {
    ticks.push_back(k == 0 ? 0 : k * step);
  }
  return ticks;
}

}  // namespace

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

Spot Panel::spot(const ExactPosition& p) const {
  return {frame_.x + frame_.width * clamped(fraction_along(horizontal_, p)),
          frame_.bottom() - frame_.height * clamped(fraction_along(vertical_, p))};
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
    spots.push_back({frame_.x + frame_.width * CGAL::to_double(p[0]),
                     frame_.bottom() - frame_.height * CGAL::to_double(p[1])});
  }
  return spots;
}

bool Panel::is_thin(const ExactShape& shape) const {
  const std::vector<Spot> spots = visible_part(shape);
  double area = 0, length = 0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot &a = spots[i], &b = spots[(i + 1) % spots.size()];
    area += (a.x * b.y - a.y * b.x) / 2;
    length += std::hypot(b.x - a.x, b.y - a.y) / 2;
  }
  return std::abs(area) < kThin * length;
}

void Panel::fill(const ExactShape& shape, Colour colour) {
  page_.clip(frame_);
  page_.fill(visible_part(shape), colour);
  page_.unclip();
}

void Panel::hatch(const ExactShape& shape, Colour colour) {
  page_.clip(frame_);
  page_.hatch(visible_part(shape), colour);
  page_.unclip();
}

void Panel::stroke(const ExactShape& shape, const Pen& pen) {
  page_.clip(frame_);
  page_.stroke(visible_part(shape), pen, shape.size() > 2);
  page_.unclip();
}

void Panel::draw_ticks() {
  const Lettering style = {.size = kTickText, .anchor = Anchor::middle, .colour = kTick};
  const auto place = [](const PanelAxis& axis, double tick) {
    const double t = (tick - axis.low) / axis.size();
    return axis.reversed ? 1 - t : t;
  };
  std::vector<double> ticks = ticks_of(horizontal_);
  if (horizontal_.reversed) std::ranges::reverse(ticks);
  double free_from = frame_.x - 20;
  for (const double tick : ticks) {
    const double x = frame_.x + frame_.width * place(horizontal_, tick);
    page_.stroke(std::array{Spot{x, frame_.bottom()}, Spot{x, frame_.bottom() + 4}}, {kTick},
                 false);
    const std::string text = tick_text(tick);
    const double half = page_.text_width(text, style) / 2;
    if (x - half < free_from) continue;
    page_.text({x, frame_.bottom() + 15}, text, style);
    free_from = x + half + 6;
  }
  for (const double tick : ticks_of(vertical_)) {
    const double y = frame_.bottom() - frame_.height * place(vertical_, tick);
    page_.stroke(std::array{Spot{frame_.x - 4, y}, Spot{frame_.x, y}}, {kTick}, false);
    page_.text({frame_.x - 6, y + 4}, tick_text(tick),
               {.size = kTickText, .anchor = Anchor::right, .colour = kTick});
  }
}

void Panel::draw_axes(const std::string& title) {
  const Rect& f = frame_;
  page_.stroke(std::array{Spot{f.x, f.y}, Spot{f.right(), f.y}, Spot{f.right(), f.bottom()},
                          Spot{f.x, f.bottom()}},
               {kFrame}, true);
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

// Upwards from the line that the labelled vertices lie on, if they do.
std::optional<Spot> Panel::normal_of(const std::vector<PlacedLabel>& labels) {
  if (labels.size() < 2) return std::nullopt;
  const auto farthest = std::ranges::max_element(labels, {}, [&](const PlacedLabel& l) {
    return std::hypot(l.at.x - labels[0].at.x, l.at.y - labels[0].at.y);
  });
  const Spot u = direction(labels[0].at, farthest->at);
  return u.x < 0 || (u.x == 0 && u.y < 0) ? Spot{-u.y, u.x} : Spot{u.y, -u.x};
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
  const double dx = target.x - from.x, dy = target.y - from.y, length = std::hypot(dx, dy);
  const Spot u = {dx / length, dy / length};
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

void Panel::draw_label(const PlacedLabel& label, Spot away) {
  const double r = label.outside ? 0 : 13;
  const Lettering style = {
      .size = kLabelText + 1, .bold = true, .anchor = Anchor::middle, .halo = true};
  const double half = page_.text_width(label.text, style) / 2 + 2;
  const double shift = label.outside ? 0 : away.x * std::max(half - 6, 0.0);
  const Spot at = {
      std::clamp(label.at.x + r * away.x + shift, frame_.x + half, frame_.right() - half),
      std::clamp(label.at.y + r * away.y, frame_.y + 9, frame_.bottom() - 9)};
  page_.text({at.x, at.y + 4.5}, label.text, style);
}

void Panel::add_label(std::vector<PlacedLabel>& labels, const PlacedLabel& label) {
  const auto same = std::ranges::find_if(labels, [&](const PlacedLabel& l) {
    return l.outside == label.outside &&
           std::hypot(l.at.x - label.at.x, l.at.y - label.at.y) < kSamePlace;
  });
  if (same == labels.end()) {
    labels.push_back(label);
  } else {
    same->text += "," + label.text;
  }
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
    draw_label(label, beside.value_or(direction(middle, label.at)));
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
