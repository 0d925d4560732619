// SPDX-License-Identifier: GPL-3.0-or-later
//
// A page of shapes and text that becomes SVG, PDF or PNG, through cairo
// (https://cairographics.org).
//
// Lengths are in px from the top left. Spots must lie within some ten thousand px of the page,
// since cairo computes in 24.8 fixed point: cut far shapes before (see panel.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct _cairo;  // cairo_t and cairo_surface_t: only vector_page.cpp reads cairo's headers
struct _cairo_surface;

namespace clipscope::experiments {

enum class PageFormat { svg, pdf, png };

// The format that the extension names. Errors: UsageError unless it is .svg, .pdf or .png, in any
// case.
PageFormat page_format(const std::filesystem::path& path);

struct Colour {
  std::uint32_t rgb = 0x000000;  // as in HTML, sRGB
};

struct Spot {
  double x = 0, y = 0;
};

struct Rect {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  Spot centre() const { return {x + width / 2, y + height / 2}; }
  // From the top left, clockwise.
  std::array<Spot, 4> corners() const {
    return {{{x, y}, {right(), y}, {right(), bottom()}, {x, bottom()}}};
  }
};

struct Pen {
  Colour colour = {};
  double width = 1;
  double dash = 0;  // length of dashes and, halved, of the gaps; 0: none
};

enum class Anchor { left, middle, right };

struct Lettering {
  double size = 12;
  bool bold = false;
  Anchor anchor = Anchor::left;
  Colour colour = {};
  bool halo = false;  // a white rim, for text over lines
};

class VectorPage {
 public:
  // Title: what the file says of itself where the format has a place for it (SVG, PDF).
  VectorPage(PageFormat format, double width, double height, const std::string& title);
  VectorPage(const VectorPage&) = delete;  // what is drawn refers to it

  void fill(std::span<const Spot> outline, Colour colour);
  void hatch(std::span<const Spot> outline, Colour colour);
  void stroke(std::span<const Spot> path, const Pen& pen, bool closed);
  void circle(Spot centre, double radius, Colour fill, const Pen& rim);

  // The baseline starts, has its middle or ends at the spot. UTF-8; what isn't is drawn as '?'.
  void text(Spot at, std::string_view text, const Lettering& lettering);
  double text_width(std::string_view text, const Lettering& lettering);
  // The text in lines of at most that width, broken at blanks; longer words stand alone. A line too
  // many is left out, and the last ends in an ellipsis.
  std::vector<std::string> wrap(std::string_view text, double width, std::size_t max_lines,
                                const Lettering& lettering);

  // Draws nothing outside of the rectangle.
  void clipped(const Rect& rect, const std::function<void()>& draw);

  // The file; the page can't be drawn on any more. Errors: OutputError.
  std::string finish();

 private:
  PageFormat format_;
  std::string title_, bytes_;
  std::unique_ptr<_cairo_surface, void (*)(_cairo_surface*)> surface_;
  std::unique_ptr<_cairo, void (*)(_cairo*)> page_;
};

}  // namespace clipscope::experiments
