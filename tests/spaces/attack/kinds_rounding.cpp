// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinds of input whose answers are hard to round: subnormal, half way between floats, at both ends
// of the range, and sums that cancel.
#include "tests/spaces/attack/kinds.hpp"
#include "tests/spaces/attack/making.hpp"
#include "tests/spaces/attack/tuning.hpp"

namespace clipscope::attack {
namespace {

// Units of the smallest float, so many bits of them, either sign.
float units(Dice& dice, int bits) {
  const auto count = static_cast<float>(dice.word() >> (64 - bits));
  return dice.turned(count * kLeastFloat);
}

// What the vertices of an edge are that one plane cuts in the ratio p to q, from inside to outside,
// in units of 2^exponent; w is 2^w_exponent units for both. The third vertex is beside the first.
struct Ratio {
  int p, q, w_exponent, exponent;
};
void set_ratio(Dice& dice, const Triangle& v, int axis, const Ratio& r) {
  const float side = dice.sign();
  for (const int i : {0, 1, 2}) {
    float* const p = v[static_cast<std::size_t>(i)];
    const int w = 1 << r.w_exponent;
    const int along = i == 1 ? w + r.q : w - r.p;
    for (int c = 0; c < 3; ++c) p[c] = 0;
    p[axis] = std::ldexp(side * static_cast<float>(along), r.exponent);
    p[3] = std::ldexp(static_cast<float>(w), r.exponent);
  }
}

// Values a, b so that (q a + p b) / (p + q), p + q = 2^sum, is half way between two floats: b is a
// and 2^(sum - 1) last places of a more.
void set_tie(Dice& dice, float& a, float& b, int sum, int exponent) {
  const float size = dice.significand();
  a = std::ldexp(size, exponent);
  b = std::ldexp(size + std::ldexp(1.0f, sum - 1 - 23), exponent);
  if (dice.one_in(2)) {
    a = -a;
    b = -b;
  }
}

// Values a, b so that (q a + 3 b) / (q + 3), q + 3 = 2^sum, is beside the middle of two floats by a
// alone, most often too little for the double next to the middle: 3 b has 25 bits and is odd.
void set_broken_tie(Dice& dice, float& a, float& b) {
  const int exponent = std::ilogb(b), odd = 2 * dice.below((1 << 23) / 6) + 1;
  b = std::ldexp(std::copysign(1.0f + std::ldexp(static_cast<float>(odd), -23), b), exponent);
  a = dice.turned(std::ldexp(1.0f, std::max(exponent - dice.between(26, 100), -149)));
}

// An edge cut in the ratio p to q, p + q = 2^sum, with ties in each coordinate and attribute that
// the cut leaves free. Returns the axis.
int set_tied_edge(Dice& dice, Triangle& v, const Batch& like, int p, int sum, int w_exponent) {
  const int exponent = dice.between(-20, 20), axis = dice.below(3), q = (1 << sum) - p;
  set_ratio(dice, v, axis, {p, q, w_exponent, exponent});
  for (std::size_t i = 0; i < like.stride(); ++i) {
    if (i == 3 || static_cast<int>(i) == axis) continue;
    const bool is_coordinate = i < 3;
    // So small that no other plane cuts.
    const int size = is_coordinate ? exponent + w_exponent - 3 : dice.between(-126, 120);
    set_tie(dice, v[0][i], v[1][i], sum, size);
    v[2][i] = is_coordinate ? std::ldexp(dice.sign(), size) : v[0][i];
  }
  return axis;
}

// Where two planes meet inside of the triangle, with weights of 1 : 1 : 2 exactly, the first two of
// which are rounded differently: vertices 0 and 1 lie on both sides of x = y = 0 by fine and
// unequal steps, vertex 2 at (2, 2) in NDC.
void set_symmetric(Dice& dice, const Triangle& v) {
  const float w = dice.sized(-20, 20), side_x = dice.sign(), side_y = dice.sign();
  const float x = w * dice.sized(-40, -2), y = w * dice.sized(-40, -2);
  const float xs[3] = {x, -x, 2 * w}, ys[3] = {y, -y, 2 * w};
  for (std::size_t i = 0; i < 3; ++i) {
    v[i][0] = side_x * xs[i];
    v[i][1] = side_y * ys[i];
    v[i][2] = 0;
    v[i][3] = w;
  }
}

// Values whose mean there is exactly 0.
void set_opposite(float& a, float& b, float& c, float size) {
  a = size;
  b = -size;
  c = 0;
}

// An edge's ties, each broken by one end that is next to nothing.
Batch broken_ties(Dice& dice, int attributes) {
  const Batch like{{}, {}, attributes, {}};
  const int sum = dice.between(2, 8);
  return make_batch(dice, some_volume(dice, 0), attributes, [&](Triangle v) {
    const int axis = set_tied_edge(dice, v, like, 3, sum, 8 + dice.below(4));
    for (int i = 0; i < 4 + attributes; ++i) {
      if (i != 3 && i != axis) set_broken_tie(dice, v[0][i], v[1][i]);
    }
    shuffle(dice, v);
  });
}

}  // namespace

Batch subnormals(Dice& dice) {
  const int attributes = some_attributes(dice);
  const int bits = dice.between(2, 25);
  return make_batch(dice, some_volume(dice, attributes), attributes, [&](const Triangle& v) {
    for (float* p : v) {
      for (int c = 0; c < 4 + attributes; ++c) p[c] = units(dice, bits);
      if (!dice.one_in(8)) p[3] = std::abs(p[3]);
    }
    if (!dice.one_in(3)) return;
    // Subnormal coordinates beside a w that is not.
    for (float* p : v) p[3] = dice.sized(-127, 2);
    float* const far = v[static_cast<std::size_t>(dice.below(3))];
    far[dice.below(3)] = 8;
  });
}

Batch exact_ties(Dice& dice) {
  const int attributes = some_attributes(dice);
  Batch like{{}, {}, attributes, {}};
  const Volume volume = some_volume(dice, 0);
  const int sum = dice.between(1, 8);
  return make_batch(dice, volume, attributes, [&](Triangle v) {
    if (dice.one_in(3)) {
      // The mean of a, a and twice its neighbour is half way between them.
      set_symmetric(dice, v);
      for (int k = 4; k < 4 + attributes; ++k) {
        v[0][k] = v[1][k] = dice.over_powers(-100, 100);
        v[2][k] = std::nextafter(v[0][k], 0.0f);
      }
      shuffle(dice, v);
      return;
    }
    const int p = 2 * dice.below(1 << (sum - 1)) + 1;
    set_tied_edge(dice, v, like, p, sum, 8 + dice.below(4));
    shuffle(dice, v);
  });
}

Batch next_to_ties(Dice& dice) {
  const int attributes = some_attributes(dice);
  if (dice.one_in(4)) return broken_ties(dice, attributes);
  if (attributes == 0 || dice.one_in(2)) {
    // Ties whose ratio is off by as little as can be: the distance of one end is 1 - tiny.
    Batch like{{}, {}, attributes, {}};
    const int sum = dice.between(1, 5);
    return make_batch(dice, some_volume(dice, 0), attributes, [&](Triangle v) {
      const int axis = set_tied_edge(dice, v, like, 1, sum, 0);
      for (const std::size_t i : {0u, 2u}) {
        const float tiny = std::ldexp(v[1][3], -dice.between(24, 140));
        v[i][axis] = dice.turned(tiny);
      }
      shuffle(dice, v);
    });
  }
  const Volume volume = some_volume(dice, 0);
  Batch r = make_clip_batch(dice, volume, attributes, [&](const Triangle& v) {
    scatter(dice, v, dice.between(-6, 6));
    // Weights of all sizes.
    float* const p = v[static_cast<std::size_t>(dice.below(3))];
    for (int c = 0; c < 3; ++c) p[c] = std::ldexp(p[c], dice.between(-2, 14));
  });
  r = in_some_space(dice, std::move(r));
  for (std::size_t t = 0; t < r.triangles(); ++t) {
    for (std::size_t i = r.dimension(); i < r.stride(); ++i) tune_to_tie(dice, r, t, i);
  }
  return r;
}

Batch inverse_w_at_overflow(Dice& dice) {
  const int attributes = some_attributes(dice);
  return make_batch(dice, some_volume(dice, attributes), attributes, [&](Triangle v) {
    // 1/w is 2^128 (1 - t 2^-21) at a part t of the edge from w = 2^-128 to one unit more: the
    // largest float is left at t = 1/16.
    const int axis = dice.below(3), w = 1 << 21, p = dice.between(1, 1 << 17),
              q = 15 * p + dice.between(-2, 2);
    set_ratio(dice, v, axis, {p, q, 21, -149});
    v[1][3] += kLeastFloat;
    v[1][axis] += v[1][axis] < 0 ? -kLeastFloat : kLeastFloat;
    const auto other = static_cast<std::size_t>((axis + 1) % 3);
    v[2][other] = static_cast<float>(dice.between(-w, w)) * kLeastFloat;
    if (dice.one_in(3)) {
      for (float* vertex : v) vertex[3] = dice.nudged(vertex[3], 3);
    }
    shuffle(dice, v);
  });
}

Batch underflowing_quotients(Dice& dice) {
  const int attributes = some_attributes(dice);
  return make_batch(dice, some_volume(dice, 0), attributes, [&](const Triangle& v) {
    const int exponent = dice.between(0, 110);
    scatter(dice, v, exponent);
    for (float* p : v) {
      for (int c = 0; c < 3; ++c) {
        if (dice.one_in(2)) p[c] = units(dice, dice.between(1, 6));
      }
      for (int k = 4; k < 4 + attributes; ++k) p[k] = units(dice, dice.between(1, 3));
    }
    // An edge is cut in its middle: half a unit is a tie.
    if (!dice.one_in(3)) return;
    for (float* p : v) p[3] = std::ldexp(1.0f, exponent);
    v[0][0] = 0;
    v[1][0] = std::ldexp(2.0f, exponent);
    for (int c = 1; c < 3; ++c) v[0][c] = v[1][c] = v[2][c] = units(dice, 3);
    for (int k = 4; k < 4 + attributes; ++k) v[0][k] = 0;
  });
}

Batch cancelling_coordinates(Dice& dice) {
  const int attributes = some_attributes(dice);
  const bool is_symmetric = dice.one_in(4);
  Batch r = make_clip_batch(dice, some_volume(dice, 0), attributes, [&](const Triangle& v) {
    if (is_symmetric) {
      set_symmetric(dice, v);
      set_opposite(v[0][2], v[1][2], v[2][2], v[0][3] * dice.sized(-100, -1));
      for (int k = 4; k < 4 + attributes; ++k) {
        set_opposite(v[0][k], v[1][k], v[2][k], dice.over_powers(-149, -100));
      }
      return;
    }
    scatter(dice, v, dice.between(-3, 3));
    // One axis is free: no plane of it cuts.
    for (float* p : v) p[0] = static_cast<float>(dice.uniform(-0.4, 0.4)) * std::abs(p[3]);
    if (dice.one_in(3)) {
      for (float* p : v) {
        for (int c = 0; c < 4; ++c) p[c] = std::round(p[c] * 4);
      }
    }
  });
  for (std::size_t t = 0; !is_symmetric && t < r.triangles(); ++t) {
    tune_to_zero(dice, r, t, 0);
    for (std::size_t i = 4; i < r.stride(); ++i) tune_to_zero(dice, r, t, i);
  }
  return in_some_space(dice, std::move(r));
}

Batch extreme_attributes(Dice& dice) {
  const int attributes = std::max(1, some_attributes(dice));
  return make_batch(dice, some_volume(dice, 0), attributes, [&](const Triangle& v) {
    scatter(dice, v, dice.between(-20, 20));
    for (int k = 4; k < 4 + attributes; ++k) {
      const bool same = dice.one_in(4);
      for (std::size_t i = 0; i < 3; ++i) {
        const float size = dice.any_of({kLargestFloat, std::nextafter(kLargestFloat, 0.0f),
                                        0x1p126f, 0x1p-126f, kLeastFloat, 1.0f});
        v[i][k] = dice.turned(size);
        if (same) v[i][k] = v[0][k];
      }
    }
  });
}

}  // namespace clipscope::attack
