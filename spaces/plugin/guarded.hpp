// SPDX-License-Identifier: MIT
//
// Memory of a file between two stretches of addresses that nobody can access: what reaches beyond
// either end is caught at once, if what is used ends where the memory ends.
#pragma once

#include <cstddef>

namespace clipscope::plugin {

enum class Place { elsewhere, before, inside, after };

class Guarded {
 public:
  Guarded() = default;
  // All of the file: bytes, whole pages. Begins and ends at null where the system refuses.
  Guarded(int file, std::size_t bytes, bool can_write);
  ~Guarded();
  Guarded(Guarded&& other) noexcept { *this = static_cast<Guarded&&>(other); }
  Guarded& operator=(Guarded&& other) noexcept;

  unsigned char* begin() const { return begin_; }
  unsigned char* end() const { return begin_ + bytes_; }
  std::size_t size() const { return bytes_; }
  Place place_of(const void* address) const;

 private:
  unsigned char* begin_ = nullptr;
  std::size_t bytes_ = 0;
};

// Memory that is written here and read, but not written, elsewhere in the same process.
class TwoFaced {
 public:
  // Grows, if it has to; what was there is lost. Whether it worked.
  bool reserve(std::size_t bytes);
  // The last so many bytes of it, as they are written and as they are read.
  void* last_to_write(std::size_t bytes) const { return written_.end() - bytes; }
  const void* last_to_read(std::size_t bytes) const { return read_.end() - bytes; }
  const Guarded& read() const { return read_; }

 private:
  Guarded written_, read_;
};

std::size_t whole_pages(std::size_t bytes);
// A file in memory, without a name; -1 where the system refuses.
int memory_file(std::size_t bytes);

}  // namespace clipscope::plugin
