// SPDX-License-Identifier: MIT
#include "spaces/plugin/guarded.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <utility>

namespace clipscope::plugin {
namespace {

// Of addresses, not of memory. A stride that misses it is a wild one.
constexpr std::size_t kGuard = std::size_t{1} << 20;

}  // namespace

Guarded::Guarded(int file, std::size_t bytes, bool can_write) {
  void* all = mmap(nullptr, bytes + 2 * kGuard, PROT_NONE,
                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (all == MAP_FAILED) return;
  unsigned char* begin = static_cast<unsigned char*>(all) + kGuard;
  const int access = can_write ? PROT_READ | PROT_WRITE : PROT_READ;
  if (mmap(begin, bytes, access, MAP_SHARED | MAP_FIXED, file, 0) == MAP_FAILED) {
    munmap(all, bytes + 2 * kGuard);
    return;
  }
  begin_ = begin;
  bytes_ = bytes;
}

Guarded::~Guarded() {
  if (begin_ != nullptr) munmap(begin_ - kGuard, bytes_ + 2 * kGuard);
}

Guarded& Guarded::operator=(Guarded&& other) noexcept {
  std::swap(begin_, other.begin_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

Place Guarded::place_of(const void* address) const {
  if (begin_ == nullptr) return Place::elsewhere;
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  const auto begin = reinterpret_cast<std::uintptr_t>(begin_);
  if (at < begin - kGuard || at >= begin + bytes_ + kGuard) return Place::elsewhere;
  if (at < begin) return Place::before;
  return at < begin + bytes_ ? Place::inside : Place::after;
}

bool TwoFaced::reserve(std::size_t bytes) {
  if (bytes <= read_.size()) return true;
  bytes = whole_pages(bytes);
  const int file = memory_file(bytes);
  if (file < 0) return false;
  written_ = Guarded(file, bytes, true);
  read_ = Guarded(file, bytes, false);
  close(file);
  return written_.begin() != nullptr && read_.begin() != nullptr;
}

std::size_t whole_pages(std::size_t bytes) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return (bytes + page - 1) / page * page;
}

int memory_file(std::size_t bytes) {
  const int file = memfd_create("clipscope", MFD_CLOEXEC);
  if (file < 0) return -1;
  if (ftruncate(file, static_cast<off_t>(bytes)) == 0) return file;
  close(file);
  return -1;
}

}  // namespace clipscope::plugin
