// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/random_cases.hpp"

#include <cmath>

namespace clipscope::experiments {

using reference::InputTriangle;
using reference::InputVertex;

namespace {

// A multiple of `step` in [-limit, limit].
double on_lattice(Random& random, double limit, double step) {
  const auto cells = static_cast<std::uint64_t>(2 * limit / step);
  return static_cast<double>(random.below(cells + 1)) * step - limit;
}

template <Space S>
Triangle<S, Exact, kRunTime> exact_triangle(const InputTriangle& triangle) {
  Triangle<S, Exact, kRunTime> r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < Vertex<S, Exact, kRunTime>::kDimension; ++c) {
      r[i].position[c] = Exact(triangle.vertices[i].position[static_cast<std::size_t>(c)]);
    }
    r[i].attributes.resize(triangle.attribute_count);
    for (int k = 0; k < triangle.attribute_count; ++k) {
      r[i].attributes[k] = Exact(triangle.vertices[i].attributes[static_cast<std::size_t>(k)]);
    }
  }
  return r;
}

// The point of the unit circle at half-angle tangent t; rational.
std::array<Exact, 2> on_circle(const Exact& t) {
  const Exact scale = 1 + t * t;
  return {Exact((1 - t * t) / scale), Exact(2 * t / scale)};
}

}  // namespace

Frustum<double> random_frustum(Random& random) {
  Frustum<double> f{.near = 1, .far = 8};
  switch (random.below(3)) {
    case 0: break;
    case 1: f.right = 2, f.bottom = -0.5; break;
    default: f.kind = ProjectionKind::parallel; f.left = f.bottom = -4, f.right = f.top = 4;
  }
  return f;
}

InputVertex lattice_view_vertex(Random& random) {
  const double x = on_lattice(random, 8, 0.25), y = on_lattice(random, 8, 0.25);
  const double z = on_lattice(random, 7, 0.25) - 5;
  return {.position = {x, y, z, 1}};
}

InputTriangle lattice_view_triangle(Random& random) {
  InputTriangle t;
  for (InputVertex& v : t.vertices) v = lattice_view_vertex(random);
  return t;
}

InputTriangle lattice_clip_triangle(Random& random) {
  InputTriangle t;
  for (InputVertex& v : t.vertices) {
    for (double& c : v.position) c = on_lattice(random, 3, 0.5);
  }
  return t;
}

InputTriangle one_vertex_outside(Random& random) {
  InputTriangle t;
  for (InputVertex& v : t.vertices) {
    const double w = 1 + static_cast<double>(random.below(3));
    for (std::size_t c = 0; c < 3; ++c) v.position[c] = on_lattice(random, w, 0.25);
    v.position[3] = w;
  }
  auto& outside = t.vertices[0].position;
  outside[random.below(3)] = random.sign() * (outside[3] + 0.25 + on_lattice(random, 2, 0.25) + 2);
  return t;
}

int outside_axis(const InputVertex& v) {
  for (int c = 0; c < 2; ++c) {
    if (std::abs(v.position[static_cast<std::size_t>(c)]) > v.position[3]) return c;
  }
  return 2;
}

InputTriangle hexagon_cutter(Random& random) {
  // Corners of a triangle around the hexagon with the corners (1, -1, 0), (1, 0, -1), ...: its edges are
  // 1.3 from the centre, between the hexagon's inscribed and circumscribed circles.
  constexpr double kCorner = 1.84;
  InputTriangle t;
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

std::vector<ClipVertex<Exact, 0>> convex_clip_polygon(Random& random) {
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
    // Half-angle tangents in increasing order: around the circle once.
    const double t = (static_cast<double>(i) - static_cast<double>(n) / 2) * 0.75 +
                     0.0625 * static_cast<double>(random.below(8));
    const auto [cosine, sine] = on_circle(Exact(t));
    for (std::size_t c = 0; c < 4; ++c) {
      const Exact value = frame[0][c] + 2 * (cosine * frame[1][c] + sine * frame[2][c]);
      polygon[i].position[static_cast<int>(c)] = value;
    }
  }
  return polygon;
}

std::vector<std::array<double, 3>> star_polygon(Random& random) {
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

Frustum<Exact> exact_frustum(const Frustum<double>& frustum) {
  return frustum_cast<Exact>(frustum);
}

ViewSegment<Exact, 1> exact_view_segment(const std::array<InputVertex, 2>& segment) {
  ViewSegment<Exact, 1> r;
  for (std::size_t i = 0; i < 2; ++i) {
    for (int c = 0; c < 3; ++c) {
      r[i].position[c] = Exact(segment[i].position[static_cast<std::size_t>(c)]);
    }
    r[i].attributes[0] = Exact(segment[i].attributes[0]);
  }
  return r;
}

ViewTriangle<Exact, kRunTime> exact_view_triangle(const InputTriangle& triangle) {
  return exact_triangle<Space::view>(triangle);
}

ClipTriangle<Exact, kRunTime> exact_clip_triangle(const InputTriangle& triangle) {
  return exact_triangle<Space::clip>(triangle);
}

}  // namespace clipscope::experiments
