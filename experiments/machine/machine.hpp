// SPDX-License-Identifier: GPL-3.0-or-later
//
// The machine that a timing was measured on, and the hold on one of its processors.
#pragma once

#include <ctime>
#include <fmt/chrono.h>
#include <sched.h>
#include <string>

namespace clipscope::experiments {

// One line: processor, compiler and version, flags, commit.
std::string machine_description();

// Keeps the calling thread on the processor that it runs on while the object lives.
class PinnedThread {
 public:
  PinnedThread();
  ~PinnedThread();
  PinnedThread(const PinnedThread&) = delete;
  PinnedThread& operator=(const PinnedThread&) = delete;

  // False where the system does not allow it.
  bool pinned() const { return pinned_; }

 private:
  cpu_set_t before_;
  bool pinned_ = false;
};

// Dates in UTC: "2026-03-01T12:34:56Z" (ISO 8601).
inline std::string date_of(std::time_t time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(time));
}

inline std::string date_now() { return date_of(std::time(nullptr)); }

}  // namespace clipscope::experiments
