// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/measure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/contestants/scalars.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/perspective/affine_error.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/survey/sweep.hpp"

namespace clipscope::experiments::perspective {
namespace {

constexpr int kWeightSteps = 1024;
constexpr std::array kTextureSizes = {256, 1024, 4096};  // texels along an edge
constexpr int kLevels = 255;                             // steps between black and white in 8 bits
constexpr int kHalvings = 2;
constexpr float kNearest = 2;  // w of the nearest vertex, twice that of the near plane

// Notes an error in shares of the attribute's range.
void note(const Exact& error, const Exact& bound, RatioRow& row, double& largest) {
  const Exact size = error < Exact(0) ? Exact(-error) : error;
  ++row.points;
  if (bound < size) ++row.beyond;
  largest = std::max(largest, nearest_double(size));
}

// A multiple of 1/1024 in [lo, hi].
Exact between(Random& random, double lo, double hi) {
  return Exact(lo) + Exact(std::floor(random.uniform() * kWeightSteps) / kWeightSteps) *
                         (Exact(hi) - Exact(lo));
}

// A triangle with this ratio of w and an attribute that goes from 0 to 1, seen at a point inside.
// Half of the points lie near the edge on which the error is largest, close to its worst point.
void search_triangle(double root, const Exact& bound, Random& random, RatioRow& row) {
  const std::array<AffineCorner<Exact>, 3> corners = {
      {{Exact(1), Exact(0)},
       {Exact(row.ratio), Exact(1)},
       {between(random, 1, row.ratio), between(random, 0, 1)}}};
  std::array<Exact, 3> weights;
  for (Exact& weight : weights) weight = between(random, 1, kWeightSteps);
  if (random.chance(0.5)) weights = {Exact(1), Exact(root), Exact(random.uniform() * 0.01 + 1e-6)};
  note(affine_error_at(corners, weights), bound, row, row.inside);
}

// The error of an edge from w = 1 to w = ratio at the point where it should be largest.
// Pre-condition: root^2 is the ratio.
Exact error_at_worst_point(const Exact& root, const Exact& ratio) {
  const Exact worst = root / (Exact(1) + root);
  return worst - edge_parameter(worst, Exact(1), ratio);
}

// The largest |t(s) - s| of an edge from w = 1 to w = ratio, by golden-section search: the error
// has one maximum in between and none at the ends.
double largest_edge_error(double ratio) {
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

// The corners of what is visible of a triangle; none if nothing is.
std::vector<TextureCorner> visible_corners(const reference::Truth& truth,
                                           const SceneTriangle& triangle) {
  const TruthPolygon polygon = truth_polygon(truth, reference::input_triangle(triangle));
  std::vector<TextureCorner> corners;
  if (!polygon.is_visible()) return corners;
  for (const auto& v : polygon.approximation) corners.push_back({1 / v[3], v[4], v[5]});
  return corners;
}

double largest_error(std::span<const TextureCorner> polygon, int halvings) {
  const auto middle = [](const TextureCorner& a, const TextureCorner& b) {
    return TextureCorner{(a.w + b.w) / 2, (a.u + b.u) / 2, (a.v + b.v) / 2};
  };
  double largest = 0;
  for_each_part(polygon, halvings, middle, [&](const std::array<TextureCorner, 3>& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const TextureCorner &a = t[i], &b = t[(i + 1) % 3];
      const double range = std::max(std::abs(b.u - a.u), std::abs(b.v - a.v));
      largest = std::max(largest, range * affine_bound(a.w, b.w));
    }
  });
  return largest;
}

// The w of its vertices go from kNearest to `ratio` times that; each vertex lies up to twice the
// half width of the volume off its axis.
SceneTriangle random_triangle(float ratio, Random& random) {
  const float farthest = kNearest * ratio;
  const auto between = static_cast<float>(random.across_magnitudes(kNearest, farthest));
  std::array<float, 3> w = {kNearest, farthest, between};
  random.shuffle(std::span<float>(w));
  SceneTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    auto& [position, attributes] = triangle[i];
    position[0] = static_cast<float>(random.uniform(-2, 2) * w[i]);
    position[1] = static_cast<float>(random.uniform(-2, 2) * w[i]);
    position[2] = -w[i];
    for (int k = 0; k < kSceneAttributes; ++k) attributes[k] = static_cast<float>(random.uniform());
  }
  return triangle;
}

reference::Truth truth_of_cuts() {
  return reference::Truth::of_frustum(frustum_cast<double>(cut_frustum()));
}

}  // namespace

RatioRow search_edges(double root, const EdgeSearch& search) {
  const Exact ratio = Exact(root) * Exact(root);
  const Exact bound = affine_bound_of_root(Exact(root));
  RatioRow row{.ratio = nearest_double(ratio), .bound = nearest_double(bound)};
  row.attained = error_at_worst_point(Exact(root), ratio) == bound;
  for (int i = 0; i <= search.edge_steps; ++i) {
    const Exact s = Exact(i) / Exact(search.edge_steps);
    note(edge_parameter(s, Exact(1), ratio) - s, bound, row, row.on_edges);
    note(edge_parameter(s, ratio, Exact(1)) - s, bound, row, row.on_edges);
  }
  Random random(search.seed);
  for (int i = 0; i < search.triangles; ++i) search_triangle(root, bound, random, row);
  return row;
}

bool is_error_at_its_ratio(int numerator, int denominator) {
  const Exact error = Exact(numerator) / Exact(denominator);
  const Exact root = (Exact(1) + error) / (Exact(1) - error);
  return error_at_worst_point(root, ratio_at_error(error)) == error;
}

// Rounding: t(s) and the error are off by at most some 4 units of 2^-53. The ratio changes with the
// error by the factor root (root + 1)^2, below 8000 for errors below 0.9 (root < 19): 4e-12 where r
// is 361, and 2e-15 near r = 1.
double measured_ratio_at_error(double error) {
  double lo = 1, hi = 1000;
  for (int i = 0; i < 100; ++i) {
    const double middle = (lo + hi) / 2;
    (largest_edge_error(middle) < error ? lo : hi) = middle;
  }
  return hi;
}

std::vector<ThresholdRow> threshold_rows() {
  std::vector<ThresholdRow> rows;
  const auto add = [&](const char* criterion, int texels, int denominator) {
    const double error = 1.0 / denominator, ratio = ratio_at_error(error);
    rows.push_back({criterion, texels, error, ratio, measured_ratio_at_error(error) - 1,
                    is_error_at_its_ratio(1, denominator)});
  };
  for (const int texels : kTextureSizes) add("half a texel", texels, 2 * texels);
  for (const int texels : kTextureSizes) add("half a level, ramp", texels, 2 * kLevels);
  for (const int texels : kTextureSizes) {
    add("half a level, checkerboard", texels, 2 * kLevels * texels);
  }
  return rows;
}

PolygonNeed need_of(std::span<const TextureCorner> polygon) {
  const auto [low, high] = std::ranges::minmax_element(polygon, {}, &TextureCorner::w);
  return {high->w / low->w, largest_error(polygon, 0), largest_error(polygon, kHalvings)};
}

std::vector<PolygonNeed> scene_needs(const Scene& scene, std::size_t triangles_per_view,
                                     Progress& progress) {
  std::vector<PolygonNeed> needs;
  for (const View& view : scene.views) {
    const auto truth = reference::Truth::of_frustum(frustum_cast<double>(view.frustum));
    const auto add_chunk = [&](std::span<const SceneTriangle> triangles, std::size_t) {
      std::vector<std::vector<TextureCorner>> polygons(triangles.size());
      tbb::parallel_for(std::size_t{0}, triangles.size(),
                        [&](std::size_t i) { polygons[i] = visible_corners(truth, triangles[i]); });
      for (const auto& polygon : polygons) {
        if (!polygon.empty()) needs.push_back(need_of(polygon));
      }
      progress.advance(triangles.size());
    };
    for_each_chunk(scene, view, spacing_of(scene, triangles_per_view), add_chunk);
  }
  return needs;
}

SceneRow scene_row(const std::string& scene, const std::vector<PolygonNeed>& needs) {
  const auto count = static_cast<double>(needs.size());
  std::vector<double> ratios;
  for (const PolygonNeed& need : needs) ratios.push_back(need.ratio);
  std::ranges::sort(ratios);
  const auto quantile = [&](double q) { return ratios[static_cast<std::size_t>(q * (count - 1))]; };
  const auto percent_off = [&](int texels, double PolygonNeed::*error) {
    const auto is_off = [&](const PolygonNeed& need) { return need.*error > 0.5 / texels; };
    return 100.0 * static_cast<double>(std::ranges::count_if(needs, is_off)) / count;
  };
  SceneRow row{scene, std::ssize(needs), quantile(0.5), quantile(0.99), ratios.back()};
  row.above_256 = percent_off(256, &PolygonNeed::error);
  row.above_1024 = percent_off(1024, &PolygonNeed::error);
  row.above_4096 = percent_off(4096, &PolygonNeed::error);
  row.split_above_1024 = percent_off(1024, &PolygonNeed::error_split);
  return row;
}

Frustum<float> cut_frustum() {
  return {.left = -1, .right = 1, .bottom = -1, .top = 1, .near = 1, .far = 131072};
}

std::vector<SceneTriangle> cut_triangles(float ratio, std::size_t count, std::uint64_t seed) {
  const reference::Truth truth = truth_of_cuts();
  Random random(seed);
  std::vector<SceneTriangle> triangles;
  while (triangles.size() < count) {
    const SceneTriangle triangle = random_triangle(ratio, random);
    const auto exact = reference::clip(truth, reference::input_triangle(triangle));
    if (exact.verdict == reference::Verdict::clipped && exact.vertices.size() >= 3) {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

CutRow measure_cut(const Contestant& contestant, float ratio,
                   const std::vector<SceneTriangle>& triangles) {
  const reference::Truth truth = truth_of_cuts();
  const SweepChunk chunk{cut_frustum(), {}, triangles, {}};
  const Answers answers = clip(contestant, chunk.batch());
  std::vector<Comparison> comparisons(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
    comparisons[i] =
        compare(answers[i], truth_polygon(truth, reference::input_triangle(triangles[i])));
  });
  CutRow row{ratio, std::string(contestant.clipper), std::string(contestant.scalar())};
  row.bound = affine_bound(ratio, 1);
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    if (comparisons[i].outcome > Outcome::visible) continue;
    ++row.triangles;
    if (!(comparisons[i].attribute > row.max_error)) continue;
    row.max_error = comparisons[i].attribute;
    row.worst = replay_text(chunk, i);
  }
  return row;
}

}  // namespace clipscope::experiments::perspective
