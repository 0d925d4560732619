// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/render/canvas.hpp"

namespace clipscope::experiments {
namespace {

const Rgb kInk = from_hex(0x1c1e21);
const Rgb kFrame = from_hex(0x8a8d93);
const Rgb kPaper = from_hex(0xffffff);

struct Layout {
  int panels, width, height, em;

  Layout(std::span<const PicturePanel> all)
      : panels(static_cast<int>(all.size())),
        width(all.front().image.width),
        height(all.front().image.height),
        em(std::clamp(width / 36, 12, 40)) {}

  int margin() const { return 2 * em; }
  int x(int panel) const { return margin() + panel * (width + em); }
  int top() const { return margin() + 4 * em; }
  int legend() const { return top() + height + em; }
  int total_width() const { return x(panels) - em + margin(); }
  int total_height() const { return legend() + 6 * em + em / 2; }
};

// Without a power of ten: 0.01, 1, 435044.
std::string plain(double value) {
  return value < 100 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

// The colours of the heat map beneath the last panel, with a tick at each power of ten and a number at each
// other one.
void draw_scale(Canvas& canvas, const Layout& l, const HeatMap& map) {
  const Area bar{l.x(l.panels - 1), l.legend(), l.width, l.em};
  for (int i = 0; i < bar.width; ++i) {
    canvas.fill({bar.x + i, bar.y, 1, bar.height}, error_colour((i + 0.5) / bar.width));
  }
  canvas.outline(bar, kFrame);
  const int first = static_cast<int>(std::lround(std::log10(map.options.lowest)));
  const int last = static_cast<int>(std::lround(std::log10(map.options.highest)));
  for (int exponent = first; exponent <= last; ++exponent) {
    const double value = std::pow(10.0, exponent);
    const int x = bar.x + static_cast<int>(scale_position(map.options, value) * (bar.width - 1));
    canvas.fill({x, bar.y + bar.height, 1, l.em / 3}, kInk);
    const Align align = exponent == first  ? Align::left
                        : exponent == last ? Align::right
                                           : Align::center;
    if ((exponent - first) % 2 != 0) continue;
    canvas.text(x, bar.y + bar.height + l.em * 3 / 2, plain(value),
                {l.em * 4 / 5, Weight::regular, align, kInk});
  }
}

void draw_scale_labels(Canvas& canvas, const Layout& l, const HeatMap& map) {
  const int x = l.x(l.panels - 1), y = l.legend() + 4 * l.em;
  canvas.fitted_text(x, y, l.width, measure_label(map.options.measure),
                     {l.em, Weight::regular, Align::left, kInk});
  canvas.fitted_text(x, y + l.em * 3 / 2, l.width,
                     fmt::format("max {}, median {}; above 1 texel: {:.3g} % of the pixels",
                                 plain(map.counts.max_error), plain(map.counts.median_error),
                                 100 * map.counts.share_above_one),
                     {l.em, Weight::regular, Align::left, kInk});
}

}  // namespace

Image compose_panels(const std::string& title, std::span<const PicturePanel> panels,
                     const HeatMap& map) {
  const Layout l(panels);
  Canvas canvas(l.total_width(), l.total_height(), kPaper);
  canvas.fitted_text(l.margin(), l.margin() + l.em, l.total_width() - 2 * l.margin(), title,
                     {l.em * 5 / 4, Weight::bold, Align::left, kInk});
  for (int i = 0; i < l.panels; ++i) {
    const PicturePanel& panel = panels[static_cast<std::size_t>(i)];
    canvas.fitted_text(l.x(i), l.top() - l.em / 2, l.width, panel.title,
                       {l.em, Weight::regular, Align::left, kInk});
    canvas.paste(panel.image, l.x(i), l.top(), 1);
    canvas.outline({l.x(i), l.top(), l.width, l.height}, kFrame);
  }
  draw_scale(canvas, l, map);
  draw_scale_labels(canvas, l, map);
  return canvas.image();
}

}  // namespace clipscope::experiments
