// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/band_time.hpp"

#include <chrono>
#include <functional>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/promise.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;
using Stream = PolygonStream<float, kSceneAttributes>;
using Clip = std::function<void(const TimedBatch&, const Projection<float>&, Stream&)>;

constexpr double kNsPerRun = 1e6;
constexpr std::size_t kChecked = 128;  // triangles of each batch

// What any of the three promises of its polygon: on the triangle, and nothing visible left out.
constexpr Promise kCovers{.domain = Promise::Domain::divisible,
                          .contained = false,
                          .attributes = false,
                          .ulps = kChainUlps,
                          .amplification = Promise::Amplification::w_ratio};

std::string first_broken_promise(std::span<const TimedBatch> batches, const Clip& clip) {
  Stream polygons;
  for (const TimedBatch& batch : batches) {
    const PromiseChecker checker(frustum_cast<double>(batch.view.frustum));
    polygons.clear();
    clip(batch, projection_of<float>(batch.view), polygons);
    for (std::size_t i = 0; i < std::min(kChecked, polygons.size()); ++i) {
      const PromiseCheck check = checker.check<float, kSceneAttributes>(
          kCovers, reference::input_triangle(batch.triangles[i]), polygons[i]);
      if (check.verdict == PromiseVerdict::broken) return check.reason;
    }
  }
  return "";
}

// Clips all batches, as often as a run needs to be long enough to be timed; ns per triangle.
class TimedRun {
 public:
  TimedRun(std::span<const TimedBatch> batches, Clip clip)
      : batches_(batches), clip_(std::move(clip)) {
    for (const TimedBatch& batch : batches) {
      projections_.push_back(projection_of<float>(batch.view));
      triangles_ += static_cast<double>(batch.triangles.size());
    }
    const double once = run(1) * triangles_;
    repetitions_ = std::max(1, static_cast<int>(kNsPerRun / once));
  }
  double operator()() { return run(repetitions_); }

 private:
  double run(int repetitions) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < repetitions; ++i) {
      for (std::size_t b = 0; b < batches_.size(); ++b) {
        polygons_.clear();
        clip_(batches_[b], projections_[b], polygons_);
      }
    }
    const double ns = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    return ns / (repetitions * triangles_);
  }

  std::span<const TimedBatch> batches_;
  Clip clip_;
  std::vector<Projection<float>> projections_;
  Stream polygons_;
  double triangles_ = 0;
  int repetitions_ = 1;
};

Clip clip_with(std::string_view clipper) {
  const auto* contestant = std::get<const Contestant<float>*>(find_contestant(clipper, "float"));
  return [contestant](const TimedBatch& batch, const Projection<float>& projection, Stream& out) {
    contestant->view(projection, batch.triangles, out);
  };
}

Clip clip_in_band(const GuardBand& band) {
  return [band](const TimedBatch& batch, const Projection<float>& projection, Stream& out) {
    NdcPolygon<float, kSceneAttributes> polygon;
    for (const SceneTriangle& triangle : batch.triangles) {
      clip_to_band(projection, band, triangle, polygon);
      out.append(polygon);
    }
  };
}

}  // namespace

BandTimes time_bands(std::span<const TimedBatch> batches, std::span<const GuardBand> bands,
                     int rounds) {
  std::vector<Clip> clips = {clip_with("homogeneous/sutherland_hodgman"),
                             clip_with("homogeneous/guard_band")};
  for (const GuardBand& band : bands) clips.push_back(clip_in_band(band));

  std::vector<BandTime> times(clips.size());
  std::vector<TimedRun> runs;
  std::vector<std::size_t> timed;
  runs.reserve(clips.size());
  for (std::size_t i = 0; i < clips.size(); ++i) {
    times[i].refused = first_broken_promise(batches, clips[i]);
    if (!times[i].refused.empty()) continue;
    timed.push_back(i);
    runs.emplace_back(batches, clips[i]);
  }
  std::vector<std::function<double()>> tasks;
  for (TimedRun& run : runs) tasks.push_back([&run] { return run(); });
  const auto samples = run_in_turn(tasks, rounds);
  for (std::size_t k = 0; k < timed.size(); ++k) {
    BandTime& time = times[timed[k]];
    time.samples_ns = samples[k];
    time.ns = median_interval(samples[k]);
    if (timed.front() == 0) time.speedup = median_interval(ratios(samples.front(), samples[k]));
  }
  return {times[0], times[1], {times.begin() + 2, times.end()}};
}

}  // namespace clipscope::experiments
