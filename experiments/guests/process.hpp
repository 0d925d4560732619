// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of a command line in a process of its own: text in, text out, within limits.
//
// The command gets its whole input as a file that is open already (memfd_create), so that it may
// read as it likes and nobody waits for anybody. What it starts in turn ends with it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace clipscope::experiments {

struct ProcessLimits {
  double seconds = 10;                // until it has ended and closed its output
  std::size_t most_output = 1 << 20;  // bytes on standard output
};

struct ProcessResult {
  enum class End { exited, killed, timed_out, too_much_output };
  End end = End::exited;
  int code = 0;        // exit code, or the signal that killed it
  std::string output;  // all of standard output
  std::string errors;  // the last of standard error, 4 KiB at most

  bool succeeded() const { return end == End::exited && code == 0; }
};

// Runs `/bin/sh -c command` in the working directory. environment: "NAME=value" that it has besides
// ours; ours whose name begins with `hidden` it does not have. May be called by several threads at
// once. Errors: GuestError if no process can be started.
ProcessResult run_process(const std::string& command, std::string_view input,
                          std::span<const std::string> environment, std::string_view hidden,
                          const ProcessLimits& limits);

// The last three lines that say something of what a process printed: "a | b | c", made visible,
// 300 bytes at most; empty if there are none.
std::string last_words(const std::string& printed);

}  // namespace clipscope::experiments
