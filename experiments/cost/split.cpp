// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/split.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "experiments/contestants/contestants_of.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/staged.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;
using Task = std::function<double()>;

constexpr std::size_t kBlock = 1024;  // triangles whose output stays in cache

enum class Order { view_space, clip_space, cvv };

// The batches in one scalar, U: T or a staged T.
template <class U>
struct StagedInput {
  std::vector<Projection<U>> projections;
  std::vector<std::vector<ViewTriangle<U, kSceneAttributes>>> triangles;

  explicit StagedInput(std::span<const TimedBatch> batches) {
    for (const TimedBatch& batch : batches) {
      projections.push_back(projection_of<U>(batch.view));
      triangles.push_back(simplices_cast<U>(batch.triangles));
    }
  }
};

// Calls step(projection, block of triangles) for all of them; ns per triangle.
template <class U, class Step>
double run_blocks(const StagedInput<U>& input, Step&& step) {
  std::size_t count = 0;
  const Clock::time_point start = Clock::now();
  for (std::size_t b = 0; b < input.triangles.size(); ++b) {
    const std::span all(input.triangles[b]);
    for (std::size_t first = 0; first < all.size(); first += kBlock) {
      step(input.projections[b], all.subspan(first, std::min(kBlock, all.size() - first)));
    }
    count += all.size();
  }
  const std::chrono::duration<double, std::nano> passed = Clock::now() - start;
  return passed.count() / static_cast<double>(count);
}

// The whole of a clipper in a scalar, or what a staged scalar leaves of it.
template <class C, class U>
Task clipper_task(std::span<const TimedBatch> batches) {
  auto input = std::make_shared<StagedInput<U>>(batches);
  auto out = std::make_shared<PolygonStream<U, kSceneAttributes>>();
  return [input, out] {
    return run_blocks(*input, [&](const auto& projection, const auto& block) {
      out->clear();
      clip_batch<C>(projection, block, *out);
    });
  };
}

// Positions to clip space, or on to NDC.
template <class T, bool kDivide>
Task transform_task(std::span<const TimedBatch> batches) {
  auto input = std::make_shared<StagedInput<T>>(batches);
  auto out = std::make_shared<std::vector<std::array<Vec4<T>, 3>>>(kBlock);
  return [input, out] {
    return run_blocks(*input, [&](const auto& projection, const auto& block) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        for (std::size_t v = 0; v < 3; ++v) {
          const Vec4<T> clip = to_clip(projection, block[i][v].position);
          if constexpr (kDivide) {
            (*out)[i][v] = clipscope::to_ndc(clip);
          } else {
            (*out)[i][v] = clip;
          }
        }
      }
    });
  };
}

template <class C>
constexpr Order order_of() {
  if (C::name.starts_with("view/")) return Order::view_space;
  return C::name.starts_with("cvv/") ? Order::cvv : Order::clip_space;
}

// Parts in the order in which the clipper does them, and runs that each do one more.
struct Steps {
  std::array<std::string_view, 3> parts;
  std::array<Task, 3> tasks;
};

template <class C, class T>
Steps steps_of(std::span<const TimedBatch> batches) {
  const Task whole = clipper_task<C, T>(batches);
  if constexpr (order_of<C>() == Order::view_space) {
    return {{"cut", "transform", "divide"},
            {clipper_task<C, Staged<T, Skip::transform_and_divide>>(batches),
             clipper_task<C, Staged<T, Skip::divide>>(batches), whole}};
  } else if constexpr (order_of<C>() == Order::cvv) {
    return {{"transform", "divide", "cut"},
            {transform_task<T, false>(batches), transform_task<T, true>(batches), whole}};
  } else {
    return {{"transform", "cut", "divide"},
            {transform_task<T, false>(batches), clipper_task<C, Staged<T, Skip::divide>>(batches),
             whole}};
  }
}

using ClippersWithSteps =
    TypeList<Textbook, ViewSutherlandHodgman, HomogeneousSutherlandHodgman, CvvNearFirst>;
using SplitScalars = TypeList<float, double>;

struct SplitTask {
  Split split;
  Steps steps;
};

bool is_timed(std::string_view clipper, std::string_view scalar,
              std::span<const AnyContestant> contestants, std::span<const Timing> timings) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (clipper_name(contestants[i]) == clipper && scalar_name(contestants[i]) == scalar) {
      return timings[i].refused.empty();
    }
  }
  return false;
}

std::vector<SplitTask> split_tasks(std::span<const TimedBatch> batches,
                                   std::span<const AnyContestant> contestants,
                                   std::span<const Timing> timings) {
  std::vector<SplitTask> tasks;
  for_each_type(ClippersWithSteps{}, [&]<class C>() {
    for_each_type(SplitScalars{}, [&]<class T>() {
      const std::string_view scalar = ScalarTraits<T>::name;
      if (!is_timed(C::name, scalar, contestants, timings)) return;
      tasks.push_back({{std::string(C::name), std::string(scalar), {}}, steps_of<C, T>(batches)});
    });
  });
  return tasks;
}

SplitPart part_of(std::string_view name, std::vector<double> ns, std::span<const double> whole) {
  std::vector<double> shares = ratios(ns, whole);
  for (double& share : shares) share *= 100;
  return {name, median_interval(ns), median_interval(shares), std::move(ns)};
}

// What the later run takes more, round by round.
std::vector<double> differences(std::span<const double> later, std::span<const double> earlier) {
  std::vector<double> result(later.begin(), later.end());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= earlier[i];
  return result;
}

}  // namespace

std::vector<Split> measure_split(std::span<const TimedBatch> batches,
                                 std::span<const AnyContestant> contestants,
                                 std::span<const Timing> timings, int rounds) {
  std::vector<SplitTask> split = split_tasks(batches, contestants, timings);
  std::vector<Task> tasks;
  for (const SplitTask& s : split) {
    tasks.insert(tasks.end(), s.steps.tasks.begin(), s.steps.tasks.end());
  }
  for (const Task& task : tasks) task();  // memory is touched, caches are warm
  const std::vector<std::vector<double>> samples = run_in_turn(tasks, rounds);
  std::vector<Split> result;
  for (std::size_t i = 0; i < split.size(); ++i) {
    const auto &first = samples[3 * i], &second = samples[3 * i + 1], &whole = samples[3 * i + 2];
    const auto& names = split[i].steps.parts;
    split[i].split.parts = {
        part_of(names[0], first, whole), part_of(names[1], differences(second, first), whole),
        part_of(names[2], differences(whole, second), whole), part_of("whole", whole, whole)};
    result.push_back(std::move(split[i].split));
  }
  return result;
}

}  // namespace clipscope::experiments
