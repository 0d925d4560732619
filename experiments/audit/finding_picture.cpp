// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/finding_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "experiments/audit/draw_text.hpp"
#include "experiments/draw/panel.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/pixels/own_driver.hpp"
#include "experiments/render/heat_map.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kMargin = 24, kSide = 260, kGap = 56, kRow = 18;
constexpr double kWidth = 2 * kMargin + 5 * kSide + 4 * kGap;
constexpr double kUnder = 92;         // beneath the panels: ticks, then the legend
constexpr int kMostAcross = 48;       // pixels of a panel
constexpr double kLeastError = 1e-7;  // relative to the range of values; less is no difference
constexpr Colour kGround = {0xf0f0f0}, kBlack = {0x000000}, kGrey = {0x555555}, kPlane = {0x707070},
                 kHatch = {0xb0b0b0}, kMarked = {0xd00000};
constexpr Lettering kTitle = {.size = 18, .bold = true}, kText = {.size = 13},
                    kHead = {.size = 13, .bold = true};

Colour colour_of(const Rgb& linear) {
  std::uint32_t rgb = 0;
  for (const float channel : encoded(linear)) {
    rgb = rgb << 8 | static_cast<std::uint32_t>(std::lround(std::clamp(channel, 0.0f, 1.0f) * 255));
  }
  return {rgb};
}

// The pixels that are shown, around the worst one.
struct Window {
  int x = 0, y = 0, across = 0;

  Window(const Pixels& pixels, const WorstPixel& worst) {
    across = std::min({kMostAcross, std::max(pixels.width, pixels.height)});
    x = std::clamp(worst.x - across / 2, 0, std::max(0, pixels.width - across));
    y = std::clamp(worst.y - across / 2, 0, std::max(0, pixels.height - across));
  }
};

// One channel of what was drawn.
struct Layer {
  const Pixels& pixels;
  Quantity quantity;
  std::size_t channel;

  bool is_there(int x, int y) const { return pixels.at(Quantity::covered, x, y) != 0; }
  float value(int x, int y) const { return pixels.at(quantity, x, y, channel); }
};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Range range_of(const Layer& layer) {
  Range range;
  for (int y = 0; y < layer.pixels.height; ++y) {
    for (int x = 0; x < layer.pixels.width; ++x) {
      if (!layer.is_there(x, y) || !std::isfinite(layer.value(x, y))) continue;
      range.low = std::min<double>(range.low, layer.value(x, y));
      range.high = std::max<double>(range.high, layer.value(x, y));
    }
  }
  return range;
}

Colour value_colour(const Layer& layer, const Range& range, int x, int y) {
  if (!layer.is_there(x, y)) return kGround;
  const double value = layer.value(x, y);
  if (!std::isfinite(value)) return colour_of(fate_colour(PixelFate::not_finite));
  return colour_of(error_colour(range.share(value)));
}

Colour difference_colour(const Layer& came, const Layer& right, const Range& range, int x, int y) {
  if (came.is_there(x, y) != right.is_there(x, y)) {
    return colour_of(fate_colour(right.is_there(x, y) ? PixelFate::hole : PixelFate::extra));
  }
  if (!came.is_there(x, y)) return kGround;
  const double difference = std::abs(double{came.value(x, y)} - right.value(x, y));
  if (!std::isfinite(difference)) return colour_of(fate_colour(PixelFate::not_finite));
  const double size = range.high > range.low ? range.high - range.low : 1;
  const HeatMapOptions scale{.lowest = kLeastError, .highest = 1};
  return difference < kLeastError * size
             ? kGround
             : colour_of(error_colour(scale_position(scale, difference / size)));
}

// Row 0 stands at the bottom.
template <class ColourAt>
void draw_pixels(VectorPage& page, const Rect& frame, const Pixels& pixels, const Window& window,
                 const WorstPixel& worst, const ColourAt& colour_at) {
  const double cell = frame.width / window.across;
  const auto box_of = [&](int x, int y) {
    return Rect{frame.x + cell * (x - window.x), frame.bottom() - cell * (y - window.y + 1), cell,
                cell};
  };
  for (int y = window.y; y < std::min(pixels.height, window.y + window.across); ++y) {
    for (int x = window.x; x < std::min(pixels.width, window.x + window.across); ++x) {
      page.fill(box_of(x, y).corners(), colour_at(x, y));
    }
  }
  page.stroke(frame.corners(), {kGrey, 1}, true);
  page.stroke(box_of(worst.x, worst.y).corners(), {kMarked, 2}, true);
}

void draw_clip_space(VectorPage& page, const Rect& frame, const DrawCall& call,
                     std::size_t primitive, std::size_t coordinate) {
  ExactShape shape;
  std::vector<Panel::Marker> markers;
  const std::vector<std::uint32_t> vertices = primitives_of(call)[primitive];
  for (const std::uint32_t number : vertices) {
    const auto& p = call.vertices[number].position;
    shape.push_back(position_at(p[0], p[1], p[2], p[3]));
    markers.push_back({shape.back(), std::to_string(number), p[3] <= 0});
  }
  PanelAxis horizontal{.coordinate = coordinate, .name = std::string(1, "xy"[coordinate])};
  PanelAxis vertical{.coordinate = 3, .name = "w"};
  fit_window({.must = {position_at(-1, -1, 0, 0), position_at(1, 1, 0, 1)}, .may = shape},
             horizontal, vertical);
  Panel panel(page, frame, horizontal, vertical);
  const double far = 8 * panel.extent();
  const auto point = [&](double c, double w) { return position_at(c, c, 0, w); };
  panel.fill({point(0, 0), point(-far, far), point(far, far)}, kGround);
  panel.hatch({point(-far, 0), point(far, 0), point(far, -far), point(-far, -far)}, kHatch);
  for (const double slope : {-1.0, 1.0}) {
    panel.stroke({point(-slope * far, -far), point(slope * far, far)}, {kPlane, 1.2});
  }
  panel.stroke(shape, {kBlack, 1.3});
  panel.mark(markers, kBlack, shape);
  panel.draw_axes(fmt::format("Clip space, {} over w", "xy"[coordinate]));
}

struct Heading {
  std::vector<std::string> lines;
  double height = 0;
};

Heading heading_of(VectorPage& page, const Audit& audit, const DriverFinding& finding) {
  Heading heading;
  const DrawExample& example = finding.example();
  for (const std::string& text :
       {draw_text(example.call), pixel_text(example.violation),
        fmt::format("{}: {}", section_text(finding.clause), finding.clause.meaning),
        driver_text(audit.info)}) {
    const auto lines = page.wrap(text, kWidth - 2 * kMargin, 2, kText);
    heading.lines.insert(heading.lines.end(), lines.begin(), lines.end());
  }
  heading.height = 30 + kRow * static_cast<double>(heading.lines.size()) + 30;
  return heading;
}

std::string title_of(const Audit& audit, const DriverFinding& finding) {
  return fmt::format("{}: {}", audit.driver, finding_text(finding.key));
}

void draw_legend(VectorPage& page, Spot corner, const Range& range) {
  struct Entry {
    Colour colour;
    std::string text;
  };
  const auto fate = [](PixelFate f) { return colour_of(fate_colour(f)); };
  const std::array entries = {
      Entry{colour_of(error_colour(0)), fmt::format("{:.4g}", range.low)},
      Entry{colour_of(error_colour(1)), fmt::format("{:.4g}", range.high)},
      Entry{fate(PixelFate::not_finite), "NaN or infinity"},
      Entry{fate(PixelFate::hole), "missing"},
      Entry{fate(PixelFate::extra), "too much"},
      Entry{colour_of(error_colour(0.1)), "small difference"},
      Entry{colour_of(error_colour(0.95)), "difference as large as the values' range"},
  };
  for (const auto& [colour, text] : entries) {
    page.fill(Rect{corner.x, corner.y - 11, 20, 12}.corners(), colour);
    page.text({corner.x + 26, corner.y}, text, {.size = 12});
    corner.x += 26 + page.text_width(text, {.size = 12}) + 22;
  }
}

void draw_panels(VectorPage& page, double top, const DriverFinding& finding, const Pixels& came,
                 const Pixels& right) {
  const DrawExample& example = finding.example();
  const WorstPixel& worst = example.violation.worst;
  const Quantity quantity = example.violation.quantity;
  const Layer drawn{came, quantity, worst.channel}, truth{right, quantity, worst.channel};
  Range range = range_of(truth);
  if (range.low > range.high) range = {0, 1};
  const Window window(came, worst);
  const auto frame = [&](int i) { return Rect{kMargin + i * (kSide + kGap), top, kSide, kSide}; };
  const auto draw = [&](int i, const char* head, const auto& colour_at) {
    page.text({frame(i).x, top - 8}, head, kHead);
    draw_pixels(page, frame(i), came, window, worst, colour_at);
  };
  draw(0, "Came out", [&](int x, int y) { return value_colour(drawn, range, x, y); });
  draw(1, "Right", [&](int x, int y) { return value_colour(truth, range, x, y); });
  draw(2, "Difference", [&](int x, int y) { return difference_colour(drawn, truth, range, x, y); });
  const std::size_t primitive = example.violation.primitive;
  draw_clip_space(page, frame(3), example.call, primitive, 0);
  draw_clip_space(page, frame(4), example.call, primitive, 1);
  const int last_x = std::min(came.width, window.x + window.across) - 1;
  const int last_y = std::min(came.height, window.y + window.across) - 1;
  page.text({kMargin, top + kSide + 20},
            fmt::format("pixels ({}, {}) to ({}, {}) of {} x {}, row {} at the bottom", window.x,
                        window.y, last_x, last_y, came.width, came.height, window.y),
            {.size = 12, .colour = kGrey});
  draw_legend(page, {kMargin, top + kSide + kUnder - 14}, range);
}

}  // namespace

void write_finding_picture(const std::filesystem::path& path, const Audit& audit,
                           const DriverFinding& finding, const Pixels& pixels) {
  const PageFormat format = page_format(path);
  OwnDriver own(RasterFault::none,
                {.api = audit.info.api, .subpixel_bits = audit.info.subpixel_bits});
  const Drawn right = own.draw(finding.example().call);
  // Lines can only be broken on a page, and the page's height depends on their number.
  VectorPage ruler(PageFormat::png, 1, 1, "");
  const Heading heading = heading_of(ruler, audit, finding);
  const std::string title = title_of(audit, finding);
  VectorPage page(format, kWidth, kMargin + heading.height + kSide + kUnder + kMargin, title);
  Spot at{kMargin, kMargin + 14};
  page.text(at, title, kTitle);
  at.y += 6;
  for (const std::string& line : heading.lines) page.text({at.x, at.y += kRow}, line, kText);
  draw_panels(page, kMargin + heading.height, finding, pixels, std::get<Pixels>(right));
  write_file(path, page.finish());
}

}  // namespace clipscope::experiments
