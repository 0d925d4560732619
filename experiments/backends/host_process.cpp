// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/host_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "experiments/drawcalls/wire.hpp"
#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kPrintedBytes = 4096;  // that are kept
constexpr double kEndingSeconds = 1;         // between closing its socket and being gone

struct SocketPair {
  Descriptor ours, theirs;
};

SocketPair open_sockets() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw GuestError(fmt::format("no socket for a driver: {}", std::strerror(errno)));
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::string file_of_host(const KnownDriver& driver) {
  const std::string file = file_beside_program(driver.host).string();
  if (!file.empty()) return file;
  throw GuestError(fmt::format("{}: {} is missing beside the program, in {}; {}", driver.name,
                               driver.host, folder_of_program().string(),
                               driver.built_with.empty()
                                   ? "building clipscope makes it"
                                   : "building clipscope makes it where Debian's packages " +
                                         driver.built_with + " are installed"));
}

int milliseconds(std::chrono::steady_clock::duration left) {
  const auto count = std::chrono::duration_cast<std::chrono::milliseconds>(left).count();
  return static_cast<int>(std::clamp<std::int64_t>(count + 1, 0, 60'000));
}

bool is_for_later() { return errno == EINTR || errno == EAGAIN || errno == EWOULDBLOCK; }

// How a process ended that waitpid tells of.
std::string end_text(int status) {
  if (WIFSIGNALED(status)) return "was ended by " + signal_text(WTERMSIG(status));
  return fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

HostProcess::HostProcess(const KnownDriver& driver) {
  if (!driver.missing.empty()) throw GuestError(driver.name + ": " + driver.missing);
  const std::string file = file_of_host(driver);
  SocketPair sockets = open_sockets();
  Pipe errors = open_pipe();
  const std::array<GivenFile, 3> files = {{{errors.write_end.number(), STDOUT_FILENO},
                                           {errors.write_end.number(), STDERR_FILENO},
                                           {sockets.theirs.number(), kHostSocket}}};
  std::vector<std::string> words = {file};
  words.insert(words.end(), driver.arguments.begin(), driver.arguments.end());
  process_ = start_process(file, std::move(words), environment_with(driver.environment), files);
  socket_ = std::move(sockets.ours);
  errors_ = std::move(errors.read_end);
  fcntl(errors_.number(), F_SETFL, O_NONBLOCK);
}

HostProcess::~HostProcess() { end(); }

bool HostProcess::send_some(std::string_view& rest) {
  const ssize_t sent =
      send(socket_.number(), rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent > 0) rest.remove_prefix(static_cast<std::size_t>(sent));
  return sent >= 0 || is_for_later();
}

// False at the end.
bool HostProcess::receive(char* to, std::size_t size, std::size_t& got) {
  const ssize_t now = recv(socket_.number(), to + got, size - got, MSG_DONTWAIT);
  if (now <= 0) return now < 0 && is_for_later();
  got += static_cast<std::size_t>(now);
  return true;
}

// False at the end, and where it is no frame.
bool HostProcess::receive_some(Frame& frame) {
  constexpr std::size_t kSize = sizeof frame.size;
  if (frame.size_got == kSize) {
    return receive(frame.bytes.data(), frame.bytes.size(), frame.bytes_got);
  }
  if (!receive(reinterpret_cast<char*>(&frame.size), kSize, frame.size_got)) return false;
  if (frame.size_got < kSize) return true;
  if (frame.size > kMostFrameBytes) return false;
  frame.bytes.resize(frame.size);
  return true;
}

void HostProcess::read_errors() {
  std::array<char, 65536> block;
  ssize_t size = 0;
  while ((size = read(errors_.number(), block.data(), block.size())) > 0) {
    printed_.append(block.data(), static_cast<std::size_t>(size));
    if (printed_.size() > kPrintedBytes) printed_.erase(0, printed_.size() - kPrintedBytes);
  }
  if (size == 0) errors_ = Descriptor();  // nobody is left who could print
}

std::variant<std::string, DrawFailure> HostProcess::answer(std::span<const char> question,
                                                           double seconds) {
  const auto limit = std::chrono::duration<double>(seconds);
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  const auto size = static_cast<std::uint32_t>(question.size());
  std::string asked;
  if (!question.empty()) asked.append(reinterpret_cast<const char*>(&size), sizeof size);
  asked.append(question.data(), question.size());
  std::string_view rest = asked;
  Frame frame;
  while (Clock::now() < deadline) {
    const auto wanted = static_cast<short>(rest.empty() ? POLLIN : POLLIN | POLLOUT);
    std::array<pollfd, 2> files = {pollfd{socket_.number(), wanted, 0},
                                   pollfd{errors_.number(), POLLIN, 0}};
    if (poll(files.data(), files.size(), milliseconds(deadline - Clock::now())) <= 0) continue;
    if (files[1].revents != 0) read_errors();
    if ((files[0].revents & POLLOUT) && !send_some(rest)) break;
    if ((files[0].revents & (POLLIN | POLLHUP)) && !receive_some(frame)) break;
    if (frame.is_whole()) return std::move(frame.bytes);
  }
  return fail(Clock::now() >= deadline, seconds);
}

// One that has closed its socket is about to end, and its exit code tells more than a kill.
DrawFailure HostProcess::fail(bool is_late, double seconds) {
  using Kind = DrawFailure::Kind;
  const auto patience = std::chrono::duration<double>(is_late ? 0 : kEndingSeconds);
  const bool ended =
      ends_before(process_, Clock::now() + std::chrono::duration_cast<Clock::duration>(patience));
  const int status = end();
  const std::string words = last_errors(printed_);
  if (ended) return {Kind::crashed, end_text(status) + words};
  if (is_late) {
    return {Kind::timed_out, fmt::format("does not answer within {:g} s{}", seconds, words)};
  }
  return {Kind::crashed, "answered with bytes that are no answer" + words};
}

DrawFailure HostProcess::fail_for_nonsense() {
  end();
  return {DrawFailure::Kind::crashed,
          "answered with bytes that are no answer" + last_errors(printed_)};
}

int HostProcess::end() {
  if (process_ < 0) return 0;
  const int status = end_group(std::exchange(process_, -1));
  read_errors();
  return status;
}

}  // namespace clipscope::experiments
