// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/contest_clock.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "experiments/judge/promise.hpp"
#include "experiments/machine/measuring.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kLeastPrimitives = 64;
constexpr std::size_t kBlock = 1024;  // primitives whose output stays in cache

std::size_t size_of(std::span<const Batch> batches) {
  std::size_t size = 0;
  for (const Batch& batch : batches) size += batch.size();
  return size;
}

// The leading share of each batch, block by block; primitives that were clipped.
std::size_t clip_share(Runner& runner, std::span<const Batch> batches, double share) {
  std::size_t clipped = 0;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    const std::size_t size = batches[b].size();
    const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(size)));
    const std::size_t count = std::min(wanted, size);
    for (std::size_t first = 0; first < count; first += kBlock) {
      runner.clip(b, first, std::min(kBlock, count - first));
    }
    clipped += count;
  }
  return clipped;
}

// On about so many primitives, spread over the batches.
std::string first_broken_promise(const Contestant& contestant, Runner& runner,
                                 std::span<const Batch> batches, std::size_t limit) {
  const std::size_t all = size_of(batches);
  for (std::size_t b = 0; b < batches.size(); ++b) {
    const Batch& batch = batches[b];
    const std::size_t share = std::max<std::size_t>(1, limit * batch.size() / all);
    const std::size_t count = std::min(share, batch.size());
    runner.clip(b, 0, count);
    const Answers answers = runner.answers();
    const PromiseChecker checker(batch);
    std::vector<PromiseCheck> found(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      found[i] =
          checker.check(contestant.promise, input_vertices(batch, i), batch.attributes, answers[i]);
    });
    for (const PromiseCheck& f : found) {
      if (f.verdict == PromiseVerdict::broken) return f.reason;
    }
  }
  return "";
}

}  // namespace

ContestClock contest_clock(bool quick) {
  if (quick) return {.rounds = 5, .milliseconds_per_run = 0.3, .checked = 24};
  return {.rounds = 21, .milliseconds_per_run = 1.5, .checked = 128};
}

Task contest_task(const Contestant& contestant, std::span<const Batch> batches,
                  std::size_t checked) {
  const std::shared_ptr<Runner> runner = contestant.prepare(batches);
  const double size = static_cast<double>(size_of(batches));
  return {.work = [=](double share) { return clip_share(*runner, batches, share); },
          .check =
              [=, &contestant] {
                if (!contestant.untimed.empty()) return std::string(contestant.untimed);
                return first_broken_promise(contestant, *runner, batches, checked);
              },
          .prepare = [=] { runner->enter_clock(); },
          .finish = [=] { runner->leave_clock(); },
          .least_share = std::min(1.0, kLeastPrimitives / size),
          .interruptions = [=] { return involuntary_switches() + runner->interruptions(); }};
}

std::vector<Timing> time_contestants(std::span<const Batch> batches, const Contestants& contestants,
                                     const Contestant& baseline, const ContestClock& clock,
                                     const Inaccuracies& inaccuracies) {
  if (size_of(batches) == 0) {
    Timing none;
    none.refused = "no primitives";
    return std::vector<Timing>(contestants.size(), none);
  }
  std::vector<Task> tasks = {contest_task(baseline, batches, clock.checked)};
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    tasks.push_back(contest_task(*contestants[c], batches, clock.checked));
    tasks.back().inaccuracy = inaccuracies.empty() ? std::vector<double>() : inaccuracies[c];
  }
  std::vector<Timing> timings =
      time_in_turn(tasks, {.rounds = clock.rounds,
                           .milliseconds_per_run = clock.milliseconds_per_run,
                           .baseline = 0,
                           .far = clock.far});
  timings.erase(timings.begin());
  return timings;
}

}  // namespace clipscope::experiments
