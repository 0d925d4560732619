// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/machine.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "experiments/machine/build_info.hpp"
#include "experiments/machine/measuring.hpp"
#include "spaces/batch/batch.hpp"

namespace clipscope::experiments {
namespace {

std::string processor_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) {
      return line.substr(std::min(line.size(), line.find(':') + 2));
    }
  }
  return "unknown processor";
}

// Seconds of all processors together.
struct ProcessorTime {
  double all = 0, busy = 0, own = 0;  // own: this process and the children that it waited for
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

ProcessorTime processor_time() {
  ProcessorTime time;
  std::ifstream stat("/proc/stat");
  std::string line;
  std::getline(stat, line);
  std::istringstream fields(line.substr(std::min<std::size_t>(line.size(), 4)));
  // user nice system idle iowait irq softirq steal; what follows is part of these (proc(5)).
  double ticks = 0;
  for (int i = 0; i < 8 && fields >> ticks; ++i) {
    const double seconds = ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
    time.all += seconds;
    if (i != 3 && i != 4) time.busy += seconds;
  }
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    time.own += seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  }
  return time;
}

const ProcessorTime kAtStart = processor_time();

std::string others_text() {
  const ProcessorTime now = processor_time();
  const double all = now.all - kAtStart.all;
  const double others = (now.busy - kAtStart.busy) - (now.own - kAtStart.own);
  if (all <= 0) return "load unknown";
  return fmt::format("other programs took {:.0f} % of the processors",
                     100 * std::clamp(others / all, 0.0, 1.0));
}

std::string governor_text() {
  std::ifstream file("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  std::string governor;
  return file >> governor ? "governor " + governor : "no governor to be seen";
}

std::string class_text() {
  const MeasuringThread as_measuring;
  const int scheduler = sched_getscheduler(0);
  if (scheduler != SCHED_FIFO && scheduler != SCHED_RR) return "no real-time class";
  return scheduler == SCHED_FIFO ? "real-time class SCHED_FIFO" : "real-time class SCHED_RR";
}

std::string build_text() {
  return fmt::format("{} {}, {}; commit {}", kCompiler, kCompilerVersion, kFlags, kCommit);
}

}  // namespace

std::string machine_name() {
  return fmt::format("{}, {} processors, {}", processor_model(), sysconf(_SC_NPROCESSORS_ONLN),
                     batch::target_name());
}

std::size_t level2_cache_bytes() {
  constexpr std::size_t kUsual = 256 * 1024;
  const long bytes = sysconf(_SC_LEVEL2_CACHE_SIZE);
  return bytes > 0 ? static_cast<std::size_t>(bytes) : kUsual;
}

std::string measuring_conditions() { return fmt::format("{}, {}", governor_text(), class_text()); }

std::string machine_state() {
  const Interruptions runs = interruptions_so_far();
  return fmt::format("{}, {}{}", measuring_conditions(), others_text(),
                     runs.runs == 0 ? "" : "; " + runs.text());
}

std::string machine_description() { return fmt::format("{}; {}", machine_name(), build_text()); }

std::string timing_description() {
  return fmt::format("{}; {}; {}", machine_name(), machine_state(), build_text());
}

}  // namespace clipscope::experiments
