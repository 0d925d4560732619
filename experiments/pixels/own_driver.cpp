// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/own_driver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/pixels/own_polygon.hpp"

namespace clipscope::experiments {
namespace {

// Weights of three of a polygon's vertices; the weights are >= 0 and their sum is 1.
struct Blend {
  std::array<std::size_t, 3> vertices = {};
  std::array<double, 3> weights = {1, 0, 0};
};

double cross(const GridPoint& o, const GridPoint& a, const GridPoint& b) {
  return static_cast<double>((a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x));
}

double doubled_area(const std::vector<GridPoint>& grid) {
  double area = 0;
  for (std::size_t i = 1; i + 1 < grid.size(); ++i) area += cross(grid[0], grid[i], grid[i + 1]);
  return area;
}

// Of the fan's triangles the one that p is deepest in.
Blend blend_at(const std::vector<GridPoint>& grid, const GridPoint& p) {
  Blend best;
  double deepest = -1e300;
  for (std::size_t i = 1; i + 1 < grid.size(); ++i) {
    const double area = cross(grid[0], grid[i], grid[i + 1]);
    if (area == 0) continue;
    const std::array<double, 3> w = {cross(p, grid[i], grid[i + 1]) / area,
                                     cross(p, grid[i + 1], grid[0]) / area,
                                     cross(p, grid[0], grid[i]) / area};
    const double depth = *std::min_element(w.begin(), w.end());
    if (depth <= deepest) continue;
    deepest = depth;
    best = {{0, i, i + 1}, w};
  }
  return best;
}

Blend inside_of_triangle(Blend blend) {
  double sum = 0;
  for (double& weight : blend.weights) sum += weight = std::max(weight, 0.0);
  for (double& weight : blend.weights) weight /= sum;
  return blend;
}

// Whether p is on or right of the line through the edge's ends; lower end first.
struct Edge {
  GridPoint low, high;
  bool crosses_row(std::int64_t y) const { return low.y <= y && y < high.y; }
  bool is_left_of(const GridPoint& p) const { return side(p) >= 0; }
  bool contains(const GridPoint& p) const {
    const auto [left, right] = std::minmax(low.x, high.x);
    return low.y <= p.y && p.y <= high.y && left <= p.x && p.x <= right && side(p) == 0;
  }
  std::int64_t side(const GridPoint& p) const {
    return (p.x - low.x) * (high.y - low.y) - (p.y - low.y) * (high.x - low.x);
  }
};

std::vector<Edge> edges_of(const std::vector<GridPoint>& grid) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    Edge edge{grid[i], grid[(i + 1) % grid.size()]};
    if (edge.high.y < edge.low.y) std::swap(edge.low, edge.high);
    edges.push_back(edge);
  }
  return edges;
}

GridPoint centre_of(int x, int y) { return {x * kGrid + kGrid / 2, y * kGrid + kGrid / 2}; }

class Painter {
 public:
  Painter(const DrawCall& call, const DriverInfo& info, RasterFault fault)
      : call_(call), info_(info), fault_(fault) {
    pixels_.width = call.width;
    pixels_.height = call.height;
    for (std::size_t q = 0; q < kQuantities; ++q) {
      const auto quantity = static_cast<Quantity>(q);
      const bool is_always = quantity == Quantity::covered || quantity == Quantity::hits;
      if (!is_always && !call.quantities[q]) continue;
      pixels_.values[q].assign(
          static_cast<std::size_t>(call.width * call.height) * channels(quantity),
          quantity == Quantity::depth ? kNoDepth : 0.0f);
    }
  }

  Pixels paint() {
    const auto primitives = primitives_of(call_);
    for (number_ = 0; number_ < primitives.size(); ++number_) {
      polygon_ = own_polygon(call_, primitives[number_], fault_);
      if (is_dropped()) continue;
      if (polygon_.vertices.size() == 1) paint_point();
      if (polygon_.vertices.size() == 2) paint_line();
      if (polygon_.vertices.size() == 3) paint_triangle();
    }
    return std::move(pixels_);
  }

 private:
  bool is_dropped() const {
    if (fault_ != RasterFault::far_vertex_dropped) return false;
    return std::any_of(polygon_.vertices.begin(), polygon_.vertices.end(), [](const OwnVertex& v) {
      return std::max(std::abs(v.position[0]), std::abs(v.position[1])) > 64 * v.position[3];
    });
  }

  // The pixels of the viewport that the target has, at most.
  struct Box {
    std::int64_t left, right, bottom, top;
  };
  Box box_around(double reach, bool is_scissored) const {
    const Viewport& port = call_.viewport;
    Box box{0, call_.width, 0, call_.height};
    if (is_scissored) {
      box.left = std::max<std::int64_t>(box.left, port.x);
      box.bottom = std::max<std::int64_t>(box.bottom, port.y);
      box.right = std::min<std::int64_t>(box.right, port.x + port.width);
      box.top = std::min<std::int64_t>(box.top, port.y + port.height);
    }
    const auto by_x = [](const GridPoint& a, const GridPoint& b) { return a.x < b.x; };
    const auto by_y = [](const GridPoint& a, const GridPoint& b) { return a.y < b.y; };
    const auto& grid = polygon_.grid;
    const auto [left, right] = std::minmax_element(grid.begin(), grid.end(), by_x);
    const auto [low, high] = std::minmax_element(grid.begin(), grid.end(), by_y);
    const auto px = static_cast<std::int64_t>(std::ceil(reach)) + 1;
    box.left = std::max(box.left, left->x / kGrid - px);
    box.right = std::min(box.right, right->x / kGrid + px + 1);
    box.bottom = std::max(box.bottom, low->y / kGrid - px);
    box.top = std::min(box.top, high->y / kGrid + px + 1);
    return box;
  }

  void paint_triangle() {
    const bool has_no_area = is_flat();
    clip_own(polygon_, call_, fault_);
    if (polygon_.vertices.size() < 3) return;
    snap_own(polygon_, call_, info_.subpixel_bits, fault_);
    is_front_ = doubled_area(polygon_.grid) > 0;
    if (fault_ == RasterFault::facing_of_clipped && polygon_.is_clipped) is_front_ = !is_front_;
    const std::vector<Edge> edges = edges_of(polygon_.grid);
    const bool is_whole_box = has_no_area && fault_ == RasterFault::zero_area_drawn;
    const Box box = box_around(0, true);
    for (std::int64_t y = box.bottom; y < box.top; ++y) {
      for (std::int64_t x = box.left; x < box.right; ++x) {
        const GridPoint centre = centre_of(static_cast<int>(x), static_cast<int>(y));
        if (!is_whole_box && !is_in(edges, centre)) continue;
        fragment(static_cast<int>(x), static_cast<int>(y), blend_in_triangle(centre));
      }
    }
  }

  bool is_flat() const {
    const auto& v = polygon_.vertices;
    const auto minor = [&](std::size_t a, std::size_t b) {
      return v[a].position[0] * v[b].position[1] - v[a].position[1] * v[b].position[0];
    };
    return minor(0, 1) * v[2].position[3] + minor(1, 2) * v[0].position[3] +
               minor(2, 0) * v[1].position[3] ==
           0;
  }

  bool is_in(const std::vector<Edge>& edges, const GridPoint& p) const {
    const bool is_changed =
        fault_ == RasterFault::edges_drawn_twice || fault_ == RasterFault::edges_never_drawn;
    bool is_odd = false;
    for (const Edge& edge : edges) {
      if (is_changed && edge.contains(p)) return fault_ == RasterFault::edges_drawn_twice;
      if (edge.crosses_row(p.y) && edge.is_left_of(p)) is_odd = !is_odd;
    }
    return is_odd;
  }

  Blend blend_in_triangle(const GridPoint& centre) const {
    if (fault_ != RasterFault::extrapolated) {
      return inside_of_triangle(blend_at(polygon_.grid, centre));
    }
    return blend_at(polygon_.grid, {centre.x + 2 * kGrid, centre.y + 2 * kGrid});
  }

  void paint_point() {
    clip_own(polygon_, call_, fault_);
    if (polygon_.vertices.empty()) return;
    const auto& position = polygon_.vertices[0].position;
    const bool is_beside = std::max(std::abs(position[0]), std::abs(position[1])) > position[3];
    // Implementations may do so under OpenGL, and here do where coordinates need it.
    if (is_beside && (info_.points_clip_at_sides || is_far(position))) return;
    snap_own(polygon_, call_, info_.subpixel_bits, fault_);
    is_front_ = true;
    const auto half = static_cast<std::int64_t>(call_.point_size * (kGrid / 2));
    const GridPoint middle = polygon_.grid[0];
    const Box box = box_around(call_.point_size / 2, false);
    for (std::int64_t y = box.bottom; y < box.top; ++y) {
      for (std::int64_t x = box.left; x < box.right; ++x) {
        const GridPoint centre = centre_of(static_cast<int>(x), static_cast<int>(y));
        const bool is_covered = middle.x - half <= centre.x && centre.x < middle.x + half &&
                                middle.y - half <= centre.y && centre.y < middle.y + half;
        if (is_covered) fragment(static_cast<int>(x), static_cast<int>(y), Blend{});
      }
    }
  }

  static bool is_far(const std::array<double, 4>& position) {
    return std::max(std::abs(position[0]), std::abs(position[1])) > 4096 * position[3];
  }

  void paint_line() {
    clip_own(polygon_, call_, fault_);
    if (polygon_.vertices.size() < 2) return;
    snap_own(polygon_, call_, info_.subpixel_bits, fault_);
    is_front_ = true;
    const GridPoint a = polygon_.grid[0], b = polygon_.grid[1];
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const bool is_x_major = std::abs(dx) >= std::abs(dy);
    const std::int64_t length = is_x_major ? dx : dy;
    if (length == 0) return;
    const Box box = box_around(1, true);
    const std::int64_t from = is_x_major ? a.x : a.y;
    const auto first = is_x_major ? box.left : box.bottom;
    const auto end = is_x_major ? box.right : box.top;
    for (std::int64_t major = first; major < end; ++major) {
      const std::int64_t along = (major * kGrid + kGrid / 2 - from) * (length > 0 ? 1 : -1);
      if (along < 0 || along >= std::abs(length)) continue;
      const double t = static_cast<double>(along) / static_cast<double>(std::abs(length));
      const double across = is_x_major ? static_cast<double>(a.y) + t * static_cast<double>(dy)
                                       : static_cast<double>(a.x) + t * static_cast<double>(dx);
      const auto minor = static_cast<std::int64_t>(std::floor(across / kGrid));
      const std::int64_t x = is_x_major ? major : minor, y = is_x_major ? minor : major;
      if (x < box.left || x >= box.right || y < box.bottom || y >= box.top) continue;
      fragment(static_cast<int>(x), static_cast<int>(y), {{0, 1, 1}, {1 - t, t, 0}});
    }
  }

  // The sum of what `of` gives for each vertex, by the weights.
  template <class Of>
  double linear(const Blend& blend, Of&& of) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const OwnVertex& v = polygon_.vertices[blend.vertices[k] % polygon_.vertices.size()];
      sum += blend.weights[k] * of(v);
    }
    return sum;
  }

  void fragment(int x, int y, const Blend& blend) {
    if (fault_ == RasterFault::row_missing && y == call_.height / 3) return;
    pixel_ = static_cast<std::size_t>(y) * static_cast<std::size_t>(call_.width) +
             static_cast<std::size_t>(x);
    put(Quantity::covered, 0, 1);
    auto& hits = pixels_.values[bit(Quantity::hits)];
    ++hits[2 * pixel_];
    if (is_front_) ++hits[2 * pixel_ + 1];
    put(Quantity::facing, 0, is_front_ ? 1 : -1);
    const bool is_one_off = fault_ == RasterFault::primitive_id_off && number_ > 0;
    put(Quantity::primitive_id, 0, static_cast<double>(number_ + (is_one_off ? 1 : 0)));
    put_varyings(blend);
    put_depth(x, y, blend);
  }

  void put_varyings(const Blend& blend) {
    const double inv_w = linear(blend, [](const OwnVertex& v) { return 1 / v.position[3]; });
    const bool is_affine = fault_ == RasterFault::smooth_affine;
    const bool is_nan = fault_ == RasterFault::noperspective_nan && polygon_.is_clipped;
    for (std::size_t c = 0; c < 4; ++c) {
      const double flat = call_.vertices[flat_vertex()].varying[c];
      const double straight =
          linear(blend, [c](const OwnVertex& v) { return v.varying_w[c] / v.position[3]; });
      const double smooth =
          linear(blend, [c](const OwnVertex& v) { return v.varying[c] / v.position[3]; }) / inv_w;
      put(Quantity::flat, c, flat);
      put(Quantity::smooth, c, is_affine ? straight : smooth);
      put(Quantity::noperspective, c, is_nan ? std::nan("") : straight);
    }
    for (std::size_t c = 0; c < kMaxClipDistances; ++c) {
      const double distance =
          linear(blend, [c](const OwnVertex& v) { return v.distances[c] / v.position[3]; }) / inv_w;
      put(Quantity::clip_distances, c, distance);
    }
  }

  std::uint32_t flat_vertex() const {
    if (fault_ != RasterFault::flat_of_other_vertex) return provoking_vertex(call_, number_);
    DrawCall other = call_;
    const bool is_first = call_.provoking == ProvokingVertex::first;
    other.provoking = is_first ? ProvokingVertex::last : ProvokingVertex::first;
    return provoking_vertex(other, number_);
  }

  void put_depth(int x, int y, const Blend& blend) {
    const bool is_symmetric = call_.volume.depth == DepthRange::minus_one_to_one;
    const double inv_w = linear(blend, [](const OwnVertex& v) { return 1 / v.position[3]; });
    const double z =
        linear(blend, [](const OwnVertex& v) { return v.position[2] / v.position[3]; });
    const double depth = is_symmetric ? (z + 1) / 2 : z;
    const bool is_kept = fault_ == RasterFault::depth_unclamped && call_.volume.depth_clamp;
    put(Quantity::frag_coord, 0, x + 0.5);
    put(Quantity::frag_coord, 1, y + 0.5);
    put(Quantity::frag_coord, 2, depth);
    put(Quantity::frag_coord, 3, fault_ == RasterFault::w_not_reciprocal ? 1 / inv_w : inv_w);
    put(Quantity::depth, 0, is_kept ? depth : std::clamp(depth, 0.0, 1.0));
  }

  void put(Quantity quantity, std::size_t channel, double value) {
    std::vector<float>& values = pixels_.values[bit(quantity)];
    if (values.empty()) return;
    values[pixel_ * channels(quantity) + channel] = static_cast<float>(value);
  }

  const DrawCall& call_;
  const DriverInfo& info_;
  RasterFault fault_;
  Pixels pixels_;
  std::size_t number_ = 0;  // of the primitive
  OwnPolygon polygon_;
  bool is_front_ = true;
  std::size_t pixel_ = 0;
};

}  // namespace

OwnDriver::OwnDriver(RasterFault fault, const OwnDriverSetup& setup) : fault_(fault) {
  info_.api = setup.api;
  info_.api_version = "none";
  info_.renderer = "clipscope's own rasteriser";
  info_.version = std::string(names_of(fault)[static_cast<std::size_t>(fault)]);
  info_.subpixel_bits = setup.subpixel_bits;
  info_.max_size = 4096;
  info_.max_clip_distances = kMaxClipDistances;
  info_.max_point_size = 64;
  info_.minus_one_to_one = info_.zero_to_one = true;
  info_.depth_clamp = true;
  info_.provoking_first = info_.provoking_last = true;
  info_.points_clip_at_sides = setup.api == GraphicsApi::vulkan;
  info_.quantities.set();
}

Drawn OwnDriver::draw(const DrawCall& call) { return Painter(call, info_, fault_).paint(); }

}  // namespace clipscope::experiments
