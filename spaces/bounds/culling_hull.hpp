// SPDX-License-Identifier: MIT
//
// The corners of a view volume: what tells volumes beside it, outside of no single plane, from
// volumes that meet it.
//
// A corner is homogeneous: the point position / weight, or with weight 0, of an infinite far plane,
// the direction `position`. The volume is then all sums of a_i position_i with a_i >= 0 and sum of
// a_i weight_i = 1, which is true of any matrix that is not singular: the corners are its inverse
// times those of the clip volume. So
//
//   n . p <= h in the whole volume if n . position_i <= h weight_i for all i,
//
// whatever the signs of the weights.
//
// Corners of a frustum: its numbers, the far ones with the weight near / far. Corners of a matrix:
// where three of its planes meet, by 3 x 3 minors (Cramer), in numbers between two bounds in
// double (enclosure.hpp), which are turned outwards.
//
// Guarantees: `reach` contains the whole volume; position and weight of a corner are off by at most
// two roundings of their magnitudes.
// Pre-conditions: round-to-nearest with gradual underflow while a hull is made. A singular matrix,
// or one that can't be told from it, gives a hull that is not `known`, and settles nothing.
#pragma once

#include "spaces/bounds/culling_planes.hpp"
#include "spaces/bounds/enclosure_arithmetic.hpp"

namespace clipscope {

template <std::floating_point T>
struct HullCorner {
  Vec3<T> position = Vec3<T>(T(0));
  T weight = T(0);
  // The magnitudes of the terms of which position and weight are sums.
  Vec3<T> magnitude = Vec3<T>(T(0));
  T weight_magnitude = T(0);
};

inline constexpr std::size_t kHullEdges = 12;

// The corners that edge e joins differ in one bit of their index.
constexpr std::array<std::size_t, 2> hull_edge(std::size_t e) {
  constexpr std::size_t kFirst[3][4] = {{0, 2, 4, 6}, {0, 1, 4, 5}, {0, 1, 2, 3}};
  const std::size_t first = kFirst[e / 4][e % 4];
  return {first, first | std::size_t{1} << (e / 4)};
}

// A half-space that contains the whole view volume: normal . p <= most.
template <std::floating_point T>
struct HullSlab {
  Vec3<T> normal = Vec3<T>(T(0));
  T most = T(0);
};

template <std::floating_point T>
struct CullingHull {
  bool known = false;
  // Bit 0 of the index chooses left or right, bit 1 bottom or top, bit 2 near or far.
  std::array<HullCorner<T>, 8> corners;
  // Directions of edges, those of parallel edges once, by any positive factor and rounding.
  std::array<Vec3<T>, kHullEdges> edges;
  int edge_count = 0;
  // The mean direction to the corners at infinity, turned round; 0 if there are none.
  Vec3<T> back = Vec3<T>(T(0));
  AxisBox<T> reach = {Vec3<T>(-std::numeric_limits<T>::infinity()),
                      Vec3<T>(std::numeric_limits<T>::infinity())};
  // Along x, y and z where the reach is not known, and across each edge and x, y or z, both ways:
  // all that may separate an axis-aligned box, beside the planes.
  std::array<HullSlab<T>, 6 * (kHullEdges + 1)> slabs;
  int slab_count = 0;
};

namespace bounds {

template <std::floating_point T>
HullCorner<T> exact_corner(const Vec3<T>& position, const T& weight) {
  return {position, weight, absolute(position), std::abs(weight)};
}

template <std::floating_point T>
Vec3<T> edge_direction(const HullCorner<T>& a, const HullCorner<T>& b) {
  return a.weight * b.position - b.weight * a.position;
}

// Whether the directions are parallel but for rounding. An axis that is missing for that costs
// sharpness within rounding, and nothing else.
template <std::floating_point T>
bool are_parallel(const Vec3<T>& a, const Vec3<T>& b) {
  const Vec3<T> across = absolute(cross(a, b)), u = absolute(a), v = absolute(b);
  const T size = std::max({u[0], u[1], u[2]}) * std::max({v[0], v[1], v[2]});
  return std::max({across[0], across[1], across[2]}) <=
         16 * std::numeric_limits<T>::epsilon() * size;
}

template <std::floating_point T>
void set_edges(CullingHull<T>& hull) {
  for (std::size_t e = 0; e < kHullEdges; ++e) {
    const auto [i, j] = hull_edge(e);
    const Vec3<T> direction = edge_direction(hull.corners[i], hull.corners[j]);
    bool is_new = true;
    for (int k = 0; k < hull.edge_count; ++k) {
      is_new = is_new && !are_parallel(hull.edges[static_cast<std::size_t>(k)], direction);
    }
    if (is_new) hull.edges[static_cast<std::size_t>(hull.edge_count++)] = direction;
  }
}

template <std::floating_point T>
void set_back(CullingHull<T>& hull) {
  constexpr T u = std::numeric_limits<T>::epsilon();
  for (const HullCorner<T>& c : hull.corners) {
    if (c.weight <= 4 * u * c.weight_magnitude) hull.back -= c.position / length_above(c.position);
  }
}

// What n . position - h weight is at a corner, and what it may be off by.
template <std::floating_point T>
struct CornerValue {
  T value, error;
};

template <std::floating_point T>
CornerValue<T> value_at(const HullCorner<T>& c, const Vec3<T>& n, const T& h) {
  const Vec3<T> size = absolute(n);
  const T terms = dot(size, c.magnitude) + std::abs(h) * c.weight_magnitude;
  return {dot(n, c.position) - h * c.weight,
          distance_error(terms, size[0] + size[1] + size[2] + std::abs(h))};
}

// Whether n . p <= h in the whole view volume; never true of what is not, whatever n is.
template <std::floating_point T>
bool is_bounded_by(const CullingHull<T>& hull, const Vec3<T>& n, const T& h) {
  for (const HullCorner<T>& c : hull.corners) {
    const CornerValue<T> at = value_at(c, n, h);
    if (!(at.value < -at.error)) return false;
  }
  return true;
}

// Adds the least h that is known to bound n . p, if there is one: past the farthest corner by twice
// its error, and then tried.
template <std::floating_point T>
void add_slab(CullingHull<T>& hull, const Vec3<T>& n) {
  if (!(T(0) < length_above(n))) return;
  T most = -std::numeric_limits<T>::infinity();
  for (const HullCorner<T>& c : hull.corners) {
    if (!(T(0) < c.weight)) continue;
    const T at = dot(n, c.position) / c.weight;
    most = std::max(most, at + 2 * value_at(c, n, at).error / c.weight);
  }
  if (!std::isfinite(most) || !is_bounded_by(hull, n, most)) return;
  hull.slabs[static_cast<std::size_t>(hull.slab_count++)] = {n, most};
}

// A plane that is to be parallel to an edge without end may cross it far away, for rounding: its
// normal is turned back by more than that.
template <std::floating_point T>
Vec3<T> turned_back(const CullingHull<T>& hull, const Vec3<T>& n) {
  return 64 * std::numeric_limits<T>::epsilon() * length_above(n) * hull.back + n;
}

template <std::floating_point T>
void set_slabs(CullingHull<T>& hull) {
  const auto add_both = [&](const Vec3<T>& n) {
    add_slab(hull, turned_back(hull, n));
    add_slab(hull, turned_back(hull, Vec3<T>(-n)));
  };
  const std::array<Vec3<T>, 3> axes = OrientedBox<T>{}.axes;
  for (const Vec3<T>& axis : axes) {
    if (!is_finite(hull.reach)) add_both(axis);
    for (int e = 0; e < hull.edge_count; ++e) {
      add_both(cross(axis, hull.edges[static_cast<std::size_t>(e)]));
    }
  }
}

// All that follows from corners and reach.
template <std::floating_point T>
void complete(CullingHull<T>& hull) {
  hull.known = true;
  set_edges(hull);
  set_back(hull);
  set_slabs(hull);
}

// A row of a matrix, a plane or a corner, in numbers between two bounds.
using Row4 = std::array<Enclosure<double>, 4>;

// The greatest value of `sign` times a coordinate over the volume, or more; infinity if there is
// none or it isn't known.
inline double greatest_of(const std::array<Row4, 8>& corners, std::size_t axis, int sign) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto along = [&](const Row4& c) { return sign > 0 ? c[axis] : -c[axis]; };
  const auto is_finite = [](const Enclosure<double>& e) {
    return std::isfinite(e.low) && std::isfinite(e.high);
  };
  double most = -infinity;
  for (const Row4& c : corners) {
    if (!is_finite(c[axis]) || !is_finite(c[3])) return infinity;
    if (c[3].low > 0) most = std::max(most, (along(c) / c[3]).high);
  }
  if (!std::isfinite(most)) return infinity;
  for (const Row4& c : corners) {
    const bool is_point = c[3].low > 0;
    if (!is_point && !(along(c).high <= (Enclosure<double>(most) * c[3]).low)) return infinity;
  }
  return most;
}

template <std::floating_point T>
AxisBox<T> reach_of(const std::array<Row4, 8>& corners) {
  AxisBox<T> r;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    r.upper[i] = rounded_up<T>(greatest_of(corners, axis, 1), Rounding::outward);
    r.lower[i] = -rounded_up<T>(greatest_of(corners, axis, -1), Rounding::outward);
  }
  return r;
}

inline Enclosure<double> minor(const Row4& a, const Row4& b, const Row4& c, std::size_t i,
                               std::size_t j, std::size_t k) {
  return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
         a[k] * (b[i] * c[j] - b[j] * c[i]);
}

// Where three planes meet, up to its sign: all products with a, b and c are 0.
inline Row4 meet(const Row4& a, const Row4& b, const Row4& c) {
  return {minor(a, b, c, 1, 2, 3), -minor(a, b, c, 0, 2, 3), minor(a, b, c, 0, 1, 3),
          -minor(a, b, c, 0, 1, 2)};
}

// The plane a + sign b of two rows of a matrix.
template <std::floating_point T>
Row4 plane_between(const Vec4<T>& a, int sign, const Vec4<T>& b) {
  Row4 r;
  for (std::size_t i = 0; i < 4; ++i) {
    const double first = a[static_cast<int>(i)], second = b[static_cast<int>(i)];
    r[i] = sum(first, sign < 0 ? -second : second);
  }
  return r;
}

// The six planes in the order of enum Plane.
template <std::floating_point T>
std::array<Row4, 6> plane_rows(DepthRange depth, const MatrixRows<T>& rows) {
  const Vec4<T>&x = rows[0], &y = rows[1], &z = rows[2], &w = rows[3];
  const Vec4<T> low_w = depth == DepthRange::minus_one_to_one ? w : Vec4<T>(T(0));
  std::array<Row4, 6> r = {plane_between(w, 1, x),     plane_between(w, -1, x),
                           plane_between(w, 1, y),     plane_between(w, -1, y),
                           plane_between(low_w, 1, z), plane_between(w, -1, z)};
  if (depth == DepthRange::reversed) std::swap(r[4], r[5]);
  return r;
}

// The corner with the sign that makes its clip w positive; false if that can't be told.
template <std::floating_point T>
bool orient(Row4& corner, const Vec4<T>& row_w) {
  Enclosure<double> w(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    w = w + corner[i] * Enclosure<double>(static_cast<double>(row_w[static_cast<int>(i)]));
  }
  if (w.high < 0) {
    for (Enclosure<double>& c : corner) c = -c;
  }
  return w.high < 0 || w.low > 0;
}

// A coordinate that is anywhere between the bounds is off by u of its magnitude at most.
template <std::floating_point T>
void set_coordinate(const Enclosure<double>& e, double scale, T& value, T& magnitude) {
  const double at = middle(e) * scale;
  const double spread = (next_above(e.high - e.low) * scale) / std::numeric_limits<T>::epsilon();
  value = static_cast<T>(at);
  magnitude = std::abs(value) + static_cast<T>(spread);
}

// Scaled by a power of two, so that T holds it well.
template <std::floating_point T>
HullCorner<T> corner_of(const Row4& corner) {
  double most = 0;
  for (const Enclosure<double>& c : corner) most = std::max({most, std::abs(c.low), c.high});
  const double scale = std::isfinite(most) && most > 0 ? std::ldexp(1.0, -std::ilogb(most)) : 1.0;
  HullCorner<T> r;
  for (int i = 0; i < 3; ++i) {
    set_coordinate(corner[static_cast<std::size_t>(i)], scale, r.position[i], r.magnitude[i]);
  }
  set_coordinate(corner[3], scale, r.weight, r.weight_magnitude);
  return r;
}

}  // namespace bounds

// The corners of a frustum in view space. Pre-condition: is_valid(f).
template <std::floating_point T>
CullingHull<T> culling_hull(const Frustum<T>& f) {
  CullingHull<T> hull;
  hull.reach = culling_planes(f).reach;
  for (std::size_t i = 0; i < 8; ++i) {
    const bool is_far = (i & 4) != 0;
    const T x = (i & 1) != 0 ? f.right : f.left, y = (i & 2) != 0 ? f.top : f.bottom;
    if (f.kind == ProjectionKind::perspective) {
      const T weight = !is_far ? T(1) : (f.infinite_far ? T(0) : f.near / f.far);
      hull.corners[i] = bounds::exact_corner(Vec3<T>(x, y, -f.near), weight);
    } else {
      const T depth = is_far ? f.far : f.near;
      const T a = f.shear_x * depth, b = f.shear_y * depth;
      hull.corners[i] = {
          Vec3<T>(x + a, y + b, -depth), T(1),
          Vec3<T>(std::abs(x) + std::abs(a), std::abs(y) + std::abs(b), std::abs(depth)), T(1)};
    }
  }
  bounds::complete(hull);
  return hull;
}

// The corners of the volume that a matrix to clip space cuts out, in the space that it leads from.
// Row i yields clip coordinate i.
template <std::floating_point T>
CullingHull<T> culling_hull(DepthRange depth, const MatrixRows<T>& rows) {
  const std::array<bounds::Row4, 6> planes = bounds::plane_rows(depth, rows);
  CullingHull<T> hull;
  std::array<bounds::Row4, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = bounds::meet(planes[i & 1], planes[2 + (i >> 1 & 1)], planes[4 + (i >> 2 & 1)]);
    if (!bounds::orient(corners[i], rows[3])) return hull;
    hull.corners[i] = bounds::corner_of<T>(corners[i]);
  }
  hull.reach = bounds::reach_of<T>(corners);
  bounds::complete(hull);
  return hull;
}

template <std::floating_point T>
CullingHull<T> culling_hull(DepthRange depth, const glm::mat<4, 4, T, glm::defaultp>& m) {
  return culling_hull(depth, rows_of(m));
}

template <std::floating_point T>
CullingHull<T> culling_hull(const Projection<T>& p) {
  return culling_hull(p.frustum.depth, rows_of(p));
}

// The planes with the box around the hull, by which boxes beside the volume are rejected, too:
// as sharp as planes of a frustum, and with what those promise. What the planes of a matrix promise
// of outcodes does not hold for a box rejected by its place beside the volume: it has no point in
// the exact volume, but its points have no bit in common.
template <std::floating_point T>
CullingPlanes<T> with_reach(CullingPlanes<T> planes, const CullingHull<T>& hull) {
  planes.reach = hull.reach;
  return planes;
}

}  // namespace clipscope
