// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/measure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/draw/panel.hpp"
#include "experiments/judge/outcome.hpp"
#include "experiments/machine/files.hpp"

namespace clipscope::experiments::watertight {
namespace {

constexpr double kMargin = 24, kTickRoom = 50, kSide = 440, kTop = 96, kGap = 76, kBeneath = 96;
constexpr double kFirst = kMargin + kTickRoom, kSecond = kFirst + kSide + kGap;  // panels
constexpr double kWidth = kSecond + kSide + kMargin, kHeight = kTop + kSide + kBeneath;
constexpr std::array<Colour, 2> kFills = {Colour{0x9fd3f2}, Colour{0xf3c99f}};
constexpr std::array<Colour, 2> kRims = {Colour{0x0072b2}, Colour{0xd55e00}};

// A polygon in px of the screen, seen from a place of NDC: 0, 0 is there, y grows upwards.
ExactShape seen_from(const std::array<double, 2>& place,
                     const std::vector<std::array<double, 2>>& polygon) {
  const ExactPosition origin = position_at(place[0], place[1]);
  ExactShape shape;
  for (const auto& v : polygon) {
    ExactPosition p = position_at(v[0], v[1]);
    p[0] = (p[0] - origin[0]) * reference::Rational(kScreenWidth / 2);
    p[1] = (p[1] - origin[1]) * reference::Rational(kScreenHeight / 2);
    shape.push_back(p);
  }
  return shape;
}

// Both polygons on a white screen; what is around it is grey.
void draw_polygons(Panel& panel, const std::array<double, 2>& place,
                   const std::array<ExactShape, 2>& shapes, double pen_width) {
  const double far = 1e5;  // px, beyond any window
  panel.fill({position_at(-far, -far), position_at(far, -far), position_at(far, far),
              position_at(-far, far)},
             {0xf0f0f0});
  panel.fill(seen_from(place, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}), {0xffffff});
  for (std::size_t s = 0; s < 2; ++s) panel.fill(shapes[s], kFills[s]);
  for (std::size_t s = 0; s < 2; ++s) panel.stroke(shapes[s], {kRims[s], pen_width});
}

void draw_ring(VectorPage& page, Spot centre, double radius) {
  constexpr int kCorners = 60;
  std::vector<Spot> ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  page.stroke(ring, {{}, 2}, true);
}

// Both neighbours on the screen; a ring where they part.
void draw_overview(VectorPage& page, const Crack& crack) {
  const auto& [first, second] = crack.polygons;
  const std::array shapes = {seen_from({0, 0}, first), seen_from({0, 0}, second)};
  PanelAxis x{0, "x [px]"}, y{1, "y [px]"};
  ExactShape all = shapes[0];
  all.insert(all.end(), shapes[1].begin(), shapes[1].end());
  fit_window({.must = all}, x, y);
  Panel panel(page, {kFirst, kTop, kSide, kSide}, x, y);
  draw_polygons(panel, {0, 0}, shapes, 1);
  draw_ring(page, panel.spot(seen_from({0, 0}, {crack.gap.at}).front()), 14);
  panel.draw_axes("On the screen of 3840 x 2160 px");
}

// 1, 2 or 5 times a power of ten, at most `length`.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= length) return factor * power;
  }
  return power;
}

void draw_scale_bar(VectorPage& page, const Panel& panel) {
  const double px = round_length(panel.extent() / 3);
  const double length = px / panel.extent() * panel.frame().width;
  const double right = panel.frame().right() - 16, y = panel.frame().bottom() - 16;
  page.stroke(std::array{Spot{right - length, y}, Spot{right, y}}, {{}, 4}, false);
  page.text({right - length / 2, y - 9}, fmt::format("{} px", short_number(px)),
            {.size = 14, .bold = true, .anchor = Anchor::middle, .halo = true});
}

void draw_magnified(VectorPage& page, const Crack& crack) {
  const double half = 2.5 * crack.gap.crack_px;
  Panel panel(page, {kSecond, kTop, kSide, kSide}, {0, "px", false, -half, half},
              {1, "px", false, -half, half});
  const auto& [first, second] = crack.polygons;
  const std::array shapes = {seen_from(crack.gap.at, first), seen_from(crack.gap.at, second)};
  draw_polygons(panel, crack.gap.at, shapes, 2);
  for (std::size_t s = 0; s < 2; ++s) panel.mark_squares(shapes[s], kRims[s], 5, s == 1);
  draw_scale_bar(page, panel);
  panel.draw_axes(fmt::format("Magnified {} times", short_number(kSide / (2 * half), 3)));
}

}  // namespace

void write_picture(const std::filesystem::path& path, const Crack& crack,
                   const std::string& title) {
  VectorPage page(page_format(path), kWidth, kHeight, title);
  page.text({kMargin, 34}, title, {.size = 18, .bold = true});
  page.text({kMargin, 58},
            fmt::format("Two triangles that share an edge, after clipping: {} px apart.",
                        short_number(crack.gap.crack_px, 3)),
            {.size = 14});
  draw_overview(page, crack);
  draw_magnified(page, crack);
  page.text(
      {kFirst, kTop + kSide + 62},
      "Blue with squares and orange with diamonds: the two polygons and their vertices. White between them is background that shows",
      {.size = 13});
  page.text(
      {kFirst, kTop + kSide + 80},
      "through; grey is beyond the screen. The ring on the left is where the right panel looks.",
      {.size = 13});
  write_file(path, page.finish());
}

}  // namespace clipscope::experiments::watertight
