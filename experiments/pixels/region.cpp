// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/region.hpp"

#include <array>
#include <limits>

#include "experiments/pixels/cuts.hpp"
#include "experiments/pixels/volume_planes.hpp"

namespace clipscope::experiments {
namespace {

// A function of (x_ndc, y_ndc, 1), and the same with all its terms positive where both are at most
// 1 in magnitude.
struct Form {
  double x = 0, y = 0, w = 0, size = 0;

  Form& operator+=(const Form& other) {
    x += other.x;
    y += other.y;
    w += other.w;
    size += other.size;
    return *this;
  }
};

Form scaled(const Form& f, double factor, double size) {
  return {f.x * factor, f.y * factor, f.w * factor, f.size * size};
}

Form cross(const DrawVertex& p, const DrawVertex& q) {
  const double px = p.position[0], py = p.position[1], pw = p.position[3];
  const double qx = q.position[0], qy = q.position[1], qw = q.position[3];
  return {py * qw - pw * qy, pw * qx - px * qw, px * qy - py * qx,
          std::abs(py * qw) + std::abs(pw * qy) + std::abs(pw * qx) + std::abs(px * qw) +
              std::abs(px * qy) + std::abs(py * qx)};
}

double length_of(const Form& f) { return std::abs(f.x) + std::abs(f.y) + std::abs(f.w); }

struct Margins {
  double snap_px = 0;
  double relative = 0;  // of a form's size
  double window_px = 0;
};

HalfPlane half_plane(const Form& f, const Viewport& port, const Margins& margins) {
  HalfPlane h;
  h.a = 2 * f.x / port.width;
  h.b = 2 * f.y / port.height;
  h.c = f.x * ((1.0 - 2.0 * port.x) / port.width - 1) +
        f.y * ((1.0 - 2.0 * port.y) / port.height - 1) + f.w;
  const double per_px = std::abs(h.a) + std::abs(h.b);
  h.snap = margins.snap_px * per_px + 0x1p-48 * f.size;  // the latter for doubles
  h.slack = margins.relative * f.size + margins.window_px * per_px;
  return h;
}

struct WindowPoint {
  double x = 0, y = 0;
  double reach = 0;  // how far from there it may be, px
};

WindowPoint window_point(const DrawVertex& v, const Viewport& port, const Margins& margins,
                         int operations) {
  const double x = v.position[0] / static_cast<double>(v.position[3]);
  const double y = v.position[1] / static_cast<double>(v.position[3]);
  const double size = std::max(std::abs(x) * port.width, std::abs(y) * port.height);
  return {port.x + (x + 1) / 2 * port.width, port.y + (y + 1) / 2 * port.height,
          margins.snap_px + margins.window_px + kEpsilon * operations * size};
}

int to_pixel(double px) { return static_cast<int>(std::clamp(px, -1e9, 1e9)); }

// Nothing less than a px around what lies between the points.
PixelBox around(const std::vector<WindowPoint>& points, PixelBox box) {
  double left = std::numeric_limits<double>::infinity(), bottom = left;
  double right = -left, top = -left;
  for (const WindowPoint& p : points) {
    left = std::min(left, p.x - p.reach);
    right = std::max(right, p.x + p.reach);
    bottom = std::min(bottom, p.y - p.reach);
    top = std::max(top, p.y + p.reach);
  }
  box.left = std::max(box.left, to_pixel(std::floor(left)) - 1);
  box.right = std::min(box.right, to_pixel(std::ceil(right)) + 1);
  box.bottom = std::max(box.bottom, to_pixel(std::floor(bottom)) - 1);
  box.top = std::min(box.top, to_pixel(std::ceil(top)) + 1);
  return box;
}

Margins margins_of(const DrawCall& call, const DriverInfo& info, bool is_clipped) {
  return {snap_px(info), kEpsilon * 2 * operations(is_clipped),
          kEpsilon * farthest_px(call.viewport)};
}

// Both sides of the line that all vertices lie on; if they are one point, the box must do. What
// lies between vertices with w > 0 has no greater (|x|, |y|, w) / w than one of them, so that its
// error in the line's function is bounded by theirs. Where a vertex has w <= 0 there is no such
// bound: if the triangle contains the eye, what is clipped there is a quotient of nothings.
void add_line(Region& region, const std::array<const DrawVertex*, 3>& v, const DrawCall& call,
              const Margins& margins) {
  region.is_degenerate = true;
  Form line;
  double greatest = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [x, y, z, w] = v[i]->position;
    if (w <= 0) return;
    greatest = std::max(greatest, static_cast<double>(std::max(std::abs(x), std::abs(y))) / w);
    const Form f = cross(*v[i], *v[(i + 1) % 3]);
    if (length_of(f) > length_of(line)) line = f;
  }
  line.size = std::max(line.size, length_of(line) * greatest);
  region.half_planes.push_back(half_plane(line, call.viewport, margins));
  region.half_planes.push_back(half_plane(scaled(line, -1, 1), call.viewport, margins));
}

bool has_twins(const std::array<const DrawVertex*, 3>& v) {
  return v[0]->position == v[1]->position || v[1]->position == v[2]->position ||
         v[2]->position == v[0]->position;
}

// Near, far and clip distances, then the sides. The viewport's sides are exact, but the vertices
// that are made on them are not.
PlaneValues all_planes(const ClipVolume& volume) {
  PlaneValues planes = planes_in(volume);
  for (const std::size_t axis : {0, 1}) {
    for (const double sign : {-1.0, 1.0}) {
      planes.emplace_back([axis, sign](const DrawVertex& v) {
        const double c = v.position[axis], w = v.position[3];
        return PlaneValue{w + sign * c, std::abs(w) + std::abs(c)};
      });
    }
  }
  return planes;
}

// Of a triangle that is clipped. A plane that all of it is in may cut it, too, where it is cut by
// others before: what they make is in that plane up to rounding.
void add_planes(Region& region, const std::array<const DrawVertex*, 3>& v, const DrawCall& call,
                const Margins& margins, const std::array<Form, 3>& edges, const Cuts& cuts) {
  const auto& [x, y, z, w] = v[0]->position;
  const double det = edges[0].x * x + edges[0].y * y + edges[0].w * w;
  for (const auto& distance : all_planes(call.volume)) {
    Form f;
    std::array<double, 3> d = {};
    bool is_needed = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const PlaneValue at = distance(*v[i]);
      f += scaled(edges[i], at.value, at.size);
      d[i] = at.value;
      is_needed = is_needed || at.value < 0 || (at.value == 0 && at.size > 0);
    }
    if (!is_needed) continue;
    HalfPlane h = half_plane(f, call.viewport, margins);
    h.slack += det * cuts.slack(d);
    region.half_planes.push_back(h);
  }
}

std::array<Form, 3> add_edges(Region& region, const std::array<const DrawVertex*, 3>& v,
                              const DrawCall& call, const Margins& margins, int orientation) {
  std::array<Form, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) {
    edges[i] = scaled(cross(*v[(i + 1) % 3], *v[(i + 2) % 3]), orientation, 1);
    region.half_planes.push_back(half_plane(edges[i], call.viewport, margins));
  }
  return edges;
}

}  // namespace

PixelBox visible_box(const DrawCall& call) {
  const Viewport& port = call.viewport;
  return {std::max(0, port.x), std::min(call.width, port.x + port.width), std::max(0, port.y),
          std::min(call.height, port.y + port.height)};
}

bool is_in_volume(const DrawVertex& vertex, const ClipVolume& volume) {
  const auto& [x, y, z, w] = vertex.position;
  if (std::abs(x) > w || std::abs(y) > w) return false;
  const auto distances = planes_in(volume);
  return std::all_of(distances.begin(), distances.end(),
                     [&](const auto& distance) { return distance(vertex).value >= 0; });
}

Region triangle_region(const DrawCall& call, std::span<const std::uint32_t> vertices,
                       const DriverInfo& info, int orientation) {
  Region region;
  const std::array<const DrawVertex*, 3> v = {
      &call.vertices[vertices[0]], &call.vertices[vertices[1]], &call.vertices[vertices[2]]};
  region.is_inside = std::all_of(v.begin(), v.end(), [&](const DrawVertex* vertex) {
    return is_in_volume(*vertex, call.volume);
  });
  const Margins margins = margins_of(call, info, !region.is_inside);
  const int steps = operations(!region.is_inside);
  std::vector<WindowPoint> points;
  for (const DrawVertex* vertex : v) {
    if (vertex->position[3] > 0) {
      points.push_back(window_point(*vertex, call.viewport, margins, steps));
    }
  }
  region.box = visible_box(call);
  region.certain = region.box;
  region.displacement_px = margins.snap_px + margins.window_px +
                           kEpsilon * steps * std::max(call.viewport.width, call.viewport.height);
  if (orientation == 0) {
    add_line(region, v, call, margins);
    region.is_discarded = region.is_inside && has_twins(v);
  } else {
    const auto edges = add_edges(region, v, call, margins, orientation);
    if (!region.is_inside) add_planes(region, v, call, margins, edges, Cuts(call, vertices));
  }
  if (points.empty()) region.is_discarded = true;
  if (points.size() == 3) region.box = around(points, region.box);
  return region;
}

Region point_region(const DrawCall& call, std::uint32_t vertex, const DriverInfo& info) {
  Region region;
  const DrawVertex& v = call.vertices[vertex];
  region.is_inside = is_in_volume(v, call.volume);
  const Margins margins = margins_of(call, info, false);
  const auto& [x, y, z, w] = v.position;
  region.box = {0, call.width, 0, call.height};
  region.certain = visible_box(call);
  const bool is_vulkan = info.api == GraphicsApi::vulkan;
  const bool is_decided = !is_vulkan || info.points_clip_at_sides;
  const auto distances = planes_in(call.volume);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const PlaneValue d = distances[i](v);
    if (d.value >= 0) continue;
    const bool is_user =
        i + static_cast<std::size_t>(call.volume.clip_distances) >= distances.size();
    const bool is_near = std::abs(d.value) <= kEpsilon * d.size && !is_user;
    (is_near || (!is_user && !is_decided) ? region.is_degenerate : region.is_discarded) = true;
  }
  const double beside = std::max(std::abs(x), std::abs(y)) - static_cast<double>(w);
  if (beside > 0) {
    const bool is_clipped = is_vulkan && info.points_clip_at_sides &&
                            beside > 2 * kEpsilon * std::abs(static_cast<double>(w));
    const bool is_kept = is_vulkan && !info.points_clip_at_sides;
    if (is_clipped) region.is_discarded = true;
    if (!is_clipped && !is_kept) region.is_degenerate = true;
  }
  if (w <= 0) {
    region.is_degenerate = true;
    return region;
  }
  const WindowPoint p = window_point(v, call.viewport, margins, kTransform);
  const double half = static_cast<double>(call.point_size) / 2;
  const double slack = p.reach - margins.snap_px + kEpsilon * half;
  region.half_planes = {{1, 0, 0.5 - (p.x - half), margins.snap_px, slack},
                        {-1, 0, p.x + half - 0.5, margins.snap_px, slack},
                        {0, 1, 0.5 - (p.y - half), margins.snap_px, slack},
                        {0, -1, p.y + half - 0.5, margins.snap_px, slack}};
  region.displacement_px = p.reach;
  region.box = around({{p.x, p.y, p.reach + half}}, region.box);
  return region;
}

double standing_at(const Region& region, int x, int y) {
  double least = std::numeric_limits<double>::max();
  for (const HalfPlane& h : region.half_planes) {
    if (h.margin() > 0) least = std::min(least, h.at(x, y) / h.margin());
  }
  return region.is_discarded || !region.box.contains(x, y) ? std::min(least, -2.0) : least;
}

Coverage coverage_at(const Region& region, int x, int y) {
  if (!region.box.contains(x, y)) return Coverage::outside;
  std::vector<Coverage> row;
  Region one = region;
  one.box.left = x;
  one.box.right = x + 1;
  coverage_of_row(one, y, row);
  return row[0];
}

void coverage_of_row(const Region& region, int y, std::vector<Coverage>& row) {
  const auto n = static_cast<std::size_t>(std::max(0, region.box.right - region.box.left));
  row.assign(n, Coverage::undecided);
  if (region.is_discarded) {
    row.assign(n, Coverage::outside);
    return;
  }
  constexpr double kFar = std::numeric_limits<double>::max();
  thread_local std::vector<double> in, out, in_by_bits, out_by_bits;
  for (auto* least : {&in, &out, &in_by_bits, &out_by_bits}) least->assign(n, kFar);
  for (const HalfPlane& h : region.half_planes) {
    const double start = h.at(region.box.left, y);
    for (std::size_t i = 0; i < n; ++i) {
      const double d = start + h.a * static_cast<double>(i);
      in[i] = std::min(in[i], d - h.margin());
      out[i] = std::min(out[i], d + h.margin());
      in_by_bits[i] = std::min(in_by_bits[i], d - h.snap);
      out_by_bits[i] = std::min(out_by_bits[i], d + h.snap);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const int x = region.box.left + static_cast<int>(i);
    const bool is_certain = !region.is_degenerate && region.certain.contains(x, y);
    if (out[i] < 0) {
      row[i] = Coverage::outside;
    } else if (out_by_bits[i] < 0) {
      row[i] = Coverage::nearly_outside;
    } else if (is_certain && in[i] >= 0) {
      row[i] = Coverage::covered;
    } else if (is_certain && in_by_bits[i] >= 0) {
      row[i] = Coverage::nearly_covered;
    }
  }
}

}  // namespace clipscope::experiments
