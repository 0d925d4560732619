// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/ulp_grid.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "reference/truth.hpp"

namespace clipscope::experiments {
namespace {

using reference::Truth;

// From the bits of floats to integers in the same order and back; -0 and 0 are both 0.
std::int32_t ordered(std::int32_t bits) {
  return bits < 0 ? std::numeric_limits<std::int32_t>::min() - bits : bits;
}

SignOf exact_plane_sign(const PlaneSetting& setting) {
  const Truth truth = setting.space == Space::view
                          ? Truth::of_frustum(frustum_cast<double>(setting.frustum))
                          : Truth::of_clip(setting.frustum.depth);
  const auto form = truth.half_spaces()[static_cast<std::size_t>(setting.plane)].form;
  return [form](const GridPoint& p) {
    const reference::InputVertex vertex = {{p[0], p[1], p[2], p[3]}, {}};
    return reference::sign(form, vertex);
  };
}

template <class T>
void add_plane_predicates(UlpGrid& grid, const PlaneSetting& setting, const std::string& scalar) {
  const auto add = [&](Route route, const char* title) {
    grid.predicates.push_back(
        {scalar + title, [=](const GridPoint& p) { return plane_sign<T>(setting, route, p); }});
  };
  add(Route::own_form, ", own form");
  if (setting.space == Space::view) add(Route::matrix, ", after the matrix");
  add(Route::divide, ", after the divide");
}

template <class T>
void add_edge_predicates(UlpGrid& grid, const GridPoint& end, const std::string& scalar) {
  grid.predicates.push_back(
      {scalar + ", at the cut", [=](const GridPoint& p) { return edge_sign_by_cut<T>(end, p); }});
  grid.predicates.push_back(
      {scalar + ", minor", [=](const GridPoint& p) { return edge_sign_by_minor<T>(end, p); }});
}

PlaneGrid plane_grid(const PlaneSetting& setting, UlpGrid grid) {
  grid.exact = exact_plane_sign(setting);
  add_plane_predicates<float>(grid, setting, "float");
  add_plane_predicates<double>(grid, setting, "double");
  return {setting, std::move(grid)};
}

}  // namespace

float moved_by_ulps(float value, int n) {
  const auto moved = std::bit_cast<float>(ordered(ordered(std::bit_cast<std::int32_t>(value)) + n));
  assert(std::isfinite(value) && std::isfinite(moved));
  return moved;
}

GridPoint grid_point(const UlpGrid& grid, int i, int j) {
  GridPoint p = grid.centre;
  p[grid.axis_i] = moved_by_ulps(p[grid.axis_i], i - grid.size / 2);
  p[grid.axis_j] = moved_by_ulps(p[grid.axis_j], j - grid.size / 2);
  return p;
}

SignMap sign_map(const UlpGrid& grid, const SignOf& sign_of) {
  SignMap map{grid.size, {}};
  map.signs.reserve(static_cast<std::size_t>(grid.size) * grid.size);
  for (int j = 0; j < grid.size; ++j) {
    for (int i = 0; i < grid.size; ++i) {
      map.signs.push_back(static_cast<std::int8_t>(sign_of(grid_point(grid, i, j))));
    }
  }
  return map;
}

SignFate sign_fate(int computed, int exact) {
  if (computed == exact) return SignFate::right;
  if (computed == 0) return SignFate::false_zero;
  return exact == 0 ? SignFate::missed_zero : SignFate::opposite;
}

SignCounts compare(const SignMap& computed, const SignMap& exact) {
  assert(computed.size == exact.size);
  SignCounts counts;
  for (std::size_t p = 0; p < exact.signs.size(); ++p) {
    switch (sign_fate(computed.signs[p], exact.signs[p])) {
      case SignFate::right: ++counts.right; break;
      case SignFate::opposite: ++counts.opposite; break;
      case SignFate::false_zero: ++counts.false_zero; break;
      case SignFate::missed_zero: ++counts.missed_zero; break;
    }
  }
  return counts;
}

std::vector<PlaneGrid> plane_grids() {
  const Frustum<float> off_centre = {
      .left = -0.3f, .right = 0.7f, .bottom = -1.1f, .top = 0.1f, .near = 0.1f, .far = 100};
  const Frustum<float> deep = {.near = 0.1f, .far = 1e6f, .depth = DepthRange::zero_to_one};
  const Frustum<float> oblique = {
      .kind = ProjectionKind::parallel, .left = -1.7f, .right = 2.3f, .shear_x = 0.35f};
  return {plane_grid({Space::view, off_centre, Plane::left},
                     {.name = "left_of_frustum",
                      .title = "Left plane of an off-centre frustum, (x, z) around (-6, -2)",
                      .centre = {-6, 0, -2, 1},
                      .axis_j = 2}),
          plane_grid({Space::view, deep, Plane::far},
                     {.name = "far_of_deep_frustum",
                      .title = "Far plane at 1e6, near 0.1: (x, z) around (0.5, -1e6)",
                      .centre = {0.5f, 0, -1e6f, 1},
                      .axis_j = 2}),
          plane_grid({Space::view, oblique, Plane::left},
                     {.name = "left_of_oblique",
                      .title = "Left plane of an oblique projection: (x, z) around (0.05, -5)",
                      .centre = {0.05f, 0, -5, 1},
                      .axis_j = 2}),
          plane_grid({Space::clip, Frustum<float>{}, Plane::right},
                     {.name = "right_in_clip_space",
                      .title = "Plane x = w in clip space: (x, w) around (1.1, 1.1)",
                      .centre = {1.1f, 0, 0, 1.1f},
                      .axis_j = 3})};
}

EdgeGrid edge_grid() {
  // They meet x = w at t = 1/3, y = w = 34/3: the rounding of such numbers is some 30 ulps of y.
  const GridPoint end = {33, 33.125f, 0, 32};
  UlpGrid grid = {
      .name = "edge_of_volume",
      .title = "A segment beside the edge x = y = w: (x, y) of one end around (0.5, 0.4375)",
      .centre = {0.5f, 0.4375f, 0, 1},
      .exact = [=](const GridPoint& p) { return edge_sign_by_minor<reference::Rational>(end, p); }};
  add_edge_predicates<float>(grid, end, "float");
  add_edge_predicates<double>(grid, end, "double");
  return {end, std::move(grid)};
}

}  // namespace clipscope::experiments
