// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/clock/clock.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "experiments/machine/machine.hpp"

namespace clipscope::experiments {
namespace {

struct Run {
  double ns = 0;
  std::size_t items = 0;

  double ns_per_item() const { return ns / static_cast<double>(items); }
};

Run run(const Task& task, double share) {
  using Clock = std::chrono::steady_clock;
  if (task.prepare) task.prepare();
  const Clock::time_point start = Clock::now();
  const std::size_t items = task.work(share);
  return {std::chrono::duration<double, std::nano>(Clock::now() - start).count(), items};
}

// The share that takes about so long. Leaves the task warm.
double fitting_share(const Task& task, double target_ns) {
  run(task, task.least_share);
  if (task.least_share == task.most_share) return task.least_share;
  const double whole_ns = run(task, task.least_share).ns / task.least_share;
  double share = std::clamp(target_ns / whole_ns, task.least_share, task.most_share);
  if (share > 1) share = std::floor(share);
  run(task, share);
  return share;
}

}  // namespace

std::vector<Timing> time_in_turn(std::span<const Task> tasks, const ClockOptions& options) {
  std::vector<Timing> timings(tasks.size());
  std::vector<std::size_t> timed;
  std::vector<double> shares(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    timings[i].refused = tasks[i].check();
    if (!timings[i].is_timed()) continue;
    shares[i] = fitting_share(tasks[i], options.milliseconds_per_run * 1e6);
    timed.push_back(i);
  }
  const PinnedThread pinned;
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t i = 0; i < timed.size(); ++i) {
      const std::size_t turn = timed[(i + static_cast<std::size_t>(round)) % timed.size()];
      timings[turn].samples_ns.push_back(run(tasks[turn], shares[turn]).ns_per_item());
    }
  }
  for (const std::size_t i : timed) {
    timings[i].ns = median_interval(timings[i].samples_ns);
    if (!options.baseline || !timings[*options.baseline].is_timed()) continue;
    timings[i].speedup =
        median_interval(ratios(timings[*options.baseline].samples_ns, timings[i].samples_ns));
  }
  return timings;
}

std::vector<double> ratios(std::span<const double> numerators,
                           std::span<const double> denominators) {
  std::vector<double> result;
  for (std::size_t i = 0; i < numerators.size(); ++i) {
    result.push_back(numerators[i] / denominators[i]);
  }
  return result;
}

}  // namespace clipscope::experiments
