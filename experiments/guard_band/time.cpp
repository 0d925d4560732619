// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/measure.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "experiments/contestants/answers.hpp"
#include "experiments/contestants/polygon_stream.hpp"
#include "experiments/judge/promise.hpp"
#include "spaces/homogeneous/guard_band.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments::guard_band {
namespace {

constexpr double kMillisecondsPerRun = 1;
constexpr std::size_t kChecked = 128;  // triangles of each view

using Stream = PolygonStream<float, kSceneAttributes>;

// What all three promise of their polygon: it lies on the triangle, and nothing visible is left
// out.
constexpr Promise kCovers{.domain = Promise::Domain::divisible,
                          .contained = false,
                          .attributes = false,
                          .ulps = kChainUlps,
                          .amplification = Promise::Amplification::w_ratio};

template <class Clip>
void clip_view(const SampledView& v, const Clip& clip, Stream& out) {
  const Projection<float> projection(v.view.frustum);
  NdcPolygon<float, kSceneAttributes> polygon;
  out.clear();
  for (const SceneTriangle& triangle : v.triangles) {
    clip(projection, triangle, polygon);
    out.append(polygon);
  }
}

template <class Clip>
std::string first_broken_promise(std::span<const SampledView> views, const Clip& clip) {
  Stream polygons;
  for (const SampledView& v : views) {
    const PromiseChecker checker(frustum_cast<double>(v.view.frustum));
    clip_view(v, clip, polygons);
    for (std::size_t i = 0; i < std::min(kChecked, polygons.size()); ++i) {
      Answers answer(kFormat<float>, 4 + kSceneAttributes);
      add_polygon(polygons[i], answer);
      const PromiseCheck check =
          checker.check(kCovers, reference::input_triangle(v.triangles[i]), answer[0]);
      if (check.verdict == PromiseVerdict::broken) return check.reason;
    }
  }
  return "";
}

// clip(projection, triangle, polygon).
template <class Clip>
Task task_of(std::span<const SampledView> views, const Clip& clip) {
  return {.work =
              [=, out = std::make_shared<Stream>()](double times) {
                std::size_t clipped = 0;
                for (int i = 0; i < times; ++i) {
                  for (const SampledView& v : views) {
                    clip_view(v, clip, *out);
                    clipped += v.triangles.size();
                  }
                }
                return clipped;
              },
          .check = [=] { return first_broken_promise(views, clip); },
          .most_share = kRepeated};
}

}  // namespace

Times time_bands(std::span<const SampledView> views, std::span<const GuardBand> bands, int rounds) {
  std::vector<Task> tasks = {task_of(views, HomogeneousSutherlandHodgman{}),
                             task_of(views, HomogeneousGuardBand{})};
  for (const GuardBand& band : bands) {
    tasks.push_back(task_of(views, [band](const auto& projection, const auto& triangle, auto& out) {
      clip_to_band(projection, band, triangle, out);
    }));
  }
  const std::vector<Timing> timings = time_in_turn(
      tasks, {.rounds = rounds, .milliseconds_per_run = kMillisecondsPerRun, .baseline = 0});
  return {timings[0], timings[1], {timings.begin() + 2, timings.end()}};
}

}  // namespace clipscope::experiments::guard_band
