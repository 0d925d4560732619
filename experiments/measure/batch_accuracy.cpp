// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/batch_accuracy.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/measure/nearest_float.hpp"
#include "experiments/measure/screen_distance.hpp"
#include "experiments/measure/stage_check.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kCoordinates = 4;  // x, y, z, 1/w; in the stage x, y, z, w

using KeptNumbers = std::array<float, kCoordinates>;  // of a vertex, in a vertex buffer

// The exact answer, its place on screen and its coordinates as the nearest floats.
struct RoundedTruth {
  TruthPolygon polygon;
  std::vector<ScreenPoint> screen;
  std::vector<KeptNumbers> nearest;
  bool has_no_area = false;  // then nothing is visible, whatever is drawn of it
};

// nearest(v): the nearest floats to the coordinates of an exact vertex.
template <class Nearest>
RoundedTruth rounded_truth(const reference::Truth& truth, const reference::InputTriangle& triangle,
                           const Nearest& nearest) {
  RoundedTruth r{truth_polygon(truth, triangle), {}, {}, false};
  for (std::size_t i = 0; i < r.polygon.exact.vertices.size(); ++i) {
    const std::vector<double>& v = r.polygon.approximation[i];
    r.screen.push_back(screen_point(v[0], v[1]));
    r.nearest.push_back(nearest(r.polygon.exact.vertices[i]));
  }
  return r;
}

KeptNumbers nearest_in_ndc(const reference::ExactVertex& v) {
  KeptNumbers numbers;
  for (int c = 0; c < kCoordinates; ++c) {
    numbers[static_cast<std::size_t>(c)] = reference::round_to<float>(coordinate(v, c));
  }
  return numbers;
}

struct Judgement {
  bool visible = false, wrong = false;
  double error_px = 0;
  int coordinates = 0, correctly_rounded = 0;
};

// The numbers of each vertex, but for one that has those of the vertex before it.
std::vector<KeptNumbers> without_repeated(std::vector<KeptNumbers> cycle) {
  cycle.erase(std::unique(cycle.begin(), cycle.end()), cycle.end());
  while (cycle.size() > 1 && cycle.front() == cycle.back()) cycle.pop_back();
  return cycle;
}

// Whether two cycles are the same, whichever of their vertices is first.
bool same_cycle(const std::vector<KeptNumbers>& a, const std::vector<KeptNumbers>& b) {
  if (a.size() != b.size()) return false;
  std::vector<KeptNumbers> turned = b;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (turned == a) return true;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  return a.empty();
}

// Whether the answer, kept as floats, is the exact polygon rounded once. Vertices that are apart may then fall
// together: what no vertex buffer can tell apart is not wrong.
template <class T, class Kept>
bool is_rounded_truth(std::span<const NdcVertex<T, kSceneAttributes>> polygon,
                      const RoundedTruth& truth, const Kept& kept) {
  if (!truth.polygon.is_visible() || polygon.empty()) return false;
  std::vector<KeptNumbers> numbers;
  for (const auto& v : polygon) numbers.push_back(kept(v));
  return same_cycle(without_repeated(std::move(numbers)), without_repeated(truth.nearest));
}

// kept(v): what is left of a vertex of the answer in a vertex buffer.
template <class T, class Kept>
int correctly_rounded(const std::vector<const NdcVertex<T, kSceneAttributes>*>& vertices,
                      const std::vector<ScreenPoint>& screen, const RoundedTruth& truth,
                      const Kept& kept) {
  const std::size_t rotation = best_rotation(truth.screen, screen);
  int count = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const KeptNumbers numbers = kept(*vertices[(i + rotation) % vertices.size()]);
    for (std::size_t c = 0; c < kCoordinates; ++c) {
      if (numbers[c] == truth.nearest[i][c]) ++count;
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

template <class T, class Kept>
Judgement judge(std::span<const NdcVertex<T, kSceneAttributes>> polygon, const RoundedTruth& truth,
                const Kept& kept) {
  const Comparison comparison = compare<T, kSceneAttributes>(polygon, truth.polygon);
  if (!comparison.visible) return {};
  const auto vertices = distinct_vertices(polygon);
  std::vector<ScreenPoint> screen;
  for (const auto* v : vertices) screen.push_back(screen_point(*v));

  Judgement r{.visible = true, .wrong = comparison.outcome > Outcome::visible};
  if (r.wrong && is_rounded_truth<T>(polygon, truth, kept)) {
    r.wrong = false;
    r.error_px = screen_distance(screen, truth.screen);
    r.coordinates = r.correctly_rounded = kCoordinates * static_cast<int>(truth.screen.size());
  } else if (r.wrong) {
    r.error_px = error_of_wrong(comparison.outcome, screen, truth.screen);
    const std::size_t expected = truth.polygon.is_visible() ? truth.screen.size() : screen.size();
    r.coordinates = kCoordinates * static_cast<int>(expected);
  } else {
    r.error_px = comparison.position_px;
    r.coordinates = kCoordinates * static_cast<int>(vertices.size());
    r.correctly_rounded = correctly_rounded<T>(vertices, screen, truth, kept);
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
  const auto kept = [](const NdcVertex<T, kSceneAttributes>& v) {
    return KeptNumbers{nearest_float(v.position[0]), nearest_float(v.position[1]),
                       nearest_float(v.position[2]), nearest_float(v.position[3])};
  };
  std::vector<Judgement> judgements(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(),
                    [&](std::size_t i) { judgements[i] = judge<T>(polygons[i], truths[i], kept); });
  return judgements;
}

// Of each triangle what a renderer would draw: its polygon, or itself if it is listed as inside.
std::vector<std::span<const float>> drawn_polygons(const StageInput& input,
                                                   const StageAnswer& answer) {
  std::vector<std::span<const float>> drawn(input.array_size());
  for (const std::uint32_t t : answer.inside) {
    drawn[t] = {input.vertex(StageContract::copy, t, 0), 3 * input.stride()};
  }
  for (std::size_t i = 0; i < answer.polygons.size(); ++i) {
    drawn[answer.polygons[i].triangle] = answer.polygon(i);
  }
  return drawn;
}

Judgement judge_in_clip_space(std::span<const float> polygon, std::size_t stride,
                              const RoundedTruth& truth) {
  if (truth.has_no_area) return {};
  std::vector<NdcVertex<double, kSceneAttributes>> divided;
  for (std::size_t i = 0; i < polygon.size(); i += stride) {
    const float* v = polygon.data() + i;
    divided.push_back({to_ndc(Vec4<double>(v[0], v[1], v[2], v[3])), {}});
    for (int k = 0; k < kSceneAttributes; ++k) divided.back().attributes[k] = v[4 + k];
  }
  const auto kept = [&](const NdcVertex<double, kSceneAttributes>& v) {
    const float* numbers = polygon.data() + static_cast<std::size_t>(&v - divided.data()) * stride;
    return KeptNumbers{numbers[0], numbers[1], numbers[2], numbers[3]};
  };
  return judge<double>(std::span<const NdcVertex<double, kSceneAttributes>>(divided), truth, kept);
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
    tbb::parallel_for(std::size_t{0}, truths.size(), [&](std::size_t i) {
      truths[i] =
          rounded_truth(truth, reference::input_triangle(batch.triangles[i]), nearest_in_ndc);
    });
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

std::vector<BatchAccuracy> judge_stage(const StageInput& input, const StageContestants& contestants,
                                       Progress& progress) {
  const auto truth = reference::Truth::of_clip(input.volume);
  const std::size_t triangles = input.array_size();
  std::vector<RoundedTruth> truths(triangles);
  tbb::parallel_for(std::size_t{0}, triangles, [&](std::size_t i) {
    const reference::InputTriangle triangle = input_triangle(input, StageContract::copy, i);
    truths[i] = rounded_truth(truth, triangle, nearest_in_clip);
    truths[i].has_no_area = has_no_area(triangle);
  });
  std::vector<BatchAccuracy> results(contestants.size());
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    contestants[c]->clip(input, 0, triangles);
    const StageAnswer answer = contestants[c]->answer();
    const auto drawn = drawn_polygons(input, answer);
    std::vector<Judgement> judgements(triangles);
    tbb::parallel_for(std::size_t{0}, triangles, [&](std::size_t i) {
      judgements[i] = judge_in_clip_space(drawn[i], answer.stride, truths[i]);
    });
    for (std::size_t i = 0; i < triangles; ++i) add(judgements[i], 0, i, results[c]);
    progress.advance(triangles);
  }
  return results;
}

}  // namespace clipscope::experiments
