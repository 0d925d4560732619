// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/measuring.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

// One in ten, of runs that were interrupted and of the time of processors: beyond, whoever took it
// has a part in what caches and memory do in most rounds.
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

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Of this process and the children that it waited for.
double own_seconds() {
  double seconds = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    seconds += seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  }
  return seconds;
}

}  // namespace

ProcessorTime processor_time() {
  ProcessorTime time;
  std::ifstream stat("/proc/stat");
  std::string name;
  if (!(stat >> name) || name != "cpu") return time;
  // user nice system idle iowait irq softirq steal; what follows is part of these (proc(5)).
  double ticks = 0;
  for (int i = 0; i < 8 && stat >> ticks; ++i) {
    const double seconds = ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
    time.all += seconds;
    if (i != 3 && i != 4) time.others += seconds;
  }
  time.others -= own_seconds();
  return time;
}

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

bool keep_to(int processor) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(processor), &one);
  return sched_setaffinity(0, sizeof one, &one) == 0;
}

MeasuringThread::MeasuringThread() : MeasuringThread(sched_getcpu()) {}

MeasuringThread::MeasuringThread(int processor) {
  class_before_ = sched_getscheduler(0);
  sched_getparam(0, &priority_before_);
  if (in_real_time) raise_to_real_time();
  CPU_ZERO(&affinity_before_);
  if (sched_getaffinity(0, sizeof affinity_before_, &affinity_before_) != 0) return;
  pinned_ = keep_to(processor);
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

double Interruptions::others_percent() const {
  // The system counts in ticks, and not all at the same moment: less is nothing.
  return seconds <= 0 ? 0 : 100 * std::clamp(others_seconds / seconds, 0.0, 1.0);
}

bool Interruptions::is_busy() const {
  return percent() > kMostPercent || others_percent() > kMostPercent;
}

std::string Interruptions::text() const {
  const std::int64_t lost = redone + disturbed;
  std::string text = fmt::format("{} of {} runs under the clock lost the processor",
                                 lost == 0 ? "none" : std::to_string(lost), runs);
  if (disturbed > 0) {
    text += fmt::format(": {} done again, {} kept all the same", redone, disturbed);
  } else if (lost > 0) {
    text += redone == 1 ? " and was done again" : " and were done again";
  }
  if (seconds <= 0) return text;
  return text + fmt::format("; other programs took {:.0f} % of the processors meanwhile",
                            others_percent());
}

Interruptions operator+(const Interruptions& a, const Interruptions& b) {
  return {a.runs + b.runs, a.redone + b.redone, a.disturbed + b.disturbed, a.seconds + b.seconds,
          a.others_seconds + b.others_seconds};
}

Interruptions operator-(const Interruptions& later, const Interruptions& earlier) {
  return {later.runs - earlier.runs, later.redone - earlier.redone,
          later.disturbed - earlier.disturbed, later.seconds - earlier.seconds,
          later.others_seconds - earlier.others_seconds};
}

std::string busy_text(const Interruptions& interruptions) {
  if (!interruptions.is_busy()) return "";
  return "The machine was busy, so that no time here is settled.";
}

void count_runs(const Interruptions& runs) { so_far = so_far + runs; }

Interruptions interruptions_so_far() { return so_far; }

}  // namespace clipscope::experiments
