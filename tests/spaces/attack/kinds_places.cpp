// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinds of input whose vertices lie where decisions are hard: on planes and beside them, on each
// other, in a line, at the eye.
#include "tests/spaces/attack/kinds.hpp"
#include "tests/spaces/attack/making.hpp"
#include "tests/spaces/attack/tuning.hpp"

namespace clipscope::attack {
namespace {

// Halves, -limit to limit of them.
float half(Dice& dice, int limit) { return static_cast<float>(dice.between(-limit, limit)) / 2; }

void set_halves(Dice& dice, const Triangle& v, int limit) {
  for (float* p : v) {
    for (int c = 0; c < 4; ++c) p[c] = half(dice, limit);
    if (!dice.one_in(6)) p[3] = std::abs(p[3]);
  }
}

}  // namespace

Batch ulps_from_planes(Dice& dice) {
  const int attributes = std::max(2, some_attributes(dice));
  Volume volume = some_volume(dice, 0);
  if (dice.one_in(3)) volume.clip_distances = 2;
  Batch r = make_clip_batch(dice, volume, attributes, [&](const Triangle& v) {
    scatter(dice, v, dice.between(-30, 30));
    for (float* p : v) {
      for (int c = 0; c < 3; ++c) {
        if (dice.one_in(2)) p[c] = dice.nudged(dice.turned(p[3]), 3);
      }
      if (dice.one_in(6)) p[2] = dice.nudged(0.0f, 3);
    }
    if (!dice.one_in(4)) return;
    for (int c = 0; c < 4; ++c) v[1][c] = dice.nudged(v[0][c], 2);
  });
  // Clip distances whose line misses a corner by as little as can be.
  for (std::size_t t = 0; volume.clip_distances != 0 && t < r.triangles(); ++t) {
    Batch only = r.only(t);
    only.volume.clip_distances = 0;
    for (std::size_t i : {4u, 5u}) {
      tune_to_zero(dice, only, 0, i);
      for (std::size_t v = 0; v < 3; ++v) r.vertex(t, v)[i] = dice.nudged(only.vertex(0, v)[i], 1);
    }
  }
  return in_some_space(dice, std::move(r));
}

Batch through_the_eye(Dice& dice) {
  const int attributes = some_attributes(dice);
  return make_batch(dice, some_volume(dice, attributes), attributes, [&](Triangle v) {
    if (dice.one_in(2)) {
      set_halves(dice, v, 4);
    } else {
      scatter(dice, v, dice.between(-4, 4));
    }
    switch (dice.below(5)) {
      case 0:  // an edge through (0, 0, 0, 0)
        for (int c = 0; c < 4; ++c) v[1][c] = -v[0][c] * 2;
        break;
      case 1:  // a vertex there
        for (int c = 0; c < 4; ++c) v[0][c] = 0;
        break;
      case 2:  // w = 0 of two vertices
        v[0][3] = v[1][3] = 0;
        break;
      case 3:  // the triangle's plane through it
        for (int c = 0; c < 4; ++c) v[2][c] = v[0][c] - v[1][c];
        break;
      default:  // w of all signs
        v[0][3] = std::abs(v[0][3]);
        v[1][3] = -std::abs(v[1][3]);
        v[2][3] = 0;
    }
    shuffle(dice, v);
  });
}

Batch slivers(Dice& dice) {
  const int attributes = some_attributes(dice);
  return make_batch(dice, some_volume(dice, attributes), attributes, [&](Triangle v) {
    scatter(dice, v, dice.between(-8, 8));
    const double part = dice.one_in(4) ? dice.uniform(-1, 2) : dice.fraction();
    for (int c = 0; c < 4; ++c) {
      const double between = (1 - part) * v[0][c] + part * v[1][c];
      v[2][c] = dice.nudged(static_cast<float>(between), dice.one_in(2) ? 0 : 3);
    }
    if (dice.one_in(2)) v[0][dice.below(3)] *= 4;  // so that something is cut
    shuffle(dice, v);
  });
}

Batch signed_zeros(Dice& dice) {
  const int attributes = some_attributes(dice);
  return make_batch(dice, some_volume(dice, attributes), attributes, [&](const Triangle& v) {
    const auto number = [&] { return dice.any_of({0.0f, -0.0f, 1.0f, -1.0f, 0.5f, -2.0f, 2.0f}); };
    for (float* p : v) {
      for (int c = 0; c < 3; ++c) p[c] = number();
      p[3] = dice.any_of({1.0f, 1.0f, 1.0f, 2.0f, 0.5f, 0.0f, -0.0f, -1.0f});
      for (int k = 4; k < 4 + attributes; ++k) p[k] = dice.one_in(3) ? number() : dice.turned(0);
    }
  });
}

Batch degenerate_corners(Dice& dice) {
  const int attributes = some_attributes(dice);
  Volume volume = some_volume(dice, attributes);
  if (dice.one_in(3)) volume.is_open = {dice.one_in(2), dice.one_in(2), dice.one_in(2), true};
  return make_batch(dice, volume, attributes, [&](Triangle v) {
    set_halves(dice, v, dice.one_in(2) ? 2 : 6);
    for (float* p : v) {
      for (int k = 4; k < 4 + attributes; ++k) p[k] = half(dice, 4);
    }
    switch (dice.below(5)) {
      case 0:  // one vertex twice, with other attributes
        for (int c = 0; c < 4; ++c) v[2][c] = v[1][c];
        break;
      case 1:  // the third half way between the others
        for (int c = 0; c < 4; ++c) v[2][c] = (v[0][c] + v[1][c]) / 2;
        break;
      case 2:  // all in one plane of the volume
        for (float* p : v) {
          p[3] = std::abs(p[3]);
          p[1] = p[3];
        }
        break;
      case 3:  // corners of the volume
        for (float* p : v) {
          for (int c = 0; c < 3; ++c) p[c] = dice.turned(p[3]);
        }
        break;
      default: break;
    }
    shuffle(dice, v);
  });
}

}  // namespace clipscope::attack
