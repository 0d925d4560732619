// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/circumstances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/table/row.hpp"

namespace clipscope::experiments {
namespace {

// Whether the vertex is in the closed volume, depth left out where it is clamped.
bool is_inside(const DrawVertex& vertex, const ClipVolume& volume) {
  const auto [x, y, z, w] = vertex.position;
  const float near = volume.depth == DepthRange::minus_one_to_one ? -w : 0;
  const bool in_depth = volume.depth_clamp || (near <= z && z <= w);
  const bool in_sides = std::abs(x) <= w && std::abs(y) <= w;
  const auto distances = vertex.clip_distances.begin();
  return in_depth && in_sides &&
         std::all_of(distances, distances + volume.clip_distances,
                     [](float distance) { return distance >= 0; });
}

}  // namespace

Primitive primitive_of(Topology topology) {
  switch (list_of(topology)) {
    case Topology::points: return Primitive::point;
    case Topology::lines: return Primitive::segment;
    default: return Primitive::triangle;
  }
}

Circumstances circumstances_of(const DrawCall& call, std::size_t primitive) {
  Circumstances found{.primitive = primitive_of(call.topology),
                      .clip_distances = call.volume.clip_distances > 0,
                      .depth_clamp = static_cast<bool>(call.volume.depth_clamp)};
  const std::vector<std::uint32_t> vertices = primitives_of(call)[primitive];
  for (const std::uint32_t number : vertices) {
    const DrawVertex& vertex = call.vertices[number];
    if (vertex.position[3] <= 0) {
      found.passage = Passage::behind_the_eye;
    } else if (!is_inside(vertex, call.volume)) {
      found.passage = std::max(found.passage, Passage::clipped);
    }
  }
  return found;
}

std::string to_string(const Circumstances& circumstances) {
  return fmt::format("{}, {}{}{}", name_of(circumstances.primitive), name_of(circumstances.passage),
                     circumstances.clip_distances ? ", clip distances" : "",
                     circumstances.depth_clamp ? ", depth clamp" : "");
}

}  // namespace clipscope::experiments
