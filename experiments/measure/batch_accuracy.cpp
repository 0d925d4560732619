// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/batch_accuracy.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/measure/nearest_float.hpp"
#include "experiments/measure/screen_distance.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kCoordinates = 4;  // x, y, z, 1/w

// The exact answer, its place on screen and its coordinates as the nearest floats.
struct RoundedTruth {
  TruthPolygon polygon;
  std::vector<ScreenPoint> screen;
  std::vector<std::array<float, kCoordinates>> nearest;
};

RoundedTruth rounded_truth(const reference::Truth& truth, const SceneTriangle& triangle) {
  RoundedTruth r{truth_polygon(truth, reference::input_triangle(triangle)), {}, {}};
  for (std::size_t i = 0; i < r.polygon.exact.vertices.size(); ++i) {
    const std::vector<double>& v = r.polygon.approximation[i];
    r.screen.push_back(screen_point(v[0], v[1]));
    for (auto& numbers = r.nearest.emplace_back(); int c : {0, 1, 2, 3}) {
      numbers[static_cast<std::size_t>(c)] =
          reference::round_to<float>(coordinate(r.polygon.exact.vertices[i], c));
    }
  }
  return r;
}

struct Judgement {
  bool visible = false, wrong = false;
  double error_px = 0;
  int coordinates = 0, correctly_rounded = 0;
};

template <class T>
int correctly_rounded(const std::vector<const NdcVertex<T, kSceneAttributes>*>& vertices,
                      const std::vector<ScreenPoint>& screen, const RoundedTruth& truth) {
  const std::size_t rotation = best_rotation(truth.screen, screen);
  int count = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& v = *vertices[(i + rotation) % vertices.size()];
    for (int c = 0; c < kCoordinates; ++c) {
      const float nearest = truth.nearest[i][static_cast<std::size_t>(c)];
      if (nearest_float(v.position[c]) == nearest) ++count;
    }
  }
  return count;
}

double error_of_wrong(Outcome outcome, const std::vector<ScreenPoint>& answer,
                      const std::vector<ScreenPoint>& truth) {
  switch (outcome) {
    case Outcome::not_finite: return std::numeric_limits<double>::infinity();
    case Outcome::flipped: return std::max(diameter(answer), diameter(truth));
    case Outcome::missing: return diameter(truth);
    case Outcome::extra: return diameter(answer);
    default: return screen_distance(answer, truth);
  }
}

template <class T>
Judgement judge(std::span<const NdcVertex<T, kSceneAttributes>> polygon,
                const RoundedTruth& truth) {
  const Comparison comparison = compare<T, kSceneAttributes>(polygon, truth.polygon);
  if (!comparison.visible) return {};
  const auto vertices = distinct_vertices(polygon);
  std::vector<ScreenPoint> screen;
  for (const auto* v : vertices) screen.push_back(screen_point(*v));

  Judgement r{.visible = true, .wrong = comparison.outcome > Outcome::visible};
  if (r.wrong) {
    r.error_px = error_of_wrong(comparison.outcome, screen, truth.screen);
    const std::size_t expected = truth.polygon.is_visible() ? truth.screen.size() : screen.size();
    r.coordinates = kCoordinates * static_cast<int>(expected);
  } else {
    r.error_px = comparison.position_px;
    r.coordinates = kCoordinates * static_cast<int>(vertices.size());
    r.correctly_rounded = correctly_rounded<T>(vertices, screen, truth);
  }
  return r;
}

void add(const Judgement& judgement, std::size_t batch, std::size_t triangle,
         BatchAccuracy& accuracy) {
  ++accuracy.triangles;
  if (!judgement.visible) return;
  if (accuracy.visible == 0 || judgement.error_px > accuracy.error_px.max()) {
    accuracy.worst_batch = batch;
    accuracy.worst_triangle = triangle;
  }
  ++accuracy.visible;
  accuracy.wrong += judgement.wrong ? 1 : 0;
  accuracy.coordinates += judgement.coordinates;
  accuracy.correctly_rounded += judgement.correctly_rounded;
  accuracy.error_px.add(judgement.error_px);
}

template <class T>
std::vector<Judgement> judge_batch(const Contestant<T>& contestant, const TimedBatch& batch,
                                   std::span<const RoundedTruth> truths) {
  const auto triangles = simplices_cast<T>(batch.triangles);
  PolygonStream<T, kSceneAttributes> polygons;
  contestant.view(projection_of<T>(batch.view), triangles, polygons);
  std::vector<Judgement> judgements(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(),
                    [&](std::size_t i) { judgements[i] = judge<T>(polygons[i], truths[i]); });
  return judgements;
}

double percent(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double BatchAccuracy::correctly_rounded_percent() const {
  return percent(correctly_rounded, coordinates);
}

double BatchAccuracy::wrong_percent() const { return percent(wrong, visible); }

std::vector<BatchAccuracy> judge_batches(std::span<const TimedBatch> batches,
                                         std::span<const AnyContestant> contestants,
                                         Progress& progress) {
  std::vector<BatchAccuracy> results(contestants.size());
  for (std::size_t b = 0; b < batches.size(); ++b) {
    const TimedBatch& batch = batches[b];
    const auto truth = reference::Truth::of_frustum(frustum_cast<double>(batch.view.frustum));
    std::vector<RoundedTruth> truths(batch.triangles.size());
    tbb::parallel_for(std::size_t{0}, truths.size(),
                      [&](std::size_t i) { truths[i] = rounded_truth(truth, batch.triangles[i]); });
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      const auto judgements = std::visit(
          [&](const auto* contestant) { return judge_batch(*contestant, batch, truths); },
          contestants[c]);
      for (std::size_t i = 0; i < judgements.size(); ++i) add(judgements[i], b, i, results[c]);
      progress.advance(batch.triangles.size());
    }
  }
  return results;
}

}  // namespace clipscope::experiments
