// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/draw_simpler.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace clipscope::experiments {
namespace {

// Its vertices in the order of a list: a turn that puts the provoking one in its place.
std::vector<std::uint32_t> as_in_list(const DrawCall& call, std::vector<std::uint32_t> vertices,
                                      std::size_t number) {
  const auto provoking = std::ranges::find(vertices, provoking_vertex(call, number));
  const bool is_last = call.provoking == ProvokingVertex::last;
  std::rotate(vertices.begin(), is_last ? provoking + 1 : provoking, vertices.end());
  return vertices;
}

void set_whole(DrawCall& call, int size) {
  call.width = call.height = size;
  call.viewport = {0, 0, size, size};
}

// Smaller targets: with a viewport as large, and with the viewport as it is.
void add_smaller_targets(const DrawCall& call, std::vector<DrawCall>& calls) {
  const int largest = std::max(call.width, call.height);
  for (const int size : {4, 8, 16, 32, 64}) {
    if (size > largest) break;
    set_whole(calls.emplace_back(call), size);
    if (has_whole_viewport(call)) continue;
    DrawCall& same_viewport = calls.emplace_back(call);
    same_viewport.width = same_viewport.height = size;
  }
}

// Smaller viewports whose middle or corner is the target's.
void add_smaller_viewports(const DrawCall& call, std::vector<DrawCall>& calls) {
  if (has_whole_viewport(call)) return;
  const int largest = std::max(call.viewport.width, call.viewport.height);
  for (int size = 64; size < largest; size *= 2) {
    for (const int offset : {0, (call.width - size) / 2, call.width - size}) {
      calls.emplace_back(call).viewport = {offset, offset, size, size};
    }
  }
}

void add_fewer_quantities(const DrawCall& call, std::vector<DrawCall>& calls) {
  if (call.quantities.none()) return;
  calls.emplace_back(call).quantities.reset();
  for (std::size_t q = 0; q < kQuantities; ++q) {
    if (call.quantities[q]) calls.emplace_back(call).quantities = Quantities().set(q);
  }
  for (std::size_t q = 0; q < kQuantities; ++q) {
    if (call.quantities[q]) calls.emplace_back(call).quantities.reset(q);
  }
}

}  // namespace

DrawCall with_primitives(const DrawCall& call, std::span<const std::size_t> numbers) {
  DrawCall list = call;
  list.topology = list_of(call.topology);
  list.vertices.clear();
  list.indices.clear();
  const auto primitives = primitives_of(call);
  std::map<std::uint32_t, std::uint32_t> places;  // of the call's vertices in the list
  for (const std::size_t number : numbers) {
    for (const std::uint32_t vertex : as_in_list(call, primitives[number], number)) {
      const auto next = static_cast<std::uint32_t>(list.vertices.size());
      const auto [place, is_new] = places.emplace(vertex, next);
      if (is_new) list.vertices.push_back(call.vertices[vertex]);
      list.indices.push_back(place->second);
    }
  }
  if (list.indices.size() == list.vertices.size()) list.indices.clear();
  return list;
}

std::vector<DrawCall> simpler_settings(const DrawCall& call) {
  std::vector<DrawCall> calls;
  add_fewer_quantities(call, calls);
  add_smaller_targets(call, calls);
  add_smaller_viewports(call, calls);
  calls.emplace_back(call).provoking = ProvokingVertex::last;
  if (call.topology == Topology::points) {
    for (const float size : {1.0f, 2.0f, 4.0f, 8.0f}) calls.emplace_back(call).point_size = size;
  }
  return calls;
}

HardCase numbers_of(const DrawCall& call) {
  HardCase c;
  c.volume = call.volume;
  c.frustum.depth = call.volume.depth;
  const auto distances = static_cast<std::size_t>(call.volume.clip_distances);
  for (const DrawVertex& v : call.vertices) {
    reference::InputVertex& vertex = c.vertices.emplace_back();
    std::ranges::copy(v.position, vertex.position.begin());
    std::copy_n(v.clip_distances.begin(), distances, vertex.attributes.begin());
    std::ranges::copy(v.varying,
                      vertex.attributes.begin() + static_cast<std::ptrdiff_t>(distances));
  }
  c.attribute_count = static_cast<int>(distances + call.vertices.front().varying.size());
  return c;
}

DrawCall with_numbers(DrawCall call, const HardCase& numbers) {
  call.volume = numbers.volume;
  const auto as_float = [](double x) { return static_cast<float>(x); };
  const auto distances = static_cast<std::size_t>(numbers.volume.clip_distances);
  if (distances == 0) call.quantities.reset(bit(Quantity::clip_distances));
  for (std::size_t i = 0; i < call.vertices.size(); ++i) {
    const reference::InputVertex& from = numbers.vertices[i];
    DrawVertex& v = call.vertices[i];
    std::ranges::transform(from.position, v.position.begin(), as_float);
    v.clip_distances.fill(0);
    v.varying.fill(0);
    const auto count = static_cast<std::size_t>(numbers.attribute_count);
    for (std::size_t k = 0; k < count; ++k) {
      const float x = as_float(from.attributes[k]);
      if (k < distances) {
        v.clip_distances[k] = x;
      } else {
        v.varying[k - distances] = x;
      }
    }
  }
  return call;
}

}  // namespace clipscope::experiments
