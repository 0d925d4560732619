// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace clipscope::experiments {
namespace {

constexpr std::size_t kLineWidth = 79;  // a longer line would break, and not be rewritten

const RunProgress* g_run = nullptr;  // the one that lives

bool on_terminal() { return isatty(STDERR_FILENO) != 0; }

void rewrite_line(const std::string& line) {
  fmt::print(stderr, "\r\033[K{}", line.substr(0, kLineWidth));
  std::fflush(stderr);
}

}  // namespace

void clear_progress_line() {
  if (on_terminal()) rewrite_line("");
}

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), start_(Clock::now()), last_print_(start_) {}

Progress::~Progress() {
  if (printed_) clear_progress_line();
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
  if (g_run != nullptr) {
    g_run->show(fmt::format("{} {:.0f} %", label_, share * 100));
  } else if (on_terminal()) {
    rewrite_line(fmt::format("{}: {:3.0f} %, {:.0f} s left", label_, share * 100, left));
    printed_ = true;
  } else {
    fmt::print(stderr, "{}: {:3.0f} %, {:.0f} s left\n", label_, share * 100, left);
  }
  last_print_ = now;
}

double seconds_left(std::span<const RunStep> steps, std::size_t done, double elapsed) {
  double expected_done = 0, expected_left = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    (i < done ? expected_done : expected_left) += steps[i].expected_seconds;
  }
  const double weight = 0.1 * (expected_done + expected_left);
  if (weight == 0) return 0;
  return expected_left * (elapsed + weight) / (expected_done + weight);
}

RunProgress::RunProgress(std::string label, std::vector<RunStep> steps)
    : label_(std::move(label)), steps_(std::move(steps)), start_(std::chrono::steady_clock::now()) {
  g_run = this;
}

RunProgress::~RunProgress() {
  clear_progress_line();
  g_run = nullptr;
}

double RunProgress::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void RunProgress::show(const std::string& detail) const {
  if (!on_terminal()) return;
  rewrite_line(fmt::format("{} {}/{}, about {:.0f} s left: {}, {}", label_, done_ + 1,
                           steps_.size(), seconds_left(steps_, done_, elapsed()),
                           steps_[done_].name, detail));
}

void RunProgress::finish_step(double seconds) {
  const std::string name = steps_[done_++].name;
  if (on_terminal()) return;
  const double left = seconds_left(steps_, done_, elapsed());
  const std::string rest =
      done_ < steps_.size() ? fmt::format("; about {:.0f} s left", left) : std::string();
  fmt::print(stderr, "{} {}/{}: {} took {:.0f} s{}\n", label_, done_, steps_.size(), name, seconds,
             rest);
  std::fflush(stderr);
}

}  // namespace clipscope::experiments
