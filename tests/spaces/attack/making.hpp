// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the kinds of input are made with.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "tests/spaces/attack/dice.hpp"
#include "tests/spaces/attack/input.hpp"

namespace clipscope::attack {

// The three vertices of a triangle in a batch, each x y z w and then attributes.
using Triangle = std::array<float*, 3>;

// Mostly the closed volume of six planes, which SIMD clips; `distances`: at most so many.
Volume some_volume(Dice& dice, int distances);

// How many attributes: what has code of its own (0, 4), and others.
int some_attributes(Dice& dice);

// How many triangles: enough for all lanes of a register, and some batches that do not fill them.
int some_count(Dice& dice);

// A triangle around the volume, about as large, at a scale of 2^exponent; about one vertex in
// eight behind the eye.
void scatter(Dice& dice, const Triangle& v, int exponent);

// The same batch in view space half of the time: x and y in NDC are the same there, w is -z, and
// depth is that of a frustum which a vertex's w bounds.
Batch in_some_space(Dice& dice, Batch batch);

// A batch of triangles, each made by set(triangle), with random attributes that it may overwrite.
template <class Set>
Batch make_clip_batch(Dice& dice, const Volume& volume, int attributes, Set&& set) {
  Batch r{volume, {}, attributes, {}};
  const int count = some_count(dice);
  r.floats.resize(static_cast<std::size_t>(3 * count) * r.stride());
  for (float& x : r.floats) x = static_cast<float>(dice.uniform(-1, 1));
  for (std::size_t t = 0; t < r.triangles(); ++t) {
    set(Triangle{r.vertex(t, 0), r.vertex(t, 1), r.vertex(t, 2)});
  }
  return r;
}
template <class Set>
Batch make_batch(Dice& dice, const Volume& volume, int attributes, Set&& set) {
  return in_some_space(dice, make_clip_batch(dice, volume, attributes, std::forward<Set>(set)));
}

// Another order of the vertices.
inline void shuffle(Dice& dice, Triangle& v) {
  for (std::size_t i = 2; i > 0; --i) {
    const int other = dice.below(static_cast<int>(i) + 1);
    std::swap(v[i], v[static_cast<std::size_t>(other)]);
  }
}

}  // namespace clipscope::attack
