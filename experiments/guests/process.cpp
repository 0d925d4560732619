// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "experiments/guests/child.hpp"
#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLastErrors = 4096;  // bytes of standard error that are kept

[[noreturn]] void refuse_to_start(const char* what) {
  throw GuestError(fmt::format("no process can be started: {}: {}", what, std::strerror(errno)));
}

// An open file that holds the text, from its beginning on.
Descriptor file_of(std::string_view text) {
  Descriptor file(memfd_create("input", MFD_CLOEXEC));
  if (!file.is_open()) refuse_to_start("memfd_create");
  while (!text.empty()) {
    const ssize_t written = write(file.number(), text.data(), text.size());
    if (written < 0 && errno != EINTR) refuse_to_start("its input can't be written");
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  lseek(file.number(), 0, SEEK_SET);
  return file;
}

// Ends it even where we are gone: the clock on the wall is ours, that of the processor is not.
void limit_processor_time(pid_t process, double seconds) {
  const double most = seconds * std::max(1u, std::thread::hardware_concurrency()) + 10;
  rlimit limit{};
  limit.rlim_cur = limit.rlim_max = static_cast<rlim_t>(most);
  prlimit(process, RLIMIT_CPU, &limit, nullptr);
}

int milliseconds_until(Clock::time_point deadline) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left + 1, 0, 60'000));
}

// Adds what is there to read; false at the end.
bool read_some(const Descriptor& from, std::string& text) {
  std::array<char, 65536> block;
  const ssize_t size = read(from.number(), block.data(), block.size());
  if (size > 0) text.append(block.data(), static_cast<std::size_t>(size));
  return size > 0 || (size < 0 && errno == EINTR);
}

// Reads both pipes to their ends, or to a limit.
void read_pipes(const Descriptor& output, const Descriptor& errors, const ProcessLimits& limits,
                Clock::time_point deadline, ProcessResult& result) {
  std::array<pollfd, 2> open = {pollfd{output.number(), POLLIN, 0},
                                pollfd{errors.number(), POLLIN, 0}};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    const int ready = poll(open.data(), open.size(), milliseconds_until(deadline));
    if (Clock::now() >= deadline) {
      result.end = ProcessResult::End::timed_out;
      return;
    }
    if (ready <= 0) continue;
    if (open[0].revents != 0 && !read_some(output, result.output)) open[0].fd = -1;
    if (open[1].revents != 0 && !read_some(errors, result.errors)) open[1].fd = -1;
    if (result.errors.size() > kLastErrors) {
      result.errors.erase(0, result.errors.size() - kLastErrors);
    }
    if (result.output.size() > limits.most_output) {
      result.end = ProcessResult::End::too_much_output;
      return;
    }
  }
}

// Ends what is left of its group, and says how the process itself ended.
void finish(pid_t process, ProcessResult& result) {
  const int status = end_group(process);
  if (result.end != ProcessResult::End::exited) return;
  constexpr int kShellSignal = 128;  // a shell's exit code for a signal that killed its command
  if (WIFSIGNALED(status)) {
    result.end = ProcessResult::End::killed;
    result.code = WTERMSIG(status);
  } else if (WEXITSTATUS(status) > kShellSignal && WEXITSTATUS(status) <= kShellSignal + SIGSYS) {
    result.end = ProcessResult::End::killed;
    result.code = WEXITSTATUS(status) - kShellSignal;
  } else {
    result.code = WEXITSTATUS(status);
  }
}

}  // namespace

ProcessResult run_process(const std::string& command, std::string_view input,
                          std::span<const std::string> environment, std::string_view hidden,
                          const ProcessLimits& limits) {
  const Descriptor file = file_of(input);
  Pipe output = open_pipe(), errors = open_pipe();
  const auto allowed = std::chrono::duration<double>(limits.seconds);
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(allowed);
  const std::array<GivenFile, 3> files = {{{file.number(), STDIN_FILENO},
                                           {output.write_end.number(), STDOUT_FILENO},
                                           {errors.write_end.number(), STDERR_FILENO}}};
  const pid_t process =
      start_process("/bin/sh", {"sh", "-c", command}, environment_with(environment, hidden), files);
  limit_processor_time(process, limits.seconds);
  output.write_end = Descriptor();  // so that the pipes end where the process does
  errors.write_end = Descriptor();
  ProcessResult result;
  read_pipes(output.read_end, errors.read_end, limits, deadline, result);
  if (result.end == ProcessResult::End::exited && !ends_before(process, deadline)) {
    result.end = ProcessResult::End::timed_out;
  }
  finish(process, result);
  return result;
}

}  // namespace clipscope::experiments
