// SPDX-License-Identifier: GPL-3.0-or-later
//
// See integer_clip.hpp.
#include "tests/spaces/attack/integer_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clipscope::attack {
namespace {

Weights unit(int i) { return {Integer(i == 0), Integer(i == 1), Integer(i == 2)}; }

Integer sum_of_magnitudes(const Weights& a, const Weights& b) {
  return abs(a[0] * b[0]) + abs(a[1] * b[1]) + abs(a[2] * b[2]);
}

// The cross product: a multiple of the point where two lines meet.
Weights meeting(const Weights& a, const Weights& b) {
  return {Integer(a[1] * b[2] - a[2] * b[1]), Integer(a[2] * b[0] - a[0] * b[2]),
          Integer(a[0] * b[1] - a[1] * b[0])};
}

// How many binary digits of a sum its terms have lost by cancellation.
int lost_bits(const Integer& sum, const Integer& magnitudes) {
  return static_cast<int>(mpz_sizeinbase(magnitudes.get_mpz_t(), 2)) -
         static_cast<int>(mpz_sizeinbase(sum.get_mpz_t(), 2));
}

// A line of the barycentric plane; lambda . values >= 0 is inside.
struct Line {
  Weights values;
  int plane =
      -1;  // left, right, bottom, top, near, far: 0 to 5; clip distances: 6 and on; -1: edge
};

// Distances, times positive factors, to the six planes in clip space.
std::vector<Weights> clip_distances_to_planes(const Vertices& vertices, Depth depth) {
  const auto plane = [&](int x, int y, int z, int w) {
    return vertices.of_each(
        [=](const Integer& vx, const Integer& vy, const Integer& vz, const Integer& vw) {
          return Integer(x * vx + y * vy + z * vz + w * vw);
        });
  };
  const Weights at_minus_one = plane(0, 0, 1, 1), at_zero = plane(0, 0, 1, 0),
                at_one = plane(0, 0, -1, 1);
  const bool upside_down = depth == Depth::one_to_zero;
  const Weights& lower = depth == Depth::minus_one_to_one ? at_minus_one : at_zero;
  return {plane(1, 0, 0, 1),  plane(-1, 0, 0, 1),           plane(0, 1, 0, 1),
          plane(0, -1, 0, 1), upside_down ? at_one : lower, upside_down ? lower : at_one};
}

// The same in view space. A far plane at infinity cuts nothing.
std::vector<Weights> view_distances_to_planes(const Vertices& vertices, const Frustum& f) {
  const Integer near = scaled(f.near), far = scaled(f.far),
                shears[2] = {scaled(f.shear_x), scaled(f.shear_y)};
  const auto side = [&](int axis, int sign, float bound) {
    const Integer b = scaled(bound);
    return vertices.of_each(
        [&](const Integer& x, const Integer& y, const Integer& z, const Integer&) {
          const Integer& c = axis == 0 ? x : y;
          return f.is_perspective ? Integer(sign * (near * c + b * z))
                                  : Integer(sign * ((c - b) * one() + shears[axis] * z));
        });
  };
  const auto depth = [&](int sign, const Integer& constant) {
    return vertices.of_each([&](const Integer&, const Integer&, const Integer& z, const Integer&) {
      return Integer(sign * z + constant);
    });
  };
  const Weights nothing = {one(), one(), one()};
  return {side(0, 1, f.left), side(0, -1, f.right),      side(1, 1, f.bottom),
          side(1, -1, f.top), depth(-1, Integer(-near)), f.is_infinite ? nothing : depth(1, far)};
}

std::vector<Weights> distances_to_planes(const Batch& batch, const Vertices& vertices) {
  return batch.is_view() ? view_distances_to_planes(vertices, *batch.frustum)
                         : clip_distances_to_planes(vertices, batch.volume.depth);
}

bool is_some_outside(const Weights& distances) {
  return distances[0] < 0 || distances[1] < 0 || distances[2] < 0;
}

// Notes how near vertices come to a plane that cuts. The terms: what a distance is a difference of.
void note_vertices(const Weights& distances, const Weights& w, Facts& facts) {
  for (std::size_t v = 0; v < 3; ++v) {
    facts.note(Fact::vertex_on_plane, distances[v] == 0);
    facts.note(Fact::beside_plane,
               distances[v] != 0 && lost_bits(distances[v], Integer(2 * abs(w[v]))) >= 20);
  }
}

// The edges, and the planes that a vertex is outside of: other planes exclude nothing.
std::vector<Line> lines_of(const Batch& batch, const Vertices& vertices, Facts& facts) {
  std::vector<Line> r = {{unit(0)}, {unit(1)}, {unit(2)}};
  const std::vector<Weights> planes = distances_to_planes(batch, vertices);
  for (int p = 0; p < 6; ++p) {
    const bool is_clamped =
        (p == 4 && batch.volume.clamps_near) || (p == 5 && batch.volume.clamps_far);
    const Weights& d = planes[static_cast<std::size_t>(p)];
    if (is_clamped || !is_some_outside(d)) continue;
    r.push_back({d, p});
    if (!batch.is_view()) note_vertices(d, vertices.floats(3), facts);
  }
  for (int k = 0; k < batch.volume.clip_distances; ++k) {
    const Weights d = vertices.attribute(k);
    if (is_some_outside(d)) r.push_back({d, 6 + k});
  }
  return r;
}

// Turns the signs so that no entry is negative; whether that can be and not all are 0.
bool make_positive(Weights& lambda) {
  const auto is_above = [](const Integer& x) { return x > 0; };
  const auto is_below = [](const Integer& x) { return x < 0; };
  const bool some_above = std::ranges::any_of(lambda, is_above),
             some_below = std::ranges::any_of(lambda, is_below);
  if (some_above == some_below) return false;
  if (some_below) {
    for (Integer& x : lambda) x = -x;
  }
  return true;
}

int own_vertex(const Weights& lambda) {
  const auto zeros = std::ranges::count(lambda, Integer(0));
  if (zeros != 2) return -1;
  return lambda[0] != 0 ? 0 : lambda[1] != 0 ? 1 : 2;
}

bool is_same_point(const Weights& a, const Weights& b) {
  return meeting(a, b) == Weights{Integer(0), Integer(0), Integer(0)};
}

// Whether no line excludes the meeting of lines a and b.
bool is_inside(const std::vector<Line>& lines, std::size_t a, std::size_t b, const Weights& lambda,
               Facts& facts) {
  bool inside = true;
  for (std::size_t i = 3; i < lines.size(); ++i) {
    if (i == a || i == b) continue;
    const Integer d = dot(lambda, lines[i].values);
    inside = inside && d >= 0;
    if (b < 3) continue;  // a vertex of the triangle
    facts.note(Fact::through_corner, d == 0);
    facts.note(Fact::next_to_corner,
               d != 0 && lost_bits(d, sum_of_magnitudes(lambda, lines[i].values)) >= 48);
  }
  return inside;
}

// In the order of the triangle, from the first one on: as their determinants turn.
void sort_around(std::vector<Corner>& corners) {
  if (corners.size() < 3) return;
  const Weights first = corners[0].lambda;
  std::sort(corners.begin() + 1, corners.end(), [&](const Corner& a, const Corner& b) {
    return dot(first, meeting(a.lambda, b.lambda)) > 0;
  });
}

// Whether the part inside lies in a side that does not own its points.
bool lies_in_open_side(const Batch& batch, const Vertices& vertices,
                       const std::vector<Corner>& corners) {
  const std::vector<Weights> planes = distances_to_planes(batch, vertices);
  for (std::size_t side = 0; side < 4; ++side) {
    if (!batch.volume.is_open[side]) continue;
    if (std::ranges::all_of(
            corners, [&](const Corner& corner) { return dot(corner.lambda, planes[side]) <= 0; })) {
      return true;
    }
  }
  return false;
}

std::vector<Corner> all_corners(const std::vector<Line>& lines, Facts& facts) {
  std::vector<Corner> r;
  for (std::size_t b = 1; b < lines.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      Weights lambda = meeting(lines[a].values, lines[b].values);
      if (!make_positive(lambda) || !is_inside(lines, a, b, lambda, facts)) continue;
      if (std::ranges::any_of(r,
                              [&](const Corner& c) { return is_same_point(c.lambda, lambda); })) {
        continue;
      }
      r.push_back({lambda, own_vertex(lambda), (a >= 3) + (b >= 3), lines[b].plane >= 6});
    }
  }
  return r;
}

// Notes whether a polygon has an area in NDC, and how little.
void note_area(const Batch& batch, const Vertices& vertices, Facts& facts) {
  if (batch.is_view()) return;
  // Its area is a multiple of the determinant of x, y and w.
  const Weights x = vertices.floats(0), y = vertices.floats(1), w = vertices.floats(3),
                minors = meeting(y, w);
  const Integer area = dot(x, minors), magnitudes = sum_of_magnitudes(x, minors);
  facts.note(Fact::flat, area == 0);
  facts.note(Fact::sliver, area != 0 && lost_bits(area, magnitudes) >= 20);
}

// The position, then the attributes.
void append_vertex(const std::vector<Channel>& channels, const Corner& corner,
                   std::vector<float>& out, Facts& facts) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Channel& c = channels[i];
    const Quotient q{dot(corner.lambda, c.numerator), dot(corner.lambda, c.denominator)};
    const Nearest r = nearest(q);
    out.push_back(r.value);
    if (corner.own >= 0) continue;
    facts.note(Fact::tie_to_low, r.is_tie && !r.went_up);
    facts.note(Fact::tie_to_high, r.is_tie && r.went_up);
    facts.note(Fact::next_to_tie, r.zeros_to_tie >= 26);
    facts.note(Fact::subnormal,
               r.value != 0 && std::abs(r.value) < std::numeric_limits<float>::min());
    facts.note(Fact::rounded_to_zero, q.numerator > 0 && r.value == 0);
    facts.note(Fact::rounded_to_minus_zero, q.numerator < 0 && r.value == 0);
    facts.note(Fact::huge, std::isfinite(r.value) && std::abs(r.value) > 0x1p120f);
    const Integer terms = sum_of_magnitudes(corner.lambda, c.numerator);
    facts.note(Fact::cancelled, q.numerator != 0 && lost_bits(q.numerator, terms) >= 24);
    // On its plane z, or a clip distance, is 0 by construction.
    const bool is_free = i != 2 && !(corner.planes > 0 && corner.on_clip_distance);
    facts.note(Fact::cancelled_to_zero, is_free && q.numerator == 0 && terms != 0);
  }
}

bool is_minus_zero(float x) { return x == 0 && std::signbit(x); }

void append_own(const Batch& batch, std::size_t triangle, int own, std::vector<float>& out,
                Facts& facts) {
  const float* v = batch.vertex(triangle, static_cast<std::size_t>(own));
  out.insert(out.end(), v, v + batch.stride());
  for (std::size_t i = 0; i < batch.stride(); ++i) {
    facts.note(Fact::kept_minus_zero, is_minus_zero(v[i]));
    facts.note(Fact::lost_minus_zero, i >= 4 && is_minus_zero(v[i]));
  }
}

std::vector<float> ndc_polygon(const Batch& batch, std::size_t triangle,
                               const std::vector<Corner>& corners, Facts& facts) {
  std::vector<float> r;
  const std::vector<Channel> channels = ndc_channels(batch, triangle);
  bool is_finite = true;
  for (const Corner& corner : corners) {
    append_vertex(channels, corner, r, facts);
    const float z = r[r.size() - channels.size() + 2], inverse = r[r.size() - channels.size() + 3];
    is_finite = is_finite && std::isfinite(z);
    facts.note(Fact::infinite_inverse, std::isinf(inverse));
    facts.note(Fact::largest_inverse, inverse == std::numeric_limits<float>::max());
    const float lowest = batch.volume.depth == Depth::minus_one_to_one ? -1.0f : 0.0f;
    facts.note(Fact::outside_depth, z > 1 || z < lowest);
  }
  if (is_finite) return r;
  facts.note(Fact::overflowed_z);
  return {};
}

std::vector<float> stage_polygon(const Batch& batch, std::size_t triangle,
                                 const std::vector<Corner>& corners, Facts& facts) {
  std::vector<float> r;
  const std::vector<Channel> channels = clip_channels(batch, triangle);
  for (const Corner& corner : corners) {
    if (corner.own >= 0) {
      append_own(batch, triangle, corner.own, r, facts);
    } else {
      append_vertex(channels, corner, r, facts);
    }
  }
  return r;
}

void note_corners(const Batch& batch, const Vertices& vertices, const std::vector<Corner>& corners,
                  Facts& facts) {
  const auto is_new = [](const Corner& c) { return c.own < 0; };
  if (std::ranges::none_of(corners, is_new)) return;
  facts.note(Fact::cut);
  for (const Corner& c : corners) {
    facts.note(Fact::two_planes, c.planes == 2);
    facts.note(Fact::by_clip_distance, c.on_clip_distance);
  }
  for (const Integer& w : w_of(batch, vertices)) facts.note(Fact::behind, w < 0);
}

}  // namespace

Integer dot(const Weights& a, const Weights& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::vector<Corner> corners(const Batch& batch, std::size_t triangle, Facts& facts) {
  const Vertices vertices(batch, triangle);
  std::vector<Corner> r = all_corners(lines_of(batch, vertices, facts), facts);
  sort_around(r);
  if (r.size() < 3) return {};
  if (lies_in_open_side(batch, vertices, r)) {
    facts.note(Fact::in_open_side);
    return {};
  }
  const Weights w = w_of(batch, vertices);
  facts.note(Fact::without_w, std::erase_if(r, [&](const Corner& corner) {
                                return dot(corner.lambda, w) <= 0;
                              }) != 0);
  if (r.size() < 3) return {};
  note_area(batch, vertices, facts);
  note_corners(batch, vertices, r, facts);
  return r;
}

Answer exact_answer(const Batch& batch, std::size_t triangle, Facts& facts) {
  const std::vector<Corner> found = corners(batch, triangle, facts);
  if (found.empty()) return {};
  Answer r;
  r.ndc = ndc_polygon(batch, triangle, found, facts);
  if (!batch.is_view()) r.stage = stage_polygon(batch, triangle, found, facts);
  return r;
}

}  // namespace clipscope::attack
