// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <thread>

#include "experiments/machine/errors.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::string_view name_of_variable(std::string_view variable) {
  return variable.substr(0, variable.find('='));
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

Pipe open_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw GuestError(fmt::format("no process can be started: pipe: {}", std::strerror(errno)));
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::vector<std::string> environment_with(std::span<const std::string> environment,
                                          std::string_view hidden) {
  std::vector<std::string> all(environment.begin(), environment.end());
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view name = name_of_variable(*variable);
    const bool is_replaced = std::ranges::any_of(
        environment, [&](const std::string& given) { return name_of_variable(given) == name; });
    const bool is_hidden = !hidden.empty() && name.starts_with(hidden);
    if (!is_replaced && !is_hidden) all.emplace_back(*variable);
  }
  return all;
}

pid_t start_process(const std::string& program, std::vector<std::string> words,
                    std::vector<std::string> environment, std::span<const GivenFile> files) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const GivenFile& file : files) {
    posix_spawn_file_actions_adddup2(&actions, file.ours, file.number);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int error = posix_spawn(&process, program.c_str(), &actions, &attributes,
                                pointers_to(words).data(), pointers_to(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return process;
  throw GuestError(fmt::format("{} does not start: {}", program, std::strerror(error)));
}

bool ends_before(pid_t process, std::chrono::steady_clock::time_point deadline) {
  while (true) {
    siginfo_t info{};
    const int flags = WEXITED | WNOWAIT | WNOHANG;
    if (waitid(P_PID, static_cast<id_t>(process), &info, flags) == 0 && info.si_pid == process) {
      return true;
    }
    if (std::chrono::steady_clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

int end_group(pid_t process) {
  kill(-process, SIGKILL);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

std::string signal_text(int number) {
  const char* name = sigabbrev_np(number);
  return name == nullptr ? fmt::format("signal {}", number) : fmt::format("SIG{}", name);
}

std::string last_words(std::string_view printed) {
  constexpr std::size_t kLines = 3, kMostBytes = 300;
  std::vector<std::string> lines;
  std::istringstream text{std::string(printed)};
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

std::string last_errors(std::string_view printed) {
  const std::string words = last_words(printed);
  return words.empty() ? "" : fmt::format(" (standard error: {})", words);
}

std::filesystem::path folder_of_program() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
}

std::filesystem::path file_beside_program(const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path program = folder_of_program();
  std::error_code ignored;
  for (const fs::path& folder :
       {program, program / CLIPSCOPE_INSTALLED_FOLDER, fs::path(CLIPSCOPE_BUILT_FOLDER)}) {
    if (fs::exists(folder / name, ignored)) return folder / name;
  }
  return {};
}

}  // namespace clipscope::experiments
