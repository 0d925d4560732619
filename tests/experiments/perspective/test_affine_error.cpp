// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error of affine interpolation: closed form, bound, search.
#include <cmath>

#include "experiments/contestants/scalars.hpp"
#include "experiments/perspective/affine_error.hpp"
#include "experiments/perspective/measure.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::perspective {
namespace {

Exact ratio(int numerator, int denominator) { return Exact(numerator) / Exact(denominator); }

Exact magnitude(const Exact& x) { return x < Exact(0) ? Exact(-x) : x; }

// Corners whose w are the squares of the roots.
std::array<AffineCorner<Exact>, 3> corners_of(const std::array<int, 3>& roots,
                                              const std::array<int, 3>& attributes) {
  std::array<AffineCorner<Exact>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = {Exact(roots[i] * roots[i]), Exact(attributes[i])};
  }
  return corners;
}

// |a1 - a0| b(w1 / w0) of the edge that lies opposite of a corner.
Exact edge_error(const std::array<int, 3>& roots, const std::array<int, 3>& attributes,
                 std::size_t corner) {
  const std::size_t a = (corner + 1) % 3, b = (corner + 2) % 3;
  return ratio(std::abs(attributes[b] - attributes[a]) * std::abs(roots[b] - roots[a]),
               roots[a] + roots[b]);
}

// The largest error on a lattice of points strictly inside.
Exact largest_inside(const std::array<AffineCorner<Exact>, 3>& corners, int steps) {
  Exact largest(0);
  for (int i = 1; i < steps; ++i) {
    for (int j = 1; i + j < steps; ++j) {
      const Exact error =
          magnitude(affine_error_at(corners, {Exact(i), Exact(j), Exact(steps - i - j)}));
      if (largest < error) largest = error;
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("affine error: from w = 1 to w = 4 two thirds of the screen are one third of the edge") {
  CHECK(edge_parameter(ratio(2, 3), Exact(1), Exact(4)) == ratio(1, 3));
  CHECK(affine_bound_of_root(Exact(2)) == ratio(1, 3));
  CHECK(affine_bound(1, 4) == Approx(1.0 / 3));
  CHECK(affine_bound(4, 1) == affine_bound(1, 4));
  CHECK(affine_bound(7, 7) == 0);
}

TEST_CASE("affine error: the bound is attained to the bit and passed nowhere") {
  const double root = GENERATE(1.0, 1 + 0x1p-14, 1.25, 2.0, 7.0, 100.0);
  const RatioRow row = search_edges(root, {.edge_steps = 64, .triangles = 200, .seed = 3});
  CAPTURE(root);
  CHECK(row.attained);
  CHECK(row.beyond == 0);
  CHECK(row.points == 2 * 65 + 200);
  CHECK(row.ratio == root * root);
  CHECK(row.on_edges <= row.bound);
  CHECK(row.inside <= row.bound);
  CHECK(row.inside >= 0.9 * row.bound);
}

TEST_CASE("affine error: a bound that is the slightest bit smaller is passed") {
  const Exact smaller = affine_bound_of_root(Exact(2 - 0x1p-40));
  CHECK(smaller < ratio(2, 3) - edge_parameter(ratio(2, 3), Exact(1), Exact(4)));
}

TEST_CASE("affine error: inside a triangle it is no larger than on the worst edge") {
  const std::array<int, 3> roots = GENERATE(std::array{1, 2, 3}, std::array{5, 1, 1},
                                            std::array{7, 4, 10}, std::array{1, 30, 2});
  const std::array<int, 3> attributes =
      GENERATE(std::array{0, 1, 2}, std::array{4, 0, 1}, std::array{-3, 5, -3});
  const Exact inside = largest_inside(corners_of(roots, attributes), 24);
  std::array<Exact, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) edges[i] = edge_error(roots, attributes, i);
  const Exact worst = std::max({edges[0], edges[1], edges[2]});
  CHECK(inside <= worst);
  CHECK(Exact(0) < inside);
}

TEST_CASE("affine error: without the worst edge the others do not bound a triangle") {
  const std::array<int, 3> roots = {1, 10, 5}, attributes = {0, 1, 0};
  const Exact inside = largest_inside(corners_of(roots, attributes), 24);
  CHECK(edge_error(roots, attributes, 0) < inside);
  CHECK(edge_error(roots, attributes, 1) < inside);
}

TEST_CASE("affine error: a search without the closed form finds the ratio that it gives") {
  const double error = GENERATE(0.5, 1.0 / 510, 1.0 / 8192, 1.0 / (510 * 4096));
  const double expected = ratio_at_error(error);
  CHECK(std::abs(measured_ratio_at_error(error) - expected) <= 1e-12 * expected);
}

TEST_CASE("affine error: at its ratio an error is the largest, to the bit") {
  const int denominator = GENERATE(2, 3, 512, 510 * 4096);
  CHECK(is_error_at_its_ratio(1, denominator));
  CHECK(ratio_at_error(Exact(0)) == Exact(1));
  CHECK(ratio_at_error(ratio(1, 3)) == Exact(4));
}

}  // namespace clipscope::experiments::perspective
