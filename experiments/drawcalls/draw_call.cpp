// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/drawcalls/draw_call.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {
namespace {

// The vertices in the order in which they are drawn.
std::vector<std::uint32_t> order_of(const DrawCall& call) {
  if (!call.indices.empty()) return call.indices;
  std::vector<std::uint32_t> order(call.vertices.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  return order;
}

// Places in that order of the vertices of primitive i; of a strip's triangle as it was given.
std::vector<std::size_t> places(Topology topology, std::size_t i) {
  switch (topology) {
    case Topology::points: return {i};
    case Topology::lines: return {2 * i, 2 * i + 1};
    case Topology::line_strip: return {i, i + 1};
    case Topology::triangles: return {3 * i, 3 * i + 1, 3 * i + 2};
    case Topology::triangle_strip: return {i, i + 1, i + 2};
    case Topology::triangle_fan: return {0, i + 1, i + 2};
  }
  return {};
}

std::size_t count_of(Topology topology, std::size_t vertices) {
  switch (topology) {
    case Topology::points: return vertices;
    case Topology::lines: return vertices / 2;
    case Topology::line_strip: return vertices < 2 ? 0 : vertices - 1;
    case Topology::triangles: return vertices / 3;
    case Topology::triangle_strip:
    case Topology::triangle_fan: return vertices < 3 ? 0 : vertices - 2;
  }
  return 0;
}

}  // namespace

Topology list_of(Topology topology) {
  switch (topology) {
    case Topology::points: return Topology::points;
    case Topology::lines:
    case Topology::line_strip: return Topology::lines;
    case Topology::triangles:
    case Topology::triangle_strip:
    case Topology::triangle_fan: break;
  }
  return Topology::triangles;
}

std::vector<std::vector<std::uint32_t>> primitives_of(const DrawCall& call) {
  const std::vector<std::uint32_t> order = order_of(call);
  std::vector<std::vector<std::uint32_t>> primitives(count_of(call.topology, order.size()));
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    for (const std::size_t place : places(call.topology, i)) primitives[i].push_back(order[place]);
    const bool is_turned = call.topology == Topology::triangle_strip && i % 2 == 1;
    if (is_turned) std::swap(primitives[i][0], primitives[i][1]);
  }
  return primitives;
}

std::uint32_t provoking_vertex(const DrawCall& call, std::size_t number) {
  const std::vector<std::size_t> of_primitive = places(call.topology, number);
  const bool is_fan = call.topology == Topology::triangle_fan;
  const std::size_t place =
      call.provoking == ProvokingVertex::last ? of_primitive.back() : of_primitive[is_fan ? 1 : 0];
  return order_of(call)[place];
}

std::string inability(const DriverInfo& info, const DrawCall& call) {
  const ClipVolume& volume = call.volume;
  if (volume.depth == DepthRange::minus_one_to_one && !info.minus_one_to_one) {
    return "has no depth range of -1 to 1";
  }
  if (volume.depth == DepthRange::zero_to_one && !info.zero_to_one) {
    return "has no depth range of 0 to 1";
  }
  if (volume.depth_clamp && !info.depth_clamp) return "has no depth clamp";
  if (volume.clip_distances > info.max_clip_distances) {
    return info.max_clip_distances == 0 ? "has no clip distances" : "has too few clip distances";
  }
  if (call.topology == Topology::triangle_fan && !info.triangle_fans) return "has no triangle fans";
  const bool is_first = call.provoking == ProvokingVertex::first;
  if (call.quantities[bit(Quantity::flat)] &&
      !(is_first ? info.provoking_first : info.provoking_last)) {
    return is_first ? "can't provoke by the first vertex" : "can't provoke by the last vertex";
  }
  if (call.topology == Topology::points && call.point_size > info.max_point_size) {
    return "has no points of that size";
  }
  if (std::max({call.width, call.height, call.viewport.width, call.viewport.height}) >
      info.max_size) {
    return "has no target or viewport of that size";
  }
  for (std::size_t q = 0; q < kQuantities; ++q) {
    if (call.quantities[q] && !info.quantities[q]) {
      return "can't tell " + std::string(names_of(Quantity{})[q]);
    }
  }
  return {};
}

}  // namespace clipscope::experiments
