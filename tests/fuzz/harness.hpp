// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the fuzzing harnesses share. A harness is a function of bytes that anybody may have made:
// whatever they are, it returns, unless it found something (Finding) or the code under it crashed.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "experiments/machine/errors.hpp"

namespace clipscope::fuzz {

using Bytes = std::span<const std::uint8_t>;

// What should never be. Nothing catches it: libFuzzer keeps the bytes that led to it.
struct Finding : std::logic_error {
  using std::logic_error::logic_error;
};

template <class... Args>
void require(bool holds, fmt::format_string<Args...> message, Args&&... args) {
  if (!holds) throw Finding(fmt::format(message, std::forward<Args>(args)...));
}

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Does the work on input that may be refused. The refusal must be an error that tells a person
// something.
template <class Work>
void read_or_refuse(Work&& work) {
  try {
    work();
  } catch (const experiments::InputError& error) {
    require(*error.what() != '\0', "the input was refused without a word");
  }
}

// Takes values off the front of bytes, and zeros once they are used up.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_arithmetic_v<T> T take() {
    T value{};
    const std::size_t size = std::min(sizeof value, bytes_.size());
    std::memcpy(&value, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return value;
  }
  // From 0 to count - 1.
  int below(int count) { return take<std::uint8_t>() % count; }
  Bytes rest() const { return bytes_; }

 private:
  Bytes bytes_;
};

// The harnesses; tests/fuzz/corpus has a folder of inputs for each.
void obj(Bytes bytes);
void ply(Bytes bytes);
void stl(Bytes bytes);
void gltf(Bytes bytes);
void clip_text(Bytes bytes);
void cases(Bytes bytes);
void store(Bytes bytes);
void clip_space(Bytes bytes);
void view_space(Bytes bytes);
void batches(Bytes bytes);
void plugin(Bytes bytes);
void program(Bytes bytes);

}  // namespace clipscope::fuzz
