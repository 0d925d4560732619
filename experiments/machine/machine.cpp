// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/machine.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
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
  return measuring_conditions() + (runs.runs == 0 ? "" : "; " + runs.text());
}

std::string machine_description() { return fmt::format("{}; {}", machine_name(), build_text()); }

std::string timing_description() {
  return fmt::format("{}; {}; {}", machine_name(), machine_state(), build_text());
}

}  // namespace clipscope::experiments
