// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/edge_search.hpp"

#include "experiments/contestants/scalars.hpp"
#include "experiments/perspective/affine_error.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kWeightSteps = 1024;

Exact magnitude(const Exact& x) { return x < Exact(0) ? Exact(-x) : x; }

// Notes an error in shares of the attribute's range.
void note(const Exact& error, const Exact& bound, EdgeSearch& result, double& largest) {
  const Exact size = magnitude(error);
  ++result.points;
  if (bound < size) ++result.beyond;
  largest = std::max(largest, nearest_double(size));
}

void search_edge(const Exact& ratio, const Exact& bound, int steps, EdgeSearch& result) {
  for (int i = 0; i <= steps; ++i) {
    const Exact s = Exact(i) / Exact(steps);
    note(edge_parameter(s, Exact(1), ratio) - s, bound, result, result.on_edges);
    note(edge_parameter(s, ratio, Exact(1)) - s, bound, result, result.on_edges);
  }
}

// A multiple of 1/1024 in [lo, hi].
Exact between(Random& random, double lo, double hi) {
  return Exact(lo) + Exact(std::floor(random.uniform() * kWeightSteps) / kWeightSteps) *
                         (Exact(hi) - Exact(lo));
}

// A triangle with this ratio of w and an attribute that goes from 0 to 1, seen at a point inside. Half of
// the points lie near the edge on which the error is largest, close to its worst point.
void search_triangle(double ratio, double root, const Exact& bound, Random& random,
                     EdgeSearch& result) {
  const std::array<AffineCorner<Exact>, 3> corners = {
      {{Exact(1), Exact(0)},
       {Exact(ratio), Exact(1)},
       {between(random, 1, ratio), between(random, 0, 1)}}};
  std::array<Exact, 3> weights;
  for (Exact& weight : weights) {
    weight = between(random, 1, kWeightSteps);
  }
  if (random.chance(0.5)) weights = {Exact(1), Exact(root), Exact(random.uniform() * 0.01 + 1e-6)};
  note(affine_error_at(corners, weights), bound, result, result.inside);
}

// The largest |t(s) - s| of an edge from w = 1 to w = ratio, by golden-section search: the error has one
// maximum in between and none at the ends.
double largest_error(double ratio) {
  const auto error = [ratio](double s) { return s - edge_parameter(s, 1.0, ratio); };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double lo = 0, hi = 1;
  for (int i = 0; i < 60; ++i) {
    const double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    if (error(a) < error(b)) {
      lo = a;
    } else {
      hi = b;
    }
  }
  return error((lo + hi) / 2);
}

}  // namespace

EdgeSearch search_edges(double root, const EdgeSearchOptions& options) {
  const Exact ratio = Exact(root) * Exact(root);
  const Exact bound = affine_bound_of_root(Exact(root));
  EdgeSearch result{.ratio = nearest_double(ratio), .bound = nearest_double(bound)};
  search_edge(ratio, bound, options.edge_steps, result);
  const Exact worst = Exact(root) / (Exact(1) + Exact(root));
  const Exact error = worst - edge_parameter(worst, Exact(1), ratio);
  result.attained = error == bound;
  Random random(options.seed);
  for (int i = 0; i < options.triangles; ++i) {
    search_triangle(result.ratio, root, bound, random, result);
  }
  return result;
}

bool is_error_at_its_ratio(int numerator, int denominator) {
  const Exact error = Exact(numerator) / Exact(denominator);
  const Exact ratio = ratio_at_error(error);
  const Exact root = (Exact(1) + error) / (Exact(1) - error);
  const Exact worst = root / (Exact(1) + root);
  return worst - edge_parameter(worst, Exact(1), ratio) == error;
}

// Rounding: t(s) and the error are off by at most some 4 units of 2^-53. The ratio changes with the error
// by the factor root (root + 1)^2, below 8000 for errors below 0.9 (root < 19): 4e-12 where r is 361, and
// 2e-15 near r = 1.
double measured_ratio_at_error(double error) {
  double lo = 1, hi = 1000;
  for (int i = 0; i < 100; ++i) {
    const double middle = (lo + hi) / 2;
    if (largest_error(middle) < error) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return hi;
}

}  // namespace clipscope::experiments
