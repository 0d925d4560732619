// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/ulp_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "experiments/render/canvas.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

constexpr int kScale = 2, kGap = 24, kEm = 18, kColumns = 4;
constexpr int kTitleHeight = 3 * kEm, kPanelText = 4 * kEm, kLegendHeight = 6 * kEm;
constexpr TextStyle kRegular = {.size_px = kEm}, kBold = {.size_px = kEm, .weight = Weight::bold};

struct SignEntry {
  int computed, exact;  // an example of what the colour stands for
  std::string_view name;
};

constexpr SignEntry kSignLegend[] = {
    {1, 1, "inside"},
    {-1, -1, "outside"},
    {0, 0, "on the plane"},
    {-1, 1, "wrong: the opposite side"},
    {0, 1, "wrong: taken to be on the plane"},
    {1, 0, "wrong: on the plane, not seen"},
};

struct Layout {
  int columns, rows, panel, width, height;

  explicit Layout(const UlpGrid& grid) {
    const int panels = 1 + static_cast<int>(grid.predicates.size());
    // Few panels in two rows look better than many in one.
    columns = panels <= kColumns ? panels : (panels + 1) / 2;
    rows = (panels + columns - 1) / columns;
    panel = grid.size * kScale;
    width = kGap + columns * (panel + kGap);
    height = kTitleHeight + rows * (panel + kPanelText) + kLegendHeight + kGap;
  }

  int x(int index) const { return kGap + index % columns * (panel + kGap); }
  int y(int index) const { return kTitleHeight + index / columns * (panel + kPanelText); }
  int legend_y() const { return height - kGap - kLegendHeight; }
};

std::string count_text(const SignCounts& counts) {
  if (counts.wrong() == 0) return fmt::format("all {} right", counts.right);
  return fmt::format("wrong {}: opposite {}, false zero {}, missed zero {}", counts.wrong(),
                     counts.opposite, counts.false_zero, counts.missed_zero);
}

std::string exact_text(const SignMap& exact) {
  const auto count = [&](int sign) { return std::ranges::count(exact.signs, sign); };
  return fmt::format("inside {}, outside {}, on the plane {}", count(1), count(-1), count(0));
}

void draw_panel(Canvas& canvas, const Layout& layout, int index, const Image& image,
                std::string_view title, std::string_view text) {
  const int x = layout.x(index), y = layout.y(index) + kEm * 3 / 2;
  canvas.fitted_text(x, y - kEm / 2, layout.panel, title, kBold);
  canvas.outline({x, y, layout.panel, layout.panel}, {0, 0, 0});
  canvas.paste(image, x, y, kScale);
  canvas.fitted_text(x, y + layout.panel + kEm * 5 / 4, layout.panel, text, kRegular);
}

void draw_legend(Canvas& canvas, const Layout& layout) {
  const int column_width = (layout.width - 2 * kGap) / 3;
  for (int i = 0; i < static_cast<int>(std::size(kSignLegend)); ++i) {
    const auto& [computed, exact, name] = kSignLegend[i];
    const int x = kGap + i % 3 * column_width;
    const int y = layout.legend_y() + kEm + i / 3 * kEm * 2;
    const Area box = {x, y, kEm, kEm};
    canvas.fill(box, sign_colour(computed, exact));
    canvas.outline(box, {0, 0, 0});
    canvas.fitted_text(x + kEm * 3 / 2, y + kEm * 7 / 8, column_width - 2 * kEm, name, kRegular);
  }
}

}  // namespace

Rgb sign_colour(int computed, int exact) {
  switch (sign_fate(computed, exact)) {
    case SignFate::right: break;
    case SignFate::opposite: return from_hex(0xd81b60);
    case SignFate::false_zero: return from_hex(0x41b6a6);
    case SignFate::missed_zero: return from_hex(0xffffff);
  }
  if (exact == 0) return from_hex(0x000000);
  return exact < 0 ? from_hex(0x084594) : from_hex(0xfdd49e);
}

Image sign_image(const SignMap& computed, const SignMap& exact) {
  Image image{exact.size, exact.size, {}};
  for (int j = exact.size - 1; j >= 0; --j) {
    for (int i = 0; i < exact.size; ++i) {
      image.pixels.push_back(sign_colour(computed.at(i, j), exact.at(i, j)));
    }
  }
  return image;
}

Image ulp_picture(const UlpGrid& grid) {
  const Layout layout(grid);
  Canvas canvas(layout.width, layout.height, {1, 1, 1});
  canvas.fitted_text(kGap, kEm * 2, layout.width - 2 * kGap,
                     fmt::format("{}; one cell is one float ulp", grid.title),
                     {.size_px = kEm * 4 / 3, .weight = Weight::bold});
  const SignMap exact = sign_map(grid, grid.exact);
  draw_panel(canvas, layout, 0, sign_image(exact, exact), "exact", exact_text(exact));
  int index = 1;
  for (const Predicate& predicate : grid.predicates) {
    const SignMap map = sign_map(grid, predicate.sign_of);
    draw_panel(canvas, layout, index++, sign_image(map, exact), predicate.title,
               count_text(compare(map, exact)));
  }
  draw_legend(canvas, layout);
  return canvas.image();
}

}  // namespace clipscope::experiments::hard_cases
