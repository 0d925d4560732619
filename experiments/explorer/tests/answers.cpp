// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/explorer/tests/answers.hpp"

#include <array>
#include <bit>
#include <span>
#include <string>
#include <string_view>

#include "experiments/explorer/engine/engine.hpp"
#include "experiments/explorer/tests/questions.hpp"

namespace clipscope::explorer {
namespace {

constexpr std::array<std::uint8_t, 6> kPlanesInOrder = {4, 5, 0, 1, 2, 3};
constexpr int kDistanceNumbers = 3 * 15;

// Which NaN it is, sign and payload, is the machine's affair (WebAssembly Core Specification 2.0,
// section 4.3.3, "NaN propagation"); that it is one is not.
std::uint64_t bits_of(double x) {
  return x == x ? std::bit_cast<std::uint64_t>(x) : 0x7ff8000000000000;
}

std::size_t numbers_of_steps() {
  std::size_t size = 0;
  for (std::size_t i = 0; i <= kPlanesInOrder.size(); ++i) {
    size += 1 + static_cast<std::size_t>(clipscope_results()[size]) * kVertexNumbers;
  }
  return size;
}

// Calls f(what, clipper, is_double, count, numbers) for each answer to the question asked last.
template <class F>
void for_each_answer(bool from_clip_space, F&& f) {
  const double* const results = clipscope_results();
  const auto numbers = [&](std::size_t size) { return std::span(results, size); };
  for (const bool is_double : {false, true}) {
    for (int clipper = 0; clipper < clipscope_clipper_count(); ++clipper) {
      const int count = clipscope_clip(clipper, is_double, from_clip_space);
      const auto vertices = static_cast<std::size_t>(count > 0 ? count : 0);
      f("clip", clipper, is_double, count, numbers(vertices * kVertexNumbers));
    }
    if (!from_clip_space) {
      clipscope_project(is_double);
      f("project", 0, is_double, 3, numbers(3 * kVertexNumbers));
    }
    clipscope_distances(is_double, from_clip_space);
    f("distances", 0, is_double, 3, numbers(kDistanceNumbers));
    clipscope_steps(is_double, from_clip_space, kPlanesInOrder.data(), kPlanesInOrder.size());
    f("steps", 0, is_double, 7, numbers(numbers_of_steps()));
  }
}

// Fowler, Noll and Vo's hash (FNV-1a), by words of 64 bits.
class Digest {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3;
    value_ ^= value_ >> 32;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t digest_of(std::uint32_t number) {
  const bool from_clip_space = is_clip(ask(number));
  Digest digest;
  for (const double x : std::span(clipscope_numbers(), 3 * kVertexNumbers)) digest.add(bits_of(x));
  for_each_answer(from_clip_space,
                  [&](std::string_view, int, bool, int count, std::span<const double> xs) {
                    digest.add(static_cast<std::uint64_t>(count));
                    for (const double x : xs) digest.add(bits_of(x));
                  });
  return digest.value();
}

void add_bits(std::string& text, std::span<const double> numbers) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const double x : numbers) {
    text += ' ';
    for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[bits_of(x) >> shift & 15];
  }
  text += '\n';
}

}  // namespace
}  // namespace clipscope::explorer

extern "C" {

const double* clipscope_ask(std::uint32_t number) {
  static clipscope::explorer::Setting setting;
  setting = clipscope::explorer::ask(number);
  return setting.data();
}

void clipscope_digests(std::uint32_t first, std::uint64_t* digests, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) digests[i] = clipscope::explorer::digest_of(first + i);
}

const char* clipscope_answers(std::uint32_t number) {
  using namespace clipscope::explorer;
  static std::string text;
  const Setting setting = ask(number);
  text = "setting";
  add_bits(text, setting);
  text += "triangle";
  add_bits(text, std::span(clipscope_numbers(), 3 * kVertexNumbers));
  for_each_answer(is_clip(setting), [](std::string_view what, int clipper, bool is_double,
                                       int count, std::span<const double> numbers) {
    text.append(what).append(" " + std::to_string(clipper));
    text.append(is_double ? " double " : " float ").append(std::to_string(count));
    add_bits(text, numbers);
  });
  return text.c_str();
}
}
