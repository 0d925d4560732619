// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex polygons and segments for tests of the methods in spaces/window/convex_clippers.hpp, and
// the exact answer.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "spaces/window/convex_clippers.hpp"

namespace clipscope::tests {

template <class T>
using Points = std::vector<Vec2<T>>;

template <class T>
using Answer = std::optional<Segment2<T>>;

// A window that owns its vertices and normals, and its dual subdivision where there is one.
template <class T>
struct OwnedWindow {
  explicit OwnedWindow(Points<T> points) : vertices(std::move(points)), normals(vertices.size()) {
    const ConvexWindow<T> prepared = prepare_window<T>(vertices, normals);
    if constexpr (HasDualSubdivision<T>) {
      dual = std::make_shared<DualSubdivision<T>>(prepared, 8 + vertices.size());
    }
  }
  ConvexWindow<T> window() const { return {vertices, normals, dual.get()}; }

  Points<T> vertices, normals;
  std::shared_ptr<const DualSubdivision<T>> dual;
};

template <class T>
Points<T> points_cast(const Points<experiments::Exact>& points) {
  Points<T> r;
  for (const auto& p : points) {
    r.emplace_back(experiments::scalar_from<T>(experiments::nearest_double(p[0])),
                   experiments::scalar_from<T>(experiments::nearest_double(p[1])));
  }
  return r;
}

// n rational points on a circle of radius 1, flattened to this height: strictly convex.
inline Points<experiments::Exact> on_ellipse(int n, double height) {
  using experiments::Exact;
  Points<Exact> points;
  for (int i = 0; i < n; ++i) {
    const double turn = (i + 0.5) / n;  // of the half circle that the tangent runs through
    const Exact s(static_cast<float>(std::tan(3.14159265 * (turn - 0.5))));
    const Exact square = s * s, all = Exact(1) + square;
    points.emplace_back((Exact(1) - square) / all, Exact(height) * (s + s) / all);
  }
  return points;
}

// A lattice polygon of 2 n vertices that is symmetric about a point: edges in n different
// directions.
inline Points<experiments::Exact> on_lattice(std::size_t n) {
  using experiments::Exact;
  std::vector<std::array<int, 2>> edges;
  for (int size = 1; edges.size() < n; ++size) {
    for (int x = -size; x <= size; ++x) {
      const int y = size - std::abs(x);
      if (std::gcd(x, y) == 1 && (y > 0 || x > 0)) edges.push_back({x, y});
    }
  }
  edges.resize(n);
  std::ranges::sort(edges, [](const auto& a, const auto& b) {
    return a[0] * b[1] - a[1] * b[0] > 0;  // all of them in half a turn
  });
  Points<Exact> points;
  std::array<int, 2> at = {0, 0};
  for (const int sign : {1, -1}) {
    for (const auto& e : edges) {
      points.emplace_back(Exact(at[0]), Exact(at[1]));
      for (std::size_t c = 0; c < 2; ++c) at[c] += sign * e[c];
    }
  }
  return points;
}

// Every edge asked, in the number type given; exact in exact arithmetic.
template <class T>
Answer<T> answer_by_all_edges(const ConvexWindow<T>& window, const Segment2<T>& s) {
  T from(0), to(1);
  for (std::size_t i = 0; i < window.size(); ++i) {
    const T first = window.distance(i, s[0]), second = window.distance(i, s[1]);
    if (first < T(0) && second < T(0)) return std::nullopt;
    if (T(0) <= first && T(0) <= second) continue;
    const T at = first / (first - second);
    if (first < T(0)) {
      from = larger(from, at);
    } else if (at < to) {
      to = at;
    }
  }
  if (!(from < to) || is_same_position(s[0], s[1])) return std::nullopt;
  return Segment2<T>{window.meet(0, s[0], s[1], from), window.meet(0, s[0], s[1], to)};
}

}  // namespace clipscope::tests
