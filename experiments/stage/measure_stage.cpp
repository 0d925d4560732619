// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/stage/stage_timing.hpp"

namespace clipscope::experiments {
namespace {

// Rounds from cache for each from memory: a run is one block, and short.
constexpr int kCacheRounds = 2;

using PassSamples = std::array<std::span<const double>, kMemoryPasses.size()>;

// The memory limit over the time, round by round, in percent.
MedianInterval limit_percent(const StageBytes& bytes, std::span<const double> samples,
                             const PassSamples& passes, const StageInput& input) {
  std::vector<double> percent;
  for (std::size_t round = 0; round < samples.size(); ++round) {
    std::array<double, 3> ns{};
    for (std::size_t p = 0; p < 3; ++p) ns[p] = passes[p].empty() ? 0 : passes[p][round];
    percent.push_back(100 * limit_ns(bytes, ns, input) / samples[round]);
  }
  return median_interval(percent);
}

// The fastest that was timed in a row's contract.
const StageTiming& fastest_beside(const StageTiming& row, const std::vector<StageTiming>& rows) {
  const StageTiming* fastest = &row;
  for (const StageTiming& other : rows) {
    if (other.contestant->contract != row.contestant->contract || !other.timing.is_timed()) {
      continue;
    }
    if (other.timing.ns.median < fastest->timing.ns.median) fastest = &other;
  }
  return *fastest;
}

// What makes the tasks of one measurement.
struct StageTasks {
  std::function<Task(const Contestant&)> contestant;
  std::function<Task(MemoryPass)> pass;
};

StageTasks memory_tasks(const StageInput& input, const StageClock& clock) {
  const auto cursor = std::make_shared<StageCursor>();
  return {[=, &input](const Contestant& c) { return stage_task(c, input, clock.check, cursor); },
          [=, &input](MemoryPass pass) { return memory_task(pass, input, cursor); }};
}

// Of what was checked from memory a block is checked again: draws are another layout.
StageTasks cache_tasks(const StageInput& input, const StageClock& clock) {
  const auto cursor = std::make_shared<StageCursor>();
  const StageCheckOptions check{.triangles = cached_block(input), .exact = clock.check.exact / 8};
  return {[=, &input](const Contestant& c) { return cached_stage_task(c, input, check, cursor); },
          [=, &input](MemoryPass pass) { return cached_memory_task(pass, input, cursor); }};
}

StageMeasurement measure(InputFrom from, const StageInput& input, const Contestants& contestants,
                         const StageTasks& make, const StageClock& clock) {
  StageMeasurement result{.from = from, .contestants = {}, .passes = {}};
  std::vector<Task> tasks;
  for (const Contestant* c : contestants) tasks.push_back(make.contestant(*c));
  for (const MemoryPass pass : kMemoryPasses) {
    if (bytes_of(pass, input) == 0) continue;
    result.passes.push_back({pass, bytes_of(pass, input), {}});
    tasks.push_back(make.pass(pass));
  }
  const bool is_cached = from == InputFrom::cache;
  const std::vector<Timing> timings =
      time_in_turn(tasks, {.rounds = is_cached ? kCacheRounds * clock.rounds : clock.rounds,
                           .milliseconds_per_run = clock.milliseconds_per_run,
                           .baseline = 0});
  PassSamples samples;
  for (std::size_t p = 0; p < result.passes.size(); ++p) {
    result.passes[p].timing = timings[contestants.size() + p];
    samples[static_cast<std::size_t>(result.passes[p].pass)] = result.passes[p].timing.samples_ns;
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    StageTiming& row = result.contestants.emplace_back();
    row = {contestants[i], timings[i]};
    if (!row.timing.is_timed()) continue;
    const double written = bytes_written(*row.contestant, input, clock.check.triangles);
    row.bytes = stage_bytes(input, row.contestant->contract, written);
    row.limit_percent = limit_percent(row.bytes, row.timing.samples_ns, samples, input);
  }
  for (StageTiming& row : result.contestants) {
    if (!row.timing.is_timed()) continue;
    const StageTiming& fastest = fastest_beside(row, result.contestants);
    row.times_fastest = median_interval(ratios(row.timing.samples_ns, fastest.timing.samples_ns));
  }
  return result;
}

}  // namespace

StageMeasurements measure_stage(const StageInput& input, const Contestants& contestants,
                                const StageClock& clock) {
  StageMeasurements result;
  result[0] = measure(InputFrom::memory, input, contestants, memory_tasks(input, clock), clock);
  // Who answered wrongly there is not asked again.
  std::map<const Contestant*, std::string> refused;
  for (const StageTiming& t : result[0].contestants) refused[t.contestant] = t.timing.refused;
  const bool is_mesh = !input.indices.empty();
  const StageInput draws = is_mesh ? in_draws(input, cached_block(input)) : StageInput();
  const StageInput& cached = is_mesh ? draws : input;
  const StageTasks tasks = cache_tasks(cached, clock);
  const auto checked = [&](const Contestant& c) {
    Task task = tasks.contestant(c);
    if (!refused[&c].empty()) task.check = [why = refused[&c]] { return why; };
    return task;
  };
  result[1] = measure(InputFrom::cache, cached, contestants, {checked, tasks.pass}, clock);
  return result;
}

}  // namespace clipscope::experiments
