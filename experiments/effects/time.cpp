// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time of planned pipelines. What is timed is compiled apart: beside a second sink for polygons
// (harm.cpp) GCC 12 inlines less of them, and they take half as long again where all is outside.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>

#include "experiments/effects/rows.hpp"
#include "spaces/effects/pipeline.hpp"

namespace clipscope::experiments::effects {
namespace {

using Triangles = std::span<const SceneTriangle>;
using Polygon4 = NdcPolygon<float, kSceneAttributes>;

constexpr std::size_t kBlock = 1024;  // triangles of a call

// Takes polygons as the next stage of a renderer does: a call, in which every coordinate is read
// where it was written. Copying them out in wide pieces would make the wait for the narrow stores
// before it most of what is timed, by an amount that depends on where code and stack happen to lie.
class Consumer {
 public:
  [[gnu::noinline]] void operator()(const Polygon4& polygon) {
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
  alignas(clipscope::effects::kCacheLine) Polygon4 polygon;
  for (const SceneTriangle& triangle : triangles) {
    polygon.clear();
    for (const auto& v : triangle) polygon.push_back(to_ndc(to_clip(projection, v)));
    sink(polygon);
  }
}

// Goes through all triangles of all views so many times: work(view, block of its triangles).
template <class Work>
Task task_of(std::span<const PlannedView> views, std::size_t block, const Work& work,
             const std::function<std::string()>& check) {
  const auto all = [=](double times) {
    std::size_t triangles = 0;
    for (int i = 0; i < times; ++i) {
      for (const PlannedView& view : views) {
        const Triangles all(view.triangles);
        for (std::size_t first = 0; first < all.size(); first += block) {
          work(view, all.subspan(first, std::min(block, all.size() - first)));
        }
        triangles += all.size();
      }
    }
    return triangles;
  };
  return {.work = all, .check = check, .most_share = kRepeated};
}

}  // namespace

Timings time_planned(std::span<const PlannedView> views, const Harm& harm,
                     const ClockOptions& options) {
  const auto consumer = std::make_shared<Consumer>();
  const auto full = [=](const PlannedView& view, Triangles block) {
    clip_fully(view.plan.projection(), block, *consumer);
  };
  const auto planned = [=](const PlannedView& view, Triangles block) {
    clip_as_planned(view.plan, view.plan.revision(), block, *consumer);
  };
  const auto bare = [=](const PlannedView& view, Triangles block) {
    transform_and_divide(view.plan.projection(), block, *consumer);
  };
  const auto facts = [](const PlannedView& view, Triangles all) {
    const SceneFacts<float> found(view.plan.projection(), all, view.facts.attributes(),
                                  view.facts.options());
    [[maybe_unused]] volatile float kept = found.w_ratio();
  };
  const auto attributes = [](const PlannedView&, Triangles all) {
    [[maybe_unused]] volatile float kept = attribute_facts(all).range;
  };
  const std::array tasks = {
      task_of(views, kBlock, full, [=] { return harm.broken; }),
      task_of(views, kBlock, planned, [=] { return harm.text(views.front().tolerance); }),
      task_of(views, kBlock, bare, nothing_to_check),
      task_of(views, SIZE_MAX, facts, nothing_to_check),
      task_of(views, SIZE_MAX, attributes, nothing_to_check)};
  const std::vector<Timing> timings = time_in_turn(tasks, options);
  return {timings[0], timings[1], timings[2], timings[3], timings[4]};
}

}  // namespace clipscope::experiments::effects
