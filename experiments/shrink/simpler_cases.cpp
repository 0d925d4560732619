// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/simpler_cases.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "experiments/catalogue/projected.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {
namespace {

using reference::InputVertex;

constexpr int kFloatBits = 24;

std::size_t dimension_of(const HardCase& c) { return c.space == Space::view ? 3 : 4; }

bool is_float(double x) {
  return std::abs(x) <= double{std::numeric_limits<float>::max()} &&
         double{static_cast<float>(x)} == x;
}

double rounded_to_bits(double x, int bits) {
  if (x == 0) return 0;
  const int shift = bits - 1 - std::ilogb(x);
  return std::ldexp(std::nearbyint(std::ldexp(x, shift)), -shift);
}

template <class F>
void for_each_coordinate(HardCase& c, const F& f) {
  for (InputVertex& v : c.vertices) {
    std::for_each_n(v.position.begin(), dimension_of(c), f);
  }
}

// --- Costs ---------------------------------------------------------------------------------------

// 0: none; 1, the simplest: 1.
double cost_of_number(double x) {
  if (x == 0) return 0;
  constexpr double kBit = 4, kExponent = 1.0 / 64, kSign = 0.25;
  return 1 + kBit * (significant_bits(x) - 1) + kExponent * std::abs(std::ilogb(x)) +
         (x < 0 ? kSign : 0);
}

double cost_of_frustum(const Frustum<double>& f) {
  const Frustum<double> standard;
  double cost = f.kind == standard.kind ? 0 : 20;
  const auto add = [&](double x, double usual) {
    if (x != usual) cost += 5 + cost_of_number(x);
  };
  add(f.left, standard.left);
  add(f.right, standard.right);
  add(f.bottom, standard.bottom);
  add(f.top, standard.top);
  add(f.near, standard.near);
  if (f.infinite_far) {
    cost += 5;
  } else {
    add(f.far, standard.far);
  }
  add(f.shear_x, 0);
  add(f.shear_y, 0);
  return cost;
}

double cost_of_setting(const HardCase& c) {
  constexpr double kOption = 200, kDepth = 10, kMatrix = 2000;
  const ClipVolume& v = c.volume;
  const OpenSides& open = v.open_sides;
  const int options = v.depth_clamp.near + v.depth_clamp.far + v.clip_distances + open.left +
                      open.right + open.bottom + open.top + static_cast<int>(c.planes.size());
  double cost = kOption * options;
  if (v.depth != DepthRange::minus_one_to_one) cost += kDepth;
  if (c.matrix) cost += kMatrix;
  return has_frustum(c) ? cost + cost_of_frustum(c.frustum) : cost;
}

// Attributes as a file of cases leaves them out are next to none.
double cost_of_attributes(const HardCase& c) {
  constexpr double kAttribute = 40;
  double cost = kAttribute * c.attribute_count;
  for (const InputVertex& v : c.vertices) {
    for (int k = 0; k < c.attribute_count; ++k) {
      cost += cost_of_number(v.attributes[static_cast<std::size_t>(k)]);
    }
  }
  return cost;
}

// --- The setting ---------------------------------------------------------------------------------

using Change = std::function<void(HardCase&)>;

void set_depth(HardCase& c, DepthRange depth) { c.volume.depth = c.frustum.depth = depth; }

void drop_clip_distance(HardCase& c) {
  --c.volume.clip_distances;
  --c.attribute_count;
  for (InputVertex& v : c.vertices) std::shift_left(v.attributes.begin(), v.attributes.end(), 1);
}

std::vector<Change> changes_of_setting(const HardCase& c) {
  std::vector<Change> changes = {[](HardCase& x) { x.planes.clear(); },
                                 [](HardCase& x) { x.volume.depth_clamp = {}; },
                                 [](HardCase& x) { x.volume.depth_clamp.near = false; },
                                 [](HardCase& x) { x.volume.depth_clamp.far = false; },
                                 [](HardCase& x) { x.volume.open_sides = {}; },
                                 [](HardCase& x) { set_depth(x, DepthRange::minus_one_to_one); },
                                 [](HardCase& x) { set_depth(x, DepthRange::zero_to_one); },
                                 [](HardCase& x) {
                                   x.attribute_count -= x.volume.clip_distances;
                                   for (InputVertex& v : x.vertices) {
                                     std::shift_left(v.attributes.begin(), v.attributes.end(),
                                                     x.volume.clip_distances);
                                   }
                                   x.volume.clip_distances = 0;
                                 }};
  for (const char* side : {"left", "right", "bottom", "top"}) {
    changes.push_back([side](HardCase& x) { *find_side(x.volume.open_sides, side) = false; });
  }
  if (c.volume.clip_distances > 0) changes.push_back(drop_clip_distance);
  if (c.space == Space::view) {
    changes.push_back([](HardCase& x) { x = projected(std::move(x)); });
    changes.push_back([](HardCase& x) { x.frustum = Frustum<double>{.depth = x.volume.depth}; });
  }
  return changes;
}

// Shorter frusta, number by number and all at once. What is no frustum any more is left out.
void add_simpler_frusta(const HardCase& original, std::vector<HardCase>& cases) {
  if (!has_frustum(original)) return;
  const auto add = [&](const std::function<void(Frustum<double>&)>& change) {
    HardCase c = original;
    change(c.frustum);
    if (is_valid(c.frustum)) cases.push_back(std::move(c));
  };
  constexpr double Frustum<double>::*kNumbers[] = {
      &Frustum<double>::left,    &Frustum<double>::right,  &Frustum<double>::bottom,
      &Frustum<double>::top,     &Frustum<double>::near,   &Frustum<double>::far,
      &Frustum<double>::shear_x, &Frustum<double>::shear_y};
  for (const auto number : kNumbers) {
    add([&](Frustum<double>& f) { f.*number = Frustum<double>().*number; });
    for (const int bits : {1, 2, 4, 8}) {
      add([&](Frustum<double>& f) { f.*number = rounded_to_bits(f.*number, bits); });
    }
  }
  for (const int bits : {1, 2, 4, 8, 12}) {
    add([&](Frustum<double>& f) {
      for (const auto number : kNumbers) f.*number = rounded_to_bits(f.*number, bits);
    });
  }
}

// Without attributes; those that a file leaves out; the first so many; with short numbers.
void add_simpler_attributes(const HardCase& original, std::vector<HardCase>& cases) {
  const int least = original.volume.clip_distances;
  for (int count = least; count < original.attribute_count; ++count) {
    cases.push_back(original);
    cases.back().attribute_count = count;
  }
  // One attribute in place of the first that is left.
  for (int k = least + 1; k < original.attribute_count; ++k) {
    HardCase c = original;
    for (InputVertex& v : c.vertices) {
      v.attributes[static_cast<std::size_t>(least)] = v.attributes[static_cast<std::size_t>(k)];
    }
    c.attribute_count = least + 1;
    cases.push_back(std::move(c));
  }
  for (std::size_t i = 0; i < original.vertices.size(); ++i) {
    for (int k = 0; k < original.attribute_count; ++k) {
      const double x = original.vertices[i].attributes[static_cast<std::size_t>(k)];
      for (const double simpler : {0.0, std::copysign(1.0, x), rounded_to_bits(x, 1),
                                   rounded_to_bits(x, 3), rounded_to_bits(x, 8)}) {
        HardCase c = original;
        c.vertices[i].attributes[static_cast<std::size_t>(k)] = simpler;
        cases.push_back(std::move(c));
      }
    }
  }
}

// --- All coordinates -----------------------------------------------------------------------------

double largest_coordinate(const HardCase& c) {
  double largest = 0;
  for (const InputVertex& v : c.vertices) {
    for (std::size_t i = 0; i < dimension_of(c); ++i) {
      largest = std::max(largest, std::abs(v.position[i]));
    }
  }
  return largest;
}

void scale_by_power(HardCase& c, int k) {
  for_each_coordinate(c, [k](double& x) { x = std::ldexp(x, k); });
  if (!has_frustum(c)) return;
  Frustum<double>& f = c.frustum;
  for (double* length : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) {
    *length = std::ldexp(*length, k);
  }
}

// Each vertex by a power of two of its own, so that its w is near 1.
void scale_vertices(HardCase& c) {
  if (c.space != Space::clip) return;
  for (InputVertex& v : c.vertices) {
    const double w = v.position[3];
    if (w == 0) continue;
    for (double& x : v.position) x = std::ldexp(x, -std::ilogb(w));
  }
}

// Each vertex over its own |w|.
void divide_vertices(HardCase& c) {
  if (c.space != Space::clip) return;
  for (InputVertex& v : c.vertices) {
    const double w = std::abs(v.position[3]);
    if (w == 0) continue;
    for (double& x : v.position) x = static_cast<float>(x / w);
  }
}

void round_all(HardCase& c, int bits) {
  for_each_coordinate(c, [bits](double& x) { x = rounded_to_bits(x, bits); });
}

// To multiples of 2^-bits of the power of two above the largest.
void round_to_grid(HardCase& c, int bits) {
  const double largest = largest_coordinate(c);
  if (largest == 0) return;
  const int shift = bits - 1 - std::ilogb(largest);
  for_each_coordinate(c, [shift](double& x) {
    x = std::ldexp(std::nearbyint(std::ldexp(x, shift)), -shift) + 0.0;
  });
}

// Up to two units of the last of so many bits off, about half of the coordinates.
void jitter(HardCase& c, int bits, Random& random) {
  for_each_coordinate(c, [&](double& x) {
    const double unit = x == 0 ? 0 : std::ldexp(1, std::ilogb(x) - bits + 1);
    const auto units = static_cast<int>(random.below(9)) - 4;
    if (std::abs(units) <= 2) x = rounded_to_bits(x + units * unit, bits);
  });
}

void add_scaled_and_rounded(const HardCase& original, std::vector<HardCase>& cases) {
  const double largest = largest_coordinate(original);
  if (largest == 0) return;
  std::set<int> powers = {0, -std::ilogb(largest)};
  for (int k = -120; k <= 120; k += 8) powers.insert(k);
  for (const int k : powers) {
    HardCase scaled = original;
    scale_by_power(scaled, k);
    cases.push_back(scaled);
    for (const int bits : {1, 2, 3, 5, 8, 12}) {
      round_all(cases.emplace_back(scaled), bits);
      round_to_grid(cases.emplace_back(scaled), bits);
    }
  }
  scale_vertices(cases.emplace_back(original));
  divide_vertices(cases.emplace_back(original));
}

void add_jittered(const HardCase& original, std::vector<HardCase>& cases) {
  constexpr int kPerLength = 48;
  const int now = significant_bits(original);
  Random random(1);
  for (const int bits : {2, 3, 4, 6, 8, 10, 12}) {
    if (bits >= now) break;
    for (int i = 0; i < kPerLength; ++i) jitter(cases.emplace_back(original), bits, random);
  }
}

bool has_floats_only(const HardCase& c) {
  const auto fits = [&](const InputVertex& v) {
    return std::all_of(v.position.begin(), v.position.end(), is_float) &&
           std::all_of(v.attributes.begin(), v.attributes.begin() + c.attribute_count, is_float);
  };
  const Frustum<double>& f = c.frustum;
  const std::array lengths = {f.left, f.right, f.bottom,  f.top,
                              f.near, f.far,   f.shear_x, f.shear_y};
  return std::ranges::all_of(c.vertices, fits) &&
         (!has_frustum(c) || (std::ranges::all_of(lengths, is_float) && is_valid(f)));
}

std::vector<double> simpler_values(const HardCase& c, std::size_t vertex, std::size_t coordinate) {
  const std::array<double, 4>& p = c.vertices[vertex].position;
  const double x = p[coordinate], sign = std::copysign(1.0, x);
  std::vector<double> values = {0, sign, -sign, 2 * sign, sign / 2, std::nearbyint(x)};
  for (int bits = 1; bits < kFloatBits; bits += bits < 12 ? 1 : 4) {
    values.push_back(rounded_to_bits(x, bits));
  }
  for (const double near : {1.0, 2.0}) values.push_back(std::nearbyint(x) + near * sign);
  for (std::size_t i = 0; i < dimension_of(c); ++i) values.insert(values.end(), {p[i], -p[i]});
  for (const InputVertex& other : c.vertices) values.push_back(other.position[coordinate]);
  return values;
}

}  // namespace

int significant_bits(double x) {
  if (x == 0 || !std::isfinite(x)) return 0;
  int bits = 1;
  while (rounded_to_bits(x, bits) != x) ++bits;
  return bits;
}

int significant_bits(const HardCase& hard_case) {
  int most = 0;
  for (const InputVertex& v : hard_case.vertices) {
    for (std::size_t i = 0; i < dimension_of(hard_case); ++i) {
      most = std::max(most, significant_bits(v.position[i]));
    }
  }
  return most;
}

double cost_of(const HardCase& c) {
  double cost = cost_of_setting(c) + cost_of_attributes(c);
  std::set<double> different;
  for (const InputVertex& v : c.vertices) {
    for (std::size_t i = 0; i < dimension_of(c); ++i) {
      cost += cost_of_number(v.position[i]);
      different.insert(std::abs(v.position[i]));
    }
  }
  constexpr double kDifferent = 0.5;
  return cost + kDifferent * static_cast<double>(different.size());
}

std::vector<CoordinateChange> simpler_coordinates(const HardCase& c) {
  std::vector<CoordinateChange> changes;
  const double cost = cost_of(c);
  for (std::size_t v = 0; v < c.vertices.size(); ++v) {
    for (std::size_t i = 0; i < dimension_of(c); ++i) {
      std::set<double> seen;
      for (const double value : simpler_values(c, v, i)) {
        if (!is_float(value) || !seen.insert(value).second) continue;
        const CoordinateChange change{v, i, value + 0.0};  // -0 becomes 0
        if (cost_of(change.of(c)) < cost) changes.push_back(change);
      }
    }
  }
  return changes;
}

std::vector<HardCase> simpler_wholes(const HardCase& original) {
  std::vector<HardCase> cases;
  for (const Change& change : changes_of_setting(original)) change(cases.emplace_back(original));
  add_simpler_attributes(original, cases);
  add_simpler_frusta(original, cases);
  add_scaled_and_rounded(original, cases);
  add_jittered(original, cases);
  const double cost = cost_of(original);
  std::erase_if(cases,
                [&](const HardCase& c) { return !has_floats_only(c) || cost_of(c) >= cost; });
  return cases;
}

}  // namespace clipscope::experiments
