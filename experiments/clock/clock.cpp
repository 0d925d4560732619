// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/clock/clock.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "experiments/machine/measuring.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {
namespace {

struct Run {
  double ns = 0;
  std::size_t items = 0;
  bool interrupted = false;

  double ns_per_item() const { return ns / static_cast<double>(items); }
};

Run run(const Task& task, double share) {
  using Clock = std::chrono::steady_clock;
  if (task.prepare) task.prepare();
  const auto interruptions = [&] {
    return task.interruptions ? task.interruptions() : involuntary_switches();
  };
  const std::int64_t before = interruptions();
  const Clock::time_point start = Clock::now();
  const std::size_t items = task.work(share);
  const Clock::time_point end = Clock::now();
  const bool interrupted = interruptions() != before;
  if (task.finish) task.finish();
  return {std::chrono::duration<double, std::nano>(end - start).count(), items, interrupted};
}

// The share that takes about so long. Leaves the task warm. The quickest of some runs decides: one
// that something has held up would give the task so small a share that all its rounds begin cold.
double fitting_share(const Task& task, double target_ns) {
  constexpr int kTries = 3;
  run(task, task.least_share);
  if (task.least_share == task.most_share) return task.least_share;
  double least_ns = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTries; ++i) least_ns = std::min(least_ns, run(task, task.least_share).ns);
  const double whole_ns = least_ns / task.least_share;
  double share = std::clamp(target_ns / whole_ns, task.least_share, task.most_share);
  if (share > 1) share = std::floor(share);
  if (share > task.least_share) run(task, share);
  return share;
}

bool is_at_most_as_inaccurate(const Task& a, const Task& b) {
  if (!a.inaccuracy) return false;
  return std::ranges::equal(*a.inaccuracy, *b.inaccuracy, std::less_equal<>());
}

// Of those in the race, who leaves it: see the header.
std::vector<std::size_t> out_of_race(std::span<const Task> tasks, std::span<const Timing> timings,
                                     const std::vector<std::size_t>& racing,
                                     const ClockOptions& options) {
  std::map<std::size_t, MedianInterval> ns;
  for (const std::size_t i : racing) ns[i] = median_interval(timings[i].samples_ns);
  std::vector<std::size_t> out;
  std::ranges::copy_if(racing, std::back_inserter(out), [&](std::size_t i) {
    if (!tasks[i].inaccuracy || i == options.baseline) return false;
    return std::ranges::any_of(racing, [&](std::size_t rival) {
      return is_at_most_as_inaccurate(tasks[rival], tasks[i]) &&
             ns[rival].high * options.far < ns[i].low;
    });
  });
  return out;
}

// Each of `turns` has its run, in that order, and those that lost the processor another one after
// them.
void run_round(std::span<const Task> tasks, const std::vector<double>& shares,
               std::vector<std::size_t> turns, std::vector<Timing>& timings) {
  std::vector<std::int64_t> repeats(tasks.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const std::size_t turn = turns[i];
    Timing& timing = timings[turn];
    const Run done = run(tasks[turn], shares[turn]);
    if (done.interrupted && repeats[turn]++ < kMostRepeats) {
      ++timing.redone;
      turns.push_back(turn);
    } else {
      timing.disturbed += done.interrupted;
      timing.samples_ns.push_back(done.ns_per_item());
    }
  }
}

void add_figures(const ClockOptions& options, std::vector<Timing>& timings) {
  for (Timing& timing : timings) {
    if (!timing.is_timed()) continue;
    timing.rounds = static_cast<std::int64_t>(timing.samples_ns.size());
    timing.ns = median_interval(timing.samples_ns);
    count_runs({timing.rounds + timing.redone, timing.redone, timing.disturbed});
    if (!options.baseline || !timings[*options.baseline].is_timed()) continue;
    timing.speedup =
        median_interval(ratios(timings[*options.baseline].samples_ns, timing.samples_ns));
  }
}

}  // namespace

std::vector<Timing> time_in_turn(std::span<const Task> tasks, const ClockOptions& options) {
  std::vector<Timing> timings(tasks.size());
  std::vector<std::size_t> racing;
  std::vector<double> shares(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    timings[i].refused = tasks[i].check();
    if (!timings[i].is_timed()) continue;
    shares[i] = fitting_share(tasks[i], options.milliseconds_per_run * 1e6);
    racing.push_back(i);
  }
  const ProcessorTime before = processor_time();
  const MeasuringThread measuring;
  Random random(options.seed);
  for (std::size_t round = 0; round < static_cast<std::size_t>(options.rounds); ++round) {
    if (round == kLeastRounds) {
      const std::vector<std::size_t> out = out_of_race(tasks, timings, racing, options);
      std::erase_if(racing, [&](std::size_t i) { return std::ranges::binary_search(out, i); });
    }
    std::vector<std::size_t> turns = racing;
    random.shuffle(std::span(turns));
    run_round(tasks, shares, std::move(turns), timings);
  }
  const ProcessorTime after = processor_time();
  count_runs({.seconds = after.all - before.all, .others_seconds = after.others - before.others});
  add_figures(options, timings);
  return timings;
}

std::vector<double> ratios(std::span<const double> numerators,
                           std::span<const double> denominators) {
  std::vector<double> result;
  const std::size_t rounds = std::min(numerators.size(), denominators.size());
  for (std::size_t i = 0; i < rounds; ++i) result.push_back(numerators[i] / denominators[i]);
  return result;
}

}  // namespace clipscope::experiments
