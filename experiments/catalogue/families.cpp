// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/families.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/hex_float.hpp"

namespace clipscope::experiments {
namespace {

using reference::InputVertex;
using reference::Rational;
using Limits = std::numeric_limits<float>;

constexpr int kScalings[] = {-60, -20, -1, 1, 20, 60};
constexpr std::string_view kCoordinateNames = "xyzw";

bool is_float(double v) {
  return std::abs(v) <= double{Limits::max()} && double{static_cast<float>(v)} == v;
}

std::size_t dimension_of(const HardCase& hard_case) {
  return hard_case.space == Space::view ? 3 : 4;
}

class Family {
 public:
  explicit Family(const HardCase& original) : original_(original) {}

  void add(std::string label, HardCase changed, const std::optional<Relation>& relation) {
    changed.name = fmt::format("{} ({})", original_.name, label);
    changed.by_hand.clear();
    CaseVariant& variant =
        variants_.emplace_back(CaseVariant{std::move(label), std::move(changed), relation});
    if (is_finite(variant)) {
      variant.hard_case.expected = exact_outcome(variant.hard_case);
    }
  }

  const HardCase& original() const { return original_; }
  std::vector<CaseVariant> take() { return std::move(variants_); }

 private:
  const HardCase& original_;
  std::vector<CaseVariant> variants_;
};

void add_scaled(Family& family, int k) {
  HardCase c = family.original();
  bool exact = true;
  const auto scale = [&](double& v) {
    const double scaled = std::ldexp(v, k);
    exact = exact && is_float(scaled) && std::ldexp(scaled, -k) == v;
    v = scaled;
  };
  for (InputVertex& v : c.vertices) {
    std::for_each_n(v.position.begin(), dimension_of(c), scale);
  }
  const bool view = c.space == Space::view;
  if (view) {
    Frustum<double>& f = c.frustum;
    for (double* length : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) {
      scale(*length);
    }
  }
  if (!exact) {
    return;
  }
  const bool w_is_one = view && c.frustum.kind == ProjectionKind::parallel;
  family.add(fmt::format("scaled by 2^{}", k), std::move(c),
             Relation{.inv_w_exponent = w_is_one ? 0 : -k});
}

void add_rotated(Family& family) {
  const HardCase& original = family.original();
  const std::size_t n = original.vertices.size();
  const Relation relation = {.keeps_order = false};
  for (std::size_t i = 1; i < n; ++i) {
    HardCase c = original;
    std::rotate(c.vertices.begin(), c.vertices.begin() + static_cast<std::ptrdiff_t>(i),
                c.vertices.end());
    family.add(n == 2 ? "ends swapped" : fmt::format("rotated by {}", i), std::move(c), relation);
  }
  if (n > 2) {
    HardCase c = original;
    std::ranges::reverse(c.vertices);
    family.add("in reverse order", std::move(c), relation);
  }
}

void mirror(double& low, double& high) { low = -std::exchange(high, -low); }

void add_mirrored(Family& family, const char* label, bool mirror_x, bool mirror_y) {
  HardCase c = family.original();
  for (InputVertex& v : c.vertices) {
    if (mirror_x) v.position[0] = -v.position[0];
    if (mirror_y) v.position[1] = -v.position[1];
  }
  if (mirror_x) {
    mirror(c.frustum.left, c.frustum.right);
    c.frustum.shear_x = -c.frustum.shear_x;
  }
  if (mirror_y) {
    mirror(c.frustum.bottom, c.frustum.top);
    c.frustum.shear_y = -c.frustum.shear_y;
  }
  family.add(label, std::move(c),
             Relation{.sign_x = mirror_x ? -1 : 1, .sign_y = mirror_y ? -1 : 1});
}

void add_swapped(Family& family) {
  HardCase c = family.original();
  for (InputVertex& v : c.vertices) {
    std::swap(v.position[0], v.position[1]);
  }
  Frustum<double>& f = c.frustum;
  std::swap(f.left, f.bottom);
  std::swap(f.right, f.top);
  std::swap(f.shear_x, f.shear_y);
  family.add("x and y swapped", std::move(c), Relation{.swap_xy = true});
}

void set_depth(HardCase& c, DepthRange depth) { c.frustum.depth = c.volume.depth = depth; }

void add_clip_depth(Family& family) {
  HardCase c = family.original();
  switch (c.volume.depth) {
    case DepthRange::minus_one_to_one:
      for (InputVertex& v : c.vertices) {
        v.position[2] = -v.position[2];
      }
      family.add("depth mirrored", std::move(c), Relation{.z_scale = -1});
      return;
    case DepthRange::zero_to_one: set_depth(c, DepthRange::reversed); break;
    case DepthRange::reversed: set_depth(c, DepthRange::zero_to_one); break;
  }
  family.add("near and far exchanged", std::move(c), Relation{});
}

// Depth z of the range: near_depth + s (far_depth - near_depth) with the same s in every range.
struct Ends {
  double near, far;
};

Ends ends_of(DepthRange depth) {
  switch (depth) {
    case DepthRange::minus_one_to_one: return {-1, 1};
    case DepthRange::zero_to_one: return {0, 1};
    case DepthRange::reversed: return {1, 0};
  }
  return {0, 1};
}

void add_view_depth(Family& family, const char* label, DepthRange depth) {
  HardCase c = family.original();
  if (c.volume.depth == depth) {
    return;
  }
  const Ends from = ends_of(c.volume.depth), to = ends_of(depth);
  const double scale = (to.far - to.near) / (from.far - from.near);
  set_depth(c, depth);
  family.add(label, std::move(c),
             Relation{.z_scale = scale, .z_offset = to.near - scale * from.near});
}

void add_depth(Family& family) {
  if (family.original().space == Space::clip) {
    add_clip_depth(family);
    return;
  }
  add_view_depth(family, "depth gl", DepthRange::minus_one_to_one);
  add_view_depth(family, "depth zero_to_one", DepthRange::zero_to_one);
  add_view_depth(family, "depth reversed", DepthRange::reversed);
}

// Calls f(case, coordinate, place) with a copy of the case whose coordinate f may change.
template <class F>
void for_each_coordinate(const HardCase& original, F&& f) {
  for (std::size_t v = 0; v < original.vertices.size(); ++v) {
    for (std::size_t i = 0; i < dimension_of(original); ++i) {
      HardCase c = original;
      double& coordinate = c.vertices[v].position[i];
      f(c, coordinate, fmt::format("vertex {} {}", v, kCoordinateNames[i]));
    }
  }
}

void add_neighbours(Family& family) {
  for (const int direction : {1, -1}) {
    for_each_coordinate(
        family.original(), [&](HardCase& c, double& coordinate, const std::string& place) {
          const float infinity = direction > 0 ? Limits::infinity() : -Limits::infinity();
          const float moved = std::nextafter(static_cast<float>(coordinate), infinity);
          if (std::isfinite(moved)) {
            coordinate = moved;
            family.add(fmt::format("{} {:+} ulp", place, direction), std::move(c), std::nullopt);
          }
        });
  }
}

}  // namespace

std::vector<CaseVariant> family(const HardCase& hard_case) {
  Family family(hard_case);
  for (const int k : kScalings) {
    add_scaled(family, k);
  }
  add_rotated(family);
  add_mirrored(family, "x mirrored", true, false);
  add_mirrored(family, "y mirrored", false, true);
  add_mirrored(family, "x and y mirrored", true, true);
  add_swapped(family);
  add_depth(family);
  if (hard_case.primitive != Primitive::polygon) {
    add_neighbours(family);
  }
  return family.take();
}

std::vector<CaseVariant> special_values(const HardCase& hard_case) {
  constexpr float kLargestSubnormal = Limits::min() - Limits::denorm_min();
  constexpr float kNotFinite[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()};
  constexpr float kFinite[] = {0.0f,
                               -0.0f,
                               Limits::denorm_min(),
                               -Limits::denorm_min(),
                               kLargestSubnormal,
                               -kLargestSubnormal,
                               Limits::max(),
                               -Limits::max()};
  std::vector<float> values(std::begin(kNotFinite), std::end(kNotFinite));
  if (hard_case.primitive != Primitive::polygon) {
    values.insert(values.end(), std::begin(kFinite), std::end(kFinite));
  }
  Family family(hard_case);
  for (const float value : values) {
    for_each_coordinate(hard_case, [&](HardCase& c, double& coordinate, const std::string& place) {
      coordinate = value;
      family.add(fmt::format("{} = {}", place, hex_float(value)), std::move(c), std::nullopt);
    });
  }
  return family.take();
}

bool is_finite(const CaseVariant& variant) {
  return reference::is_finite(variant.hard_case.vertices, variant.hard_case.attribute_count);
}

std::vector<reference::RationalVertex> related(const Relation& relation,
                                               std::vector<reference::RationalVertex> original) {
  const Rational z_scale(relation.z_scale), z_offset(relation.z_offset);
  const Rational inv_w_scale(std::ldexp(1.0, relation.inv_w_exponent));
  for (reference::RationalVertex& v : original) {
    if (relation.swap_xy) {
      std::swap(v.x, v.y);
    }
    v.x *= relation.sign_x;
    v.y *= relation.sign_y;
    v.z = z_scale * v.z + z_offset;
    v.inv_w *= inv_w_scale;
  }
  std::ranges::sort(original, [](const auto& a, const auto& b) { return a < b; });
  return original;
}

}  // namespace clipscope::experiments
