// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <spawn.h>
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
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/machine/errors.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLastErrors = 4096;  // bytes of standard error that are kept

[[noreturn]] void refuse_to_start(const char* what) {
  throw GuestError(fmt::format("no process can be started: {}: {}", what, std::strerror(errno)));
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

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

struct Pipe {
  Descriptor read_end, write_end;
};

// Closed in every process that is started but where it is given a number of its own.
Pipe open_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse_to_start("pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::vector<std::string> environment_with(std::span<const std::string> ours,
                                          std::string_view hidden) {
  std::vector<std::string> all(ours.begin(), ours.end());
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (!std::string_view(*variable).starts_with(hidden)) all.emplace_back(*variable);
  }
  return all;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Leads a process group of its own, so that all of it can be ended.
pid_t start(const std::string& command, std::vector<std::string> environment, int input, int output,
            int errors) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> words = {"sh", "-c", command};
  pid_t process = 0;
  const int error = posix_spawn(&process, "/bin/sh", &actions, &attributes,
                                pointers_to(words).data(), pointers_to(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return process;
  errno = error;
  refuse_to_start("/bin/sh");
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

// Whether it ended in time; it can still be waited for. It has closed its pipes, so it ends now or,
// most likely, not at all.
bool has_ended(pid_t process, Clock::time_point deadline) {
  while (true) {
    siginfo_t info{};
    const int flags = WEXITED | WNOWAIT | WNOHANG;
    if (waitid(P_PID, static_cast<id_t>(process), &info, flags) == 0 && info.si_pid == process) {
      return true;
    }
    if (Clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

// Ends what is left of its group, and says how the process itself ended.
void finish(pid_t process, ProcessResult& result) {
  kill(-process, SIGKILL);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
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
  const pid_t process = start(command, environment_with(environment, hidden), file.number(),
                              output.write_end.number(), errors.write_end.number());
  limit_processor_time(process, limits.seconds);
  output.write_end = Descriptor(-1);  // so that the pipes end where the process does
  errors.write_end = Descriptor(-1);
  ProcessResult result;
  read_pipes(output.read_end, errors.read_end, limits, deadline, result);
  if (result.end == ProcessResult::End::exited && !has_ended(process, deadline)) {
    result.end = ProcessResult::End::timed_out;
  }
  finish(process, result);
  return result;
}

std::string last_words(const std::string& printed) {
  constexpr std::size_t kLines = 3, kMostBytes = 300;
  std::vector<std::string> lines;
  std::istringstream text(printed);
  for (std::string line; std::getline(text, line);) {
    line.erase(0, line.find_first_not_of(" \t\r"));
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool only_marks_a_place = line.find_first_not_of(" ^~") == std::string::npos;
    if (!only_marks_a_place) lines.push_back(visible_utf8(line));
  }
  if (lines.size() > kLines) {
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kLines));
  }
  std::string words = fmt::format("{}", fmt::join(lines, " | "));
  if (words.size() > kMostBytes) {
    words = "..." + valid_utf8(words.substr(words.size() - kMostBytes), "");
  }
  return words;
}

}  // namespace clipscope::experiments
