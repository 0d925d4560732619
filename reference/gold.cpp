// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gold.hpp"

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <stdexcept>

namespace clipscope::reference {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

using Point = std::array<Rational, 3>;
using Corners = std::array<Point, 3>;
using Vector = std::array<Rational, 4>;  // homogeneous coordinates, or a plane's coefficients
using Matrix = std::array<Vector, 4>;    // rows

Vector operator+(const Vector& a, const Vector& b) {
  return {Rational(a[0] + b[0]), Rational(a[1] + b[1]), Rational(a[2] + b[2]),
          Rational(a[3] + b[3])};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2]),
          Rational(a[3] - b[3])};
}
Rational dot(const Vector& a, const Vector& b) {
  return Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
}
Rational determinant(const Vector& a, const Vector& b, const Vector& c, int i, int j, int k) {
  return Rational(a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
                  a[k] * (b[i] * c[j] - b[j] * c[i]));
}

// --- CGAL's objects -----------------------------------------------------------------------------

Kernel::Point_3 kernel_point(const Point& p) {
  return {Kernel::FT(p[0]), Kernel::FT(p[1]), Kernel::FT(p[2])};
}

Point point(const Kernel::Point_3& p) {
  return {Rational(CGAL::exact(p.x())), Rational(CGAL::exact(p.y())), Rational(CGAL::exact(p.z()))};
}

// Pre-condition of CGAL: a closed surface that bounds a volume.
Nef solid(Polyhedron& boundary) {
  if (!boundary.is_valid() || !boundary.is_closed() || boundary.size_of_vertices() < 4) {
    throw std::logic_error("gold: the surface of a convex volume is not closed");
  }
  return Nef(boundary);
}

// Pre-condition: not all points in one plane.
Nef convex_hull(const std::vector<Point>& points) {
  std::vector<Kernel::Point_3> p;
  for (const Point& q : points) p.push_back(kernel_point(q));
  Polyhedron hull;
  CGAL::convex_hull_3(p.begin(), p.end(), hull);
  return solid(hull);
}

// Pre-condition of CGAL: the corners are not on one line, else the facet is empty.
Nef facet(const Corners& corners) {
  std::vector<Kernel::Point_3> p;
  for (const Point& corner : corners) p.push_back(kernel_point(corner));
  const Nef r(p.begin(), p.end());
  if (r.is_empty()) {
    throw std::logic_error("gold: CGAL made no facet of three points that are not on a line");
  }
  return r;
}

std::vector<Point> vertices(const Nef& set) {
  std::vector<Point> r;
  for (auto v = set.vertices_begin(); v != set.vertices_end(); ++v) {
    if (v->mark()) r.push_back(point(v->point()));
  }
  return r;
}

// CGAL's half-space of a plane is the one of values <= 0.
Kernel::Plane_3 kernel_plane(const Vector& inside) {
  return {Kernel::FT(-inside[0]), Kernel::FT(-inside[1]), Kernel::FT(-inside[2]),
          Kernel::FT(-inside[3])};
}

// The part with inside . (x, y, z, 1) >= 0 of the cube [-size, size]^3.
// Pre-condition: the form changes its sign within the cube. CGAL wants a point strictly inside:
// with inside . (s c, 1) = s reach + d for the corner c where the form is largest, s in (-d /
// reach, 1).
Nef half_cube(const Vector& inside, const Rational& size) {
  std::vector<Kernel::Plane_3> planes = {kernel_plane(inside)};
  Point interior;
  Rational reach = 0;
  for (int i = 0; i < 3; ++i) {
    for (const int side : {-1, 1}) {
      Vector face = {0, 0, 0, size};
      face[i] = side;
      planes.push_back(kernel_plane(face));
    }
    interior[i] = size * CGAL::sign(inside[i]);
    reach += inside[i] * interior[i];
  }
  const Rational lowest = -inside[3] / reach;
  const Rational start = lowest < -1 ? Rational(-1) : lowest;
  const Rational s = (start + 1) / 2;
  for (Rational& coordinate : interior) coordinate *= s;
  const Kernel::Point_3 origin = kernel_point(interior);
  for (const Kernel::Plane_3& plane : planes) {
    if (!plane.has_on_negative_side(origin)) {
      throw std::logic_error("gold: the interior point of a half cube is not in its interior");
    }
  }
  Polyhedron boundary;
  CGAL::halfspace_intersection_3(planes.begin(), planes.end(), boundary, origin);
  return solid(boundary);
}

// Half-spaces, by the forms that are >= 0 in the closed ones and > 0 in the open ones.
struct HalfSpaces {
  std::vector<Vector> closed, open;
};

// How far the form changes within the cube [-size, size]^3, from its middle.
Rational reach_of(const Vector& form, const Rational& size) {
  return Rational(size * (abs(form[0]) + abs(form[1]) + abs(form[2])));
}

// The vertices of the closure of the set's part within all half-spaces. Pre-condition: the set is
// in the interior of the cube [-size, size]^3.
std::vector<Point> intersect(Nef rest, const HalfSpaces& half_spaces, const Rational& size) {
  for (const Vector& inside : half_spaces.closed) {
    const Rational reach = reach_of(inside, size);
    if (reach + inside[3] <= 0 && (reach != 0 || inside[3] < 0)) {
      return {};  // the half-space has no point in the interior of the cube
    }
    if (inside[3] - reach < 0) rest *= half_cube(inside, size);
  }
  for (const Vector& inside : half_spaces.open) {
    const Rational reach = reach_of(inside, size);
    if (reach + inside[3] <= 0) return {};
    if (inside[3] - reach < 0) rest -= half_cube(Vector{} - inside, size);
  }
  return vertices(half_spaces.open.empty() ? rest : rest.closure());
}

// --- Projections ---------------------------------------------------------------------------------

Vector position(const InputVertex& v) {
  return {to_rational(v.position[0]), to_rational(v.position[1]), to_rational(v.position[2]),
          to_rational(v.position[3])};
}

Vector view_position(const InputVertex& v) {
  Vector r = position(v);
  r[3] = 1;
  return r;
}

// z_clip = a z + b, from what it is at the near and the far plane: depth times w.
void set_depth_row(Matrix& m, const Frustum<double>& f) {
  const Rational near = to_rational(f.near);
  const bool reversed = f.depth == DepthRange::reversed;
  const Rational depth_near = f.depth == DepthRange::minus_one_to_one ? -1 : (reversed ? 1 : 0);
  const Rational depth_far = reversed ? 0 : 1;
  Rational& a = m[2][2];
  Rational& b = m[2][3];
  if (f.infinite_far) {
    // z_clip / -z -> depth_far, so a = -depth_far; and a (-near) + b = depth_near near.
    a = -depth_far;
    b = near * (depth_near - depth_far);
    return;
  }
  const Rational far = to_rational(f.far);
  const bool perspective = f.kind == ProjectionKind::perspective;
  const Rational w_near = perspective ? near : Rational(1);
  const Rational w_far = perspective ? far : Rational(1);
  a = (depth_near * w_near - depth_far * w_far) / (far - near);
  b = depth_near * w_near + a * near;
}

// x_clip / w is 2 (position between low and high) - 1.
void set_side_row(Matrix& m, int axis, double low, double high, double shear,
                  const Frustum<double>& f) {
  const Rational l = to_rational(low), h = to_rational(high);
  const Rational width = h - l, middle = h + l;
  Vector& row = m[axis];
  if (f.kind == ProjectionKind::perspective) {
    row[axis] = 2 * to_rational(f.near) / width;
    row[2] = middle / width;
  } else {
    row[axis] = 2 / width;
    row[2] = 2 * to_rational(shear) / width;
    row[3] = -middle / width;
  }
}

Matrix projection_matrix(const Frustum<double>& f) {
  Matrix m;
  set_side_row(m, 0, f.left, f.right, f.shear_x, f);
  set_side_row(m, 1, f.bottom, f.top, f.shear_y, f);
  set_depth_row(m, f);
  if (f.kind == ProjectionKind::perspective) {
    m[3][2] = -1;
  } else {
    m[3][3] = 1;
  }
  return m;
}

Matrix projection_matrix(const Projection<float>& p) {
  Matrix m;
  m[0] = {to_rational(p.x.own), 0, to_rational(p.x.z), to_rational(p.x.one)};
  m[1] = {0, to_rational(p.y.own), to_rational(p.y.z), to_rational(p.y.one)};
  m[2] = {0, 0, to_rational(p.z.z), to_rational(p.z.one)};
  m[3] = {0, 0, to_rational(p.w.z), to_rational(p.w.one)};
  return m;
}

// The open sides in terms of x, y and w.
std::vector<Vector> open_forms_of(const ClipVolume& volume, const Vector& x, const Vector& y,
                                  const Vector& w) {
  std::vector<Vector> forms;
  if (volume.open_sides.left) forms.push_back(w + x);
  if (volume.open_sides.right) forms.push_back(w - x);
  if (volume.open_sides.bottom) forms.push_back(w + y);
  if (volume.open_sides.top) forms.push_back(w - y);
  return forms;
}

// The volume in terms of x, y, z and w, its clip distances apart. An open side is among the closed
// ones, too.
HalfSpaces half_spaces_of(const ClipVolume& volume, const Vector& x, const Vector& y,
                          const Vector& z, const Vector& w) {
  HalfSpaces r = {{w + x, w - x, w + y, w - y}, open_forms_of(volume, x, y, w)};
  std::vector<Vector>& forms = r.closed;
  const Vector low = volume.depth == DepthRange::minus_one_to_one ? w + z : z, high = w - z;
  const bool reversed = volume.depth == DepthRange::reversed;
  if (!volume.depth_clamp.near) forms.push_back(reversed ? high : low);
  if (!volume.depth_clamp.far) forms.push_back(reversed ? low : high);
  return r;
}

// A number beyond every |x|, |y| and |z| of the triangle.
Rational beyond(const InputTriangle& triangle) {
  Rational r = 1;
  for (const InputVertex& v : triangle.vertices) {
    for (int c = 0; c < 3; ++c) {
      const Rational magnitude = abs(to_rational(v.position[c]));
      r = std::max(r, magnitude);
    }
  }
  return Rational(2 * r);
}

// The corners at z = -first and z = -last; at the eye (first = 0) they are one.
std::vector<Point> frustum_corners(const Frustum<double>& f, const Rational& first,
                                   const Rational& last) {
  std::vector<Point> r;
  for (const Rational& distance : {first, last}) {
    const bool perspective = f.kind == ProjectionKind::perspective;
    const Rational scale = perspective ? Rational(distance / to_rational(f.near)) : Rational(1);
    const Rational shift_x =
        perspective ? Rational(0) : Rational(to_rational(f.shear_x) * distance);
    const Rational shift_y =
        perspective ? Rational(0) : Rational(to_rational(f.shear_y) * distance);
    for (const double x : {f.left, f.right}) {
      for (const double y : {f.bottom, f.top}) {
        r.push_back({Rational(to_rational(x) * scale + shift_x),
                     Rational(to_rational(y) * scale + shift_y), Rational(-distance)});
      }
    }
  }
  return r;
}

// --- From points of the triangle to vertices -----------------------------------------------------

// Pre-condition: p is in the plane of the corners, and they are not on one line.
Point barycentric(const Corners& c, const Point& p) {
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
    const auto area = [i = i, j = j](const Point& a, const Point& b, const Point& c) {
      return Rational((b[i] - a[i]) * (c[j] - a[j]) - (c[i] - a[i]) * (b[j] - a[j]));
    };
    const Rational whole = area(c[0], c[1], c[2]);
    if (whole != 0) {
      const Rational l0 = area(p, c[1], c[2]) / whole;
      const Rational l1 = area(c[0], p, c[2]) / whole;
      return {l0, l1, Rational(1 - l0 - l1)};
    }
  }
  throw std::logic_error("gold: barycentric coordinates over a triangle without area");
}

// The clip distances as half-spaces: forms over (x, y, z, 1) that take the values of the attributes
// at the corners. They are affine, so their values at 0 and at the unit vectors tell all.
std::vector<Vector> clip_distance_forms(const ClipVolume& volume, const InputTriangle& triangle,
                                        const Corners& corners) {
  std::vector<Vector> forms;
  for (int k = 0; k < volume.clip_distances; ++k) {
    const auto form_at = [&](const Point& p) {
      const Point lambda = barycentric(corners, p);
      Rational sum = 0;
      for (int i = 0; i < 3; ++i) {
        sum += lambda[i] * to_rational(triangle.vertices[i].attributes[k]);
      }
      return sum;
    };
    const Rational origin = form_at({0, 0, 0});
    forms.push_back({Rational(form_at({1, 0, 0}) - origin), Rational(form_at({0, 1, 0}) - origin),
                     Rational(form_at({0, 0, 1}) - origin), origin});
  }
  return forms;
}

// The vertices at the points given, as far as w > 0, sorted.
std::vector<RationalVertex> project(const InputTriangle& triangle,
                                    const std::array<Vector, 3>& clip, const Corners& corners,
                                    const std::vector<Point>& points) {
  std::vector<RationalVertex> r;
  for (const Point& p : points) {
    const Point lambda = barycentric(corners, p);
    const auto interpolate = [&](const Rational& a, const Rational& b, const Rational& c) {
      return Rational(lambda[0] * a + lambda[1] * b + lambda[2] * c);
    };
    Vector position;
    for (int i = 0; i < 4; ++i) position[i] = interpolate(clip[0][i], clip[1][i], clip[2][i]);
    const Rational w = position[3];
    if (w <= 0) continue;
    RationalVertex v = {Rational(position[0] / w),
                        Rational(position[1] / w),
                        Rational(position[2] / w),
                        Rational(1 / w),
                        {}};
    const auto& t = triangle.vertices;
    for (int k = 0; k < triangle.attribute_count; ++k) {
      v.attributes.push_back(
          interpolate(t[0].attributes[k], t[1].attributes[k], t[2].attributes[k]));
    }
    r.push_back(v);
  }
  std::sort(r.begin(), r.end());
  return r;
}

void require_area(const std::array<Vector, 3>& clip) {
  for (const auto& [i, j, k] : {std::array{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
    if (determinant(clip[0], clip[1], clip[2], i, j, k) != 0) return;
  }
  throw std::invalid_argument("gold: not applicable to a triangle without area in NDC");
}

std::array<Vector, 3> clip_positions(const Matrix& m, const InputTriangle& triangle) {
  std::array<Vector, 3> r;
  for (int i = 0; i < 3; ++i) {
    const Vector v = view_position(triangle.vertices[i]);
    r[i] = {dot(m[0], v), dot(m[1], v), dot(m[2], v), dot(m[3], v)};
  }
  return r;
}

Corners view_corners(const InputTriangle& triangle) {
  Corners r;
  for (int i = 0; i < 3; ++i) {
    const Vector v = view_position(triangle.vertices[i]);
    r[i] = {v[0], v[1], v[2]};
  }
  return r;
}

}  // namespace

std::vector<RationalVertex> gold_of_frustum(const Frustum<double>& frustum,
                                            const InputTriangle& triangle) {
  return gold_of_frustum(frustum, {.depth = frustum.depth}, triangle);
}

std::vector<RationalVertex> gold_of_frustum(const Frustum<double>& frustum,
                                            const ClipVolume& volume,
                                            const InputTriangle& triangle) {
  assert(is_finite(triangle));
  Truth::of_frustum(frustum, volume);  // throws unless both are valid
  const Matrix m = projection_matrix(frustum);
  const std::array<Vector, 3> clip = clip_positions(m, triangle);
  require_area(clip);
  const Rational horizon = beyond(triangle) + to_rational(abs(frustum.near));
  const bool perspective = frustum.kind == ProjectionKind::perspective;
  Rational first = to_rational(frustum.near);
  if (volume.depth_clamp.near) first = perspective ? Rational(0) : Rational(-horizon);
  const bool endless = volume.depth_clamp.far || frustum.infinite_far;
  const Rational last = endless ? horizon : to_rational(frustum.far);
  const Corners corners = view_corners(triangle);
  const Nef part = facet(corners) * convex_hull(frustum_corners(frustum, first, last));
  const HalfSpaces half_spaces = {clip_distance_forms(volume, triangle, corners),
                                  open_forms_of(volume, m[0], m[1], m[3])};
  return project(triangle, clip, corners, intersect(part, half_spaces, beyond(triangle)));
}

std::vector<RationalVertex> gold_of_matrix(const Projection<float>& projection,
                                           const InputTriangle& triangle) {
  assert(is_finite(triangle));
  Truth::of_matrix(projection);  // throws unless the matrix is finite
  const Matrix m = projection_matrix(projection);
  const std::array<Vector, 3> clip = clip_positions(m, triangle);
  require_area(clip);
  const Corners corners = view_corners(triangle);
  HalfSpaces half_spaces = half_spaces_of(projection.volume, m[0], m[1], m[2], m[3]);
  for (const Vector& form : clip_distance_forms(projection.volume, triangle, corners)) {
    half_spaces.closed.push_back(form);
  }
  return project(triangle, clip, corners, intersect(facet(corners), half_spaces, beyond(triangle)));
}

std::vector<RationalVertex> gold_of_clip(DepthRange depth, const InputTriangle& triangle) {
  return gold_of_clip(ClipVolume{.depth = depth}, triangle);
}

// A point of the triangle is (1 - l1 - l2) a + l1 b + l2 c: each form d of clip space becomes the
// form d(a) + (d(b) - d(a)) l1 + (d(c) - d(a)) l2 over the plane of (l1, l2).
std::vector<RationalVertex> gold_of_clip(const ClipVolume& volume, const InputTriangle& triangle) {
  assert(is_finite(triangle));
  const auto& v = triangle.vertices;
  const std::array<Vector, 3> clip = {position(v[0]), position(v[1]), position(v[2])};
  require_area(clip);
  const Vector x = {1, 0, 0, 0}, y = {0, 1, 0, 0}, z = {0, 0, 1, 0}, w = {0, 0, 0, 1};
  const Corners simplex = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const auto over_simplex = [&](const Vector& form) {
    const Rational a = dot(form, clip[0]), b = dot(form, clip[1]), c = dot(form, clip[2]);
    return Vector{Rational(b - a), Rational(c - a), 0, a};
  };
  HalfSpaces half_spaces = {clip_distance_forms(volume, triangle, simplex), {}};
  const HalfSpaces of_volume = half_spaces_of(volume, x, y, z, w);
  std::ranges::transform(of_volume.closed, std::back_inserter(half_spaces.closed), over_simplex);
  std::ranges::transform(of_volume.open, std::back_inserter(half_spaces.open), over_simplex);
  return project(triangle, clip, simplex, intersect(facet(simplex), half_spaces, 2));
}

}  // namespace clipscope::reference
