// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/camera/frustum_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/draw/panel.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kMargin = 24, kTop = 60, kSide = 360, kTickRoom = 56, kBeneath = 92;
constexpr double kNearsShown = 12;  // a far plane beyond so many near distances leaves the window
constexpr Colour kVolume = {0xdfeaf4}, kEdge = {0x0072b2}, kEyeEdge = {0x555555};
constexpr Lettering kTitle = {.size = 17, .bold = true}, kText = {.size = 12};

// A section through the volume: coordinate 0 to the side, 1 along the view direction.
struct Section {
  std::string title, side, low_name, high_name;
  double low, high;  // tangents, or lengths of a parallel projection
};

// Where the picture ends along the view direction.
double end_of(const MatrixMeaning& m) {
  const double near = m.reading().near.value, far = m.reading().far.value;
  return m.perspective ? std::min(far, kNearsShown * near) : far;
}

bool shows_far(const MatrixMeaning& m) { return end_of(m) == m.reading().far.value; }

ExactShape outline_of(const MatrixMeaning& m, const Section& s) {
  const double near = m.reading().near.value, end = end_of(m);
  const auto corner = [&](double side, double distance) {
    return position_at(m.perspective ? side * distance : side, distance);
  };
  return {corner(s.low, near), corner(s.high, near), corner(s.high, end), corner(s.low, end)};
}

// The volume in the panel whose axes are given; the sides of the volume carry their names.
void draw_section(VectorPage& page, Spot corner, const MatrixMeaning& m, const Section& s,
                  PanelAxis horizontal, PanelAxis vertical) {
  const ExactShape outline = outline_of(m, s);
  WindowRequest request{.must = outline, .free_aspect = true};
  const ExactPosition eye = position_at(0, 0);
  if (m.perspective) request.must.push_back(eye);
  fit_window(request, horizontal, vertical);
  Panel panel(page, {corner.x, corner.y, kSide, kSide}, horizontal, vertical);
  panel.fill(outline, kVolume);
  for (const std::size_t side : {0, 1, 3}) {
    panel.stroke({outline[side], outline[(side + 1) % 4]}, {kEdge, 1.6});
  }
  if (shows_far(m)) panel.stroke({outline[2], outline[3]}, {kEdge, 1.6});
  if (m.perspective) {
    panel.stroke({eye, outline[0]}, {kEyeEdge, 1, 4});
    panel.stroke({eye, outline[1]}, {kEyeEdge, 1, 4});
    page.circle(panel.spot(eye), 4, {0xffffff}, {kEyeEdge, 1.4});
  }
  const auto label = [&](std::size_t a, std::size_t b, const std::string& text) {
    const Spot p = panel.spot(outline[a]), q = panel.spot(outline[b]);
    page.text({(p.x + q.x) / 2, (p.y + q.y) / 2 - 4}, text,
              {.size = 12, .anchor = Anchor::middle, .colour = kEdge, .halo = true});
  };
  label(0, 1, "near");
  label(1, 2, s.high_name);
  label(3, 0, s.low_name);
  if (shows_far(m)) label(2, 3, "far");
  panel.draw_axes(s.title);
}

std::string lines_beneath(const MatrixMeaning& m, int line) {
  if (line == 0) {
    return fmt::format(
        "near {}, far {}{}", short_number(m.reading().near.value, 6),
        std::isinf(m.reading().far.value) ? "at infinity" : short_number(m.reading().far.value, 6),
        shows_far(m) ? "" : ", beyond the picture");
  }
  if (!m.perspective) return fmt::format("aspect {}", short_number(m.aspect(), 5));
  return fmt::format("{}° wide, {}° high, aspect {}", short_number(m.horizontal_degrees(), 5),
                     short_number(m.vertical_degrees(), 5), short_number(m.aspect(), 5));
}

}  // namespace

void write_frustum_picture(const std::filesystem::path& path, const MatrixMeaning& m) {
  const PageFormat format = page_format(path);
  if (m.singular || !m.reading().encloses_volume) {
    throw UsageError("--picture: the matrix encloses no volume that could be drawn");
  }
  const char* title = m.perspective ? "A perspective frustum" : "An orthographic volume";
  const double width = 2 * kMargin + 2 * (kTickRoom + kSide) + kMargin;
  VectorPage page(format, width, kTop + kSide + kBeneath, title);
  page.fill(Rect{0, 0, width, kTop + kSide + kBeneath}.corners(), {0xffffff});
  page.text({kMargin, 30}, title, kTitle);
  const Section above{"From above", "x", "left", "right", m.left, m.right_side};
  const Section beside{"From the side", "y", "bottom", "top", m.bottom, m.top};
  const PanelAxis along{.coordinate = 1, .name = "distance"};
  const Spot first{kMargin + kTickRoom, kTop}, second{first.x + kSide + kTickRoom + kMargin, kTop};
  draw_section(page, first, m, above, {.coordinate = 0, .name = "right"}, along);
  draw_section(page, second, m, beside, along, {.coordinate = 0, .name = "up"});
  for (const int line : {0, 1}) {
    page.text({first.x, kTop + kSide + 58 + 18 * line}, lines_beneath(m, line), kText);
  }
  write_file(path, page.finish());
}

}  // namespace clipscope::experiments
