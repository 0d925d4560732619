// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/triangulate.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "experiments/machine/errors.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {
namespace {

using Exact = reference::Rational;

// Nothing but input points is ever constructed, so exact predicates make the whole computation
// exact.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = Kernel::Point_2;

enum class Region { unknown, inside, outside };

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Region, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;

template <std::size_t D>
using Points = std::span<const std::array<double, D>>;

template <std::size_t D>
void check_finite(Points<D> points, const std::string& where) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double x : points[i]) {
      if (!std::isfinite(x)) {
        throw InputError(fmt::format(
            "{}: vertex {} has the coordinate {}, expected a finite number", where, i, x));
      }
    }
  }
}

// The polygon's area in the plane of coordinates a and b, times 2; exact.
template <std::size_t D>
Exact projected_area(Points<D> points, std::size_t a, std::size_t b) {
  Exact area(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &p = points[i], &q = points[(i + 1) % points.size()];
    area = area + Exact(Exact(p[a]) * Exact(q[b])) - Exact(Exact(p[b]) * Exact(q[a]));
  }
  return area;
}

// The projection in which the area is largest.
template <std::size_t D>
std::vector<Point2> project(Points<D> points, const std::string& where) {
  std::size_t best_a = 0, best_b = 1;
  Exact largest(0);
  for (std::size_t a = 0; a < D; ++a) {
    for (std::size_t b = a + 1; b < D; ++b) {
      const Exact area = CGAL::abs(projected_area(points, a, b));
      if (largest < area) {
        largest = area;
        best_a = a;
        best_b = b;
      }
    }
  }
  if (largest == Exact(0)) {
    throw InputError(where +
                     ": the polygon has no area, or its loops cancel; expected a simple polygon");
  }
  std::vector<Point2> projected;
  for (const auto& p : points) projected.emplace_back(p[best_a], p[best_b]);
  return projected;
}

Triangulation constrain_edges(const std::vector<Point2>& points) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    vertices.push_back(triangulation.insert(points[i]));
    vertices.back()->info() = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % points.size()]);
  }
  return triangulation;
}

// Faces reached from infinity without crossing the polygon's edges are outside; the rest are
// inside, for the edges make one simple loop.
void mark_places(Triangulation& triangulation) {
  for (auto face : triangulation.all_face_handles()) face->info() = Region::inside;
  std::vector<Triangulation::Face_handle> pending = {triangulation.infinite_face()};
  while (!pending.empty()) {
    const Triangulation::Face_handle face = pending.back();
    pending.pop_back();
    if (face->info() == Region::outside) continue;
    face->info() = Region::outside;
    for (int i = 0; i < 3; ++i) {
      if (!face->is_constrained(i)) pending.push_back(face->neighbor(i));
    }
  }
}

// The polygon in the plane. Errors: InputError unless it is simple.
template <std::size_t D>
std::vector<Point2> simple_projection(Points<D> points, const std::string& where) {
  if (points.size() < 3) {
    throw InputError(fmt::format("{}: {} vertices, expected 3 or more", where, points.size()));
  }
  check_finite(points, where);
  std::vector<Point2> projected = project(points, where);
  if (!CGAL::is_simple_2(projected.begin(), projected.end(), Kernel())) {
    throw InputError(where +
                     ": edges of the polygon cross or touch each other; expected a simple polygon");
  }
  return projected;
}

// Pre-condition: the polygon is simple.
std::vector<IndexTriangle> triangulate_simple(const std::vector<Point2>& polygon) {
  const bool counterclockwise =
      CGAL::orientation_2(polygon.begin(), polygon.end(), Kernel()) == CGAL::COUNTERCLOCKWISE;
  Triangulation triangulation = constrain_edges(polygon);
  mark_places(triangulation);
  std::vector<IndexTriangle> triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    if (face->info() != Region::inside) continue;
    IndexTriangle t = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    if (!counterclockwise) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  return triangles;
}

template <std::size_t D>
std::vector<IndexPolygon> convex_parts_of(Points<D> points, const std::string& where) {
  const std::vector<Point2> polygon = simple_projection(points, where);
  if (CGAL::is_convex_2(polygon.begin(), polygon.end(), Kernel())) {
    IndexPolygon all(polygon.size());
    std::iota(all.begin(), all.end(), 0);
    return {all};
  }
  std::vector<IndexPolygon> parts;
  for (const IndexTriangle& t : triangulate_simple(polygon)) parts.emplace_back(t.begin(), t.end());
  return parts;
}

}  // namespace

std::vector<IndexTriangle> triangulate(std::span<const std::array<double, 3>> points,
                                       const std::string& where) {
  return triangulate_simple(simple_projection(points, where));
}

std::vector<IndexTriangle> triangulate(std::span<const std::array<double, 4>> points,
                                       const std::string& where) {
  return triangulate_simple(simple_projection(points, where));
}

std::vector<IndexPolygon> convex_parts(std::span<const std::array<double, 3>> points,
                                       const std::string& where) {
  return convex_parts_of(points, where);
}

std::vector<IndexPolygon> convex_parts(std::span<const std::array<double, 4>> points,
                                       const std::string& where) {
  return convex_parts_of(points, where);
}

}  // namespace clipscope::experiments
