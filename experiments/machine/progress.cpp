// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace clipscope::experiments {
namespace {

bool on_terminal() { return isatty(STDERR_FILENO) != 0; }

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), start_(Clock::now()), last_print_(start_) {}

Progress::~Progress() {
  if (printed_ && on_terminal()) fmt::print(stderr, "\r\033[K");
}

void Progress::advance(std::size_t steps) {
  done_ += steps;
  const Clock::time_point now = Clock::now();
  const auto interval = on_terminal() ? std::chrono::milliseconds(200) : std::chrono::seconds(10);
  if (now - last_print_ >= interval) print(now);
}

void Progress::print(Clock::time_point now) {
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double share = total_ == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(total_);
  const double left = share > 0 ? elapsed * (1.0 - share) / share : 0.0;
  const std::string line = fmt::format("{}: {:3.0f} %, {:.0f} s left", label_, share * 100, left);
  if (on_terminal()) {
    fmt::print(stderr, "\r\033[K{}", line);
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
  last_print_ = now;
  printed_ = true;
}

}  // namespace clipscope::experiments
