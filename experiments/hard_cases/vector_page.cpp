// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/vector_page.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "experiments/errors.hpp"

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

// The length of the UTF-8 character that starts at i, 0 if there is none. Overlong forms and
// surrogates are none.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(i);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc2 ? 2 : 0;
  if (length == 0 || lead > 0xf4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xc0) != 0x80) return 0;
  }
  const unsigned second = byte(i + 1);
  const bool out_of_range = (lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
                            (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f);
  return out_of_range ? 0 : length;
}

// Control characters become blanks, bytes that are no UTF-8 '?'.
std::string printable(std::string_view text) {
  std::string r;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) {
      r += '?';
    } else if (std::iscntrl(static_cast<unsigned char>(text[i])) != 0) {
      r += ' ';
    } else {
      r += text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
  return r;
}

std::string escaped(std::string_view text) {
  std::string r;
  for (const char c : text) {
    switch (c) {
      case '&': r += "&amp;"; break;
      case '<': r += "&lt;"; break;
      case '>': r += "&gt;"; break;
      default: r += c;
    }
  }
  return r;
}

// cairo has no call for it: the title is the first child of the root element.
std::string with_title(std::string svg, const std::string& title) {
  const std::size_t root = svg.find("<svg");
  const std::size_t end = root == std::string::npos ? root : svg.find('>', root);
  if (end != std::string::npos) {
    svg.insert(end + 1, fmt::format("\n<title>{}</title>", escaped(title)));
  }
  return svg;
}

}  // namespace

struct VectorPage::Cairo {
  PageFormat format;
  std::string title;
  std::string bytes;
  cairo_surface_t* surface;
  cairo_t* context;

  Cairo(PageFormat f, double width, double height, const std::string& t)
      : format(f),
        title(printable(t)),
        surface(make_surface(f, width, height, bytes)),
        context(cairo_create(surface)) {}
  Cairo(const Cairo&) = delete;
  Cairo& operator=(const Cairo&) = delete;
  ~Cairo() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }

  void set_colour(Colour colour) const {
    const auto channel = [&](int shift) { return ((colour.rgb >> shift) & 0xffu) / 255.0; };
    cairo_set_source_rgb(context, channel(16), channel(8), channel(0));
  }
  void set_pen(const Pen& pen) const {
    set_colour(pen.colour);
    cairo_set_line_width(context, pen.width);
    const double dashes[] = {pen.dash, pen.dash / 2};
    cairo_set_dash(context, dashes, pen.dash > 0 ? 2 : 0, 0);
  }
  void set_font(const Lettering& lettering) const {
    cairo_select_font_face(context, kFont, CAIRO_FONT_SLANT_NORMAL,
                           lettering.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, lettering.size);
  }
  void trace(std::span<const Spot> path) const {
    cairo_new_path(context);
    for (const Spot& s : path) cairo_line_to(context, s.x, s.y);
  }
};

PageFormat page_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".svg") return PageFormat::svg;
  if (extension == ".pdf") return PageFormat::pdf;
  if (extension == ".png") return PageFormat::png;
  throw UsageError(
      fmt::format("--picture {}: the extension must be .svg, .pdf or .png", path.string()));
}

VectorPage::VectorPage(PageFormat format, double width, double height, const std::string& title)
    : cairo_(std::make_unique<Cairo>(format, width, height, title)) {
  cairo_t* c = cairo_->context;
  if (format == PageFormat::png) cairo_scale(c, kPngScale, kPngScale);
  if (format == PageFormat::pdf) {
    cairo_pdf_surface_set_metadata(cairo_->surface, CAIRO_PDF_METADATA_TITLE,
                                   cairo_->title.c_str());
  }
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  cairo_set_source_rgb(c, 1, 1, 1);
  cairo_paint(c);
}

VectorPage::~VectorPage() = default;

void VectorPage::fill(std::span<const Spot> outline, Colour colour) {
  cairo_->set_colour(colour);
  cairo_->trace(outline);
  cairo_fill(cairo_->context);
}

void VectorPage::hatch(std::span<const Spot> outline, Colour colour) {
  if (outline.empty()) return;
  cairo_t* c = cairo_->context;
  const auto [left, right] = std::ranges::minmax(outline, {}, &Spot::x);
  const auto [top, bottom] = std::ranges::minmax(outline, {}, &Spot::y);
  cairo_save(c);
  cairo_->trace(outline);
  cairo_clip(c);
  cairo_->set_pen({colour, 0.7});
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
  cairo_->set_pen(pen);
  cairo_->trace(path);
  if (closed) cairo_close_path(cairo_->context);
  cairo_stroke(cairo_->context);
}

void VectorPage::circle(Spot centre, double radius, Colour fill, const Pen& rim) {
  cairo_t* c = cairo_->context;
  cairo_new_path(c);
  cairo_arc(c, centre.x, centre.y, radius, 0, 6.283185307179586);
  cairo_->set_colour(fill);
  cairo_fill_preserve(c);
  cairo_->set_pen(rim);
  cairo_stroke(c);
}

void VectorPage::text(Spot at, std::string_view text, const Lettering& lettering) {
  cairo_t* c = cairo_->context;
  const double width = text_width(text, lettering);
  const double shift = lettering.anchor == Anchor::left     ? 0
                       : lettering.anchor == Anchor::middle ? 0.5
                                                            : 1;
  const Spot start = {at.x - shift * width, at.y};
  const std::string safe = printable(text);
  cairo_->set_font(lettering);
  if (lettering.halo) {
    cairo_new_path(c);
    cairo_move_to(c, start.x, start.y);
    cairo_text_path(c, safe.c_str());
    cairo_->set_pen({{0xffffff}, 3});
    cairo_stroke(c);
  }
  cairo_->set_colour(lettering.colour);
  cairo_move_to(c, start.x, start.y);
  cairo_show_text(c, safe.c_str());
}

double VectorPage::text_width(std::string_view text, const Lettering& lettering) {
  cairo_->set_font(lettering);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_->context, printable(text).c_str(), &extents);
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

void VectorPage::clip(const Rect& rect) {
  cairo_t* c = cairo_->context;
  cairo_save(c);
  cairo_new_path(c);
  cairo_rectangle(c, rect.x, rect.y, rect.width, rect.height);
  cairo_clip(c);
}

void VectorPage::unclip() { cairo_restore(cairo_->context); }

std::string VectorPage::finish() {
  Cairo& c = *cairo_;
  if (c.format == PageFormat::png) {
    cairo_surface_write_to_png_stream(c.surface, append, &c.bytes);
  } else {
    cairo_show_page(c.context);
  }
  cairo_status_t status = cairo_status(c.context);
  cairo_surface_finish(c.surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(c.surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw OutputError(
        fmt::format("the picture can't be drawn: cairo says '{}'", cairo_status_to_string(status)));
  }
  return c.format == PageFormat::svg ? with_title(std::move(c.bytes), c.title) : c.bytes;
}

}  // namespace clipscope::experiments
