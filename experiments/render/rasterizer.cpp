// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scanline rasterizer; see the header.
//
// Each edge is reduced to one number per row: the x at which it crosses the row of pixel centres,
// computed from its upper to its lower end, hence with the same bits for both triangles that share
// it. One of them fills up to that x, the other from it: no pixel is drawn twice or left out.
#include "experiments/render/rasterizer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace clipscope::experiments {
namespace {

// A vertex on the screen: x right and y down in pixels, and what is linear there.
struct Corner {
  double x = 0, y = 0, z = 0, inv_w = 0;
  ScreenAttributes over_w = {};
};

using Corners = std::array<Corner, 3>;

float far_depth(DepthRange range) { return range == DepthRange::reversed ? 0.0f : 1.0f; }

bool is_nearer(DepthRange range, float a, float b) {
  return range == DepthRange::reversed ? a > b : a < b;
}

Corner to_corner(const FrameBuffer& target, const ScreenVertex& v) {
  Corner c{(v.x * 0.5 + 0.5) * target.width, (0.5 - v.y * 0.5) * target.height, v.z, v.inv_w, {}};
  for (int k = 0; k < kScreenAttributes; ++k) c.over_w[k] = v.attributes[k] * v.inv_w;
  return c;
}

bool has_finite_position(const Corner& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && std::isfinite(c.inv_w);
}

// Twice the signed area of a, b and the point (x, y); positive where they turn clockwise as seen.
double doubled_area(const Corner& a, const Corner& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

// The first of `size` pixels whose centre is at or after the coordinate; `size` if there is none.
int first_pixel(double coordinate, int size) {
  if (!(coordinate > 0.5)) return 0;
  if (coordinate > size - 0.5) return size;
  return static_cast<int>(std::ceil(coordinate - 0.5));
}

// An edge that crosses rows: top.y < bottom.y.
struct Edge {
  double top_x, top_y, bottom_x, bottom_y;

  // Half open, as pixels are: of two edges that meet at a vertex one crosses the row through it.
  bool crosses(double y) const { return top_y <= y && y < bottom_y; }
  double x_at(double y) const {
    const double t = (y - top_y) / (bottom_y - top_y);
    const double x = top_x + t * (bottom_x - top_x);
    return std::clamp(x, std::min(top_x, bottom_x), std::max(top_x, bottom_x));
  }
};

Edge edge_between(const Corner& a, const Corner& b) {
  if (a.y <= b.y) return {a.x, a.y, b.x, b.y};
  return {b.x, b.y, a.x, a.y};
}

// Writes one pixel if it passes the depth test. The weights are clamped to the triangle, so that no
// rounding can take a value out of the range of the three corners.
void draw_pixel(FrameBuffer& target, std::size_t pixel, const Corners& c,
                const std::array<double, 3>& weight, std::uint32_t triangle, Facing facing) {
  const double sum = weight[0] + weight[1] + weight[2];
  const bool usable = sum > 0 && std::isfinite(sum);
  const double b = usable ? weight[1] / sum : 1.0 / 3;
  const double d = usable ? weight[2] / sum : 1.0 / 3;
  const double z = c[0].z + b * (c[1].z - c[0].z) + d * (c[2].z - c[0].z);
  const auto depth = static_cast<float>(z);
  if (target.covered(pixel) && !is_nearer(target.depth_range, depth, target.depth[pixel])) return;
  const double a = 1 - b - d;
  const double inv_w = a * c[0].inv_w + b * c[1].inv_w + d * c[2].inv_w;
  for (int k = 0; k < kScreenAttributes; ++k) {
    const double over_w = a * c[0].over_w[k] + b * c[1].over_w[k] + d * c[2].over_w[k];
    target.attributes[pixel][k] = over_w / inv_w;
  }
  target.depth[pixel] = depth;
  target.inv_w[pixel] = inv_w;
  target.triangle[pixel] = triangle;
  target.facing[pixel] = facing;
}

// The pixels [begin, end) of a row.
std::pair<int, int> span_at(const std::array<Edge, 3>& edges, double y, int width) {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (const Edge& edge : edges) {
    if (edge.crosses(y)) {
      const double x = edge.x_at(y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
  }
  return {first_pixel(left, width), first_pixel(right, width)};
}

void draw_triangle(FrameBuffer& target, const Corners& c, std::uint32_t triangle) {
  const double area = doubled_area(c[0], c[1], c[2].x, c[2].y);
  if (!std::isfinite(area)) {
    ++target.not_finite;
    return;
  }
  if (area == 0) return;
  const double sign = area > 0 ? 1 : -1;
  const Facing facing = area < 0 ? Facing::front : Facing::back;
  const std::array<Edge, 3> edges = {edge_between(c[0], c[1]), edge_between(c[1], c[2]),
                                     edge_between(c[2], c[0])};
  const int row_begin = first_pixel(std::min({c[0].y, c[1].y, c[2].y}), target.height);
  const int row_end = first_pixel(std::max({c[0].y, c[1].y, c[2].y}), target.height);
  for (int row = row_begin; row < row_end; ++row) {
    const double y = row + 0.5;
    const auto [begin, end] = span_at(edges, y, target.width);
    for (int column = begin; column < end; ++column) {
      const double x = column + 0.5;
      const std::array<double, 3> weight = {std::max(0.0, sign * doubled_area(c[1], c[2], x, y)),
                                            std::max(0.0, sign * doubled_area(c[2], c[0], x, y)),
                                            std::max(0.0, sign * doubled_area(c[0], c[1], x, y))};
      const auto pixel = static_cast<std::size_t>(row) * target.width + column;
      draw_pixel(target, pixel, c, weight, triangle, facing);
    }
  }
}

}  // namespace

FrameBuffer::FrameBuffer(int width_px, int height_px, DepthRange range)
    : width(width_px), height(height_px), depth_range(range) {
  assert(width >= 1 && height >= 1);
  const auto n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  depth.assign(n, far_depth(range));
  inv_w.assign(n, 0.0);
  attributes.assign(n, {});
  triangle.assign(n, kNoTriangle);
  facing.assign(n, Facing::none);
}

bool FrameBuffer::finite(std::size_t pixel) const {
  return std::isfinite(depth[pixel]) &&
         std::ranges::all_of(attributes[pixel], [](double a) { return std::isfinite(a); });
}

void draw_polygon(FrameBuffer& target, std::span<const ScreenVertex> polygon,
                  std::uint32_t triangle) {
  if (polygon.size() < 3) return;
  Corners corners = {to_corner(target, polygon[0]), to_corner(target, polygon[1]), {}};
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    corners[2] = to_corner(target, polygon[i]);
    if (std::ranges::all_of(corners, has_finite_position)) {
      draw_triangle(target, corners, triangle);
    } else {
      ++target.not_finite;
    }
    corners[1] = corners[2];
  }
}

}  // namespace clipscope::experiments
