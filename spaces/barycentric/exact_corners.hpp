// SPDX-License-Identifier: MIT
//
// The part of a triangle inside a volume as a polygon of meetings of lines, every decision exact.
//
// The polygon lies in the barycentric plane: lambda >= 0 with lambda . row >= 0 for each plane that
// cuts; a row holds the distances of the three vertices to its plane. Which space the rows come
// from and what is made of the corners is up to the callers.
//
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974, on lines instead
// of points; of the parts, see distance_matrix.hpp and exact_lines.hpp.
// Guarantees: exactly the corners of the closed part, each of them once in lambda, in the order of
// the triangle. A corner may have w <= 0, or the place of another one where the triangle has no
// area.
#pragma once

#include <array>
#include <tuple>
#include <utility>

#include "spaces/barycentric/exact_lines.hpp"
#include "spaces/planes.hpp"
#include "spaces/polygon.hpp"
#include "spaces/rounding.hpp"

namespace clipscope::barycentric {

// A vertex, and the line from it to the next one.
struct Corner {
  Meeting at;
  const Line* next;
};
using Corners = VertexList<Corner>;

// Edge i is opposite to vertex i.
inline constexpr std::array<Line, 3> kEdges = {
    {{{1, 0, 0}, {}, 0, {}}, {{0, 1, 0}, {}, 0, {}}, {{0, 0, 1}, {}, 0, {}}}};

// A polygon and the lines that its corners point to: it stays where it is.
struct CutTriangle {
  Corners corners;
  std::array<Line, kMaxPlanes> rows;
  Corners scratch;

  CutTriangle() = default;
  CutTriangle(const CutTriangle&) = delete;
  CutTriangle& operator=(const CutTriangle&) = delete;
};

// All of the triangle.
inline void set_whole(Corners& corners) {
  corners.clear();
  for (int i = 0; i < 3; ++i) {
    const Line &before = kEdges[(i + 1) % 3], &after = kEdges[(i + 2) % 3];
    corners.push_back({meet(before, after), &after});
  }
}

// The corners on the line's inner side and the meetings of the polygon's lines with it. The polygon
// is strictly convex in the barycentric plane and is walked in the order of the triangle, so that
// at each corner the lines turn one way and lambda, as `meet` has it, is positive.
template <class Count>
void cut_corners(const Corners& in, const Line& line, Corners& out, Count& count) {
  std::array<int, kMaxPolygonVertices> sides;
  for (int i = 0; i < in.size(); ++i) sides[i] = side(in[i].at, line, count);
  out.clear();
  for (int i = 0; i < in.size(); ++i) {
    const Corner& from = in[i];
    const int here = sides[i], next = sides[(i + 1) % in.size()];
    if (here >= 0) out.push_back({from.at, here == 0 && next < 0 ? &line : from.next});
    if (here > 0 && next < 0) {
      out.push_back({meet(*from.next, line), &line});
    } else if (here < 0 && next > 0) {
      out.push_back({meet(line, *from.next), from.next});
    }
  }
}

// The triangle cut by the planes of the code; row_of(plane) is the line of one. Fewer than three
// corners enclose nothing: then there may be more than the exact ones.
template <class RowOf, class Count>
void cut_triangle(Outcode code, RowOf&& row_of, CutTriangle& cut, Count& count) {
  set_whole(cut.corners);
  for_each_plane(code, kAllPlanes, [&](Plane plane) {
    if (cut.corners.size() < 3) return;  // a point or a segment never grows
    Line& line = cut.rows[static_cast<int>(plane)];
    line = row_of(plane);
    cut_corners(cut.corners, line, cut.scratch, count);
    std::swap(cut.corners, cut.scratch);
  });
}

// The row of a clip distance. Pre-condition: they are finite.
template <Space S, int K>
Line clip_distance_row(Plane plane, const Triangle<S, float, K>& triangle) {
  Line r{{}, {}, bit(plane), {}};
  for (int i = 0; i < 3; ++i) r.rounded[i] = triangle[i].attributes[clip_distance_index(plane)];
  return r;
}

// Whether the clip distances of the code are finite.
template <Space S, int K>
bool has_finite_distances(Outcode planes, const Triangle<S, float, K>& triangle) {
  for (int i = 0; (planes >> (kPlanes + i)) != 0; ++i) {
    if ((planes >> (kPlanes + i) & 1) == 0) continue;
    for (const Vertex<S, float, K>& v : triangle) {
      if (!is_finite(v.attributes[i])) return false;
    }
  }
  return true;
}

// One of the six planes in clip space is w - bound c >= 0, and c >= 0 if bound is 0, where c is
// coordinate `axis`: on it c = bound w.
struct PlaneForm {
  int axis;
  float bound;
};
constexpr PlaneForm plane_form(DepthRange depth, Plane plane) {
  const int p = static_cast<int>(plane), axis = p / 2;
  const bool is_z = axis == 2;
  const bool is_upper = (p % 2 != 0) != (is_z && depth == DepthRange::reversed);
  if (is_upper) return {axis, 1};
  return {axis, is_z && depth != DepthRange::minus_one_to_one ? 0.0f : -1.0f};
}

// The row of one of the six planes at three values of its coordinate and of w, floats all of them.
inline Line clip_row(const PlaneForm& form, Plane plane, const Values& c, const Values& w) {
  Line r{{}, {}, bit(plane), {}};
  for (int i = 0; i < 3; ++i) {
    if (form.bound == 0) {
      r.rounded[i] = c[i];
    } else {
      std::tie(r.rounded[i], r.error[i]) = bounds::two_sum(w[i], -form.bound * c[i]);
    }
  }
  return r;
}

// x, y, z and w at the three vertices.
template <int K>
std::array<Values, 4> clip_coordinates(const ClipTriangle<float, K>& triangle) {
  std::array<Values, 4> r;
  for (int c = 0; c < 4; ++c) {
    for (int i = 0; i < 3; ++i) r[c][i] = triangle[i].position[c];
  }
  return r;
}

// The part of a clip-space triangle inside the volume; whether it has three corners or more.
// Nothing is left of a triangle with a position, or a clip distance that cuts, that isn't finite.
template <int K, class Count>
bool cut_clip_triangle(const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                       const std::array<Values, 4>& coordinates, CutTriangle& cut, Count& count) {
  if (!has_finite_positions(triangle) || is_beyond_open_side(volume, triangle)) return false;
  const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
    return clip_outcode(volume.depth, triangle[i].position);
  });
  if (code.all != 0 || !has_finite_distances(code.any, triangle)) return false;
  const auto row_of = [&](Plane plane) {
    if (is_clip_distance(plane)) return clip_distance_row(plane, triangle);
    const PlaneForm form = plane_form(volume.depth, plane);
    return clip_row(form, plane, coordinates[form.axis], coordinates[3]);
  };
  cut_triangle(code.any, row_of, cut, count);
  return cut.corners.size() >= 3;
}

// The planes that a meeting lies on by construction.
inline Outcode planes_of(const Meeting& m) { return m.a->plane | m.b->plane; }

// The number of the triangle's vertex that a meeting is, or -1.
inline int own_vertex(const Meeting& m) {
  if (planes_of(m) != 0) return -1;
  return m.magnitude[0] != 0 ? 0 : m.magnitude[1] != 0 ? 1 : 2;
}

inline constexpr Outcode kSixPlanes = (Outcode{1} << kPlanes) - 1;

// Sets the coordinates that the meeting's planes fix, c = bound w with +0 for 0; returns a bit for
// each.
inline Outcode set_fixed(DepthRange depth, const Meeting& m, float w, Vec4<float>& position) {
  Outcode fixed = 0;
  for_each_plane(planes_of(m) & kSixPlanes, kAllPlanes, [&](Plane plane) {
    const auto [axis, bound] = plane_form(depth, plane);
    position[axis] = bound == 0 ? 0 : bound * w;
    fixed |= Outcode{1} << axis;
  });
  return fixed;
}

inline constexpr Values kOnes = {1, 1, 1};

// The attributes at a meeting, rounded; a clip distance that cut there is +0. Attributes that are
// not finite are interpolated in double without a promise. sum: divisor(m, kOnes).
template <Space S, int K, class Count>
void set_attributes(const Meeting& m, const Divisor& sum, const Triangle<S, float, K>& triangle,
                    Attributes<float, K>& out, Count& count) {
  out.resize(triangle[0].attributes.size());
  for (int k = 0; k < out.size(); ++k) {
    if (k < kMaxClipDistances && (planes_of(m) >> (kPlanes + k) & 1) != 0) {
      out[k] = 0;
      continue;
    }
    Values a{};  // a vertex without weight takes no part, whatever its attribute
    for (int i = 0; i < 3; ++i) {
      if (m.magnitude[i] != 0) a[i] = triangle[i].attributes[k];
    }
    if (is_finite(a[0] + a[1] + a[2])) {
      out[k] = rounded_quotient(m, a, sum, count);
    } else {
      out[k] = rounded_to_float(dot(m, a).value / sum.dot.value);
    }
  }
}

// The points of a clip-space triangle in NDC.
class ClipPoints {
 public:
  ClipPoints(DepthRange depth, const std::array<Values, 4>& coordinates)
      : depth_(depth), coordinates_(coordinates), w_{coordinates[3], {}, 0, {}} {}

  const Line& w() const { return w_; }

  // x, y, z and 1/w at a meeting with w > 0, rounded; coordinates on their planes exactly.
  template <class Count>
  Vec4<float> position(const Meeting& m, Count& count) const {
    const Divisor w = divisor(m, coordinates_[3]);
    Vec4<float> r(0);
    const Outcode fixed = set_fixed(depth_, m, 1, r);
    for (int c = 0; c < 3; ++c) {
      if ((fixed >> c & 1) == 0) r[c] = rounded_quotient(m, coordinates_[c], w, count);
    }
    r[3] = rounded_quotient(m, kOnes, w, count);
    return r;
  }

  // x, y, z and w with lambda made to sum to 1.
  template <class Count>
  Vec4<float> clip_position(const Meeting& m, const Divisor& sum, Count& count) const {
    Vec4<float> r(0);
    r[3] = rounded_quotient(m, coordinates_[3], sum, count);
    const Outcode fixed = set_fixed(depth_, m, r[3], r);
    for (int c = 0; c < 3; ++c) {
      if ((fixed >> c & 1) == 0) r[c] = rounded_quotient(m, coordinates_[c], sum, count);
    }
    return r;
  }

 private:
  DepthRange depth_;
  const std::array<Values, 4>& coordinates_;
  Line w_;
};

}  // namespace clipscope::barycentric
