// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast the reference is: triangles (BM_value: values) per second on one core, with position and
// four attributes.
// Straddling triangles cross at least one plane and leave something inside.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "reference/exact_clip.hpp"
#include "reference/gold.hpp"

namespace {

using namespace clipscope;
using namespace clipscope::reference;

constexpr int kTriangles = 1024;

InputTriangle random_triangle(std::mt19937& random, double extent) {
  std::uniform_real_distribution<float> side(-10, 10), depth(-12, 2), offset(-extent, extent);
  const std::array<float, 3> centre = {side(random), side(random), depth(random)};
  InputTriangle r;
  r.attribute_count = 4;
  for (InputVertex& v : r.vertices) {
    for (int c = 0; c < 3; ++c) v.position[c] = centre[c] + offset(random);
    for (int k = 0; k < 4; ++k) v.attributes[k] = side(random);
  }
  return r;
}

// Triangles with the verdict wanted, and with something left inside if it is `clipped`.
std::vector<InputTriangle> triangles(const Truth& truth, Verdict wanted) {
  std::mt19937 random(1);
  std::vector<InputTriangle> r;
  while (r.size() < kTriangles) {
    const InputTriangle triangle = random_triangle(random, wanted == Verdict::clipped ? 4 : 0.5);
    if (classify(truth, triangle) == wanted &&
        (wanted == Verdict::rejected || clip(truth, triangle).vertices.size() > 2)) {
      r.push_back(triangle);
    }
  }
  return r;
}

Frustum<double> frustum() {
  Frustum<double> f;
  f.left = f.bottom = -0.1f;
  f.right = f.top = 0.1f;
  f.near = 0.1f;
  f.far = 100;
  return f;
}

template <class Function>
void run(benchmark::State& state, const std::vector<InputTriangle>& input,
         const Function& function) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(function(input[i]));
    i = (i + 1) % input.size();
  }
  state.SetItemsProcessed(state.iterations());
}

void BM_classify(benchmark::State& state, const Truth& truth, Verdict verdict) {
  run(state, triangles(truth, verdict),
      [&](const InputTriangle& triangle) { return classify(truth, triangle); });
}

void BM_clip(benchmark::State& state, const Truth& truth, Verdict verdict) {
  run(state, triangles(truth, verdict),
      [&](const InputTriangle& triangle) { return clip(truth, triangle); });
}

void BM_gold(benchmark::State& state, const Truth& truth, Verdict verdict) {
  run(state, triangles(truth, verdict),
      [](const InputTriangle& triangle) { return gold_of_frustum(frustum(), triangle); });
}

// The way back to floating point, per value: all coordinates and attributes of straddling
// triangles.
template <class Function>
void BM_value(benchmark::State& state, const Truth& truth, const Function& function) {
  std::vector<Fraction> values;
  for (const InputTriangle& triangle : triangles(truth, Verdict::clipped)) {
    for (const ExactVertex& v : clip(truth, triangle).vertices) {
      values.insert(values.end(), {v.x, v.y, v.z, v.inv_w});
      values.insert(values.end(), v.attributes.begin(), v.attributes.end());
    }
  }
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(function(values[i]));
    i = (i + 1) % values.size();
  }
  state.SetItemsProcessed(state.iterations());
}

const Truth kFrustum = Truth::of_frustum(frustum());
const Truth kMatrix = Truth::of_matrix(Projection<float>(frustum_cast<float>(frustum())));

BENCHMARK_CAPTURE(BM_classify, rejected, kFrustum, Verdict::rejected);
BENCHMARK_CAPTURE(BM_classify, accepted, kFrustum, Verdict::accepted);
BENCHMARK_CAPTURE(BM_classify, straddling, kFrustum, Verdict::clipped);
BENCHMARK_CAPTURE(BM_clip, rejected, kFrustum, Verdict::rejected);
BENCHMARK_CAPTURE(BM_clip, accepted, kFrustum, Verdict::accepted);
BENCHMARK_CAPTURE(BM_clip, straddling, kFrustum, Verdict::clipped);
BENCHMARK_CAPTURE(BM_clip, straddling_matrix, kMatrix, Verdict::clipped);
BENCHMARK_CAPTURE(BM_gold, straddling, kFrustum, Verdict::clipped);
BENCHMARK_CAPTURE(BM_value, approximate, kFrustum, approximate);
BENCHMARK_CAPTURE(BM_value, error_of, kFrustum, [](const Fraction& f) { return error_of(1.0, f); });
BENCHMARK_CAPTURE(BM_value, round_to_float, kFrustum,
                  [](const Fraction& f) { return round_to<float>(f); });
BENCHMARK_CAPTURE(BM_value, round_to_double, kFrustum,
                  [](const Fraction& f) { return round_to<double>(f); });

}  // namespace

BENCHMARK_MAIN();
