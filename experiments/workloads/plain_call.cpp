// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/plain_call.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace clipscope::experiments {

std::array<float, 4> varying_of(std::size_t vertex) {
  const auto halves = static_cast<float>((5 * vertex + 1) % 17);
  const auto quarters = static_cast<float>(7 * vertex % 33);
  return {halves / 2 - 4, vertex % 3 == 0 ? 1.0f : 0.0f, 4 - quarters / 4, 1};
}

std::array<float, kMaxClipDistances> clip_distances_of(std::size_t vertex) {
  std::array<float, kMaxClipDistances> distances;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const std::size_t turn = (vertex + 2 * k) % 5;
    distances[k] =
        vertex % 3 == k % 3 ? -0.5f - static_cast<float>(k) / 4 : 1 + static_cast<float>(turn) / 2;
  }
  return distances;
}

DrawCall plain_call(std::string name, Topology topology,
                    std::span<const std::array<float, 4>> positions, const DriverInfo& info) {
  DrawCall call{.name = std::move(name), .topology = topology};
  for (const std::array<float, 4>& position : positions) {
    call.vertices.push_back({.position = position, .varying = varying_of(call.vertices.size())});
  }
  call.volume.depth =
      info.minus_one_to_one ? DepthRange::minus_one_to_one : DepthRange::zero_to_one;
  call.provoking = info.provoking_last ? ProvokingVertex::last : ProvokingVertex::first;
  call.quantities = info.quantities;
  call.quantities.reset(bit(Quantity::clip_distances));
  call.quantities.reset(bit(Quantity::primitive_id));
  set_size(call, kSmallTarget, kSmallTarget);
  return call;
}

DrawCall labelled(DrawCall call, std::string_view label) {
  if (call.name.ends_with(')')) {
    call.name.pop_back();
    call.name += ", ";
  } else {
    call.name += " (";
  }
  call.name += label;
  call.name += ')';
  return call;
}

void set_depth_range(DrawCall& call, DepthRange range) {
  assert(range != DepthRange::reversed && call.volume.depth != DepthRange::reversed);
  if (call.volume.depth == range) return;
  call.volume.depth = range;
  for (DrawVertex& v : call.vertices) {
    const double z = v.position[2], w = v.position[3];
    v.position[2] = static_cast<float>(range == DepthRange::zero_to_one ? (z + w) / 2 : 2 * z - w);
  }
}

void set_size(DrawCall& call, int width, int height) {
  call.width = width;
  call.height = height;
  call.viewport = {0, 0, width, height};
}

void set_large_viewport(DrawCall& call, const DriverInfo& info, Random& random) {
  constexpr int kFirstPower = 10, kPowers = 5;
  const int power = kFirstPower + static_cast<int>(random.below(kPowers));
  const int large = std::min(1 << power, info.max_size);
  const auto offset = [&](std::uint64_t place, int size) {
    const int last = size - large;
    const double anywhere = random.uniform(last, 0);
    return std::array{0, last / 2, last, static_cast<int>(anywhere)}[place];
  };
  const std::uint64_t across = random.below(4);
  const std::uint64_t up = random.chance(0.5) ? across : random.below(4);
  const int x = offset(across, call.width), y = offset(up, call.height);
  call.viewport = {x, y, large, large};
}

void set_clip_distances(DrawCall& call, int count) {
  call.volume.clip_distances = count;
  call.quantities.set(bit(Quantity::clip_distances));
  for (std::size_t v = 0; v < call.vertices.size(); ++v) {
    const auto distances = clip_distances_of(v);
    std::copy_n(distances.begin(), count, call.vertices[v].clip_distances.begin());
  }
}

bool is_finite(const DrawCall& call) {
  const auto is_number = [](float x) { return std::isfinite(x); };
  return std::ranges::all_of(call.vertices, [&](const DrawVertex& v) {
    return std::ranges::all_of(v.position, is_number) &&
           std::ranges::all_of(v.varying, is_number) &&
           std::ranges::all_of(v.clip_distances, is_number);
  });
}

}  // namespace clipscope::experiments
