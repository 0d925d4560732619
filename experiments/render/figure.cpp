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
const Rgb kFrame = from_hex(0x8a8d93);

// All lengths in pixels; `em` is the size of the text.
struct Layout {
  const FrameBuffer& buffer;
  bool has_heat_map;
  int scale = std::max(1, (kSmallestPanel + buffer.width - 1) / buffer.width);
  int panel_width = buffer.width * scale, panel_height = buffer.height * scale;
  int em = std::clamp(panel_width / 40, 12, 40), margin = 2 * em;
  // y of the panels and of what is beneath them, x of the right panel.
  int top = margin + 4 * em, legend = top + panel_height + 2 * em;
  int right_x = margin + panel_width + em * 3 / 2;
  int width = (has_heat_map ? right_x : margin) + panel_width + margin;
  int height = has_heat_map ? legend + 6 * em + margin / 2 : top + panel_height + margin;
};

// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t n) {
  const std::string digits = fmt::format("{}", n);
  std::string s;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) s += ',';
    s += digits[i];
  }
  return s;
}

TextStyle text_of(int size_px, const Rgb& colour = kInk) {
  return {.size_px = size_px, .colour = colour};
}

void draw_titles(Canvas& canvas, const Layout& l, const Figure& figure) {
  const FigureTitles& t = figure.titles;
  const int y = l.top - l.em * 2 / 3;
  canvas.fitted_text(l.margin, l.margin + l.em * 5 / 4, l.width - 2 * l.margin, t.scene,
                     {l.em * 5 / 4, Weight::bold, Align::left, kInk});
  canvas.fitted_text(l.margin, y, l.panel_width, fmt::format("{}, {}", t.clipper, t.scalar),
                     text_of(l.em));
  if (figure.heat_map != nullptr) {
    canvas.fitted_text(l.right_x, y, l.panel_width, fmt::format("Error against {}", t.against),
                       text_of(l.em));
  }
}

void draw_panel(Canvas& canvas, const Layout& l, const Image& image, int x) {
  canvas.paste(image, x, l.top, l.scale);
  canvas.outline({x, l.top, l.panel_width, l.panel_height}, kFrame);
}

struct LegendEntry {
  PixelFate fate;
  std::string_view name;
};
constexpr LegendEntry kLegend[] = {
    {PixelFate::hole, "hole"},         {PixelFate::extra, "extra"},
    {PixelFate::flipped, "flipped"},   {PixelFate::not_finite, "not finite"},
    {PixelFate::equal, "below scale"}, {PixelFate::empty, "empty"}};

// Colours of categories with their pixel counts: two columns of three rows beneath the picture.
void draw_categories(Canvas& canvas, const Layout& l, const HeatMap& map) {
  const int column_width = l.panel_width / 2;
  const TextStyle count{l.em, Weight::regular, Align::right, kInk};
  for (int i = 0; const auto& [fate, name] : kLegend) {
    const int x = l.margin + i / 3 * column_width;
    const int y = l.legend + i++ % 3 * l.em * 7 / 4;
    const Area swatch{x + 1, y + 1, l.em * 3 / 2, l.em};
    canvas.fill(swatch, fate_colour(fate));
    canvas.outline(swatch, kFrame);
    canvas.text(x + l.em * 9 / 4, y + l.em * 7 / 8, name, text_of(l.em));
    canvas.text(x + column_width - l.em * 3, y + l.em * 7 / 8, grouped(map.counts[fate]) + " px",
                count);
  }
  if (map.counts.triangles_not_drawn > 0) {
    canvas.fitted_text(l.margin, l.legend + l.em * 6, l.panel_width,
                       fmt::format("triangles not drawn: {} (a vertex is not finite)",
                                   grouped(map.counts.triangles_not_drawn)),
                       text_of(l.em, kFaintInk));
  }
}

// "10" with the exponent raised, centred at x.
void draw_power_of_ten(Canvas& canvas, int x, int y, int em, int exponent) {
  const TextStyle base = text_of(em), raised = text_of(em * 7 / 10);
  const std::string power = fmt::format("{}", exponent);
  const int base_width = text_width("10", base) + std::max(1, em / 10);
  const int left = x - (base_width + text_width(power, raised)) / 2;
  canvas.text(left, y, "10", base);
  canvas.text(left + base_width, y - em * 2 / 5, power, raised);
}

void draw_bar(Canvas& canvas, const Area& bar) {
  for (int i = 0; i < bar.width; ++i) {
    canvas.fill({bar.x + i, bar.y, 1, bar.height}, error_colour((i + 0.5) / bar.width));
  }
  canvas.outline(bar, kFrame);
}

// The colour scale beneath the heat map, with a tick at each power of ten.
void draw_scale(Canvas& canvas, const Layout& l, const HeatMap& map) {
  const Area bar{l.right_x, l.legend + 1, l.panel_width, l.em};
  draw_bar(canvas, bar);
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
  const int x = l.right_x, y = l.legend + l.em * 9 / 2;
  canvas.fitted_text(x, y, l.panel_width, kErrorLabel, text_of(l.em));
  canvas.fitted_text(
      x, y + l.em * 3 / 2, l.panel_width,
      fmt::format("max {:.2g}, median {:.2g}; above 1 texel: {:.2g} % of {} px", c.max_error,
                  c.median_error, 100 * c.share_above_one, grouped(c.compared())),
      text_of(l.em, kFaintInk));
}

// All lengths in px; `em` is the size of the text.
struct RowLayout {
  int panels, width, height;  // width and height of a panel
  int em = std::clamp(width / 36, 12, 40);
  int margin = 2 * em, top = margin + 4 * em, legend = top + height + em;
  int total_width = x(panels) - em + margin, total_height = legend + 6 * em + em / 2;

  int x(int panel) const { return margin + panel * (width + em); }
  TextStyle text() const { return text_of(em); }
};

// Without a power of ten: 0.01, 1, 435044.
std::string plain(double value) {
  return value < 100 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

// The colour scale beneath the last panel: a tick at each power of ten, a number at each other one.
void draw_row_scale(Canvas& canvas, const RowLayout& l, const HeatMap& map) {
  const Area bar{l.x(l.panels - 1), l.legend, l.width, l.em};
  draw_bar(canvas, bar);
  const int first = static_cast<int>(std::lround(std::log10(map.options.lowest)));
  const int last = static_cast<int>(std::lround(std::log10(map.options.highest)));
  for (int exponent = first; exponent <= last; ++exponent) {
    const double value = std::pow(10.0, exponent);
    const int x = bar.x + static_cast<int>(scale_position(map.options, value) * (bar.width - 1));
    canvas.fill({x, bar.y + bar.height, 1, l.em / 3}, kInk);
    if ((exponent - first) % 2 != 0) continue;
    const Align align = exponent == first  ? Align::left
                        : exponent == last ? Align::right
                                           : Align::center;
    canvas.text(x, bar.y + bar.height + l.em * 3 / 2, plain(value),
                {l.em * 4 / 5, Weight::regular, align, kInk});
  }
  const int y = l.legend + 4 * l.em;
  canvas.fitted_text(bar.x, y, l.width, kErrorLabel, l.text());
  canvas.fitted_text(bar.x, y + l.em * 3 / 2, l.width,
                     fmt::format("max {}, median {}; above 1 texel: {:.3g} % of the pixels",
                                 plain(map.counts.max_error), plain(map.counts.median_error),
                                 100 * map.counts.share_above_one),
                     l.text());
}

}  // namespace

Image compose(const Figure& figure) {
  assert(figure.tested != nullptr);
  const FrameBuffer& buffer = *figure.tested;
  const HeatMap* map = figure.heat_map;
  assert(map == nullptr ||
         (map->image.width == buffer.width && map->image.height == buffer.height));
  const Layout l{buffer, map != nullptr};
  Canvas canvas(l.width, l.height, kPaper);
  draw_titles(canvas, l, figure);
  draw_panel(canvas, l, shade(buffer, figure.picture), l.margin);
  if (map != nullptr) {
    draw_panel(canvas, l, map->image, l.right_x);
    draw_categories(canvas, l, *map);
    draw_scale(canvas, l, *map);
    draw_scale_labels(canvas, l, *map);
  }
  return canvas.image();
}

Image compose_row(const std::string& title, std::span<const CaptionedImage> panels,
                  const HeatMap& map) {
  const RowLayout l{static_cast<int>(panels.size()), panels[0].image.width, panels[0].image.height};
  Canvas canvas(l.total_width, l.total_height, kPaper);
  canvas.fitted_text(l.margin, l.margin + l.em, l.total_width - 2 * l.margin, title,
                     {l.em * 5 / 4, Weight::bold, Align::left, kInk});
  for (int i = 0; i < l.panels; ++i) {
    const CaptionedImage& panel = panels[static_cast<std::size_t>(i)];
    canvas.fitted_text(l.x(i), l.top - l.em / 2, l.width, panel.caption, l.text());
    canvas.paste(panel.image, l.x(i), l.top, 1);
    canvas.outline({l.x(i), l.top, l.width, l.height}, kFrame);
  }
  draw_row_scale(canvas, l, map);
  return canvas.image();
}

}  // namespace clipscope::experiments
