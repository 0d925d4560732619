// SPDX-License-Identifier: GPL-3.0-or-later
//
// The engine's answers to random questions, as this machine computes them, for same_bits.mjs.
//
//   clipscope_explorer_answers FIRST COUNT   the digests of so many questions, 8 bytes each
//   clipscope_explorer_answers NUMBER        the answers to one, as text
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "experiments/explorer/tests/answers.hpp"

namespace {

// Errors: returns false if it is no number.
bool read(const char* text, std::uint32_t& number) {
  const char* const end = text + std::strlen(text);
  return std::from_chars(text, end, number) == std::from_chars_result{end, std::errc{}};
}

}  // namespace

int main(int count, char** arguments) {
  std::uint32_t first = 0, size = 0;
  if (count < 2 || count > 3 || !read(arguments[1], first) ||
      (count == 3 && !read(arguments[2], size))) {
    std::fputs("usage: clipscope_explorer_answers FIRST COUNT | NUMBER\n", stderr);
    return 2;
  }
  if (count == 2) return std::fputs(clipscope_answers(first), stdout) < 0 ? 1 : 0;
  std::vector<std::uint64_t> digests(size);
  clipscope_digests(first, digests.data(), size);
  return std::fwrite(digests.data(), sizeof(std::uint64_t), size, stdout) == size ? 0 : 1;
}
