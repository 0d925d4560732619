// SPDX-License-Identifier: GPL-3.0-or-later
//
// Threads that wait for work, so that what is timed is the work and not their start.
#pragma once

#include <barrier>
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

  std::size_t size() const { return threads_.size(); }

  // work(i) on thread i, all at once, until the last has finished.
  void run(std::function<void(std::size_t)> work) {
    work_ = std::move(work);
    start_.arrive_and_wait();
    done_.arrive_and_wait();
  }

 private:
  std::barrier<> start_, done_;
  std::function<void(std::size_t)> work_;
  std::vector<std::thread> threads_;
};

}  // namespace clipscope::experiments
