// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/draw/vector_page.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kPngScale = 2;  // pixels per px
constexpr double kHatchGap = 6;
constexpr const char* kFont = "DejaVu Sans";

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(PageFormat format, double width, double height, std::string& bytes) {
  if (format == PageFormat::svg) {
    cairo_surface_t* surface = cairo_svg_surface_create_for_stream(append, &bytes, width, height);
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    return surface;
  }
  if (format == PageFormat::pdf) {
    return cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width * kPngScale),
                                    static_cast<int>(height * kPngScale));
}

// Control characters become blanks, bytes that are no UTF-8 '?'.
std::string printable(std::string_view text) {
  std::string r = valid_utf8(text, "?");
  std::ranges::replace_if(
      r, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return r;
}

// cairo has no call for it: the title is the first child of the root element.
std::string with_title(std::string svg, const std::string& title) {
  const std::size_t root = svg.find("<svg");
  const std::size_t end = root == std::string::npos ? root : svg.find('>', root);
  if (end != std::string::npos) {
    svg.insert(end + 1, fmt::format("\n<title>{}</title>", xml_escaped(title)));
  }
  return svg;
}

void set_colour(cairo_t* c, Colour colour) {
  const auto channel = [&](int shift) { return ((colour.rgb >> shift) & 0xffu) / 255.0; };
  cairo_set_source_rgb(c, channel(16), channel(8), channel(0));
}

void set_pen(cairo_t* c, const Pen& pen) {
  set_colour(c, pen.colour);
  cairo_set_line_width(c, pen.width);
  const double dashes[] = {pen.dash, pen.dash / 2};
  cairo_set_dash(c, dashes, pen.dash > 0 ? 2 : 0, 0);
}

void set_font(cairo_t* c, const Lettering& lettering) {
  cairo_select_font_face(c, kFont, CAIRO_FONT_SLANT_NORMAL,
                         lettering.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, lettering.size);
}

void trace(cairo_t* c, std::span<const Spot> path) {
  cairo_new_path(c);
  for (const Spot& s : path) cairo_line_to(c, s.x, s.y);
}

}  // namespace

PageFormat page_format(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".svg") return PageFormat::svg;
  if (extension == ".pdf") return PageFormat::pdf;
  if (extension == ".png") return PageFormat::png;
  throw UsageError(
      fmt::format("--picture {}: the extension must be .svg, .pdf or .png", path.string()));
}

VectorPage::VectorPage(PageFormat format, double width, double height, const std::string& title)
    : format_(format),
      title_(printable(title)),
      surface_(make_surface(format, width, height, bytes_), cairo_surface_destroy),
      page_(cairo_create(surface_.get()), cairo_destroy) {
  cairo_t* c = page_.get();
  if (format == PageFormat::png) cairo_scale(c, kPngScale, kPngScale);
  if (format == PageFormat::pdf) {
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE, title_.c_str());
  }
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  cairo_set_source_rgb(c, 1, 1, 1);
  cairo_paint(c);
}

void VectorPage::fill(std::span<const Spot> outline, Colour colour) {
  set_colour(page_.get(), colour);
  trace(page_.get(), outline);
  cairo_fill(page_.get());
}

void VectorPage::hatch(std::span<const Spot> outline, Colour colour) {
  if (outline.empty()) return;
  cairo_t* c = page_.get();
  const auto [left, right] = std::ranges::minmax(outline, {}, &Spot::x);
  const auto [top, bottom] = std::ranges::minmax(outline, {}, &Spot::y);
  cairo_save(c);
  trace(page_.get(), outline);
  cairo_clip(c);
  set_pen(page_.get(), {colour, 0.7});
  cairo_new_path(c);
  const double height = bottom.y - top.y;
  for (double x = left.x - height; x < right.x; x += kHatchGap) {
    cairo_move_to(c, x, bottom.y);
    cairo_line_to(c, x + height, top.y);
  }
  cairo_stroke(c);
  cairo_restore(c);
}

void VectorPage::stroke(std::span<const Spot> path, const Pen& pen, bool closed) {
  set_pen(page_.get(), pen);
  trace(page_.get(), path);
  if (closed) cairo_close_path(page_.get());
  cairo_stroke(page_.get());
}

void VectorPage::circle(Spot centre, double radius, Colour fill, const Pen& rim) {
  cairo_t* c = page_.get();
  cairo_new_path(c);
  cairo_arc(c, centre.x, centre.y, radius, 0, 6.283185307179586);
  set_colour(page_.get(), fill);
  cairo_fill_preserve(c);
  set_pen(page_.get(), rim);
  cairo_stroke(c);
}

void VectorPage::text(Spot at, std::string_view text, const Lettering& lettering) {
  cairo_t* c = page_.get();
  const double width = text_width(text, lettering);
  const Spot start = {at.x - 0.5 * static_cast<int>(lettering.anchor) * width, at.y};
  const std::string safe = printable(text);
  set_font(page_.get(), lettering);
  if (lettering.halo) {
    cairo_new_path(c);
    cairo_move_to(c, start.x, start.y);
    cairo_text_path(c, safe.c_str());
    set_pen(page_.get(), {{0xffffff}, 3});
    cairo_stroke(c);
  }
  set_colour(page_.get(), lettering.colour);
  cairo_move_to(c, start.x, start.y);
  cairo_show_text(c, safe.c_str());
}

double VectorPage::text_width(std::string_view text, const Lettering& lettering) {
  set_font(page_.get(), lettering);
  cairo_text_extents_t extents;
  cairo_text_extents(page_.get(), printable(text).c_str(), &extents);
  return extents.x_advance;
}

std::vector<std::string> VectorPage::wrap(std::string_view text, double width,
                                          std::size_t max_lines, const Lettering& lettering) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word(text.substr(begin, end - begin));
    begin = end + 1;
    const std::string longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    if (lines.back().empty() || text_width(longer, lettering) <= width) {
      lines.back() = longer;
    } else if (lines.size() < max_lines) {
      lines.push_back(word);
    } else {
      lines.back() += " …";
      break;
    }
  }
  return lines;
}

void VectorPage::clipped(const Rect& rect, const std::function<void()>& draw) {
  cairo_t* c = page_.get();
  cairo_save(c);
  cairo_new_path(c);
  cairo_rectangle(c, rect.x, rect.y, rect.width, rect.height);
  cairo_clip(c);
  draw();
  cairo_restore(c);
}

std::string VectorPage::finish() {
  if (format_ == PageFormat::png) {
    cairo_surface_write_to_png_stream(surface_.get(), append, &bytes_);
  } else {
    cairo_show_page(page_.get());
  }
  cairo_status_t status = cairo_status(page_.get());
  cairo_surface_finish(surface_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    throw OutputError(
        fmt::format("the picture can't be drawn: cairo says '{}'", cairo_status_to_string(status)));
  }
  return format_ == PageFormat::svg ? with_title(std::move(bytes_), title_) : bytes_;
}

}  // namespace clipscope::experiments
