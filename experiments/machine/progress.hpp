// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress of long work on standard error: what is being done, how far, how long it will take.
//
// On a terminal one line is rewritten; elsewhere a line is printed every ten seconds, and within a
// run one line for each of its steps instead.
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

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

// A step of a run, such as an experiment, and how long it is expected to take.
struct RunStep {
  std::string name;
  double expected_seconds = 1;
};

// How long the rest of the steps will take, the first `done` of which took `elapsed` seconds: as
// long as expected, times what those done have taken of theirs. A tenth of the whole counts as
// having taken what was expected of it, so that a short first step does not decide all.
double seconds_left(std::span<const RunStep> steps, std::size_t done, double elapsed);

// Progress over the steps of a run, as long as it lives also of what a step tells by Progress.
class RunProgress {
 public:
  // label: what the run is, before the count of steps. At most one lives at a time.
  RunProgress(std::string label, std::vector<RunStep> steps);
  ~RunProgress();
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  // The next step begins; what it is about, and how far it is (on a terminal).
  void show(const std::string& detail) const;
  // The step that is being done took so long.
  void finish_step(double seconds);
  double elapsed() const;

 private:
  std::string label_;
  std::vector<RunStep> steps_;
  std::size_t done_ = 0;
  std::chrono::steady_clock::time_point start_;
};

// Takes the rewritten line off the terminal, before something else is printed.
void clear_progress_line();

}  // namespace clipscope::experiments
