// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/flatness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/fraction.hpp"

namespace clipscope::experiments {
namespace {

using Exact = reference::Rational;

template <std::size_t D>
using Direction = std::array<Exact, D>;

template <std::size_t D>
Exact dot(const Direction<D>& a, const Direction<D>& b) {
  Exact sum(0);
  for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

// The part of p at right angles to `along`, which is not 0.
template <std::size_t D>
Direction<D> rejection(const Direction<D>& p, const Direction<D>& along) {
  const Exact t = dot(p, along) / dot(along, along);
  Direction<D> r;
  for (std::size_t i = 0; i < D; ++i) r[i] = p[i] - t * along[i];
  return r;
}

struct Farthest {
  std::size_t index = 0;
  Exact squared = Exact(0);
};

template <std::size_t D>
Farthest farthest(const std::vector<Direction<D>>& from_origin) {
  Farthest r;
  for (std::size_t i = 0; i < from_origin.size(); ++i) {
    const Exact squared = dot(from_origin[i], from_origin[i]);
    if (r.squared < squared) r = {i, squared};
  }
  return r;
}

// Gram and Schmidt: what is left of the vertices, relative to the first, without two directions.
template <std::size_t D>
Departure departure(std::span<const std::array<double, D>> points) {
  std::vector<Direction<D>> rest(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t i = 0; i < D; ++i) rest[p][i] = Exact(points[p][i]) - Exact(points[0][i]);
  }
  for (int direction = 0; direction < 2; ++direction) {
    const Farthest most = farthest(rest);
    if (most.squared == 0) return {};
    const Direction<D> along = rest[most.index];
    for (Direction<D>& p : rest) p = rejection(p, along);
  }
  const Farthest off = farthest(rest);
  if (off.squared == 0) return {};
  const double distance = std::sqrt(reference::round_to<double>(off.squared));
  return {static_cast<int>(off.index),
          std::max(distance, std::numeric_limits<double>::denorm_min())};
}

}  // namespace

Departure departure_from_plane(std::span<const std::array<double, 3>> points) {
  return departure(points);
}

Departure departure_from_plane(std::span<const std::array<double, 4>> points) {
  return departure(points);
}

}  // namespace clipscope::experiments
