// SPDX-License-Identifier: GPL-3.0-or-later
//
// HostProcess: one life of a process that has a driver in it, seen from the program.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "experiments/backends/known_drivers.hpp"
#include "experiments/guests/child.hpp"

namespace clipscope::experiments {

class HostProcess {
 public:
  // Errors: GuestError if the host is not built or does not start.
  explicit HostProcess(const KnownDriver& driver);
  ~HostProcess();
  HostProcess(const HostProcess&) = delete;
  HostProcess& operator=(const HostProcess&) = delete;

  // Sends a frame and returns the one that answers it. Without a question: the greeting. Or why
  // there is no answer, after which the process has ended.
  std::variant<std::string, DrawFailure> answer(std::span<const char> question, double seconds);

  // Ends it for an answer that is none.
  DrawFailure fail_for_nonsense();

 private:
  using Clock = std::chrono::steady_clock;
  // As far as it has come.
  struct Frame {
    std::uint32_t size = 0;
    std::string bytes = {};  // of that size, once it is known
    std::size_t size_got = 0, bytes_got = 0;

    bool is_whole() const { return size_got == sizeof size && bytes_got == bytes.size(); }
  };

  bool send_some(std::string_view& rest);
  bool receive(char* to, std::size_t size, std::size_t& got);
  bool receive_some(Frame& frame);
  void read_errors();
  DrawFailure fail(bool is_late, double seconds);
  int end();

  Descriptor socket_, errors_;
  pid_t process_ = -1;
  std::string printed_ = {};  // the last of it
};

}  // namespace clipscope::experiments
