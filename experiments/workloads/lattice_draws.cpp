// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/lattice_draws.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/workloads/plain_call.hpp"

namespace clipscope::experiments {
namespace {

using Positions = std::vector<std::array<float, 4>>;

constexpr std::array<std::string_view, 4> kPrimitives = {"", "point", "segment", "triangle"};

bool is_possible(const LatticeStratum& s) {
  const bool is_ordered =
      s.setting == LatticeSetting::strip || s.setting == LatticeSetting::other_provoking;
  if (s.primitive == 1) {
    return !is_ordered && (s.signs == WSigns::in_front || s.signs == WSigns::none_in_front);
  }
  return s.primitive == 3 || (s.signs != WSigns::two_behind && s.signs != WSigns::on_and_behind);
}

std::vector<LatticeStratum> all_strata() {
  std::vector<LatticeStratum> strata;
  for (std::size_t primitive = 1; primitive <= 3; ++primitive) {
    for (std::size_t signs = 0; signs < names_of(WSigns{}).size(); ++signs) {
      for (std::size_t numbers = 0; numbers < names_of(LatticeNumbers{}).size(); ++numbers) {
        for (std::size_t setting = 0; setting < names_of(LatticeSetting{}).size(); ++setting) {
          const LatticeStratum s{primitive, static_cast<WSigns>(signs),
                                 static_cast<LatticeNumbers>(numbers),
                                 static_cast<LatticeSetting>(setting)};
          if (is_possible(s)) strata.push_back(s);
        }
      }
    }
  }
  return strata;
}

// In lo ... hi.
int integer(int lo, int hi, Random& random) {
  return lo + static_cast<int>(random.below(static_cast<std::uint64_t>(hi - lo) + 1));
}

// -1, 0 or 1 for each vertex, in random order.
std::vector<int> signs_of_w(const LatticeStratum& s, Random& random) {
  std::vector<int> signs(s.primitive, 1);
  switch (s.signs) {
    case WSigns::in_front: break;
    case WSigns::one_on: signs[0] = 0; break;
    case WSigns::one_behind: signs[0] = -1; break;
    case WSigns::two_behind: signs[0] = signs[1] = -1; break;
    case WSigns::on_and_behind:
      signs[0] = 0;
      signs[1] = -1;
      break;
    case WSigns::none_in_front:
      for (int& sign : signs) sign = integer(-1, 0, random);
  }
  random.shuffle(std::span(signs));
  return signs;
}

// Whole numbers over `parts`; x, y and z up to `most`, |w| up to `most_w`.
struct Grid {
  int most = 2, most_w = 3, parts = 1;
};

Grid grid_of(LatticeNumbers numbers, Random& random) {
  if (numbers != LatticeNumbers::larger) return {};
  if (random.chance(0.5)) return {.most = 9, .most_w = 5};
  return {.parts = 1 << integer(1, 2, random)};
}

std::array<float, 4> lattice_point(int sign, LatticeNumbers numbers, Random& random) {
  const Grid grid = grid_of(numbers, random);
  const int most = grid.most * grid.parts;
  const auto over_parts = [&](int n) {
    return static_cast<float>(n) / static_cast<float>(grid.parts);
  };
  std::array<float, 4> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = over_parts(integer(-most, most, random));
  p[3] = over_parts(sign * integer(1, grid.most_w * grid.parts, random));
  return p;
}

void scale_point(std::array<float, 4>& point, int power) {
  for (float& x : point) x = std::ldexp(x, power);
}

void scale_some(Positions& positions, Random& random) {
  if (random.chance(0.5)) {
    scale_point(positions[random.below(positions.size())], integer(-12, 12, random));
    return;
  }
  const int power = integer(-60, 28, random);
  for (std::array<float, 4>& p : positions) scale_point(p, power);
}

// All coordinates of two vertices, or their x or y alone: an edge that is short, or nearly level.
void bring_close(Positions& positions, Random& random) {
  if (positions.size() < 2) return;
  random.shuffle(std::span(positions));
  std::array<float, 4>& moved = positions[0];
  const std::array<float, 4>& other = positions[1];
  const bool is_short = random.chance(0.5);
  const std::size_t axis = random.below(is_short ? 3 : 2);
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_short || i == axis) moved[i] = other[i];
  }
  if (moved[3] * other[3] > 0) moved[3] = other[3];  // else its sign is the stratum's
  const double sign = random.sign();
  moved[axis] += static_cast<float>(std::ldexp(sign, integer(-12, -3, random)));
}

void change_numbers(Positions& positions, LatticeNumbers numbers, Random& random) {
  std::array<float, 4>& one = positions[random.below(positions.size())];
  float& x = one[random.below(3)];
  const auto keep_off_zero = [&] {
    if (x == 0) x = static_cast<float>(random.sign());
  };
  switch (numbers) {
    case LatticeNumbers::small:
    case LatticeNumbers::larger: break;
    case LatticeNumbers::scaled: return scale_some(positions, random);
    case LatticeNumbers::far_vertex:
      keep_off_zero();
      x = std::ldexp(x, integer(10, 24, random));
      break;
    case LatticeNumbers::small_w:
      keep_off_zero();
      one[3] = std::ldexp(one[3], integer(-24, -4, random));
      break;
    case LatticeNumbers::close_vertices: return bring_close(positions, random);
  }
}

Positions some_positions(const LatticeStratum& s, Random& random) {
  Positions positions;
  for (const int sign : signs_of_w(s, random)) {
    positions.push_back(lattice_point(sign, s.numbers, random));
  }
  change_numbers(positions, s.numbers, random);
  return positions;
}

bool is_visible(const Positions& positions, DepthRange depth) {
  std::vector<reference::InputVertex> vertices;
  for (const std::array<float, 4>& p : positions) {
    vertices.push_back({.position = {p[0], p[1], p[2], p[3]}});
  }
  const reference::Truth truth = reference::Truth::of_clip(depth);
  return reference::clip(truth, vertices, 0).vertices.size() >= positions.size();
}

Positions positions_of(const LatticeStratum& s, DepthRange depth, Random& random) {
  constexpr int kTries = 8;
  const int tries = s.primitive == 1 && random.chance(0.5) ? 1 : kTries;
  Positions positions = some_positions(s, random);
  for (int i = 1; i < tries && !is_visible(positions, depth); ++i) {
    positions = some_positions(s, random);
  }
  return positions;
}

// To the nearest point of the volume with the same w > 0.
void bring_inside(DrawCall& call) {
  for (DrawVertex& v : call.vertices) {
    const float w = v.position[3];
    for (std::size_t i = 0; i < 3; ++i) v.position[i] = std::clamp(v.position[i], -w, w);
  }
}

// Half of those in front of the eye are brought inside: then the common edge is all visible.
void make_strip(DrawCall& call, const LatticeStratum& s, Random& random) {
  const int sign = s.signs == WSigns::none_in_front ? -1 : 1;
  call.topology = s.primitive == 3 ? Topology::triangle_strip : Topology::line_strip;
  call.vertices.push_back({.position = lattice_point(sign, s.numbers, random),
                           .varying = varying_of(call.vertices.size())});
  if (s.signs == WSigns::in_front && random.chance(0.5)) bring_inside(call);
}

void make_other_provoking(DrawCall& call) {
  const bool is_last = call.provoking == ProvokingVertex::last;
  call.provoking = is_last ? ProvokingVertex::first : ProvokingVertex::last;
  call.indices = {1, 0};
  if (call.vertices.size() == 3) call.indices.insert(call.indices.begin(), 2);
}

// gl_PrimitiveID says something where there are two.
void set_one_quantity(DrawCall& call, const LatticeStratum& s, Random& random) {
  constexpr std::array kOnes = {
      Quantity::smooth, Quantity::noperspective, Quantity::flat, Quantity::frag_coord,
      Quantity::facing, Quantity::primitive_id,  Quantity::depth};
  const Quantity one = kOnes[random.below(kOnes.size())];
  call.quantities = Quantities().set(bit(one));
  if (one == Quantity::primitive_id && s.primitive > 1) make_strip(call, s, random);
}

// 256 px now and then; 33 px, so that the lines x = 0 and y = 0 run through centres of pixels.
int size_of_target(Random& random) {
  constexpr int kOdd = 33;
  const double choice = random.uniform();
  if (choice < 0.05) return kLargeTarget;
  return choice < 0.3 ? kOdd : kSmallTarget;
}

void change_setting(DrawCall& call, const LatticeStratum& s, const DriverInfo& info,
                    Random& random) {
  switch (s.setting) {
    case LatticeSetting::plain: break;
    case LatticeSetting::strip: return make_strip(call, s, random);
    case LatticeSetting::other_provoking: return make_other_provoking(call);
    case LatticeSetting::depth_clamp: call.volume.depth_clamp = true; break;
    case LatticeSetting::clip_distances:
      return set_clip_distances(call, integer(1, std::max(1, info.max_clip_distances), random));
    case LatticeSetting::large_viewport: return set_large_viewport(call, info, random);
    case LatticeSetting::quantity_alone: return set_one_quantity(call, s, random);
  }
}

Topology topology_of(const LatticeStratum& s) {
  return std::array{Topology::points, Topology::lines, Topology::triangles}[s.primitive - 1];
}

template <class E>
std::string_view name_of(E value) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

}  // namespace

LatticeStratum lattice_stratum(std::size_t number) {
  static const std::vector<LatticeStratum> strata = all_strata();
  // No divisor in common with their number, so that any few draw calls in a row are of many kinds.
  constexpr std::size_t kStep = 187;
  return strata[number % strata.size() * kStep % strata.size()];
}

DrawCall lattice_draw(std::uint64_t seed, std::size_t number, const DriverInfo& info) {
  const LatticeStratum s = lattice_stratum(number);
  Random random(seed + 0x9e3779b97f4a7c15u * (number + 1));
  const bool prefers_zero_to_one = random.chance(0.25);
  const int size = size_of_target(random);
  const bool is_gl = info.minus_one_to_one && !(info.zero_to_one && prefers_zero_to_one);
  const DepthRange depth = is_gl ? DepthRange::minus_one_to_one : DepthRange::zero_to_one;
  const std::string name =
      fmt::format("lattice/{} ({}, {}, {}, {})", number, kPrimitives[s.primitive], name_of(s.signs),
                  name_of(s.numbers), name_of(s.setting));
  DrawCall call = plain_call(name, topology_of(s), positions_of(s, depth, random), info);
  call.volume.depth = depth;
  set_size(call, size, size);
  if (s.primitive == 1) call.point_size = static_cast<float>(integer(1, 16, random));
  change_setting(call, s, info, random);
  return call;
}

}  // namespace clipscope::experiments
