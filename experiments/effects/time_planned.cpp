// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/effects/time_planned.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>

#include "experiments/measure/machine.hpp"
#include "spaces/effects/pipeline.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;
using Triangles = std::span<const SceneTriangle>;
using NdcScenePolygon = NdcPolygon<float, kSceneAttributes>;

constexpr std::size_t kBlock = 1024;  // triangles of a call

// Takes polygons as the next stage of a renderer does: a call, in which every coordinate is read where it
// was written. Copying them out in wide pieces would make the wait for the narrow stores before it most
// of what is timed, by an amount that depends on where code and stack happen to lie.
class Consumer {
 public:
  [[gnu::noinline]] void operator()(const NdcScenePolygon& polygon) {
    for (int i = 0; i < polygon.size(); ++i) {
      for (int c = 0; c < 4; ++c) position_[c] ^= bits(polygon[i].position[c]);
      for (int k = 0; k < kSceneAttributes; ++k) attributes_[k] ^= bits(polygon[i].attributes[k]);
    }
  }

 private:
  static std::uint32_t bits(float a) { return std::bit_cast<std::uint32_t>(a); }
  std::array<std::uint32_t, 4> position_{};
  std::array<std::uint32_t, kSceneAttributes> attributes_{};
};

// What is left where nothing is clipped: the same way from view space to the contract's polygon.
void transform_and_divide(const Projection<float>& projection, Triangles triangles,
                          Consumer& sink) {
  alignas(effects::kCacheLine) NdcScenePolygon polygon;
  for (const SceneTriangle& triangle : triangles) {
    polygon.clear();
    for (const auto& v : triangle) polygon.push_back(to_ndc(to_clip(projection, v)));
    sink(polygon);
  }
}

// Calls work(view, block of its triangles) for all views.
template <class Work>
void for_each_block(std::span<const PlannedView> views, Work&& work) {
  for (const PlannedView& view : views) {
    const Triangles all(view.triangles);
    for (std::size_t first = 0; first < all.size(); first += kBlock) {
      work(view, all.subspan(first, std::min(kBlock, all.size() - first)));
    }
  }
}

// What is timed; each entry goes through all triangles of all views once.
std::array<std::function<void()>, 5> entries(std::span<const PlannedView> views,
                                             Consumer& consumer) {
  return {[views, &consumer] {
            for_each_block(views, [&](const PlannedView& view, Triangles block) {
              clip_fully(view.plan.projection(), block, consumer);
            });
          },
          [views, &consumer] {
            for_each_block(views, [&](const PlannedView& view, Triangles block) {
              clip_as_planned(view.plan, view.plan.revision(), block, consumer);
            });
          },
          [views, &consumer] {
            for_each_block(views, [&](const PlannedView& view, Triangles block) {
              transform_and_divide(view.plan.projection(), block, consumer);
            });
          },
          [views] {
            for (const PlannedView& view : views) {
              const SceneFacts<float> facts(view.plan.projection(), Triangles(view.triangles),
                                            view.facts.attributes(), view.facts.options());
              [[maybe_unused]] volatile float kept = facts.w_ratio();
            }
          },
          [views] {
            for (const PlannedView& view : views) {
              [[maybe_unused]] volatile float kept =
                  attribute_facts(Triangles(view.triangles)).range;
            }
          }};
}

double nanoseconds(const std::function<void()>& entry, int times) {
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < times; ++i) entry();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / times;
}

MedianInterval ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios(a.size());
  std::transform(a.begin(), a.end(), b.begin(), ratios.begin(), std::divides<>());
  return median_interval(std::move(ratios));
}

}  // namespace

PlannedTiming time_planned(std::span<const PlannedView> views,
                           const PlannedTimingOptions& options) {
  const PinnedThread pinned;
  double triangles = 0;
  for (const PlannedView& view : views) triangles += static_cast<double>(view.triangles.size());

  Consumer consumer;
  const auto all = entries(views, consumer);
  std::array<int, all.size()> times;
  std::array<std::size_t, all.size()> order;
  for (std::size_t e = 0; e < all.size(); ++e) {
    nanoseconds(all[e], 1);
    const double once = nanoseconds(all[e], 1);
    times[e] = static_cast<int>(std::ceil(options.milliseconds_per_run * 1e6 / (once + 1)));
    order[e] = e;
  }
  std::array<std::vector<double>, all.size()> samples;
  for (int round = 0; round < options.rounds; ++round) {
    for (const std::size_t e : order) {
      samples[e].push_back(nanoseconds(all[e], times[e]) / triangles);
    }
    std::rotate(order.begin(), order.begin() + 1, order.end());
  }
  return {.full_ns = median_interval(samples[0]),
          .planned_ns = median_interval(samples[1]),
          .bare_ns = median_interval(samples[2]),
          .to_full = ratio(samples[1], samples[0]),
          .to_bare = ratio(samples[1], samples[2]),
          .facts_ns = median_interval(samples[3]),
          .attributes_ns = median_interval(samples[4]),
          .full_samples = samples[0],
          .planned_samples = samples[1],
          .bare_samples = samples[2]};
}

}  // namespace clipscope::experiments
