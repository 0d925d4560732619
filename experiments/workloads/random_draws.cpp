// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/random_draws.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "experiments/hunt/breeding.hpp"
#include "experiments/workloads/lattice_draws.hpp"
#include "experiments/workloads/plain_call.hpp"

namespace clipscope::experiments {
namespace {

using Position = std::array<float, 4>;

hunt::Setting setting_of(const DrawCall& call) { return {.volume = {.depth = call.volume.depth}}; }

void set_positions(DrawCall& call, const std::vector<Position>& positions) {
  call.vertices.clear();
  for (const Position& p : positions) {
    call.vertices.push_back({.position = p, .varying = varying_of(call.vertices.size())});
  }
}

// The first so many vertices of a prey.
void make_prey(DrawCall& call, std::size_t vertices, Random& random) {
  const hunt::Prey prey = hunt::random_prey(setting_of(call), random);
  set_positions(
      call, {prey.position.begin(), prey.position.begin() + static_cast<std::ptrdiff_t>(vertices)});
}

void make_edge_pair(DrawCall& call, Random& random) {
  make_prey(call, 4, random);
  call.indices = {0, 1, 2, 1, 0, 3};
}

void make_neighbour(DrawCall& call, std::uint64_t seed, std::size_t number, const DriverInfo& info,
                    Random& random) {
  const DrawCall near = lattice_draw(seed, number, info);
  hunt::Prey prey = hunt::random_prey(setting_of(call), random);
  const std::size_t count = std::min<std::size_t>(3, near.vertices.size());
  for (std::size_t i = 0; i < count; ++i) prey.position[i] = near.vertices[i].position;
  prey = hunt::mutated(setting_of(call), prey, 0, random);
  set_positions(call, {prey.position.begin(), prey.position.begin() + 3});
}

// The plane of a mesh.
class Sheet4 {
 public:
  explicit Sheet4(Random& random) {
    constexpr double kWithin = 0.75;
    for (std::size_t i = 0; i < 3; ++i) origin_[i] = random.uniform(-kWithin, kWithin);
    origin_[3] = 1;
    for (std::array<double, 4>* direction : {&u_, &v_}) {
      const double size = random.across_magnitudes(0.25, 8);
      for (double& x : *direction) x = random.uniform(-size, size);
      if (random.chance(0.25)) (*direction)[3] = 0;  // parallel to the picture
    }
  }

  Position at(double u, double v) const {
    Position p;
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = static_cast<float>(origin_[i] + u * u_[i] + v * v_[i]);
    }
    return p;
  }

 private:
  std::array<double, 4> origin_, u_, v_;
};

// A star-shaped ring around (0, 0): corners of the square of side 2 and points between them.
void make_fan_mesh(DrawCall& call, Random& random) {
  const Sheet4 sheet(random);
  std::vector<Position> positions = {sheet.at(0, 0)};
  const auto add = [&](double u, double v) {
    const double reach = random.uniform(0.5, 1.5);
    positions.push_back(sheet.at(reach * u, reach * v));
  };
  const std::array<std::array<double, 2>, 4> corners = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  for (std::size_t side = 0; side < 4; ++side) {
    const auto [u, v] = corners[side];
    const auto [next_u, next_v] = corners[(side + 1) % 4];
    add(u, v);
    const double t = random.uniform(0.25, 0.75);
    if (random.chance(0.5)) add(u + t * (next_u - u), v + t * (next_v - v));
  }
  set_positions(call, positions);
  const auto ring = static_cast<std::uint32_t>(positions.size() - 1);
  for (std::uint32_t i = 0; i < ring; ++i) {
    call.indices.insert(call.indices.end(), {0, 1 + i, 1 + (i + 1) % ring});
  }
}

void make_strip_mesh(DrawCall& call, Random& random) {
  const Sheet4 sheet(random);
  std::vector<Position> positions;
  const auto columns = 3 + static_cast<int>(random.below(6));
  for (int column = 0; column <= columns; ++column) {
    const double u = 2.0 * column / columns - 1;
    for (const double v : {-1.0, 1.0}) {
      const double reach = random.uniform(0.25, 1);
      positions.push_back(sheet.at(u, reach * v));
    }
  }
  set_positions(call, positions);
  call.topology = Topology::triangle_strip;
}

void make_grid_mesh(DrawCall& call, Random& random) {
  constexpr std::uint32_t kSide = 5;  // vertices
  const Sheet4 sheet(random);
  std::vector<Position> positions;
  for (std::uint32_t row = 0; row < kSide; ++row) {
    for (std::uint32_t column = 0; column < kSide; ++column) {
      positions.push_back(sheet.at(column / 2.0 - 1, row / 2.0 - 1));
    }
  }
  set_positions(call, positions);
  for (std::uint32_t row = 0; row + 1 < kSide; ++row) {
    for (std::uint32_t column = 0; column + 1 < kSide; ++column) {
      const std::uint32_t a = row * kSide + column, b = a + 1, d = a + kSide, c = d + 1;
      call.indices.insert(call.indices.end(), {a, b, c, a, c, d});
    }
  }
}

}  // namespace

DrawCall random_draw(std::uint64_t seed, std::size_t number, const DriverInfo& info) {
  const RandomKind kind = random_kind(number);
  const std::string name =
      fmt::format("random/{} ({})", number, names_of(kind)[static_cast<std::size_t>(kind)]);
  DrawCall call = plain_call(name, Topology::triangles, {}, info);
  Random random(seed + 0x9e3779b97f4a7c15u * (number + 1));
  if (random.chance(0.1)) {
    set_size(call, kLargeTarget, kLargeTarget);
  } else if (random.chance(0.1)) {
    set_large_viewport(call, info, random);
  }
  switch (kind) {
    case RandomKind::triangle: make_prey(call, 3, random); break;
    case RandomKind::edge_pair: make_edge_pair(call, random); break;
    case RandomKind::fan_mesh: make_fan_mesh(call, random); break;
    case RandomKind::segment:
      call.topology = Topology::lines;
      make_prey(call, 2, random);
      break;
    case RandomKind::strip_mesh: make_strip_mesh(call, random); break;
    case RandomKind::neighbour: make_neighbour(call, seed, number, info, random); break;
    case RandomKind::point:
      call.topology = Topology::points;
      call.point_size = static_cast<float>(1 + random.below(16));
      make_prey(call, 1, random);
      break;
    case RandomKind::grid_mesh: make_grid_mesh(call, random); break;
  }
  return call;
}

}  // namespace clipscope::experiments
