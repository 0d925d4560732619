// SPDX-License-Identifier: MIT
//
// The distance-matrix clipper: a triangle's part inside as a polygon of barycentric coordinates.
//
// D[p] holds the signed distances of the three vertices to plane p. The part inside is the set of
// lambda >= 0 with lambda . D[p] >= 0 for each p: a polygon bounded by lines, the three edges and
// the rows of D. A new vertex is the meeting of two lines, lambda = l1 x l2, and its side of a
// third line is their determinant, so that nothing is decided from a rounded position, and every
// vertex comes from the three original ones:
//
//   ndc = sum lambda_i pos_i / sum lambda_i w_i      attribute = sum lambda_i a_i / sum lambda_i
//
// A mean rounds, and would change an attribute that is constant; that of equal values is the value.
// A coordinate that lies on its plane is set to exactly -1, 0 or 1.
// Source: homogeneous lines and their meetings: Blinn, "A Trip Down the Graphics Pipeline", 1996;
// the triangle as a 2D homogeneous problem: Olano and Greer, "Triangle Scan Conversion using 2D
// Homogeneous Coordinates", Graphics Hardware 1997.
// Guarantees: the entries of a meeting have a small relative error (spaces/products.hpp), without
// which the meeting of two nearly parallel lines would lie anywhere. The vertices on an edge depend
// on that edge alone, bit for bit.
// Does not guarantee: determinants of the right sign (they are rounded), hence the exact vertex
// count; the bits of a vertex on two planes when the input is rotated (a sum of three is rounded in
// order).
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <utility>

#include "spaces/clipper.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/planes.hpp"
#include "spaces/products.hpp"

namespace clipscope {

struct DistanceMatrix : StartsAtClipPositions<DistanceMatrix> {
  static constexpr std::string_view name = "barycentric/distance_matrix";
  static constexpr std::string_view summary =
      "every vertex from the three original ones, every decision a minor of the distance matrix";
  static constexpr std::string_view source = "Olano and Greer, 2D Homogeneous Coordinates, 1997";
  // Each of two distances 2, a meeting 3, the sums of three products over lambda and w 3 each, the
  // quotient 1: in front of that the transform.
  static constexpr Promise promise{
      .ulps = kProjectUlps + 14, .watertight = true, .rotation_invariant = false};

  template <HasSumOfProducts T, Space S, int K>
  static constexpr void clip(const ClipVolume& volume, const std::array<Vec4<T>, 3>& positions,
                             const Triangle<S, T, K>& source, NdcPolygon<T, K>& out) {
    const OutcodeSummary code = summarize_outcodes(
        volume, source, [&](std::size_t i) { return clip_outcode(volume.depth, positions[i]); });
    out.clear();
    if (code.all != 0) return;
    if (code.any == 0) {
      divide_inside(volume, positions, source, out);
      return;
    }
    for_each_corner(volume.depth, code.any, positions, source,
                    [&](const WeightedVertex<T, K>& v, Outcode on) {
                      NdcVertex<T, K> ndc = to_ndc(v);
                      set_on_planes(volume.depth, on, T(1), ndc.position);
                      out.push_back(ndc);
                    });
    out.drop_if_degenerate();
    clear_if_overflowed(out);
  }

  // A vertex as it comes out of the sums, before any quotient: clip coordinates times its weight.
  template <Scalar T, int K>
  struct WeightedVertex : ClipVertex<T, K> {
    T weight;
  };

  // The divide of the call operator.
  template <Scalar T, int K>
  static constexpr NdcVertex<T, K> to_ndc(const WeightedVertex<T, K>& v) {
    const auto& p = v.position;
    const T x = p[0] / p[3];
    const T y = p[1] / p[3];
    const T z = p[2] / p[3];
    const T inv_w = v.weight / p[3];
    return {Vec4<T>(x, y, z, inv_w), v.attributes};
  }

  // The polygon before the divide: `to_ndc` of its vertices is the answer of the call operator.
  template <HasSumOfProducts T, int K>
  static constexpr VertexList<WeightedVertex<T, K>> cut_weighted(
      const ClipVolume& volume, const ClipTriangle<T, K>& triangle) {
    VertexList<WeightedVertex<T, K>> out;
    const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
      return clip_outcode(volume.depth, triangle[i].position);
    });
    if (code.all != 0 || is_beyond_open_side(volume, triangle)) return out;
    const std::array positions = {triangle[0].position, triangle[1].position, triangle[2].position};
    for_each_corner(volume.depth, code.any, positions, triangle,
                    [&](WeightedVertex<T, K> v, Outcode on) {
                      const T w = v.position[3];
                      set_on_planes(volume.depth, on, w, v.position);
                      out.push_back(v);
                    });
    out.drop_if_degenerate();
    return out;
  }

  // The same in clip coordinates. These are rounded, and a divide rounds again.
  template <HasSumOfProducts T, int K>
  static constexpr ClipPolygon<T, K> cut(const ClipVolume& volume,
                                         const ClipTriangle<T, K>& triangle) {
    ClipPolygon<T, K> polygon;
    for (const WeightedVertex<T, K>& weighted : cut_weighted(volume, triangle)) {
      ClipVertex<T, K> v = weighted;
      for (int c = 0; c < 4; ++c) v.position[c] = v.position[c] / weighted.weight;
      polygon.push_back(v);
    }
    return divisible<T, K>(polygon);
  }

 private:
  static constexpr Outcode kNoPlane = 0;

  // A line in barycentric coordinates, inside where line . lambda >= 0, and the plane that it comes
  // from (no bit: an edge of the triangle).
  template <Scalar T>
  struct Line {
    std::array<T, 3> of;
    Outcode plane = kNoPlane;
  };

  // A vertex, the planes that it lies on by construction, and the line from it to the next vertex.
  template <Scalar T>
  struct Corner {
    std::array<T, 3> lambda;
    Outcode on = kNoPlane;
    Line<T> next;
  };

  template <Scalar T>
  using Corners = VertexList<Corner<T>>;

  template <Scalar T>
  static constexpr Corners<T> whole_triangle() {
    const T o(0), i(1);
    Corners<T> r;  // vertex 0, then the edge 0-1, where lambda_2 = 0, and so on
    r.push_back({{i, o, o}, kNoPlane, {{o, o, i}}});
    r.push_back({{o, i, o}, kNoPlane, {{i, o, o}}});
    r.push_back({{o, o, i}, kNoPlane, {{o, i, o}}});
    return r;
  }

  // Multiplies by the power of two that makes the largest entry about 1: lines and points mean the
  // same then, and their products neither overflow nor vanish.
  template <Scalar T>
  static constexpr void scale_to_one(std::array<T, 3>& v) {
    if constexpr (std::floating_point<T>) {
      constexpr int kLargestExponent = std::numeric_limits<T>::max_exponent - 2;
      const T largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
      if (!(T(0) < largest)) return;
      const int exponent = std::clamp(-std::ilogb(largest), -kLargestExponent, kLargestExponent);
      const T factor = std::ldexp(T(1), exponent);
      for (T& x : v) x *= factor;
    }
  }

  // A row of the matrix.
  template <Scalar T, Space S, int K>
  static constexpr Line<T> row(DepthRange depth, Plane plane,
                               const std::array<Vec4<T>, 3>& positions,
                               const Triangle<S, T, K>& source) {
    Line<T> r{{}, bit(plane)};
    for (std::size_t i = 0; i < 3; ++i) {
      r.of[i] = signed_distance(depth, plane, ClipVertex<T, K>{positions[i], source[i].attributes});
    }
    scale_to_one(r.of);
    return r;
  }

  template <Scalar T>
  static constexpr T dot(const std::array<T, 3>& a, const std::array<T, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  template <Scalar T>
  static constexpr std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b) {
    std::array<T, 3> r = {sum_of_products(a[1], b[2], T(-a[2]), b[1]),
                          sum_of_products(a[2], b[0], T(-a[0]), b[2]),
                          sum_of_products(a[0], b[1], T(-a[1]), b[0])};
    scale_to_one(r);
    return r;
  }

  // The corners with line . lambda >= 0 and the meetings of the polygon's lines with this one.
  template <Scalar T>
  static constexpr void cut_corners(const Corners<T>& in, const Line<T>& line, Corners<T>& out) {
    out.clear();
    const T zero(0);
    for (int i = 0; i < in.size(); ++i) {
      const Corner<T>& from = in[i];
      const T d = dot(line.of, from.lambda);
      const T d_next = dot(line.of, in[(i + 1) % in.size()].lambda);
      const Outcode on = from.next.plane | line.plane;
      if (zero <= d) {
        out.push_back({from.lambda, from.on, zero == d && d_next < zero ? line : from.next});
      }
      if (zero < d && d_next < zero) {
        out.push_back({cross(from.next.of, line.of), on, line});
      } else if (d < zero && zero < d_next) {
        out.push_back({cross(line.of, from.next.of), on, from.next});
      }
    }
  }

  // f(vertex, planes) of each corner in front of the eye, and the planes that it lies on by
  // construction; none of a triangle that is not finite.
  template <Scalar T, Space S, int K, class F>
  static constexpr void for_each_corner(DepthRange depth, Outcode planes,
                                        const std::array<Vec4<T>, 3>& positions,
                                        const Triangle<S, T, K>& source, F&& f) {
    for (const Vec4<T>& p : positions) {
      for (int c = 0; c < 4; ++c) {
        if (!is_finite(p[c])) return;
      }
    }
    Corners<T> corners = whole_triangle<T>(), other;
    for_each_plane(planes, kAllPlanes, [&](Plane plane) {
      cut_corners(corners, row(depth, plane, positions, source), other);
      std::swap(corners, other);
    });
    for (const Corner<T>& corner : corners) {
      WeightedVertex<T, K> v;
      if (weigh(corner.lambda, positions, source, v)) f(v, corner.on);
    }
  }

  // The vertex at lambda; whether it is in front of the eye.
  template <Scalar T, Space S, int K>
  static constexpr bool weigh(const std::array<T, 3>& lambda,
                              const std::array<Vec4<T>, 3>& positions,
                              const Triangle<S, T, K>& source, WeightedVertex<T, K>& v) {
    const auto sum = [&](auto&& value) {
      const T r = dot(lambda, {value(0), value(1), value(2)});
      return r;
    };
    const auto coordinate = [&](int c) {
      return sum([&](std::size_t i) { return positions[i][c]; });
    };
    v.weight = lambda[0] + lambda[1] + lambda[2];
    v.position[3] = coordinate(3);
    if (!(T(0) < v.weight) || !(T(0) < v.position[3])) return false;
    for (int c = 0; c < 3; ++c) v.position[c] = coordinate(c);
    v.attributes.resize(source[0].attributes.size());
    for (int k = 0; k < v.attributes.size(); ++k) {
      v.attributes[k] =
          mean({source[0].attributes[k], source[1].attributes[k], source[2].attributes[k]}, lambda,
               v.weight);
    }
    return true;
  }

  // The mean of three values, whose weights are lambda. Where all that have a weight are equal it
  // is their value: the third vertex of an edge has no say, so that neighbours agree there.
  template <Scalar T>
  static constexpr T mean(const std::array<T, 3>& values, const std::array<T, 3>& lambda,
                          const T& weight) {
    const T zero(0);
    const std::size_t first = lambda[0] != zero ? 0 : lambda[1] != zero ? 1 : 2;
    const auto agrees = [&](std::size_t i) {
      return values[i] == values[first] || lambda[i] == zero;
    };
    if (agrees(1) && agrees(2)) return values[first];
    const T r = dot(lambda, values) / weight;
    return r;
  }

  // Sets the coordinates that the planes fix. `one` is w, or 1 in NDC.
  template <Scalar T>
  static constexpr void set_on_planes(DepthRange depth, Outcode on, const T& one, Vec4<T>& v) {
    const bool gl = depth == DepthRange::minus_one_to_one;
    const T minus_one = -one;
    const T low = gl ? minus_one : T(0);
    const bool reversed = depth == DepthRange::reversed;
    if (on & bit(Plane::left)) v[0] = minus_one;
    if (on & bit(Plane::right)) v[0] = one;
    if (on & bit(Plane::bottom)) v[1] = minus_one;
    if (on & bit(Plane::top)) v[1] = one;
    if (on & bit(Plane::near)) v[2] = reversed ? one : low;
    if (on & bit(Plane::far)) v[2] = reversed ? T(0) : one;
  }
};

}  // namespace clipscope
