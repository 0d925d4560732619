// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random input for exact counting: coordinates on coarse lattices, so that vertices fall on planes,
// on each other and on w = 0 as often as between them.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/scenes/random.hpp"
#include "reference/truth.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments::claims {

// A multiple of `step` in [-limit, limit].
inline double on_lattice(Random& random, double limit, double step) {
  const auto cells = static_cast<std::uint64_t>(2 * limit / step);
  return static_cast<double>(random.below(cells + 1)) * step - limit;
}

// Perspective, off-centre or parallel, with small numbers; depth [-1, 1].
inline Frustum<double> random_frustum(Random& random) {
  Frustum<double> f{.near = 1, .far = 8};
  switch (random.below(3)) {
    case 0: break;
    case 1: f.right = 2, f.bottom = -0.5; break;
    default: f.kind = ProjectionKind::parallel; f.left = f.bottom = -4, f.right = f.top = 4;
  }
  return f;
}

// Around those frusta: |x|, |y| <= 8, -12 <= z <= 2, in quarters.
inline reference::InputVertex lattice_view_vertex(Random& random) {
  const double x = on_lattice(random, 8, 0.25), y = on_lattice(random, 8, 0.25);
  const double z = on_lattice(random, 7, 0.25) - 5;
  return {.position = {x, y, z, 1}};
}

inline reference::InputTriangle lattice_view_triangle(Random& random) {
  reference::InputTriangle t;
  for (reference::InputVertex& v : t.vertices) v = lattice_view_vertex(random);
  return t;
}

// |x|, |y|, |z|, |w| <= 3, in halves: w of both signs and 0.
inline reference::InputTriangle lattice_clip_triangle(Random& random) {
  reference::InputTriangle t;
  for (reference::InputVertex& v : t.vertices) {
    for (double& c : v.position) c = on_lattice(random, 3, 0.5);
  }
  return t;
}

// Vertex 0 is outside of exactly one plane of the volume, vertices 1 and 2 are inside of all; w =
// 1, 2 or 3.
inline reference::InputTriangle one_vertex_outside(Random& random) {
  reference::InputTriangle t;
  for (reference::InputVertex& v : t.vertices) {
    const double w = 1 + static_cast<double>(random.below(3));
    for (std::size_t c = 0; c < 3; ++c) v.position[c] = on_lattice(random, w, 0.25);
    v.position[3] = w;
  }
  auto& outside = t.vertices[0].position;
  outside[random.below(3)] = random.sign() * (outside[3] + 0.25 + on_lattice(random, 2, 0.25) + 2);
  return t;
}

// The coordinate in which a vertex is outside. Pre-condition: it is, in one.
inline int outside_axis(const reference::InputVertex& v) {
  for (int c = 0; c < 2; ++c) {
    if (std::abs(v.position[static_cast<std::size_t>(c)]) > v.position[3]) return c;
  }
  return 2;
}

// Near the plane x + y + z = 0, which cuts the volume in a hexagon: of a size such that each edge
// cuts off a corner of the hexagon if the random shifts are small.
inline reference::InputTriangle hexagon_cutter(Random& random) {
  // Corners of a triangle around the hexagon with the corners (1, -1, 0), (1, 0, -1), ...: its
  // edges are 1.3 from the centre, between the hexagon's inscribed and circumscribed circles.
  constexpr double kCorner = 1.84;
  reference::InputTriangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    auto& p = t.vertices[i].position;
    p[i] = -kCorner;
    p[(i + 1) % 3] = kCorner;
    for (std::size_t c = 0; c < 3; ++c) p[c] += on_lattice(random, 0.25, 0.03125);
    const double w = 1 + static_cast<double>(random.below(2));
    for (std::size_t c = 0; c < 3; ++c) p[c] *= w;
    p[3] = w;
  }
  return t;
}

// 3 to 8 vertices on a circle in a random plane, about as large as the volume; w > 0 varies over
// it.
inline std::vector<ClipVertex<Exact, 0>> convex_clip_polygon(Random& random) {
  // Two directions and a centre in clip space; on the circle centre + cos u + sin v of radius 1.
  std::array<std::array<Exact, 4>, 3> frame;
  for (auto& direction : frame) {
    for (Exact& c : direction) c = Exact(on_lattice(random, 2, 0.25));
  }
  // w > 0: that of the centre exceeds what the directions can take away.
  frame[0][3] = Exact(9);
  const std::uint64_t n = 3 + random.below(6);
  std::vector<ClipVertex<Exact, 0>> polygon(n);
  for (std::uint64_t i = 0; i < n; ++i) {
    // Half-angle tangents in increasing order: around the circle once, at rational points.
    const Exact t = (static_cast<double>(i) - static_cast<double>(n) / 2) * 0.75 +
                    0.0625 * static_cast<double>(random.below(8));
    const Exact scale = 1 + t * t, cosine = (1 - t * t) / scale, sine = 2 * t / scale;
    for (std::size_t c = 0; c < 4; ++c) {
      const Exact value = frame[0][c] + 2 * (cosine * frame[1][c] + sine * frame[2][c]);
      polygon[i].position[static_cast<int>(c)] = value;
    }
  }
  return polygon;
}

// A star of 4 to 7 points about a random centre, in the plane z = 0.
inline std::vector<std::array<double, 3>> star_polygon(Random& random) {
  const std::uint64_t points = 4 + random.below(4);
  const double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5);
  const double turn = random.uniform(0, 1), outer = random.uniform(1, 2.5);
  std::vector<std::array<double, 3>> star;
  for (std::uint64_t i = 0; i < 2 * points; ++i) {
    const double angle = 2 * M_PI * (turn + static_cast<double>(i) / (2.0 * points));
    const double radius = i % 2 == 0 ? outer : outer / 8;
    star.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), 0});
  }
  return star;
}

}  // namespace clipscope::experiments::claims
