// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinds of input whose volume is odd: its frustum, its clip distances, its depth, its extent.
#include "tests/spaces/attack/kinds.hpp"
#include "tests/spaces/attack/making.hpp"
#include "tests/spaces/attack/tuning.hpp"

namespace clipscope::attack {
namespace {

// low < high in one of the ways in which bounds can be odd.
void set_bounds(Dice& dice, float& low, float& high) {
  const int exponent = dice.between(-30, 30);
  low = dice.over_powers(exponent, exponent + 1);
  switch (dice.below(5)) {
    case 0: high = dice.nudged(low, 3); break;  // almost nothing between them
    case 1: high = -low; break;                 // symmetric
    case 2: high = low * static_cast<float>(dice.between(2, 5)); break;
    case 3: high = dice.over_powers(-140, 120); break;  // of another size
    default: high = dice.one_in(2) ? 0.0f : dice.over_powers(exponent - 2, exponent + 2);
  }
  if (high < low) std::swap(low, high);
  if (!(low < high)) high = std::nextafter(low, kLargestFloat);
}

Frustum odd_frustum(Dice& dice) {
  Frustum f;
  f.is_perspective = !dice.one_in(3);
  set_bounds(dice, f.left, f.right);
  set_bounds(dice, f.bottom, f.top);
  set_bounds(dice, f.near, f.far);
  if (f.is_perspective) {
    f.near = std::abs(f.near);
    f.far = std::abs(f.far);
    if (f.far < f.near) std::swap(f.near, f.far);
    if (f.near == 0) f.near = kLeastFloat;
    if (!(f.near < f.far)) f.far = std::nextafter(f.near, kLargestFloat);
    f.is_infinite = dice.one_in(4);
  } else if (dice.one_in(2)) {
    f.shear_x = dice.over_powers(-10, 10);
    f.shear_y = dice.one_in(2) ? 0.0f : dice.over_powers(-140, 20);
  }
  return f;
}

// Between two bounds, on one of them or beside it, or outside.
double about(Dice& dice, double low, double high) {
  if (dice.one_in(4)) return dice.one_in(2) ? low : high;
  return low + (high - low) * dice.uniform(-0.7, 1.7);
}

void set_in_view(Dice& dice, const Frustum& f, float* p) {
  const double depth = f.is_infinite ? 20.0 * f.near : f.far;
  const double z = -about(dice, f.near, depth), scale = f.is_perspective ? -z / f.near : 1;
  const double x = about(dice, f.left, f.right), y = about(dice, f.bottom, f.top);
  const double shear_x = f.is_perspective ? 0 : f.shear_x,
               shear_y = f.is_perspective ? 0 : f.shear_y;
  const auto number = [&](double v) {
    const double bounded = std::clamp(v, -double{kLargestFloat}, double{kLargestFloat});
    return dice.nudged(static_cast<float>(bounded), 2);
  };
  p[0] = number(scale * x - shear_x * z);
  p[1] = number(scale * y - shear_y * z);
  p[2] = number(z);
}

// An edge that the left side of a sheared projection cuts in its middle, but for what the third
// component says of its distances: x + shear z - left = 1 - a - b and -1 + a - b. Values there are
// next to half way between floats.
Batch sheared_middles(Dice& dice) {
  Frustum f{.is_perspective = false, .left = 0, .right = 4, .bottom = -4, .top = 4};
  f.near = -4;
  f.far = 4;
  f.left = dice.one_in(4) ? 0.0f : dice.over_powers(-149, -100);
  f.shear_x = dice.over_powers(-70, -30);
  const int attributes = some_attributes(dice);
  Batch r{{.depth = some_volume(dice, 0).depth}, f, attributes, {}};
  r.floats.resize(static_cast<std::size_t>(3 * some_count(dice)) * r.stride());
  for (std::size_t t = 0; t < r.triangles(); ++t) {
    const float z = dice.over_powers(-1, 0);
    for (std::size_t k = 0; k < r.stride(); ++k) {
      float* const v[3] = {r.vertex(t, 0) + k, r.vertex(t, 1) + k, r.vertex(t, 2) + k};
      const float low = dice.over_powers(-2, 0);
      *v[0] = k == 0 ? 1.0f : k == 2 ? z : low;
      *v[1] = k == 0 ? -1.0f : k == 2 ? -z : std::nextafter(low, 2.0f);
      *v[2] = k == 1 ? -low : *v[0];
    }
  }
  return r;
}

// Bounds of such different sizes that no double holds right - left; only bottom and top cut, and x
// is next to half way between floats.
Batch inexact_widths(Dice& dice) {
  Frustum f;
  f.is_perspective = dice.one_in(2);
  f.right = dice.sized(0, 3);
  f.left = -dice.sized(-40, -28);
  f.far = 20;
  const int attributes = some_attributes(dice);
  Batch r{{.depth = some_volume(dice, 0).depth}, f, attributes, {}};
  r.floats.resize(static_cast<std::size_t>(3 * some_count(dice)) * r.stride());
  for (std::size_t i = 0; i < 3 * r.triangles(); ++i) {
    float* const p = r.vertex(0, i);
    p[2] = -static_cast<float>(dice.uniform(1.5, 19));
    const float scale = f.is_perspective ? -p[2] : 1;
    p[0] = static_cast<float>(dice.uniform(0.1, 0.9)) * f.right * scale;
    p[1] = static_cast<float>(dice.uniform(-2, 2)) * scale;
    for (int k = 3; k < 3 + attributes; ++k) p[k] = static_cast<float>(dice.uniform(-1, 1));
  }
  for (std::size_t t = 0; t < r.triangles(); ++t) tune_to_tie(dice, r, t, 0);
  return r;
}

}  // namespace

Batch odd_frusta(Dice& dice) {
  if (dice.one_in(5)) return sheared_middles(dice);
  if (dice.one_in(5)) return inexact_widths(dice);
  const int attributes = some_attributes(dice);
  Batch r{some_volume(dice, attributes), odd_frustum(dice), attributes, {}};
  const int count = some_count(dice);
  r.floats.resize(static_cast<std::size_t>(3 * count) * r.stride());
  for (std::size_t i = 0; i < static_cast<std::size_t>(3 * count); ++i) {
    float* p = r.vertex(0, i);
    set_in_view(dice, *r.frustum, p);
    for (int k = 3; k < 3 + attributes; ++k) p[k] = static_cast<float>(dice.uniform(-1, 1));
  }
  return r;
}

Batch clip_distances(Dice& dice) {
  const int attributes = dice.between(1, 9);
  Volume volume = some_volume(dice, 0);
  volume.clip_distances = std::min(8, dice.between(1, attributes));
  const bool on_lattice = dice.one_in(2);
  return make_batch(dice, volume, attributes, [&](const Triangle& v) {
    scatter(dice, v, dice.between(-4, 4));
    for (int k = 4; k < 4 + volume.clip_distances; ++k) {
      const int low = dice.between(-140, 100), width = dice.between(0, 20);
      for (float* p : v) {
        p[k] = on_lattice ? static_cast<float>(dice.between(-2, 3))
                          : dice.over_powers(low, low + width);
        // More are inside than outside, so that something is left.
        if (dice.one_in(2)) p[k] = std::abs(p[k]);
      }
    }
  });
}

Batch depth_clamp(Dice& dice) {
  const int attributes = some_attributes(dice);
  Volume volume = some_volume(dice, attributes);
  volume.clamps_near = dice.one_in(2);
  volume.clamps_far = !volume.clamps_near || dice.one_in(2);
  if (dice.one_in(4)) {
    volume.clamps_near = volume.clamps_far = true;
    Batch r = make_clip_batch(dice, volume, attributes,
                              [&](const Triangle& v) { scatter(dice, v, dice.between(-60, -3)); });
    for (std::size_t t = 0; t < r.triangles(); ++t) tune_to_overflow(dice, r, t, 2);
    return r;
  }
  return make_batch(dice, volume, attributes, [&](const Triangle& v) {
    const int exponent = dice.between(-60, 60);
    scatter(dice, v, exponent);
    if (dice.one_in(3)) {
      // Depths beside the largest float.
      for (float* p : v) {
        for (int c = 0; c < 4; ++c) p[c] = std::ldexp(p[c], -60 - exponent);
        p[2] = dice.over_powers(62, 69);
      }
    } else if (dice.one_in(2)) {
      for (float* p : v) p[2] = std::ldexp(p[2], dice.between(-3, 30));
    }
  });
}

Batch extents(Dice& dice) {
  const int attributes = some_attributes(dice);
  const Volume volume = some_volume(dice, attributes);
  const int width = dice.any_of({0, 2, 10, 60, 250}), low = dice.between(100 - width, 127 - width);
  return make_batch(dice, volume, attributes, [&](const Triangle& v) {
    for (float* p : v) {
      for (int c = 0; c < 4 + attributes; ++c) {
        p[c] = dice.one_in(20) ? dice.turned(kLargestFloat) : dice.over_powers(low, low + width);
      }
      if (!dice.one_in(8)) p[3] = std::abs(p[3]);
    }
  });
}

}  // namespace clipscope::attack
