// SPDX-License-Identifier: GPL-3.0-or-later
//
// Grids of neighbouring floats around a point for which a predicate is 0 or nearly so: the exact
// sign at each, and the sign that floating point makes of it.
//
// Source: Kettner, Mehlhorn, Pion, Schirra and Yap, "Classroom Examples of Robustness Problems in
// Geometric Computations", ESA 2004 and Computational Geometry 40 (2008), figures 2 and 3.
//
// The predicates: the side of a plane that a point is on, computed in three ways (Route), and the
// side of an edge of the volume on which a segment passes it, computed in two.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reference/fraction.hpp"
#include "spaces/planes.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

using GridPoint = std::array<float, 4>;  // x, y, z and in clip space w

// -1, 0 or 1: negative is outside, 0 on the plane.
using SignOf = std::function<int(const GridPoint&)>;

struct Predicate {
  std::string title;
  SignOf sign_of;
};

struct UlpGrid {
  std::string name, title;
  GridPoint centre;
  std::size_t axis_i = 0, axis_j = 1;  // the coordinates that change along columns and rows
  int size = 256;                      // points per side
  SignOf exact = {};
  std::vector<Predicate> predicates = {};  // what is compared with `exact`
};

// Column i and row j: the centre moved by i - size/2 and j - size/2 float ulps. Rows grow upwards
// in pictures. Pre-condition: 0 <= i, j < size.
GridPoint grid_point(const UlpGrid& grid, int i, int j);

// The float that is n floats above the value (-0 and 0 are one float). Pre-condition: both are
// finite.
float moved_by_ulps(float value, int n);

// The sign at each point of a grid.
struct SignMap {
  int size = 0;
  std::vector<std::int8_t> signs;  // row by row

  int at(int i, int j) const { return signs[static_cast<std::size_t>(j) * size + i]; }
};

SignMap sign_map(const UlpGrid& grid, const SignOf& sign_of);

// What became of a point.
enum class SignFate : std::uint8_t {
  right,
  opposite,    // outside instead of inside or the reverse
  false_zero,  // taken to be on the plane
  missed_zero  // is on the plane and is not taken to be
};

SignFate sign_fate(int computed, int exact);

struct SignCounts {
  std::int64_t right = 0, opposite = 0, false_zero = 0, missed_zero = 0;

  std::int64_t wrong() const { return opposite + false_zero + missed_zero; }
};

// Pre-condition: both maps have the same size.
SignCounts compare(const SignMap& computed, const SignMap& exact);

// --- Predicates ----------------------------------------------------------------------------------

template <class T>
int sign_of_value(const T& value) {
  return value < T(0) ? -1 : (T(0) < value ? 1 : 0);
}

template <class T>
Vec4<T> grid_vector(const GridPoint& p) {
  return Vec4<T>(T(double{p[0]}), T(double{p[1]}), T(double{p[2]}), T(double{p[3]}));
}

enum class Route {
  own_form,  // the form of the plane in the space given: near x + left z, w - x, ...
  matrix,    // of view space: transformed to clip space first
  divide     // then also divided by w: 1 - x/w
};

// A plane of a view volume, in view space or in clip space.
struct PlaneSetting {
  Space space = Space::view;
  Frustum<float> frustum;  // in clip space of use for its depth range alone
  Plane plane = Plane::left;
};

// The sign of the plane's form at the point, computed in T.
template <class T>
int plane_sign(const PlaneSetting& setting, Route route, const GridPoint& point) {
  Vec4<T> p = grid_vector<T>(point);
  const Frustum<T> frustum = frustum_cast<T>(setting.frustum);
  if (setting.space == Space::view) {
    const Vec3<T> v(p[0], p[1], p[2]);
    if (route == Route::own_form) return sign_of_value(view_distance(frustum, setting.plane, v));
    p = to_clip(Projection<T>(frustum), v);
  }
  if (route != Route::divide) return sign_of_value(clip_distance(frustum.depth, setting.plane, p));
  return sign_of_value(ndc_distance(frustum.depth, setting.plane, to_ndc(p)));
}

// A segment from the grid's point, inside of x = w, to an end outside of it: does it leave the
// volume below the edge x = y = w (1), through it (0) or above it (-1)?

// As a chain of cuts decides: w - y at the rounded point where the segment meets x = w.
template <class T>
int edge_sign_by_cut(const GridPoint& end, const GridPoint& point) {
  const Vec4<T> a = grid_vector<T>(point), b = grid_vector<T>(end);
  const T d_a = a[3] - a[0], d_b = b[3] - b[0];
  const T t = d_a / (d_a - d_b);
  const T y = a[1] + t * (b[1] - a[1]);
  const T w = a[3] + t * (b[3] - a[3]);
  const T d = w - y;
  return sign_of_value(d);
}

// As the minor of the distances decides, without a point: d_x(a) d_y(b) - d_x(b) d_y(a), whose sign
// is that of w - y where the segment meets x = w.
template <class T>
int edge_sign_by_minor(const GridPoint& end, const GridPoint& point) {
  const Vec4<T> a = grid_vector<T>(point), b = grid_vector<T>(end);
  const T x_a = a[3] - a[0], x_b = b[3] - b[0];
  const T y_a = a[3] - a[1], y_b = b[3] - b[1];
  const T minor = x_a * y_b - x_b * y_a;
  return sign_of_value(minor);
}

// --- Built-in grids ------------------------------------------------------------------------------

// Grids around points of planes and one around an edge, with predicates in float and double. A
// caller adds other scalars: grid.predicates.push_back({"...", [](const GridPoint& p) { ... }}).
struct PlaneGrid {
  PlaneSetting setting;
  UlpGrid grid;
};
std::vector<PlaneGrid> plane_grids();

struct EdgeGrid {
  GridPoint end;
  UlpGrid grid;
};
EdgeGrid edge_grid();

}  // namespace clipscope::experiments
