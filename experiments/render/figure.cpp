// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string_view>

#include "experiments/render/canvas.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kSmallestPanel = 480;  // px; narrower buffers are enlarged

const Rgb kInk = from_hex(0x1c1e21);
const Rgb kFaintInk = from_hex(0x5d6168);
const Rgb kPaper = from_hex(0xffffff);

// All lengths in pixels; `em` is the size of the text.
struct Layout {
  int scale, panel_width, panel_height, em;
  int margin, gap, top, legend;  // top and legend: y of the panels and of what is beneath them
  int width, height;

  int right_x() const { return margin + panel_width + gap; }
};

Layout lay_out(const FrameBuffer& buffer, bool has_heat_map) {
  Layout l{};
  l.scale = std::max(1, (kSmallestPanel + buffer.width - 1) / buffer.width);
  l.panel_width = buffer.width * l.scale;
  l.panel_height = buffer.height * l.scale;
  l.em = std::clamp(l.panel_width / 40, 12, 40);
  l.margin = 2 * l.em;
  l.gap = l.em * 3 / 2;
  l.top = l.margin + 4 * l.em;
  l.legend = l.top + l.panel_height + 2 * l.em;
  l.width = 2 * l.margin + l.panel_width * (has_heat_map ? 2 : 1) + (has_heat_map ? l.gap : 0);
  l.height = has_heat_map ? l.legend + 6 * l.em + l.margin / 2 : l.top + l.panel_height + l.margin;
  return l;
}

// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t n) {
  const std::string digits = fmt::format("{}", n);
  std::string s;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) {
      s += ',';
    }
    s += digits[i];
  }
  return s;
}

void draw_titles(Canvas& canvas, const Layout& l, const Figure& figure) {
  const FigureTitles& t = figure.titles;
  const TextStyle heading{l.em * 5 / 4, Weight::bold, Align::left, kInk};
  const TextStyle caption{l.em, Weight::regular, Align::left, kInk};
  const int y = l.top - l.em * 2 / 3;
  canvas.fitted_text(l.margin, l.margin + l.em * 5 / 4, l.width - 2 * l.margin, t.scene, heading);
  canvas.fitted_text(l.margin, y, l.panel_width, fmt::format("{}, {}", t.clipper, t.scalar),
                     caption);
  if (figure.heat_map != nullptr) {
    canvas.fitted_text(l.right_x(), y, l.panel_width, fmt::format("Error against {}", t.against),
                       caption);
  }
}

void draw_panel(Canvas& canvas, const Layout& l, const Image& image, int x) {
  canvas.paste(image, x, l.top, l.scale);
  canvas.outline({x, l.top, l.panel_width, l.panel_height}, from_hex(0x8a8d93));
}

struct LegendEntry {
  PixelFate fate;
  std::string_view name;
};

constexpr std::array<LegendEntry, 6> kLegend = {{{PixelFate::hole, "hole"},
                                                 {PixelFate::extra, "extra"},
                                                 {PixelFate::flipped, "flipped"},
                                                 {PixelFate::not_finite, "not finite"},
                                                 {PixelFate::equal, "equal"},
                                                 {PixelFate::empty, "empty"}}};

// In texels, "equal" is what the colour scale can't show; in ulp it is equality.
std::string_view label(const LegendEntry& entry, PixelMeasure measure) {
  const bool below = entry.fate == PixelFate::equal && measure == PixelMeasure::texels;
  return below ? "below scale" : entry.name;
}

// Colours of categories with their pixel counts: two columns of three rows beneath the picture.
void draw_categories(Canvas& canvas, const Layout& l, const HeatMap& map) {
  const int column_width = l.panel_width / 2;
  const TextStyle name{l.em, Weight::regular, Align::left, kInk};
  const TextStyle count{l.em, Weight::regular, Align::right, kInk};
  for (std::size_t i = 0; i < kLegend.size(); ++i) {
    const int x = l.margin + static_cast<int>(i / 3) * column_width;
    const int y = l.legend + static_cast<int>(i % 3) * l.em * 7 / 4;
    const Area swatch{x + 1, y + 1, l.em * 3 / 2, l.em};
    canvas.fill(swatch, fate_colour(kLegend[i].fate));
    canvas.outline(swatch, from_hex(0x8a8d93));
    canvas.text(x + l.em * 9 / 4, y + l.em * 7 / 8, label(kLegend[i], map.options.measure), name);
    canvas.text(x + column_width - l.em * 3, y + l.em * 7 / 8,
                grouped(map.counts[kLegend[i].fate]) + " px", count);
  }
  if (map.counts.triangles_not_drawn > 0) {
    canvas.fitted_text(l.margin, l.legend + l.em * 6, l.panel_width,
                       fmt::format("triangles not drawn: {} (a vertex is not finite)",
                                   grouped(map.counts.triangles_not_drawn)),
                       {l.em, Weight::regular, Align::left, kFaintInk});
  }
}

// "10" with the exponent raised, centred at x.
void draw_power_of_ten(Canvas& canvas, int x, int y, int em, int exponent) {
  const TextStyle base{em, Weight::regular, Align::left, kInk};
  const TextStyle raised{em * 7 / 10, Weight::regular, Align::left, kInk};
  const std::string power = fmt::format("{}", exponent);
  const int base_width = text_width("10", base) + std::max(1, em / 10);
  const int left = x - (base_width + text_width(power, raised)) / 2;
  canvas.text(left, y, "10", base);
  canvas.text(left + base_width, y - em * 2 / 5, power, raised);
}

// The colour scale beneath the heat map, with a tick at each power of ten.
void draw_scale(Canvas& canvas, const Layout& l, const HeatMap& map) {
  const Area bar{l.right_x(), l.legend + 1, l.panel_width, l.em};
  for (int i = 0; i < bar.width; ++i) {
    canvas.fill({bar.x + i, bar.y, 1, bar.height}, error_colour((i + 0.5) / bar.width));
  }
  canvas.outline(bar, from_hex(0x8a8d93));
  const int first = static_cast<int>(std::ceil(std::log10(map.options.lowest) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(map.options.highest) + 1e-9));
  const int label_y = bar.y + bar.height + l.em * 7 / 4;
  for (int exponent = first; exponent <= last; ++exponent) {
    const double t = scale_position(map.options, std::pow(10.0, exponent));
    const int x =
        bar.x + std::clamp(static_cast<int>(std::lround(t * bar.width)), 0, bar.width - 1);
    canvas.fill({x, bar.y + bar.height, 1, std::max(3, l.em / 3)}, kInk);
    draw_power_of_ten(canvas, std::clamp(x, bar.x + l.em, bar.x + bar.width - l.em), label_y, l.em,
                      exponent);
  }
}

void draw_scale_labels(Canvas& canvas, const Layout& l, const HeatMap& map) {
  const HeatMapCounts& c = map.counts;
  const std::string_view unit = measure_unit(map.options.measure);
  const int x = l.right_x(), y = l.legend + l.em * 9 / 2;
  canvas.fitted_text(x, y, l.panel_width, measure_label(map.options.measure),
                     {l.em, Weight::regular, Align::left, kInk});
  canvas.fitted_text(
      x, y + l.em * 3 / 2, l.panel_width,
      fmt::format("max {:.2g}, median {:.2g}; above 1 {}: {:.2g} % of {} px", c.max_error,
                  c.median_error, unit, 100 * c.share_above_one, grouped(c.compared())),
      {l.em, Weight::regular, Align::left, kFaintInk});
}

}  // namespace

Image compose(const Figure& figure) {
  assert(figure.tested != nullptr);
  const FrameBuffer& buffer = *figure.tested;
  const HeatMap* map = figure.heat_map;
  assert(map == nullptr ||
         (map->image.width == buffer.width && map->image.height == buffer.height));
  const Layout l = lay_out(buffer, map != nullptr);
  Canvas canvas(l.width, l.height, kPaper);
  draw_titles(canvas, l, figure);
  draw_panel(canvas, l, shade(buffer, figure.picture), l.margin);
  if (map != nullptr) {
    draw_panel(canvas, l, map->image, l.right_x());
    draw_categories(canvas, l, *map);
    draw_scale(canvas, l, *map);
    draw_scale_labels(canvas, l, *map);
  }
  return canvas.image();
}

}  // namespace clipscope::experiments
