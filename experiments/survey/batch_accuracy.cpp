// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/batch_accuracy.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory>

#include "experiments/judge/compare.hpp"
#include "experiments/judge/cycle.hpp"
#include "experiments/judge/equal_numbers.hpp"
#include "experiments/judge/match.hpp"
#include "experiments/judge/stage_check.hpp"
#include "experiments/survey/judged_once.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kCoordinates = 4;  // x, y, z, 1/w; in the stage x, y, z, w

using KeptNumbers = std::array<float, kCoordinates>;

// The exact answer, its place on screen and its coordinates as the nearest floats.
struct RoundedTruth {
  TruthPolygon polygon;
  std::vector<ScreenPoint> screen;
  std::vector<KeptNumbers> nearest;
  bool has_no_area = false;  // then nothing is visible, whatever is drawn of it
};

// nearest(v): the nearest floats to the coordinates of an exact vertex.
RoundedTruth rounded_truth(const reference::Truth& truth, const reference::InputTriangle& triangle,
                           KeptNumbers (*nearest)(const reference::ExactVertex&)) {
  RoundedTruth r{truth_polygon(truth, triangle), {}, {}, false};
  r.screen = screen_points(r.polygon.approximation);
  for (const reference::ExactVertex& v : r.polygon.exact.vertices) r.nearest.push_back(nearest(v));
  return r;
}

// number(c): coordinate c.
template <class Number>
KeptNumbers kept_numbers(const Number& number) {
  return {number(0), number(1), number(2), number(3)};
}

KeptNumbers nearest_in_ndc(const reference::ExactVertex& v) {
  return kept_numbers([&](int c) { return reference::round_to<float>(coordinate(v, c)); });
}

struct Judgement {
  bool visible = false, wrong = false;
  double error_px = 0;
  std::size_t coordinates = 0, correctly_rounded = 0;
};

// What is left of a vertex in a vertex buffer.
using Kept = std::function<KeptNumbers(const VertexView&)>;

// Whether the answer, kept as floats, is the exact polygon rounded once. Vertices that are apart
// may then fall together: what no vertex buffer can tell apart is not wrong.
bool is_rounded_truth(const PolygonView& polygon, const RoundedTruth& truth, const Kept& kept) {
  if (!truth.polygon.is_visible() || polygon.empty()) return false;
  std::vector<KeptNumbers> numbers;
  for (const VertexView& v : polygon) numbers.push_back(kept(v));
  constexpr Likeness kValue = Likeness::by_value;
  return same_cycle(without_repeats(numbers, kValue), without_repeats(truth.nearest, kValue),
                    kValue);
}

std::size_t correctly_rounded(const std::vector<VertexView>& vertices, const RoundedTruth& truth,
                              const Kept& kept) {
  std::vector<KeptNumbers> numbers;
  for (const VertexView& v : vertices) numbers.push_back(kept(v));
  return equal_numbers(truth.nearest, numbers, most_equal_rotation(truth.nearest, numbers));
}

double error_of_wrong(Outcome outcome, const std::vector<ScreenPoint>& answer,
                      const std::vector<ScreenPoint>& truth) {
  switch (outcome) {
    case Outcome::not_finite:
    case Outcome::crashed:
    case Outcome::timed_out:
    case Outcome::malformed: return std::numeric_limits<double>::infinity();
    case Outcome::flipped: return std::max(diameter(answer), diameter(truth));
    case Outcome::missing: return diameter(truth);
    case Outcome::extra: return diameter(answer);
    default: return screen_distance(answer, truth);
  }
}

Judgement judge(const PolygonView& polygon, const RoundedTruth& truth, const Kept& kept) {
  const Comparison comparison = compare(polygon, truth.polygon);
  if (!comparison.visible) return {};
  const std::vector<ScreenPoint> screen = screen_points(distinct_vertices(polygon));
  Judgement r{.visible = true, .wrong = comparison.outcome > Outcome::visible};
  if (r.wrong && is_rounded_truth(polygon, truth, kept)) {
    r.wrong = false;
    r.error_px = screen_distance(screen, truth.screen);
    r.coordinates = r.correctly_rounded = kCoordinates * truth.screen.size();
  } else if (r.wrong) {
    r.error_px = error_of_wrong(comparison.outcome, screen, truth.screen);
    const std::size_t expected = truth.polygon.is_visible() ? truth.screen.size() : screen.size();
    r.coordinates = kCoordinates * expected;
  } else {
    r.error_px = comparison.position_px;
    r.coordinates = kCoordinates * truth.screen.size();
    r.correctly_rounded =
        correctly_rounded(matched_vertices(polygon, truth.polygon).value(), truth, kept);
  }
  return r;
}

void add(const Judgement& judgement, std::size_t view, std::size_t triangle,
         BatchAccuracy& accuracy) {
  ++accuracy.triangles;
  if (!judgement.visible) return;
  if (accuracy.visible == 0 || judgement.error_px > accuracy.error_px.max()) {
    accuracy.worst_view = view;
    accuracy.worst_triangle = triangle;
  }
  ++accuracy.visible;
  accuracy.wrong += judgement.wrong ? 1 : 0;
  accuracy.coordinates += static_cast<std::int64_t>(judgement.coordinates);
  accuracy.correctly_rounded += static_cast<std::int64_t>(judgement.correctly_rounded);
  accuracy.error_px.add(judgement.error_px);
}

// judge_one(i, c): the judgement of triangle i as contestant c answers it.
template <class JudgeOne>
void judge_all(std::size_t view, const std::vector<Answers>& answers,
               std::span<BatchAccuracy> results, const JudgeOne& judge_one) {
  const std::size_t triangles = answers.empty() ? 0 : answers.front().size();
  std::vector<std::vector<Judgement>> judgements(triangles);
  tbb::parallel_for(std::size_t{0}, triangles, [&](std::size_t i) {
    JudgedOnce<Judgement> judged;
    for (std::size_t c = 0; c < answers.size(); ++c) {
      judgements[i].push_back(judged.of(answers[c][i], [&] { return judge_one(i, c); }));
    }
  });
  for (std::size_t i = 0; i < triangles; ++i) {
    for (std::size_t c = 0; c < answers.size(); ++c) add(judgements[i][c], view, i, results[c]);
  }
}

Judgement judge_in_clip_space(const PolygonView& polygon, const RoundedTruth& truth) {
  if (truth.has_no_area) return {};
  const Answers ndc = divided(polygon);
  return judge(ndc[0], truth, [&](const VertexView& v) {
    const VertexView clip = polygon[v.index()];
    return kept_numbers([&](std::size_t c) { return static_cast<float>(clip[c].value); });
  });
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

std::vector<BatchAccuracy> judge_batches(std::span<const SampledView> views,
                                         const Contestants& contestants, Progress& progress) {
  std::vector<BatchAccuracy> results(contestants.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    const auto& [view, triangles, numbers] = views[v];
    const reference::Truth truth = truth_of(view);
    std::vector<RoundedTruth> truths(triangles.size());
    tbb::parallel_for(std::size_t{0}, truths.size(), [&](std::size_t i) {
      truths[i] =
          rounded_truth(truth, reference::input_triangle(views[v].triangles[i]), nearest_in_ndc);
    });
    const std::vector<Answers> answers = answers_of(contestants, batch_of(view, triangles));
    judge_all(v, answers, results, [&](std::size_t i, std::size_t c) {
      const Format& format = answers[c].format();
      return judge(answers[c][i], truths[i], [&](const VertexView& vertex) {
        return kept_numbers([&](std::size_t k) { return nearest_float(vertex[k], format); });
      });
    });
    progress.advance(triangles.size() * contestants.size());
  }
  return results;
}

std::vector<BatchAccuracy> judge_stage(const StageInput& input, const Contestants& contestants,
                                       Progress& progress) {
  const auto truth = reference::Truth::of_clip(input.volume);
  const std::size_t triangles = input.array_size();
  std::vector<RoundedTruth> truths(triangles);
  tbb::parallel_for(std::size_t{0}, triangles, [&](std::size_t i) {
    const reference::InputTriangle triangle = input_triangle(input, Contract::copy, i);
    truths[i] = rounded_truth(truth, triangle, nearest_in_clip);
    truths[i].has_no_area = has_no_area(triangle);
  });
  std::vector<BatchAccuracy> results(contestants.size());
  std::vector<Answers> answers;
  for (const Contestant* contestant : contestants) {
    const std::unique_ptr<Runner> runner = contestant->prepare_stage(input);
    runner->clip(0, 0, triangles);
    answers.push_back(runner->answers());
  }
  judge_all(0, answers, results, [&](std::size_t i, std::size_t c) {
    return judge_in_clip_space(answers[c][i], truths[i]);
  });
  progress.advance(triangles * contestants.size());
  return results;
}

}  // namespace clipscope::experiments
