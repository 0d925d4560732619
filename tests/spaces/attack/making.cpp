// SPDX-License-Identifier: GPL-3.0-or-later
//
// See making.hpp.
#include "tests/spaces/attack/making.hpp"

#include <cmath>

namespace clipscope::attack {
namespace {

// The magnitude of the w of some vertex, or 1.
float some_w(Dice& dice, const Batch& batch) {
  const auto t = static_cast<std::size_t>(dice.below(static_cast<int>(batch.triangles())));
  const float w = std::abs(batch.vertex(t, static_cast<std::size_t>(dice.below(3)))[3]);
  return w == 0 || w > 0x1p100f ? 1.0f : w;
}

Frustum some_frustum(Dice& dice, const Batch& batch) {
  const float w = some_w(dice, batch);
  Frustum f;
  f.is_perspective = !dice.one_in(3);
  f.left = f.bottom = -w;
  f.right = f.top = w;
  f.near = f.is_perspective ? w : -w;
  f.far = w;
  if (f.is_perspective) {
    f.is_infinite = dice.one_in(4);
    f.far = std::max(std::ldexp(w, dice.between(1, 12)), std::nextafter(w, kLargestFloat));
  }
  return f;
}

}  // namespace

Volume some_volume(Dice& dice, int distances) {
  Volume r;
  r.depth = dice.any_of({Depth::minus_one_to_one, Depth::zero_to_one, Depth::one_to_zero});
  if (!dice.one_in(3)) return r;
  r.clamps_near = dice.one_in(4);
  r.clamps_far = dice.one_in(4);
  if (distances > 0 && dice.one_in(2)) r.clip_distances = dice.between(1, std::min(distances, 8));
  if (dice.one_in(3)) {
    for (bool& open : r.is_open) open = dice.one_in(2);
  }
  return r;
}

int some_attributes(Dice& dice) { return dice.any_of({0, 1, 4, 4, 4, 7, 9}); }

int some_count(Dice& dice) {
  return dice.one_in(8) ? dice.between(1, 5) : dice.one_in(8) ? 130 : 40;
}

void scatter(Dice& dice, const Triangle& v, int exponent) {
  for (float* p : v) {
    const double w = dice.uniform(0.1, 2);
    for (int c = 0; c < 3; ++c) p[c] = static_cast<float>(dice.uniform(-1.6, 1.6) * w);
    p[3] = static_cast<float>(dice.one_in(8) ? -w : w);
    for (int c = 0; c < 4; ++c) p[c] = std::ldexp(p[c], exponent);
  }
}

Batch in_some_space(Dice& dice, Batch batch) {
  if (dice.one_in(2)) return batch;
  Batch r{batch.volume, some_frustum(dice, batch), batch.attributes, {}};
  for (std::size_t i = 0; i < 3 * batch.triangles(); ++i) {
    const float* p = batch.vertex(0, i);
    r.floats.insert(r.floats.end(), {p[0], p[1], r.frustum->is_perspective ? -p[3] : p[2]});
    r.floats.insert(r.floats.end(), p + 4, p + batch.stride());
  }
  return r;
}

}  // namespace clipscope::attack
