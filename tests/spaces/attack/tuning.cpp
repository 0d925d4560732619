// SPDX-License-Identifier: GPL-3.0-or-later
//
// See tuning.hpp.
#include "tests/spaces/attack/tuning.hpp"

#include <cmath>
#include <vector>

#include "tests/spaces/attack/integer_clip.hpp"

namespace clipscope::attack {
namespace {

constexpr int kTries = 12;

// The weights of some new corner; none: all 0.
Weights some_new_corner(Dice& dice, const Batch& batch, std::size_t triangle) {
  Facts unused;
  std::vector<Corner> found = corners(batch, triangle, unused);
  std::erase_if(found, [](const Corner& c) { return c.own >= 0; });
  if (found.empty()) return {};
  return found[static_cast<std::size_t>(dice.below(static_cast<int>(found.size())))].lambda;
}

Weights numbers_at(const Batch& batch, std::size_t triangle, std::size_t place) {
  return {scaled(batch.vertex(triangle, 0)[place]), scaled(batch.vertex(triangle, 1)[place]),
          scaled(batch.vertex(triangle, 2)[place])};
}

// lambda . (1, 1, 1), or, of a coordinate that is divided by w, lambda . w; in the scale of `one`.
Integer divisor_of(const Batch& batch, std::size_t triangle, std::size_t place, bool in_ndc,
                   const Weights& lambda) {
  if (place < 3 && in_ndc && !batch.is_view()) return dot(lambda, numbers_at(batch, triangle, 3));
  return (lambda[0] + lambda[1] + lambda[2]) << kFloatScale;
}

// The vertex of the least weight: its float is what the number depends on most finely.
std::size_t finest(const Weights& lambda) {
  std::size_t r = 3;
  for (std::size_t v = 0; v < 3; ++v) {
    if (lambda[v] != 0 && (r == 3 || lambda[v] < lambda[r])) r = v;
  }
  return r;
}

// Sets the float of vertex v so that lambda . numbers comes next to `wanted` over 2.
void set_for_sum(Batch& batch, std::size_t triangle, std::size_t place, std::size_t v,
                 const Weights& lambda, const Integer& wanted) {
  Weights others = numbers_at(batch, triangle, place);
  others[v] = 0;
  const Integer rest = wanted - 2 * dot(lambda, others);
  const float x = nearest({rest, Integer(2 * lambda[v]) << kFloatScale}).value;
  if (std::isfinite(x)) batch.vertex(triangle, v)[place] = x;
}

void randomise(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place) {
  for (std::size_t v = 0; v < 3; ++v) {
    float& x = batch.vertex(triangle, v)[place];
    x = std::copysign(dice.sized(-2, 1), x);
  }
}

}  // namespace

void tune_to_tie(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place) {
  const Weights lambda = some_new_corner(dice, batch, triangle);
  const std::size_t v = finest(lambda);
  if (v == 3) return;
  const Integer divisor = divisor_of(batch, triangle, place, dice.one_in(2), lambda);
  if (divisor <= 0) return;
  std::array<float, 3> best_floats{};
  int most = -1;
  for (int i = 0; i < kTries; ++i) {
    if (i > 0) randomise(dice, batch, triangle, place);
    const float here = nearest({dot(lambda, numbers_at(batch, triangle, place)), divisor}).value,
                next = std::nextafter(here, kLargestFloat);
    if (!std::isfinite(next)) continue;
    // Twice the sum that makes the quotient half way between them.
    Integer wanted = (scaled(here) + scaled(next)) * divisor;
    wanted >>= kFloatScale;
    set_for_sum(batch, triangle, place, v, lambda, wanted);
    const int zeros =
        nearest({dot(lambda, numbers_at(batch, triangle, place)), divisor}).zeros_to_tie;
    if (zeros <= most) continue;
    most = zeros;
    for (std::size_t k = 0; k < 3; ++k) best_floats[k] = batch.vertex(triangle, k)[place];
  }
  if (most < 0) return;
  for (std::size_t k = 0; k < 3; ++k) batch.vertex(triangle, k)[place] = best_floats[k];
}

void tune_to_zero(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place) {
  const Weights lambda = some_new_corner(dice, batch, triangle);
  const std::size_t v = finest(lambda);
  if (v != 3) set_for_sum(batch, triangle, place, v, lambda, 0);
}

}  // namespace clipscope::attack
