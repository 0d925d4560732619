// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/measuring.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstring>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

// One in ten: beyond, half of the runs of a round or more had a neighbour that was interrupted, and
// whoever interrupted them left its own data in the caches.
constexpr double kMostPercent = 10;

bool in_real_time = false;
Interruptions so_far;

// The least of the class is above every program outside of it. Who has more keeps it.
void raise_to_real_time() {
  const int before = sched_getscheduler(0);
  if (before == SCHED_FIFO || before == SCHED_RR) return;
  const sched_param priority{.sched_priority = sched_get_priority_min(SCHED_FIFO)};
  if (sched_setscheduler(0, SCHED_FIFO, &priority) == 0) return;
  throw UsageError(fmt::format(
      "--realtime: the kernel refuses the real-time class ({}); allow it, as root, by `prlimit --pid $$ --rtprio=1` in your shell or a line `USER - rtprio 1` in /etc/security/limits.conf, or go without",
      std::strerror(errno)));
}

bool pin_to(int processor) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(processor), &one);
  return sched_setaffinity(0, sizeof one, &one) == 0;
}

}  // namespace

void measure_in_real_time() {
  in_real_time = true;
  const MeasuringThread tried;
}

std::vector<int> allowed_processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return {};
  std::vector<int> processors;
  for (int p = 0; p < CPU_SETSIZE; ++p) {
    if (CPU_ISSET(static_cast<std::size_t>(p), &set)) processors.push_back(p);
  }
  return processors;
}

MeasuringThread::MeasuringThread() : MeasuringThread(sched_getcpu()) {}

MeasuringThread::MeasuringThread(int processor) {
  class_before_ = sched_getscheduler(0);
  sched_getparam(0, &priority_before_);
  if (in_real_time) raise_to_real_time();
  CPU_ZERO(&affinity_before_);
  if (sched_getaffinity(0, sizeof affinity_before_, &affinity_before_) != 0) return;
  pinned_ = pin_to(processor);
}

MeasuringThread::~MeasuringThread() {
  if (pinned_) sched_setaffinity(0, sizeof affinity_before_, &affinity_before_);
  if (in_real_time) sched_setscheduler(0, class_before_, &priority_before_);
}

std::int64_t involuntary_switches() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nivcsw;
}

double Interruptions::percent() const {
  const auto interrupted = static_cast<double>(redone + disturbed);
  return runs == 0 ? 0 : 100 * interrupted / static_cast<double>(runs);
}

bool Interruptions::is_busy() const { return percent() > kMostPercent; }

std::string Interruptions::text() const {
  const std::int64_t lost = redone + disturbed;
  const std::string text = fmt::format("{} of {} runs under the clock lost the processor",
                                       lost == 0 ? "none" : std::to_string(lost), runs);
  if (lost == 0) return text;
  if (disturbed == 0) return text + (redone == 1 ? " and was done again" : " and were done again");
  return fmt::format("{}: {} done again, {} kept all the same", text, redone, disturbed);
}

Interruptions operator+(const Interruptions& a, const Interruptions& b) {
  return {a.runs + b.runs, a.redone + b.redone, a.disturbed + b.disturbed};
}

Interruptions operator-(const Interruptions& later, const Interruptions& earlier) {
  return {later.runs - earlier.runs, later.redone - earlier.redone,
          later.disturbed - earlier.disturbed};
}

std::string busy_text(const Interruptions& interruptions) {
  if (!interruptions.is_busy()) return "";
  return "The machine was busy, so that no time here is settled.";
}

void count_runs(const Interruptions& runs) { so_far = so_far + runs; }

Interruptions interruptions_so_far() { return so_far; }

}  // namespace clipscope::experiments
