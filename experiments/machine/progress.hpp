// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress of long work on standard error: what is being done, how far, how long it will take.
//
// On a terminal one line is rewritten; elsewhere a line is printed every ten seconds.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace clipscope::experiments {

class Progress {
 public:
  // total: steps of work, in any unit that takes about equally long.
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::size_t steps = 1);

 private:
  using Clock = std::chrono::steady_clock;
  void print(Clock::time_point now);

  std::string label_;
  std::size_t total_;
  std::size_t done_ = 0;
  Clock::time_point start_;
  Clock::time_point last_print_;
  bool printed_ = false;
};

}  // namespace clipscope::experiments
