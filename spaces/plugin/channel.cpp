// SPDX-License-Identifier: MIT
#include "spaces/plugin/channel.hpp"

#include <linux/futex.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

#include <climits>
#include <cmath>
#include <cstring>

namespace clipscope::plugin {
namespace {

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
static_assert(sizeof(std::atomic<std::uint32_t>) == sizeof(std::uint32_t));

double now_us() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

bool comes_while_awake(const Turn& turn, std::uint32_t number, double microseconds) {
  const double start = now_us();
  do {
    for (int i = 0; i < 16; ++i) {
      if (turn.number.load(std::memory_order_acquire) == number) return true;
      relax();
    }
  } while (now_us() - start < microseconds);
  return false;
}

// As long as the word has that value, or so many microseconds.
void sleep_on(Turn& turn, std::uint32_t value, double microseconds) {
  const double seconds = std::floor(microseconds * 1e-6);
  const timespec most{static_cast<time_t>(seconds),
                      static_cast<long>((microseconds - seconds * 1e6) * 1e3)};
  syscall(SYS_futex, &turn.number, FUTEX_WAIT, value, &most, nullptr, 0);
}

}  // namespace

void pass(Turn& turn, std::uint32_t number) {
  turn.number.store(number);
  if (turn.is_slept_on.load() != 0) {
    syscall(SYS_futex, &turn.number, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
  }
}

bool await(Turn& turn, std::uint32_t number, const Patience& patience) {
  if (turn.number.load(std::memory_order_acquire) == number) return true;
  if (patience.awake_us > 0 && comes_while_awake(turn, number, patience.awake_us)) return true;
  const double end = now_us() + patience.seconds * 1e6;
  turn.is_slept_on.store(1);
  std::uint32_t seen = turn.number.load();
  for (double left = patience.seconds * 1e6; seen != number && left > 0; left = end - now_us()) {
    sleep_on(turn, seen, left);
    seen = turn.number.load();
  }
  turn.is_slept_on.store(0);
  return seen == number;
}

namespace {

// A message with room for one file descriptor beside it.
struct Envelope {
  explicit Envelope(AreaMessage& message) {
    part = {&message, sizeof message};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    header.msg_control = beside;
    header.msg_controllen = sizeof beside;
  }
  iovec part{};
  alignas(cmsghdr) char beside[CMSG_SPACE(sizeof(int))] = {};
  msghdr header{};
};

}  // namespace

bool send_area(int socket, const AreaMessage& message, int file) {
  AreaMessage copy = message;
  Envelope envelope(copy);
  cmsghdr* beside = CMSG_FIRSTHDR(&envelope.header);
  beside->cmsg_level = SOL_SOCKET;
  beside->cmsg_type = SCM_RIGHTS;
  beside->cmsg_len = CMSG_LEN(sizeof file);
  std::memcpy(CMSG_DATA(beside), &file, sizeof file);
  return sendmsg(socket, &envelope.header, MSG_NOSIGNAL) == static_cast<ssize_t>(sizeof copy);
}

bool receive_area(int socket, AreaMessage& message, int& file) {
  Envelope envelope(message);
  if (recvmsg(socket, &envelope.header, MSG_CMSG_CLOEXEC) != static_cast<ssize_t>(sizeof message)) {
    return false;
  }
  const cmsghdr* beside = CMSG_FIRSTHDR(&envelope.header);
  if (beside == nullptr || beside->cmsg_type != SCM_RIGHTS) return false;
  std::memcpy(&file, CMSG_DATA(beside), sizeof file);
  return true;
}

void copy_text(const char* from, Text& to) {
  to = {};
  if (from != nullptr) std::strncpy(to.data(), from, to.size() - 1);
}

}  // namespace clipscope::plugin
