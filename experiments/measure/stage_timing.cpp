// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/stage_timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

namespace clipscope::experiments {
namespace {

Timing timing_of(std::vector<double> samples, std::span<const double> baseline) {
  Timing timing;
  timing.samples_ns = std::move(samples);
  timing.ns = median_interval(timing.samples_ns);
  timing.speedup = median_interval(ratios(baseline, timing.samples_ns));
  return timing;
}

// Tasks of one measurement: the baseline and contestants that keep their promise, then memory passes.
struct StageTasks {
  std::vector<std::unique_ptr<StageRun>> runs;
  std::vector<std::unique_ptr<MemoryRun>> passes;
  std::vector<std::function<double()>> tasks;

  void add(std::unique_ptr<StageRun> run) {
    tasks.push_back([r = run.get()] { return r->run(); });
    runs.push_back(std::move(run));
  }
  void add(std::unique_ptr<MemoryRun> pass) {
    tasks.push_back([p = pass.get()] { return p->run(); });
    passes.push_back(std::move(pass));
  }
};

// The memory limit over the time, round by round, in percent.
MedianInterval limit_percent(const StageBytes& bytes, std::span<const double> samples,
                             const std::array<std::vector<double>, 3>& passes,
                             const StageInput& input) {
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
    if (other.contract != row.contract || other.timing.samples_ns.empty()) continue;
    if (other.timing.ns.median < fastest->timing.ns.median) fastest = &other;
  }
  return *fastest;
}

}  // namespace

StageRun::StageRun(StageContestant& contestant, const StageInput& input)
    : contestant_(contestant),
      input_(input),
      size_(contestant.contract() == StageContract::copy ? input.array_size()
                                                         : input.size(contestant.contract())),
      block_(contestant.contract() == StageContract::indexed ? size_
                                                             : std::min(kStageBlock, size_)) {}

std::size_t StageRun::clip_block(std::size_t index) {
  const std::size_t first = index * block_;
  const std::size_t count = std::min(block_, size_ - first);
  contestant_.clip(input_, first, count);
  return count;
}

double StageRun::run() {
  using Clock = std::chrono::steady_clock;
  std::size_t clipped = 0;
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < taken_; ++i) {
    clipped += clip_block(next_);
    next_ = next_ + 1 == blocks() ? 0 : next_ + 1;
  }
  const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
  return spent.count() / static_cast<double>(clipped);
}

void StageRun::choose_share(double target_ns) {
  run();
  const double ns_per_block = run() * static_cast<double>(block_);
  taken_ = std::clamp(static_cast<std::size_t>(target_ns / ns_per_block), std::size_t{1}, blocks());
  run();
}

double StageRun::bytes_out(std::size_t triangles) {
  const std::size_t wanted = std::clamp<std::size_t>(triangles / block_, 1, blocks());
  std::size_t clipped = 0, bytes = 0;
  for (std::size_t i = 0; i < wanted; ++i) {
    clipped += clip_block(i);
    bytes += contestant_.answer().bytes();
  }
  return static_cast<double>(bytes) / static_cast<double>(clipped);
}

StageMeasurement measure_stage(const StageInput& input, const StageContestants& contestants,
                               const StageTimingOptions& options) {
  StageMeasurement result;
  StageTasks tasks;
  std::vector<std::size_t> timed;  // by run
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    StageContestant& c = *contestants[i];
    StageTiming& row = result.contestants.emplace_back();
    row = {c.method(), c.scalar(), c.build(), std::string(contract_name(c.contract()))};
    row.timing.refused = first_broken_promise(c, input, options.check);
    if (!row.timing.refused.empty() && i > 0) continue;
    auto run = std::make_unique<StageRun>(c, input);
    row.bytes = stage_bytes(input, c.contract(), run->bytes_out(options.check.triangles));
    run->choose_share(options.milliseconds_per_run * 1e6);
    timed.push_back(i);
    tasks.add(std::move(run));
  }
  std::vector<MemoryPass> passes;
  for (const MemoryPass pass : kMemoryPasses) {
    if (bytes_of(pass, input) == 0) continue;
    passes.push_back(pass);
    tasks.add(std::make_unique<MemoryRun>(pass, input));
  }
  const auto samples = run_in_turn(tasks.tasks, options.rounds);
  std::array<std::vector<double>, 3> pass_samples;
  for (std::size_t p = 0; p < passes.size(); ++p) {
    const auto& ns = samples[timed.size() + p];
    pass_samples[static_cast<std::size_t>(passes[p])] = ns;
    result.passes.push_back({passes[p], bytes_of(passes[p], input), timing_of(ns, samples[0])});
  }
  for (std::size_t r = 0; r < timed.size(); ++r) {
    StageTiming& row = result.contestants[timed[r]];
    if (!row.timing.refused.empty()) continue;
    row.timing = timing_of(samples[r], samples[0]);
    row.limit_percent = limit_percent(row.bytes, samples[r], pass_samples, input);
  }
  for (StageTiming& row : result.contestants) {
    if (row.timing.samples_ns.empty()) continue;
    const StageTiming& fastest = fastest_beside(row, result.contestants);
    row.times_fastest = median_interval(ratios(row.timing.samples_ns, fastest.timing.samples_ns));
  }
  return result;
}

}  // namespace clipscope::experiments
