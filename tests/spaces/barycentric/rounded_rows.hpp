// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons as rows of floats, those of clippers and exact ones rounded once, compared bit by bit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

#include "experiments/catalogue/catalogue.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/barycentric/exact_lines.hpp"
#include "spaces/polygon.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/barycentric/clip_cases.hpp"

namespace clipscope::reference {

using Row = std::array<float, 4 + kAttributes>;  // the position, the attributes
using Rows = std::vector<Row>;

template <Space S>
Rows rows(const Polygon<S, float, kAttributes>& polygon) {
  Rows r;
  for (const auto& v : polygon) {
    Row& row = r.emplace_back();
    for (int c = 0; c < 4; ++c) row[c] = v.position[c];
    for (int k = 0; k < kAttributes; ++k) row[4 + k] = v.attributes[k];
  }
  return r;
}

// No infinite z.
inline Rows rounded(const ExactPolygon& exact) {
  Rows r;
  for (const ExactVertex& v : exact.vertices) {
    Row& row = r.emplace_back(Row{round_to<float>(v.x), round_to<float>(v.y), round_to<float>(v.z),
                                  round_to<float>(v.inv_w)});
    for (int k = 0; k < kAttributes; ++k) row[4 + k] = round_to<float>(v.attributes[k]);
    if (std::isinf(row[2])) return {};
  }
  return r;
}

inline bool same_bits(const Row& a, const Row& b) {
  using Bits = std::array<std::uint32_t, 4 + kAttributes>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

inline bool same_bits(const Rows& a, const Rows& b) {
  return std::ranges::equal(a, b, [](const Row& x, const Row& y) { return same_bits(x, y); });
}

// Whether a polygon has an area in NDC, exactly: three of its vertices are not on a line.
inline bool has_area(const ExactPolygon& polygon) {
  const auto& v = polygon.vertices;
  const auto difference = [](const Fraction& a, const Fraction& b) {
    const Rational r = to_rational(a) - to_rational(b);
    return r;
  };
  for (std::size_t i = 2; i < v.size(); ++i) {
    const std::array<Rational, 3> a = {difference(v[1].x, v[0].x), difference(v[1].y, v[0].y),
                                       difference(v[1].z, v[0].z)};
    const std::array<Rational, 3> b = {difference(v[i].x, v[0].x), difference(v[i].y, v[0].y),
                                       difference(v[i].z, v[0].z)};
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      if (a[c] * b[d] != a[d] * b[c]) return true;
    }
  }
  return false;
}

// Whether it has all rows of `exact` in order, and others at their places alone.
inline bool repeats(const Rows& computed, const Rows& exact) {
  std::size_t found = 0;
  for (const Row& row : computed) {
    const auto at_its_place = [&](const Row& e) {
      return e[0] == row[0] && e[1] == row[1] && e[2] == row[2];
    };
    if (found < exact.size() && same_bits(row, exact[found])) {
      ++found;
    } else if (std::ranges::none_of(exact, at_its_place)) {
      return false;
    }
  }
  return found == exact.size();
}

// Whether a clipper has to yield `computed`: the exact polygon rounded, or, if that has no area,
// one with vertices repeated, or nothing in the place of fewer than three.
inline bool agrees(const Rows& computed, const ExactPolygon& exact) {
  const Rows nearest = rounded(exact);
  if (exact.vertices.size() >= 3 && same_bits(computed, nearest)) return true;
  if (has_area(exact)) return false;
  return repeats(computed, nearest) || (computed.empty() && exact.vertices.size() < 3);
}

// The same polygon, from whichever vertex on.
inline bool same_cycle(const Rows& a, Rows b) {
  if (a.empty() || b.empty()) return a.empty() && b.empty();
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (same_bits(a, b)) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

struct Compared {
  std::int64_t triangles = 0, coordinates = 0;
  barycentric::CountStages stages;
};

// Cases from `make`, what a clipper makes of them and what it has to. Fails at the first that
// differs.
template <class AnyCase>
Compared compare_with_reference(AnyCase (*make)(Random&),
                                Rows (*clipped)(const AnyCase&, barycentric::CountStages&),
                                ExactPolygon (*exact_polygon)(const AnyCase&), int triangles,
                                std::uint64_t seed) {
  Random random(seed);
  Compared r;
  for (; r.triangles < triangles; ++r.triangles) {
    AnyCase c = make(random);
    add_zero(c);
    const Rows computed = clipped(c, r.stages);
    const ExactPolygon exact = exact_polygon(c);
    r.coordinates += static_cast<std::int64_t>(computed.size() * Row{}.size());
    if (!agrees(computed, exact)) {
      FAIL(describe(c) << "has " << computed.size() << " vertices, exactly "
                       << exact.vertices.size());
    }
  }
  return r;
}

// A longer look, each time another one, at sets of cases that have a name and a `make`: prints what
// was compared and which stage settled it.
template <class Sets, class AnyCase>
void compare_at_length(const Sets& sets, Rows (*clipped)(const AnyCase&, barycentric::CountStages&),
                       ExactPolygon (*exact_polygon)(const AnyCase&)) {
  const std::uint64_t seed = std::random_device{}();
  INFO("seed " << seed);
  std::int64_t total = 0;
  for (const auto& set : sets) {
    const Compared r = compare_with_reference(set.make, clipped, exact_polygon, 600000, seed);
    total += r.coordinates;
    std::ostringstream s;
    s << set.name << ": " << r.coordinates << " coordinates; stages";
    for (const std::int64_t n : r.stages.counts) s << ' ' << n;
    WARN(s.str());
  }
  WARN(total << " coordinates");
}

// The polygon is the same one whichever vertex of the triangle is first, and backwards if two
// change places.
template <class AnyCase>
void check_that_no_vertex_is_first(AnyCase c, Rows (*clipped)(const AnyCase&)) {
  const Rows r = clipped(c);
  std::rotate(c.triangle.begin(), c.triangle.begin() + 1, c.triangle.end());
  if (!same_cycle(r, clipped(c))) FAIL(describe(c));
  std::swap(c.triangle[0], c.triangle[1]);
  Rows back = clipped(c);
  std::ranges::reverse(back);
  if (!same_cycle(r, back)) FAIL("back: " << describe(c));
}

// What a hard case of the catalogue holds, in float.
template <class AnyTriangle>
void set_vertices(const experiments::HardCase& hard_case, AnyTriangle& triangle) {
  for (std::size_t i = 0; i < triangle.size(); ++i) {
    const InputVertex& v = hard_case.vertices[i];
    auto& position = triangle[i].position;
    for (int k = 0; k < position.length(); ++k) position[k] = static_cast<float>(v.position[k]);
    for (int k = 0; k < kAttributes; ++k) {
      triangle[i].attributes[k] = static_cast<float>(v.attributes[k]);
    }
  }
}

}  // namespace clipscope::reference
