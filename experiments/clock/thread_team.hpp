// SPDX-License-Identifier: GPL-3.0-or-later
//
// Threads that wait for work, each on a processor of its own, so that what is timed is the work and
// neither their start nor their moves.
#pragma once

#include <atomic>
#include <barrier>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

#include "experiments/machine/measuring.hpp"

namespace clipscope::experiments {

// Thread i keeps to the i-th of the processors that the constructing thread may run on, from the
// first on again where these are fewer: make the team before that thread measures.
class ThreadTeam {
 public:
  explicit ThreadTeam(std::size_t threads)
      : start_(static_cast<std::ptrdiff_t>(threads) + 1),
        done_(static_cast<std::ptrdiff_t>(threads) + 1) {
    const std::vector<int> processors = allowed_processors();
    for (std::size_t i = 0; i < threads; ++i) {
      const int processor = processors.empty() ? 0 : processors[i % processors.size()];
      threads_.emplace_back([this, i, processor] { serve(i, processor); });
    }
  }
  ~ThreadTeam() {
    work_ = nullptr;
    start_.arrive_and_wait();
    for (std::thread& thread : threads_) thread.join();
  }
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  std::size_t size() const { return threads_.size(); }

  // work(i) on thread i, all at once, until the last has finished.
  void run(std::function<void(std::size_t)> work) {
    work_ = std::move(work);
    start_.arrive_and_wait();
    done_.arrive_and_wait();
  }

  // How often a thread lost its processor while it worked, of all threads so far; see Task.
  std::int64_t interruptions() const { return interruptions_; }

 private:
  void serve(std::size_t i, int processor) {
    const MeasuringThread measuring(processor);
    for (;;) {
      start_.arrive_and_wait();
      if (!work_) return;
      const std::int64_t before = involuntary_switches();
      work_(i);
      interruptions_ += involuntary_switches() - before;
      done_.arrive_and_wait();
    }
  }

  std::barrier<> start_, done_;
  std::function<void(std::size_t)> work_;
  std::atomic<std::int64_t> interruptions_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace clipscope::experiments
