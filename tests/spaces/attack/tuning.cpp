// SPDX-License-Identifier: GPL-3.0-or-later
//
// See tuning.hpp.
#include "tests/spaces/attack/tuning.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
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

// What is tuned: a number of one vertex, for a corner and the divisor of its quotient; the terms of
// the numerator are `factor` times the numbers, plus `offsets`.
struct Aim {
  Weights lambda;
  Integer divisor;
  std::size_t triangle, place, vertex;
  Integer factor = 1;
  Weights offsets = {};
};

// x or y in NDC, of a view-space triangle.
void see_through_frustum(const Batch& batch, Aim& aim) {
  const Frustum& f = *batch.frustum;
  const Channel channel = ndc_channels(batch, aim.triangle)[aim.place];
  const Weights numbers = numbers_at(batch, aim.triangle, aim.place);
  aim.factor = f.is_perspective ? Integer(2 * scaled(f.near)) : Integer(1) << (kFloatScale + 1);
  for (std::size_t v = 0; v < 3; ++v) {
    aim.offsets[v] = channel.numerator[v] - aim.factor * numbers[v];
  }
  aim.divisor = dot(aim.lambda, channel.denominator);
}

std::optional<Aim> some_aim(Dice& dice, const Batch& batch, std::size_t triangle, std::size_t place,
                            bool in_ndc) {
  const Weights lambda = some_new_corner(dice, batch, triangle);
  const std::size_t v = finest(lambda);
  if (v == 3) return {};
  Aim r{lambda, divisor_of(batch, triangle, place, in_ndc, lambda), triangle, place, v, 1, {}};
  if (batch.is_view() && place < 2) see_through_frustum(batch, r);
  return r.divisor > 0 ? std::optional(r) : std::nullopt;
}

Integer numerator_at(const Batch& batch, const Aim& aim) {
  return aim.factor * dot(aim.lambda, numbers_at(batch, aim.triangle, aim.place)) +
         dot(aim.lambda, aim.offsets);
}

Nearest quotient_at(const Batch& batch, const Aim& aim) {
  return nearest({numerator_at(batch, aim), aim.divisor});
}

// Sets the float of the vertex so that lambda . numbers comes next to `wanted` over 2.
void set_for_sum(Batch& batch, const Aim& aim, const Integer& wanted) {
  float& own = batch.vertex(aim.triangle, aim.vertex)[aim.place];
  own = 0;
  const Integer rest = wanted - 2 * numerator_at(batch, aim),
                weight = 2 * aim.factor * aim.lambda[aim.vertex];
  const float x = nearest({rest, weight << kFloatScale}).value;
  if (std::isfinite(x)) own = x;
}

// Moves the floats of all vertices but one by some last places, so that they keep their size; that
// one becomes 0.
void randomise(Dice& dice, Batch& batch, const Aim& aim, int most) {
  for (std::size_t v = 0; v < 3; ++v) {
    float& x = batch.vertex(aim.triangle, v)[aim.place];
    if (v == aim.vertex) x = 0;
    if (std::abs(x) < 0x1p-100f) continue;
    const auto steps = static_cast<std::uint32_t>(dice.between(-most, most));
    const float moved = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + steps);
    if (std::isfinite(moved)) x = moved;
  }
}

// The float above one in magnitude, in the scale of integers: above the largest it is 2^128.
Integer scaled_next(float x) {
  const float furthest = std::copysign(kLargestFloat, x);
  if (x != furthest) return scaled(std::nextafter(x, furthest));
  const Integer above = Integer(1) << (128 + kFloatScale);
  return x < 0 ? Integer(-above) : above;
}

// Tries some floats of the other vertices, and keeps those from which the one comes nearest to half
// way between the float that the others give and the next.
void approach(Dice& dice, Batch& batch, const Aim& aim, int most_steps) {
  const auto floats = [&](std::size_t v) -> float& {
    return batch.vertex(aim.triangle, v)[aim.place];
  };
  const std::array<float, 3> first = {floats(0), floats(1), floats(2)};
  std::array<float, 3> best = first;
  int most = -1;
  for (int i = 0; i < kTries; ++i) {
    for (std::size_t v = 0; v < 3; ++v) floats(v) = first[v];
    randomise(dice, batch, aim, most_steps);
    const float here = quotient_at(batch, aim).value;
    if (!std::isfinite(here)) continue;
    // Twice the sum that makes the quotient half way between them.
    Integer wanted = (scaled(here) + scaled_next(here)) * aim.divisor;
    wanted >>= kFloatScale;
    set_for_sum(batch, aim, wanted);
    const int zeros = quotient_at(batch, aim).zeros_to_tie;
    if (zeros <= most) continue;
    most = zeros;
    best = {floats(0), floats(1), floats(2)};
  }
  for (std::size_t v = 0; v < 3; ++v) floats(v) = best[v];
}

}  // namespace

void tune_to_tie(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place) {
  if (const auto aim = some_aim(dice, batch, triangle, place, dice.one_in(2))) {
    approach(dice, batch, *aim, 4000);
  }
}

void tune_to_overflow(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place) {
  const auto aim = some_aim(dice, batch, triangle, place, true);
  if (!aim) return;
  // Equal floats of the other vertices, so that without the one the quotient is about the largest.
  Integer others = aim->lambda[0] + aim->lambda[1] + aim->lambda[2] - aim->lambda[aim->vertex];
  if (others == 0) return;
  const Integer wanted = scaled(dice.turned(kLargestFloat)) * aim->divisor;
  const float x = nearest({wanted, others << (2 * kFloatScale)}).value;
  if (!std::isfinite(x)) return;
  for (std::size_t v = 0; v < 3; ++v) batch.vertex(triangle, v)[place] = x;
  approach(dice, batch, *aim, 2);
}

void tune_to_zero(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place) {
  const Weights lambda = some_new_corner(dice, batch, triangle);
  const std::size_t v = finest(lambda);
  if (v != 3) set_for_sum(batch, {lambda, 0, triangle, place, v, 1, {}}, 0);
}

}  // namespace clipscope::attack
