// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a thread that measures asks of the system: one processor, the real-time class where the user
// wants it, and word of each time that the processor was taken from it all the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <sched.h>
#include <string>
#include <vector>

namespace clipscope::experiments {

// From now on threads that measure are in the real-time class (SCHED_FIFO) while they do: no other
// program takes the processor from them. It stands still meanwhile, so somebody has to ask for it.
// Errors: UsageError, which says what to do, where the kernel refuses.
void measure_in_real_time();

// The processors that the calling thread may run on, by number.
std::vector<int> allowed_processors();

// The calling thread keeps to that processor from now on; false where the system does not allow it.
bool keep_to(int processor);

// While the object lives the calling thread keeps to one processor, and is in the real-time class
// if measure_in_real_time() was called. Errors: UsageError where the kernel refuses that.
class MeasuringThread {
 public:
  // On the processor that it runs on, or on that of a number.
  MeasuringThread();
  explicit MeasuringThread(int processor);
  ~MeasuringThread();
  MeasuringThread(const MeasuringThread&) = delete;
  MeasuringThread& operator=(const MeasuringThread&) = delete;

  // False where the system does not allow it.
  bool pinned() const { return pinned_; }

 private:
  cpu_set_t affinity_before_;
  int class_before_ = SCHED_OTHER;
  sched_param priority_before_ = {};
  bool pinned_ = false;
};

// How often the calling thread has lost its processor though it could have gone on, since it
// started: its involuntary context switches.
std::int64_t involuntary_switches();

// Time of all processors together since the machine started, in seconds; 0 where it isn't known.
struct ProcessorTime {
  double all = 0;
  double others = 0;  // busy, and neither for this process nor for children that it waited for
};
ProcessorTime processor_time();

// Runs under a clock, those of them that lost the processor, and the company that they had.
struct Interruptions {
  std::int64_t runs = 0;       // all of them, those that were done again, too
  std::int64_t redone = 0;     // were done again and do not count
  std::int64_t disturbed = 0;  // lost it each time that they were done again, and count
  // Of all processors, while the rounds went on. Another program takes its share of caches, memory
  // and, where two processors are threads of one core, of that, too.
  double seconds = 0, others_seconds = 0;

  double percent() const;
  double others_percent() const;
  // Then times and their ratios may move, and settle nothing.
  bool is_busy() const;
  // "12 of 3400 runs under the clock lost the processor and were done again; other programs took
  // 3 % of the processors meanwhile".
  std::string text() const;

  friend bool operator==(const Interruptions&, const Interruptions&) = default;
};

Interruptions operator+(const Interruptions& a, const Interruptions& b);
Interruptions operator-(const Interruptions& later, const Interruptions& earlier);

// What a finding says of a machine that was busy; empty for one that was not.
std::string busy_text(const Interruptions& interruptions);

// Of this process so far. For one thread.
void count_runs(const Interruptions& runs);
Interruptions interruptions_so_far();

}  // namespace clipscope::experiments
