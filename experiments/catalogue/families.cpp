// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/catalogue.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments {
namespace {

using reference::InputVertex;
using Limits = std::numeric_limits<float>;

bool is_float(double v) {
  return std::abs(v) <= double{Limits::max()} && double{static_cast<float>(v)} == v;
}

std::size_t dimension_of(const HardCase& hard_case) {
  return hard_case.space == Space::view ? 3 : 4;
}

class Family {
 public:
  explicit Family(const HardCase& original) : original_(original) {}

  void add(std::string_view label, HardCase changed) {
    changed.name = fmt::format("{} ({})", original_.name, label);
    changed.by_hand.clear();
    if (is_finite(changed)) changed.expected = exact_outcome(changed);
    variants_.push_back(std::move(changed));
  }

  const HardCase& original() const { return original_; }
  std::vector<HardCase> take() { return std::move(variants_); }

 private:
  const HardCase& original_;
  std::vector<HardCase> variants_;
};

void add_scaled(Family& family, int k) {
  HardCase c = family.original();
  bool exact = true;
  const auto scale = [&](double& v) {
    const double scaled = std::ldexp(v, k);
    exact = exact && is_float(scaled) && std::ldexp(scaled, -k) == v;
    v = scaled;
  };
  for (InputVertex& v : c.vertices) std::for_each_n(v.position.begin(), dimension_of(c), scale);
  if (c.space == Space::view) {
    Frustum<double>& f = c.frustum;
    for (double* length : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) scale(*length);
  }
  if (exact) family.add(fmt::format("scaled by 2^{}", k), std::move(c));
}

void add_rotated(Family& family) {
  const std::size_t n = family.original().vertices.size();
  for (std::size_t i = 1; i < n; ++i) {
    HardCase c = family.original();
    std::rotate(c.vertices.begin(), c.vertices.begin() + static_cast<std::ptrdiff_t>(i),
                c.vertices.end());
    family.add(n == 2 ? "ends swapped" : fmt::format("rotated by {}", i), std::move(c));
  }
  if (n > 2) {
    HardCase c = family.original();
    std::ranges::reverse(c.vertices);
    family.add("in reverse order", std::move(c));
  }
}

void add_mirrored(Family& family, const char* label, bool mirror_x, bool mirror_y) {
  HardCase c = family.original();
  Frustum<double>& f = c.frustum;
  const auto mirror = [&](std::size_t axis, double& low, double& high, double& shear) {
    for (InputVertex& v : c.vertices) v.position[axis] = -v.position[axis];
    low = -std::exchange(high, -low);
    shear = -shear;
  };
  OpenSides& open = c.volume.open_sides;
  if (mirror_x) {
    mirror(0, f.left, f.right, f.shear_x);
    std::swap(open.left, open.right);
  }
  if (mirror_y) {
    mirror(1, f.bottom, f.top, f.shear_y);
    std::swap(open.bottom, open.top);
  }
  family.add(label, std::move(c));
}

void add_swapped(Family& family) {
  HardCase c = family.original();
  for (InputVertex& v : c.vertices) std::swap(v.position[0], v.position[1]);
  Frustum<double>& f = c.frustum;
  std::swap(f.left, f.bottom);
  std::swap(f.right, f.top);
  std::swap(f.shear_x, f.shear_y);
  std::swap(c.volume.open_sides.left, c.volume.open_sides.bottom);
  std::swap(c.volume.open_sides.right, c.volume.open_sides.top);
  family.add("x and y swapped", std::move(c));
}

void add_with_depth(Family& family, std::string_view label, DepthRange depth) {
  HardCase c = family.original();
  if (depth == c.volume.depth) return;
  c.frustum.depth = c.volume.depth = depth;
  family.add(label, std::move(c));
}

// In clip space near and far exchange their places by the sign of z or by another depth range, and
// so does what is clamped.
void add_other_depths(Family& family) {
  HardCase c = family.original();
  const DepthRange depth = c.volume.depth;
  if (c.space == Space::view) {
    add_with_depth(family, "depth gl", DepthRange::minus_one_to_one);
    add_with_depth(family, "depth zero_to_one", DepthRange::zero_to_one);
    add_with_depth(family, "depth reversed", DepthRange::reversed);
    return;
  }
  std::swap(c.volume.depth_clamp.near, c.volume.depth_clamp.far);
  if (depth == DepthRange::minus_one_to_one) {
    for (InputVertex& v : c.vertices) v.position[2] = -v.position[2];
    family.add("depth mirrored", std::move(c));
  } else {
    c.frustum.depth = c.volume.depth =
        depth == DepthRange::reversed ? DepthRange::zero_to_one : DepthRange::reversed;
    family.add("near and far exchanged", std::move(c));
  }
}

// Calls f(case, coordinate, place) with a copy of the case whose coordinate f may change.
template <class F>
void for_each_coordinate(const HardCase& original, F&& f) {
  for (std::size_t v = 0; v < original.vertices.size(); ++v) {
    for (std::size_t i = 0; i < dimension_of(original); ++i) {
      HardCase c = original;
      double& coordinate = c.vertices[v].position[i];
      f(c, coordinate, fmt::format("vertex {} {}", v, "xyzw"[i]));
    }
  }
}

void add_neighbours(Family& family, int direction) {
  const auto add = [&](HardCase& c, double& coordinate, const std::string& place) {
    const float infinity = direction > 0 ? Limits::infinity() : -Limits::infinity();
    const float moved = std::nextafter(static_cast<float>(coordinate), infinity);
    if (!std::isfinite(moved)) return;
    coordinate = moved;
    family.add(fmt::format("{} {:+} ulp", place, direction), std::move(c));
  };
  for_each_coordinate(family.original(), add);
}

}  // namespace

std::vector<HardCase> family(const HardCase& hard_case) {
  Family family(hard_case);
  for (const int k : {-60, -20, -1, 1, 20, 60}) add_scaled(family, k);
  add_rotated(family);
  add_mirrored(family, "x mirrored", true, false);
  add_mirrored(family, "y mirrored", false, true);
  add_mirrored(family, "x and y mirrored", true, true);
  add_swapped(family);
  add_other_depths(family);
  if (hard_case.primitive != Primitive::polygon) {
    for (const int direction : {1, -1}) add_neighbours(family, direction);
  }
  return family.take();
}

std::vector<HardCase> special_values(const HardCase& hard_case) {
  constexpr float kLargestSubnormal = Limits::min() - Limits::denorm_min();
  std::vector<float> values = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()};
  if (hard_case.primitive != Primitive::polygon) {
    for (const float size : {0.0f, Limits::denorm_min(), kLargestSubnormal, Limits::max()}) {
      values.insert(values.end(), {size, -size});
    }
  }
  Family family(hard_case);
  for (const float value : values) {
    for_each_coordinate(hard_case, [&](HardCase& c, double& coordinate, const std::string& place) {
      coordinate = value;
      family.add(fmt::format("{} = {}", place, hex_float(value)), std::move(c));
    });
  }
  return family.take();
}

bool is_finite(const HardCase& hard_case) {
  return reference::is_finite(hard_case.vertices, hard_case.attribute_count);
}

}  // namespace clipscope::experiments
