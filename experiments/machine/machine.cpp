// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <sched.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "experiments/machine/build_info.hpp"
#include "experiments/machine/machine.hpp"

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

}  // namespace

std::string machine_description() {
  return fmt::format("{}, {} processors; {} {}, {}; commit {}", processor_model(),
                     sysconf(_SC_NPROCESSORS_ONLN), kCompiler, kCompilerVersion, kFlags, kCommit);
}

PinnedThread::PinnedThread() {
  CPU_ZERO(&before_);
  if (sched_getaffinity(0, sizeof before_, &before_) != 0) return;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  pinned_ = sched_setaffinity(0, sizeof one, &one) == 0;
}

PinnedThread::~PinnedThread() {
  if (pinned_) sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace clipscope::experiments
