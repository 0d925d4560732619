// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/segments/clip_segments.hpp"

namespace clipscope::experiments::segments {
namespace {

using Limits = std::numeric_limits<float>;
using Point = std::array<float, 4>;

void add_segment(const Point& a, const Point& b, ClipSegments& set) {
  set.numbers.insert(set.numbers.end(), a.begin(), a.end());
  set.numbers.insert(set.numbers.end(), b.begin(), b.end());
}

// All segments of the plane between points whose coordinates are among those given.
void add_grid(std::span<const float> coordinates, ClipSegments& set) {
  for (const float ax : coordinates) {
    for (const float ay : coordinates) {
      for (const float bx : coordinates) {
        for (const float by : coordinates) add_segment({ax, ay, 0, 1}, {bx, by, 0, 1}, set);
      }
    }
  }
}

void add_borders(Random&, std::size_t, ClipSegments& set) {
  add_grid(std::array{-3.0f, -1.0f, -0.5f, 0.0f, 1.0f, 2.0f}, set);
}

void add_neighbours(Random&, std::size_t, ClipSegments& set) {
  const float in = std::nextafter(1.0f, 0.0f), out = std::nextafter(1.0f, 2.0f);
  add_grid(std::array{-out, -1.0f, -in, 0.25f, in, 1.0f, out}, set);
}

void add_far(Random&, std::size_t, ClipSegments& set) {
  add_grid(std::array{-Limits::max(), -1e20f, -0.5f, 0.25f, 1e8f, 1e20f, Limits::max()}, set);
}

void add_subnormal(Random&, std::size_t, ClipSegments& set) {
  const float tiny = Limits::denorm_min(), low = Limits::min() / 2;
  add_grid(std::array{-1.5f, -low, -tiny, 0.0f, tiny, low, 0.75f, 1.5f}, set);
}

// Through the corner but for the rounding of both ends.
void add_corners(Random& random, std::size_t size, ClipSegments& set) {
  while (set.size() < size) {
    const double cx = random.sign(), cy = random.sign();
    const double dx = random.uniform(-1, 1), dy = random.uniform(-1, 1);
    const double back = random.across_magnitudes(0x1p-8, 8);
    const double forth = random.across_magnitudes(0x1p-8, 8);
    add_segment({static_cast<float>(cx - back * dx), static_cast<float>(cy - back * dy), 0, 1},
                {static_cast<float>(cx + forth * dx), static_cast<float>(cy + forth * dy), 0, 1},
                set);
  }
}

// From a few ulps inside a side to a few ulps beyond it.
void add_grazing(Random& random, std::size_t size, ClipSegments& set) {
  while (set.size() < size) {
    const bool along_x = random.chance(0.5);
    const double side = random.sign();
    std::array<Point, 2> ends;
    for (Point& end : ends) {
      const auto along = static_cast<float>(random.uniform(-3, 3));
      const double steps = static_cast<double>(random.below(9)) - 4;
      const auto across = static_cast<float>(side * (1 + steps * 0x1p-23));
      end = along_x ? Point{along, across, 0, 1} : Point{across, along, 0, 1};
    }
    add_segment(ends[0], ends[1], set);
  }
}

void add_w_sign(Random& random, std::size_t size, ClipSegments& set) {
  const auto end = [&random] {
    Point p;
    for (float& coordinate : p) coordinate = static_cast<float>(random.below(6)) - 3;
    p[3] = static_cast<float>(random.below(4)) - 1;  // -1, 0, 1, 2
    return p;
  };
  while (set.size() < size) {
    const Point a = end(), b = end();
    add_segment(a, b, set);
  }
}

void add_w_scale(Random& random, std::size_t size, ClipSegments& set) {
  const auto end = [&random] {
    const int exponent = static_cast<int>(random.below(200)) - 100;
    Point p;
    for (float& coordinate : p) {
      coordinate = std::ldexp(static_cast<float>(random.uniform(-2, 2)), exponent);
    }
    p[3] = std::ldexp(static_cast<float>(random.uniform(0.5, 1)), exponent);
    return p;
  };
  while (set.size() < size) {
    const Point a = end(), b = end();
    add_segment(a, b, set);
  }
}

struct HardRecipe {
  std::string_view name;
  bool in_plane = true;
  void (*add)(Random&, std::size_t, ClipSegments&);
};

constexpr std::array kHardRecipes = {
    HardRecipe{"borders", true, add_borders}, HardRecipe{"neighbours", true, add_neighbours},
    HardRecipe{"corners", true, add_corners}, HardRecipe{"grazing", true, add_grazing},
    HardRecipe{"far", true, add_far},         HardRecipe{"subnormal", true, add_subnormal},
    HardRecipe{"w_sign", false, add_w_sign},  HardRecipe{"w_scale", false, add_w_scale}};

}  // namespace

std::vector<std::string> hard_sets() {
  std::vector<std::string> names;
  for (const HardRecipe& recipe : kHardRecipes) names.emplace_back(recipe.name);
  return names;
}

ClipSegments make_hard_set(std::string_view name, std::size_t size, std::uint64_t seed) {
  const auto recipe = std::ranges::find(kHardRecipes, name, &HardRecipe::name);
  if (recipe == kHardRecipes.end()) {
    throw UsageError(fmt::format("no hard set of segments is called '{}'; there are: {}", name,
                                 fmt::join(hard_sets(), ", ")));
  }
  Random random(seed);
  ClipSegments set{std::string(name), recipe->in_plane};
  recipe->add(random, size, set);
  return thinned(set, size);
}

}  // namespace clipscope::experiments::segments
