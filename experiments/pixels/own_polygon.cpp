// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/own_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace clipscope::experiments {
namespace {

// From the middle of the viewport: far enough that a picture hardly ever needs it, near enough that
// products of grid coordinates fit into 64 bits.
constexpr double kGuardBandPx = 0x1p18;

// Weights of two ends. Each has a division of its own: 1 - t would lose the smaller one.
struct Ends {
  double from = 0, to = 0;
};

template <std::size_t n>
void blend(std::array<double, n>& to, const std::array<double, n>& from, const Ends& ends) {
  for (std::size_t i = 0; i < n; ++i) to[i] = ends.from * from[i] + ends.to * to[i];
}

OwnVertex between(const OwnVertex& from, OwnVertex to, const Ends& ends) {
  blend(to.position, from.position, ends);
  blend(to.varying, from.varying, ends);
  blend(to.varying_w, from.varying_w, ends);
  blend(to.distances, from.distances, ends);
  return to;
}

using Distance = std::function<double(const OwnVertex&)>;

// From the inside to the outside end, so that both triangles of an edge get the same vertex.
OwnVertex crossing(const OwnVertex& a, const OwnVertex& b, double d_a, double d_b) {
  if (d_a < 0) return crossing(b, a, d_b, d_a);
  return between(a, b, {-d_b / (d_a - d_b), d_a / (d_a - d_b)});
}

void cut(OwnPolygon& polygon, const Distance& distance) {
  std::vector<OwnVertex> kept;
  const std::size_t n = polygon.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const OwnVertex& a = polygon.vertices[i];
    const OwnVertex& b = polygon.vertices[(i + 1) % n];
    const double d_a = distance(a), d_b = distance(b);
    if (d_a >= 0) kept.push_back(a);
    if (d_a < 0) polygon.is_clipped = true;
    const bool is_last_of_open = n < 3 && i + 1 == n;  // a point or a line
    if ((d_a >= 0) != (d_b >= 0) && !is_last_of_open) kept.push_back(crossing(a, b, d_a, d_b));
  }
  polygon.vertices = std::move(kept);
}

std::vector<Distance> planes_of(const DrawCall& call, RasterFault fault) {
  std::vector<Distance> planes;
  const bool is_symmetric = call.volume.depth == DepthRange::minus_one_to_one;
  if (!call.volume.depth_clamp.near && fault != RasterFault::near_unclipped) {
    planes.emplace_back([is_symmetric](const OwnVertex& v) {
      return is_symmetric ? v.position[3] + v.position[2] : v.position[2];
    });
  }
  if (!call.volume.depth_clamp.far) {
    planes.emplace_back([](const OwnVertex& v) { return v.position[3] - v.position[2]; });
  }
  const int ignored = fault == RasterFault::clip_distance_ignored ? 1 : 0;
  for (int c = 0; c < call.volume.clip_distances - ignored; ++c) {
    planes.emplace_back(
        [c](const OwnVertex& v) { return v.distances[static_cast<std::size_t>(c)]; });
  }
  return planes;
}

void add_guard_band(std::vector<Distance>& planes, const Viewport& port) {
  const double times_side = kGuardBandPx / std::max(port.width, port.height);
  for (const std::size_t axis : {0, 1}) {
    for (const double sign : {-1.0, 1.0}) {
      planes.emplace_back([axis, sign, times_side](const OwnVertex& v) {
        return times_side * v.position[3] + sign * v.position[axis];
      });
    }
  }
}

// With bits of 12 px, as a counter that is too short.
std::int64_t wrapped(std::int64_t x) {
  constexpr std::int64_t kRange = 4096 * kGrid;
  return ((x + kRange / 2) % kRange + kRange) % kRange - kRange / 2;
}

std::int64_t on_grid(double px, int bits, RasterFault fault) {
  const double steps = std::ldexp(1.0, fault == RasterFault::fewer_bits ? 2 : bits);
  const double snapped = std::nearbyint(px * steps) * (static_cast<double>(kGrid) / steps);
  if (fault != RasterFault::guard_band_wraps) return static_cast<std::int64_t>(snapped);
  return wrapped(static_cast<std::int64_t>(std::clamp(snapped, -0x1p60, 0x1p60)));
}

}  // namespace

OwnPolygon own_polygon(const DrawCall& call, const std::vector<std::uint32_t>& numbers,
                       RasterFault fault) {
  OwnPolygon polygon;
  for (const std::uint32_t number : numbers) {
    const DrawVertex& given = call.vertices[number];
    OwnVertex v;
    std::copy(given.position.begin(), given.position.end(), v.position.begin());
    if (fault == RasterFault::absolute_w) v.position[3] = std::abs(v.position[3]);
    for (std::size_t c = 0; c < v.varying.size(); ++c) {
      v.varying[c] = given.varying[c];
      v.varying_w[c] = v.varying[c] * v.position[3];
    }
    std::copy(given.clip_distances.begin(), given.clip_distances.end(), v.distances.begin());
    polygon.vertices.push_back(v);
  }
  return polygon;
}

void clip_own(OwnPolygon& polygon, const DrawCall& call, RasterFault fault) {
  std::vector<Distance> planes = planes_of(call, fault);
  const bool is_point = polygon.vertices.size() == 1;
  if (!is_point && fault != RasterFault::guard_band_wraps) add_guard_band(planes, call.viewport);
  // What the planes leave has w >= 0, and 0 only where all of them meet.
  planes.emplace_back([](const OwnVertex& v) { return v.position[3] - 0x1p-120; });
  for (const Distance& distance : planes) {
    cut(polygon, distance);
    if (polygon.vertices.empty()) return;
  }
}

void snap_own(OwnPolygon& polygon, const DrawCall& call, int bits, RasterFault fault) {
  const Viewport& port = call.viewport;
  polygon.grid.clear();
  for (const OwnVertex& v : polygon.vertices) {
    const double x_ndc = v.position[0] / v.position[3], y_ndc = v.position[1] / v.position[3];
    polygon.grid.push_back({on_grid(port.x + (x_ndc + 1) / 2 * port.width, bits, fault),
                            on_grid(port.y + (y_ndc + 1) / 2 * port.height, bits, fault)});
  }
}

}  // namespace clipscope::experiments
