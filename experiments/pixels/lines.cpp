// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/lines.hpp"

#include <array>
#include <cmath>

#include "experiments/pixels/volume_planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kReach = 1.5;          // px, see the header
constexpr double kMostRounding = 0.25;  // px

// The sides of a window in NDC.
struct Sides {
  double left = -1, right = 1, bottom = -1, top = 1;
};

struct WindowLine {
  bool is_empty = false;
  bool is_uncertain = false;             // for rounding
  std::array<double, 2> a = {}, b = {};  // px
  double rounding_px = 0;                // of its ends, beside snapping
};

// The part of a line from s to t, 0 at the first vertex.
struct Part {
  double s = 0, t = 1;
  void cut(double first, double second) {
    if (first < 0 && second < 0) t = -1;
    if (first < 0 && second >= 0) s = std::max(s, first / (first - second));
    if (first >= 0 && second < 0) t = std::min(t, first / (first - second));
  }
};

// Between near and far, and where clip distances leave it.
Part part_between_planes(const DrawVertex& a, const DrawVertex& b, const ClipVolume& volume) {
  Part part;
  for (const auto& plane : planes_in(volume)) part.cut(plane(a).value, plane(b).value);
  return part;
}

Part part_between(const DrawVertex& a, const DrawVertex& b, const ClipVolume& volume,
                  const Sides& sides) {
  Part part = part_between_planes(a, b, volume);
  const auto side = [&](std::size_t axis, double place, double sign) {
    const auto distance = [&](const DrawVertex& v) {
      return sign * (place * v.position[3] - static_cast<double>(v.position[axis]));
    };
    part.cut(distance(a), distance(b));
  };
  side(0, sides.left, -1);
  side(0, sides.right, 1);
  side(1, sides.bottom, -1);
  side(1, sides.top, 1);
  return part;
}

std::array<double, 2> to_window(double x_ndc, double y_ndc, const Viewport& port) {
  return {port.x + (x_ndc + 1) / 2 * port.width, port.y + (y_ndc + 1) / 2 * port.height};
}

WindowLine window_line(const DrawCall& call, std::span<const std::uint32_t> vertices,
                       const ClipVolume& volume, const Sides& sides) {
  const DrawVertex& a = call.vertices[vertices[0]];
  const DrawVertex& b = call.vertices[vertices[1]];
  const Part part = part_between(a, b, volume, sides);
  WindowLine line;
  line.is_empty = part.s > part.t;
  line.is_uncertain = line.is_empty && part.s - part.t < 1e-3;  // of a corner of the volume
  if (line.is_empty) return line;
  for (const double t : {part.s, part.t}) {
    std::array<double, 4> v = {};
    double size = 0, length = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const double from = (1 - t) * a.position[c], to = t * b.position[c];
      v[c] = from + to;
      size = std::max(size, std::abs(from) + std::abs(to));
      length = std::max(length, std::abs(static_cast<double>(b.position[c]) - a.position[c]));
    }
    line.is_uncertain = line.is_uncertain || v[3] <= 0;
    if (line.is_uncertain) return line;
    const bool is_cut = t > 0 && t < 1;  // then it may be along the line from there, too: cuts.hpp
    const double errors = 2 * operations(true) * size + (is_cut ? kClip * length / 2 : 0);
    const double rounding = errors / v[3] * std::max(call.viewport.width, call.viewport.height) +
                            farthest_px(call.viewport);
    line.rounding_px = std::max(line.rounding_px, kEpsilon * rounding);
    (t == part.s ? line.a : line.b) = to_window(v[0] / v[3], v[1] / v[3], call.viewport);
  }
  if (part.s == part.t) line.b = line.a;
  line.is_uncertain = line.rounding_px > kMostRounding;
  return line;
}

// What surely clips where fragments may be.
ClipVolume widest_volume(const DrawCall& call, std::span<const std::uint32_t> vertices,
                         const DriverInfo& info) {
  ClipVolume volume = call.volume;
  const bool is_in_front =
      call.vertices[vertices[0]].position[3] > 0 && call.vertices[vertices[1]].position[3] > 0;
  if (info.api == GraphicsApi::vulkan && is_in_front) volume.depth_clamp = true;
  return volume;
}

// Where fragments may be: all of the target, and some px around it, if the sides don't clip.
Sides widest_sides(const DrawCall& call, const DriverInfo& info) {
  if (info.api == GraphicsApi::opengl) return {};
  const Viewport& port = call.viewport;
  const auto to_ndc = [](double px, int start, int size) { return 2 * (px - start) / size - 1; };
  Sides sides;
  sides.left = std::min(sides.left, to_ndc(-4, port.x, port.width));
  sides.right = std::max(sides.right, to_ndc(call.width + 4, port.x, port.width));
  sides.bottom = std::min(sides.bottom, to_ndc(-4, port.y, port.height));
  sides.top = std::max(sides.top, to_ndc(call.height + 4, port.y, port.height));
  return sides;
}

// The hits on a line that is alone, and what the rules ask of them.
class FragmentCount {
 public:
  FragmentCount(const DrawCall& call, const WindowLine& line, const Pixels& pixels, double margin,
                bool is_polygon)
      : call_(call), line_(line), pixels_(pixels), margin_(margin), is_polygon_(is_polygon) {
    const double dx = std::abs(line.b[0] - line.a[0]), dy = std::abs(line.b[1] - line.a[1]);
    major_ = dx >= dy ? 0 : 1;
    is_major_certain_ = std::abs(dx - dy) > 4 * margin;
  }

  void accuse(Accusations& accusations) {
    const int size = major_ == 0 ? call_.width : call_.height;
    int least = 0, hits = 0;
    std::optional<WorstPixel> lacking;
    for (int k = 0; k < size; ++k) {
      const std::vector<WorstPixel> in_column = hits_in_column(k);
      hits += static_cast<int>(in_column.size());
      if (in_column.size() > 1 && is_major_certain_ && !is_polygon_) {
        WorstPixel second = in_column[1];
        second.channel = major_;
        second.exact = 1;
        second.returned = static_cast<float>(in_column.size());
        accusations.add(0, Quantity::covered, ViolationKind::extra, second,
                        std::numeric_limits<double>::infinity());
      }
      if (!is_needed(k)) continue;
      ++least;
      if (in_column.empty() && !lacking) lacking = pixel_at(k);
    }
    if (hits >= least - 1 || !lacking) return;
    lacking->exact = least - 1;
    lacking->returned = static_cast<float>(hits);
    const auto kind = hits == 0 ? ViolationKind::primitive_lost : ViolationKind::missing;
    for (int i = hits; i < least - 1; ++i) {
      accusations.add(0, Quantity::covered, kind, *lacking, static_cast<double>(least - 1 - hits));
    }
  }

 private:
  std::size_t minor() const { return 1 - major_; }

  double minor_at(int k) const {
    const double length = line_.b[major_] - line_.a[major_];
    const double t = (k + 0.5 - line_.a[major_]) / length;
    return line_.a[minor()] + t * (line_.b[minor()] - line_.a[minor()]);
  }

  // Whether the column's centre is so far inside of the line, and the line so far inside of the
  // target there, that any rule has a fragment.
  bool is_needed(int k) const {
    const auto [first, last] = std::minmax(line_.a[major_], line_.b[major_]);
    const double centre = k + 0.5, inner = 0.5 + margin_;
    if (centre < first + inner || centre > last - inner) return false;
    const PixelBox box = visible_box(call_);
    const double low = major_ == 0 ? box.bottom : box.left,
                 high = major_ == 0 ? box.top : box.right;
    const double across = minor_at(k);
    const double to_centre = std::abs(across - std::floor(across) - 0.5);
    if (is_polygon_ && to_centre > 0.5 - 2 * margin_) return false;
    const bool is_in_box =
        major_ == 0 ? k >= box.left && k < box.right : k >= box.bottom && k < box.top;
    return is_in_box && across >= low + kReach && across <= high - kReach;
  }

  WorstPixel pixel_at(int k) const {
    const int across = static_cast<int>(std::floor(minor_at(k)));
    return major_ == 0 ? WorstPixel{k, across, 0, 1, 0} : WorstPixel{across, k, 0, 1, 0};
  }

  std::vector<WorstPixel> hits_in_column(int k) const {
    std::vector<WorstPixel> found;
    const int size = major_ == 0 ? call_.height : call_.width;
    for (int m = 0; m < size; ++m) {
      const int x = major_ == 0 ? k : m, y = major_ == 0 ? m : k;
      const float hits = pixels_.at(Quantity::hits, x, y);
      if (hits > 0) found.push_back({x, y, 0, 0, hits});
    }
    return found;
  }

  const DrawCall& call_;
  const WindowLine& line_;
  const Pixels& pixels_;
  double margin_;
  bool is_polygon_;  // has corners of its own, which are snapped
  std::size_t major_ = 0;
  bool is_major_certain_ = false;
};

}  // namespace

bool is_divided_by_zero(const DrawCall& call, std::span<const std::uint32_t> vertices,
                        const DriverInfo& info) {
  if (info.api != GraphicsApi::webgl || vertices.size() != 2) return false;
  const DrawVertex &a = call.vertices[vertices[0]], &b = call.vertices[vertices[1]];
  const Part part = part_between_planes(a, b, call.volume);
  if (part.s > part.t) return false;
  const double least = kEpsilon * std::max(std::abs(a.position[3]), std::abs(b.position[3]));
  return std::ranges::any_of(std::array{part.s, part.t}, [&](double t) {
    return (1 - t) * a.position[3] + t * b.position[3] <= least;
  });
}

Region line_region(const DrawCall& call, std::span<const std::uint32_t> vertices,
                   const DriverInfo& info) {
  Region region;
  region.is_degenerate = true;
  region.box = {0, call.width, 0, call.height};
  region.is_inside = is_in_volume(call.vertices[vertices[0]], call.volume) &&
                     is_in_volume(call.vertices[vertices[1]], call.volume);
  const double snap = snap_px(info);
  region.displacement_px = kReach + snap;
  const WindowLine line =
      window_line(call, vertices, widest_volume(call, vertices, info), widest_sides(call, info));
  region.is_discarded = line.is_empty && !line.is_uncertain;
  if (line.is_empty || line.is_uncertain) return region;
  const double nx = line.b[1] - line.a[1], ny = line.a[0] - line.b[0];
  const double size = std::max(std::abs(nx) + std::abs(ny), 1e-9);
  const auto add = [&](double a, double b, double c) {
    region.half_planes.push_back(
        {a, b, c + 0.5 * (a + b) + kReach, snap, line.rounding_px + kEpsilon * kReach});
  };
  const double offset = (nx * line.a[0] + ny * line.a[1]) / size;
  add(nx / size, ny / size, -offset);
  add(-nx / size, -ny / size, offset);
  add(1, 0, -std::min(line.a[0], line.b[0]));
  add(-1, 0, std::max(line.a[0], line.b[0]));
  add(0, 1, -std::min(line.a[1], line.b[1]));
  add(0, -1, std::max(line.a[1], line.b[1]));
  return region;
}

void judge_lines(const DrawCall& call, const std::vector<JudgedPrimitive>& primitives,
                 const Pixels& pixels, const DriverInfo& info, Accusations& accusations) {
  if (primitives.size() != 1 || primitives[0].vertices.size() != 2) return;
  const WindowLine line = window_line(call, primitives[0].vertices, call.volume, {});
  if (line.is_empty || line.is_uncertain) return;
  const bool is_polygon = info.api == GraphicsApi::vulkan;
  FragmentCount(call, line, pixels, snap_px(info) + line.rounding_px, is_polygon)
      .accuse(accusations);
}

}  // namespace clipscope::experiments
