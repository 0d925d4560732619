// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/pixels/draw_calls.hpp"

#include <cmath>
#include <utility>

namespace clipscope::experiments {
namespace {

int pick(std::mt19937& random, int least, int greatest) {
  return std::uniform_int_distribution<int>(least, greatest)(random);
}

float real(std::mt19937& random, float size) {
  return std::uniform_real_distribution<float>(-size, size)(random);
}

void set_state(DrawCall& call, std::mt19937& random) {
  const bool is_symmetric = pick(random, 0, 1) == 0;
  call.volume.depth = is_symmetric ? DepthRange::minus_one_to_one : DepthRange::zero_to_one;
  call.volume.depth_clamp = pick(random, 0, 3) == 0;
  if (pick(random, 0, 3) == 0) call.volume.clip_distances = pick(random, 1, 3);
  call.provoking = pick(random, 0, 1) == 0 ? ProvokingVertex::first : ProvokingVertex::last;
  if (pick(random, 0, 3) == 0) call.viewport = {pick(random, -9, 9), pick(random, -9, 9), 40, 23};
  call.point_size = static_cast<float>(pick(random, 1, 16));
}

Topology any_topology(std::mt19937& random) {
  constexpr std::array<Topology, 6> kAll = {Topology::triangles,      Topology::triangles,
                                            Topology::triangle_strip, Topology::triangle_fan,
                                            Topology::points,         Topology::lines};
  return kAll[static_cast<std::size_t>(pick(random, 0, 5))];
}

template <class Coordinate>
DrawCall any_call(std::mt19937& random, Coordinate&& coordinate) {
  const Topology topology = any_topology(random);
  const int count = topology == Topology::triangles ? 3 : pick(random, 3, 5);
  std::vector<DrawVertex> vertices;
  for (int i = 0; i < count; ++i) {
    DrawVertex v;
    for (float& c : v.position) c = coordinate();
    for (float& c : v.varying) c = static_cast<float>(pick(random, -5, 5));
    for (float& c : v.clip_distances) c = static_cast<float>(pick(random, -2, 3));
    vertices.push_back(v);
  }
  DrawCall call = call_of(topology, std::move(vertices));
  set_state(call, random);
  return call;
}

}  // namespace

Quantities all_quantities() { return Quantities().set(); }

DrawVertex vertex_at(float x, float y, float z, float w, float varying) {
  return {{x, y, z, w}, {varying, 1, -varying, 2 * varying + 1}};
}

DrawCall call_of(Topology topology, std::vector<DrawVertex> vertices, int size) {
  DrawCall call{.topology = topology, .vertices = std::move(vertices)};
  call.width = call.height = size;
  call.viewport = {0, 0, size, size};
  call.quantities = all_quantities();
  return call;
}

DrawCall lattice_call(std::mt19937& random) {
  return any_call(random, [&] { return static_cast<float>(pick(random, -3, 3)); });
}

DrawCall far_call(std::mt19937& random) {
  DrawCall call = lattice_call(random);
  for (DrawVertex& v : call.vertices) {
    if (pick(random, 0, 1) == 0) continue;
    const float factor = std::ldexp(1.0f, pick(random, 10, 24));
    for (const std::size_t c : {0, 1}) v.position[c] = v.position[c] * factor + real(random, 2);
  }
  return call;
}

DrawCall scaled_call(std::mt19937& random) {
  DrawCall call = lattice_call(random);
  const float factor = std::ldexp(1.0f, pick(random, -28, 28));
  for (DrawVertex& v : call.vertices) {
    for (float& c : v.position) c *= factor;
  }
  return call;
}

DrawCall random_call(std::mt19937& random) {
  return any_call(random, [&] { return real(random, 2); });
}

}  // namespace clipscope::experiments
