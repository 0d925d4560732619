// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/breeding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace clipscope::experiments::hunt {
namespace {

using Position = std::array<float, 4>;
using Limits = std::numeric_limits<float>;

float finite(float x) { return std::isfinite(x) ? x : std::copysign(Limits::max(), x); }
float finite_or_zero(double x) { return std::isnan(x) ? 0 : finite(static_cast<float>(x)); }

// The float so many places up or down in the order of all floats.
float moved_by_ulps(float x, std::int64_t ulps) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  std::int64_t place =
      bits >= 0 ? bits : std::numeric_limits<std::int32_t>::min() - std::int64_t{bits};
  constexpr std::int64_t kLast = 0x7f7fffff;  // the largest finite float
  place = std::clamp(place + ulps, -kLast, kLast);
  const auto moved = static_cast<std::uint32_t>(place >= 0 ? place : -place);
  const float size = std::bit_cast<float>(moved);
  return place >= 0 ? size : -size;
}

int in_range(Random& random, int low, int high) {
  return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

template <std::size_t N>
std::size_t any_of(Random& random) {
  return static_cast<std::size_t>(random.below(N));
}

float uniform_float(Random& random, double size) {
  const double x = random.uniform(-size, size);
  return static_cast<float>(x);
}

// --- Settings ------------------------------------------------------------------------------------

Frustum<float> random_frustum(Random& random) {
  Frustum<float> f;
  switch (random.below(8)) {
    case 0: f.far = 1000; break;
    case 1: f.infinite_far = true; break;
    case 2:
      f.near = 0.01f, f.left = f.bottom = -0.01f, f.right = f.top = 0.01f, f.far = 1e5f;
      break;
    case 3: f.left = -0.3f, f.top = 0.7f; break;
    case 4: f.kind = ProjectionKind::parallel; break;
    default: break;
  }
  return f;
}

ClipVolume random_volume(int attributes, const SettingLimits& limits, Random& random) {
  ClipVolume v;
  v.depth = static_cast<DepthRange>(random.below(3));
  const std::uint64_t option = random.below(6);
  if (limits.is_plain) return v;
  bool* const clamps[] = {&v.depth_clamp.near, &v.depth_clamp.far};
  bool* const sides[] = {&v.open_sides.left, &v.open_sides.right, &v.open_sides.bottom,
                         &v.open_sides.top};
  if (option == 0) {
    for (bool* const clamp : clamps) *clamp = random.chance(0.7);
  } else if (option == 1) {
    for (bool* const side : sides) *side = random.chance(0.5);
  }
  if (option == 2 && limits.has_distances && attributes > 0) {
    v.clip_distances = in_range(random, 1, std::min(attributes, 2));
  }
  return v;
}

// --- Coordinates ---------------------------------------------------------------------------------

// The coordinate on a plane of the volume through the other coordinates, or some ulps beside it.
float beside_a_plane(const Setting& setting, const Position& p, std::size_t axis, Random& random) {
  double x = p[3];
  if (setting.space == Space::view) {
    const Frustum<float>& f = setting.frustum;
    const bool spreads = f.kind == ProjectionKind::perspective;
    const double depth = spreads ? -double{p[2]} / f.near : 1;
    if (axis == 0) x = depth * (random.chance(0.5) ? f.left : f.right);
    if (axis == 1) x = depth * (random.chance(0.5) ? f.bottom : f.top);
    if (axis >= 2) x = -(random.chance(0.5) || f.infinite_far ? f.near : f.far);
  } else if (axis == 2 && setting.volume.depth != DepthRange::minus_one_to_one &&
             random.chance(0.5)) {
    x = 0;
  } else if (random.chance(0.5)) {
    x = -x;
  }
  constexpr int kFar = 4;
  return moved_by_ulps(finite_or_zero(x), random.chance(0.3) ? 0 : in_range(random, -kFar, kFar));
}

float with_any_exponent(Random& random, int reach) {
  const int exponent = in_range(random, -reach, reach);
  const double sign = random.sign();
  const double x = random.uniform(1, 2);
  return finite(std::ldexp(static_cast<float>(sign * x), exponent));
}

void place_in_view(const Setting& setting, Prey& prey, Random& random) {
  const double size = random.across_magnitudes(0x1p-6, 0x1p+10);
  const double near = setting.frustum.near;
  for (Position& p : prey.position) {
    p = {uniform_float(random, size), uniform_float(random, size),
         static_cast<float>(uniform_float(random, size) - near), 1};
  }
}

void place_in_clip(Prey& prey, Random& random) {
  const double size = random.chance(0.5) ? 2 : random.across_magnitudes(1, 0x1p+20);
  const bool behind = random.chance(0.4);
  for (Position& p : prey.position) {
    for (float& x : p) x = uniform_float(random, size);
    p[3] = uniform_float(random, random.chance(0.5) ? 2 : size);
    if (!behind) p[3] = std::abs(p[3]);
  }
}

void make_whole_numbers(Prey& prey, Random& random) {
  constexpr std::array kNumbers = {0.0f, 0.0f,  1.0f, -1.0f, 1.0f, -1.0f,
                                   2.0f, -2.0f, 0.5f, -0.5f, 3.0f};
  for (Position& p : prey.position) {
    for (float& x : p) x = kNumbers[any_of<kNumbers.size()>(random)];
  }
}

void make_any_exponents(Prey& prey, Random& random) {
  const int reach = random.chance(0.8) ? 30 : 140;
  for (Position& p : prey.position) {
    for (float& x : p) x = with_any_exponent(random, reach);
    if (random.chance(0.7)) p[3] = std::abs(p[3]);
  }
}

// All vertices exactly in one side.
void put_into_a_side(const Setting& setting, Prey& prey, Random& random) {
  const std::size_t axis = any_of<2>(random);
  const bool at_low_end = random.chance(0.5);
  const Frustum<float>& f = setting.frustum;
  const float low = axis == 0 ? f.left : f.bottom, high = axis == 0 ? f.right : f.top;
  for (Position& p : prey.position) {
    const double spread = f.kind == ProjectionKind::perspective ? -double{p[2]} / f.near : 1;
    const double x = setting.space == Space::view ? spread * (at_low_end ? low : high)
                                                  : (at_low_end ? -p[3] : p[3]);
    p[axis] = finite_or_zero(x);
  }
}

// From one pair of opposite corners' neighbourhood to the next, so that all six planes cut.
void place_across_all_planes(const Setting& setting, Prey& prey, Random& random) {
  const std::size_t first = any_of<3>(random);
  const std::size_t step = random.chance(0.5) ? 1 : 2;
  const auto size = [&] { return static_cast<float>(random.uniform(1.4, 2.4)); };
  for (std::size_t v = 0; v < Prey::kVertices; ++v) {
    Position& p = prey.position[v];
    p = {};
    p[(first + v) % 3] = size();
    p[(first + v + step) % 3] = -size();
    p[3] = 1;
    const float from_zero = (p[2] + 1) / 2;
    if (setting.volume.depth == DepthRange::zero_to_one) p[2] = from_zero;
    if (setting.volume.depth == DepthRange::reversed) p[2] = 1 - from_zero;
  }
}

void scale_all(Prey& prey, int exponent) {
  for (Position& p : prey.position) {
    for (float& x : p) x = finite(std::ldexp(x, exponent));
  }
}

// Towards or beyond the other vertex; often next to it, or to the line through both.
void move_towards(const Position& other, Position& p, Random& random) {
  const int nearness = in_range(random, -1, 24);
  const double t = 1 - std::ldexp(random.uniform(-1, 1), -nearness);
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = finite_or_zero(p[i] + t * (double{other[i]} - double{p[i]}));
  }
}

void keep_in_space(const Setting& setting, Prey& prey) {
  if (setting.space == Space::clip) return;
  for (Position& p : prey.position) p[3] = 1;
}

// --- Changes -------------------------------------------------------------------------------------

void change_coordinate(const Setting& setting, Prey& prey, Random& random) {
  Position& p = prey.position[any_of<Prey::kVertices>(random)];
  const auto axis =
      static_cast<std::size_t>(random.below(static_cast<std::uint64_t>(setting.dimension())));
  float& x = p[axis];
  switch (random.below(8)) {
    case 0: x = moved_by_ulps(x, in_range(random, -4, 4)); break;
    case 1:
    case 2: {
      const int bit = in_range(random, 0, 22);
      const std::int64_t step = std::int64_t{1} << bit;
      x = moved_by_ulps(x, random.chance(0.5) ? step : -step);
      break;
    }
    case 3: x = finite(std::ldexp(x, in_range(random, -8, 8))); break;
    case 4: x = beside_a_plane(setting, p, axis, random); break;
    case 5: x = -x; break;
    case 6: x = random.chance(0.5) ? 0 : p[any_of<4>(random)]; break;
    default: x = prey.position[any_of<Prey::kVertices>(random)][axis]; break;
  }
}

void change_vertex(Prey& prey, Random& random) {
  Position& p = prey.position[any_of<Prey::kVertices>(random)];
  switch (random.below(4)) {
    case 0: {
      const int exponent = in_range(random, -8, 8);
      for (float& x : p) x = finite(std::ldexp(x, exponent));
      break;
    }
    case 1: {
      const double factor = random.uniform(0.5, 2);
      for (float& x : p) x = finite_or_zero(x * factor);
      break;
    }
    default: move_towards(prey.position[any_of<Prey::kVertices>(random)], p, random); break;
  }
}

void change_attribute(int attributes, Prey& prey, Random& random) {
  auto& values = prey.attributes[any_of<Prey::kVertices>(random)];
  float& x = values[static_cast<std::size_t>(random.below(static_cast<std::uint64_t>(attributes)))];
  switch (random.below(4)) {
    case 0: x = uniform_float(random, 1); break;
    case 1: x = moved_by_ulps(x, in_range(random, -4, 4)); break;
    case 2: x = -x; break;
    default: x = random.chance(0.5) ? 0 : finite(std::ldexp(x, in_range(random, -4, 4))); break;
  }
}

}  // namespace

bool takes(const Contestant& contestant, const Setting& setting, int attributes) {
  return contestant.takes({.space = setting.space,
                           .frustum = frustum_cast<double>(setting.frustum),
                           .volume = setting.volume,
                           .attributes = attributes});
}

Setting random_setting(const Contestant& contestant, int attributes, const SettingLimits& limits,
                       Random& random) {
  constexpr int kTries = 200;
  Setting setting;
  for (int i = 0; i < kTries; ++i) {
    setting.space = random.chance(0.35) ? Space::view : Space::clip;
    if (limits.space) setting.space = *limits.space;
    setting.frustum = random_frustum(random);
    setting.volume = random_volume(attributes, limits, random);
    setting.frustum.depth = setting.volume.depth;
    if (takes(contestant, setting, attributes)) break;
  }
  return setting;
}

Prey random_prey(const Setting& setting, Random& random) {
  enum Kind {
    whole_numbers,
    any_exponents,
    sliver,
    in_a_side,
    across,
    beside_planes = 7,
    kinds = 10
  };
  Prey prey;
  const std::uint64_t kind = random.below(kinds);
  if (kind == whole_numbers) {
    make_whole_numbers(prey, random);
  } else if (kind == any_exponents) {
    make_any_exponents(prey, random);
  } else if (setting.space == Space::view) {
    place_in_view(setting, prey, random);
  } else if (kind == across) {
    place_across_all_planes(setting, prey, random);
  } else {
    place_in_clip(prey, random);
  }
  if (kind >= beside_planes) {
    for (Position& p : prey.position) {
      const std::size_t axis = any_of<3>(random);
      if (random.chance(0.7)) p[axis] = beside_a_plane(setting, p, axis, random);
    }
  }
  if (kind == sliver) move_towards(prey.position[0], prey.position[any_of<3>(random)], random);
  if (kind == in_a_side) put_into_a_side(setting, prey, random);
  if (random.chance(0.2)) scale_all(prey, in_range(random, -40, 40));
  keep_in_space(setting, prey);
  set_attributes(prey, setting.volume.clip_distances);
  for (int k = 0; k < setting.volume.clip_distances; ++k) {
    const auto place = static_cast<std::size_t>(k);
    for (auto& values : prey.attributes) values[place] = uniform_float(random, 1);
  }
  return prey;
}

Prey mutated(const Setting& setting, Prey prey, int attributes, Random& random) {
  do {
    if (attributes > 0 && random.chance(0.3)) {
      change_attribute(attributes, prey, random);
    } else if (random.chance(0.03)) {
      scale_all(prey, in_range(random, -4, 4));
    } else if (random.chance(0.75)) {
      change_coordinate(setting, prey, random);
    } else {
      change_vertex(prey, random);
    }
  } while (random.chance(0.4));
  keep_in_space(setting, prey);
  return prey;
}

Prey crossed(const Prey& a, const Prey& b, Random& random) {
  Prey r = a;
  for (std::size_t v = 0; v < Prey::kVertices; ++v) {
    if (random.chance(0.5)) continue;
    r.position[v] = b.position[v];
    r.attributes[v] = b.attributes[v];
  }
  return r;
}

}  // namespace clipscope::experiments::hunt
