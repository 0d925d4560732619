// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/timing.hpp"

#include <algorithm>
#include <memory>
#include <random>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/promise.hpp"
#include "experiments/measure/timed_runs.hpp"

namespace clipscope::experiments {

AnyContestant baseline() { return find_contestant("textbook", "float"); }

std::vector<Timing> measure_time(std::span<const TimedBatch> batches,
                                 std::span<const AnyContestant> contestants,
                                 const TimingOptions& options) {
  std::vector<RunBatch<3>> runs;
  std::size_t triangles = 0;
  for (const TimedBatch& batch : batches) {
    runs.push_back({&batch.view, batch.triangles});
    triangles += batch.triangles.size();
  }
  if (triangles == 0) {
    Timing none;
    none.refused = "no triangles";
    return std::vector<Timing>(contestants.size(), none);
  }
  RunInputs<3> inputs(std::move(runs));

  const auto checks_in = [&]<class T>(TypeList<T>) {
    return [&](std::size_t b) {
      const TimedBatch& batch = batches[b];
      return [&batch, checker = PromiseChecker(frustum_cast<double>(batch.view.frustum))](
                 const Promise& promise, std::size_t i,
                 std::span<const NdcVertex<T, kSceneAttributes>> answer) {
        return checker.template check<T, kSceneAttributes>(
            promise, reference::input_triangle(batch.triangles[i]), answer);
      };
    };
  };
  const auto prepare = [&](const AnyContestant& contestant) {
    return std::visit(
        [&]<class T>(const Contestant<T>* c) {
          return make_timed_run(*c, inputs.template in<T>(), checks_in(TypeList<T>{}));
        },
        contestant);
  };
  return time_in_turn(
      prepare(baseline()), contestants.size(),
      [&](std::size_t i) { return prepare(contestants[i]); }, options);
}

std::vector<std::vector<double>> run_in_turn(std::span<const std::function<double()>> tasks,
                                             int rounds) {
  const PinnedThread pinned;
  std::vector<std::vector<double>> samples(tasks.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const std::size_t turn = (i + static_cast<std::size_t>(round)) % tasks.size();
      samples[turn].push_back(tasks[turn]());
    }
  }
  return samples;
}

std::vector<double> ratios(std::span<const double> numerators,
                           std::span<const double> denominators) {
  std::vector<double> result;
  for (std::size_t i = 0; i < numerators.size(); ++i) {
    result.push_back(numerators[i] / denominators[i]);
  }
  return result;
}

std::vector<TimedBatch> timed_batches(const Scene& scene, std::size_t limit) {
  std::vector<TimedBatch> batches;
  const Sample sample = sample_of(scene, std::max<std::size_t>(1, limit / scene.views.size()));
  std::mt19937_64 generator(1);
  for (const View& view : scene.views) {
    TimedBatch batch{view, sampled_view_triangles(scene, view, sample, 0, sample.count)};
    for (std::size_t i = 0; i < sample.count; ++i) batch.numbers.push_back(i * sample.stride);
    for (std::size_t i = batch.triangles.size(); i > 1; --i) {
      const std::size_t other = generator() % i;
      std::swap(batch.triangles[i - 1], batch.triangles[other]);
      std::swap(batch.numbers[i - 1], batch.numbers[other]);
    }
    batches.push_back(std::move(batch));
  }
  return batches;
}

}  // namespace clipscope::experiments
