// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/w_sign/side_by_side.hpp"

#include "experiments/render/canvas.hpp"
#include "experiments/render/picture.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kMargin = 16;      // px
constexpr int kTextHeight = 30;  // px

void draw_panel(Canvas& canvas, const FrameBuffer& buffer, int x, int y,
                const std::string& caption) {
  canvas.fitted_text(x, y + kTextHeight - 10, buffer.width, caption,
                     {.size_px = 17, .weight = Weight::bold});
  const int top = y + kTextHeight;
  canvas.outline({x, top, buffer.width, buffer.height}, from_hex(0x808080));
  canvas.paste(shade(buffer), x, top, 1);
}

}  // namespace

Image side_by_side(std::span<const PanelRow> rows) {
  const int width = rows.front().left->width, height = rows.front().left->height;
  const int row_height = height + 2 * kTextHeight + kMargin;
  const int sheet_width = 2 * width + 3 * kMargin;
  Canvas canvas(sheet_width, static_cast<int>(rows.size()) * row_height + kMargin,
                from_hex(0xffffff));
  int y = kMargin / 2;
  for (const PanelRow& row : rows) {
    draw_panel(canvas, *row.left, kMargin, y, row.left_caption);
    draw_panel(canvas, *row.right, width + 2 * kMargin, y, row.right_caption);
    canvas.fitted_text(kMargin, y + height + 2 * kTextHeight - 8, sheet_width - 2 * kMargin,
                       row.note, {.size_px = 16});
    y += row_height;
  }
  return canvas.image();
}

}  // namespace clipscope::experiments
