// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/timed_runs.hpp"

namespace clipscope::experiments {

std::vector<Timing> time_in_turn(
    std::unique_ptr<TimedRun> baseline, std::size_t count,
    const std::function<std::unique_ptr<TimedRun>(std::size_t)>& prepare,
    const TimingOptions& options) {
  const double target_ns = options.milliseconds_per_run * 1e6;
  std::vector<Timing> timings(count);
  std::vector<std::unique_ptr<TimedRun>> runs;
  baseline->choose_share(target_ns);
  runs.push_back(std::move(baseline));
  std::vector<std::size_t> timed;  // whose run is the next one
  for (std::size_t i = 0; i < count; ++i) {
    std::unique_ptr<TimedRun> run = prepare(i);
    run->choose_share(target_ns);
    timings[i].refused = run->first_broken_promise(options.checked_triangles);
    if (!timings[i].refused.empty()) continue;
    timed.push_back(i);
    runs.push_back(std::move(run));
  }
  if (timed.empty()) return timings;

  std::vector<std::function<double()>> tasks;
  for (const auto& run : runs) tasks.push_back([&run] { return run->run(); });
  const std::vector<std::vector<double>> samples = run_in_turn(tasks, options.rounds);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    Timing& timing = timings[timed[i]];
    timing.samples_ns = samples[i + 1];
    timing.ns = median_interval(timing.samples_ns);
    timing.speedup = median_interval(ratios(samples[0], timing.samples_ns));
  }
  return timings;
}

}  // namespace clipscope::experiments
