// SPDX-License-Identifier: GPL-3.0-or-later
//
// Threads that wait for work, so that what is timed is the work and not their start.
#pragma once

#include <barrier>
#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace clipscope::experiments {

// Threads keep the affinity that the constructing thread has: make the team before it is pinned.
class ThreadTeam {
 public:
  explicit ThreadTeam(std::size_t threads)
      : start_(static_cast<std::ptrdiff_t>(threads) + 1),
        done_(static_cast<std::ptrdiff_t>(threads) + 1) {
    for (std::size_t i = 0; i < threads; ++i) {
      threads_.emplace_back([this, i] {
        for (;;) {
          start_.arrive_and_wait();
          if (!work_) return;
          work_(i);
          done_.arrive_and_wait();
        }
      });
    }
  }
  ~ThreadTeam() {
    work_ = nullptr;
    start_.arrive_and_wait();
    for (std::thread& thread : threads_) thread.join();
  }
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  // work(i) on thread i, all at once; ns until the last has finished.
  double run(std::function<void(std::size_t)> work) {
    using Clock = std::chrono::steady_clock;
    work_ = std::move(work);
    const Clock::time_point start = Clock::now();
    start_.arrive_and_wait();
    done_.arrive_and_wait();
    const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
    return spent.count();
  }

 private:
  std::barrier<> start_, done_;
  std::function<void(std::size_t)> work_;
  std::vector<std::thread> threads_;
};

}  // namespace clipscope::experiments
