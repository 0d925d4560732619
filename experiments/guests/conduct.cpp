// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/conduct.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "experiments/contestants/same_bits.hpp"
#include "experiments/guests/plugin_runner.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kTimesInThreads = 8;
constexpr unsigned char kOneByte = 0x00, kOtherByte = 0xff;  // the other one makes NaNs

std::pair<std::size_t, std::size_t> vertices_of(const Batch& batch, std::size_t i) {
  const auto n = static_cast<std::size_t>(batch.vertices);
  if (n > 0) return {n * i, n * (i + 1)};
  return {i == 0 ? 0 : batch.ends[i - 1], batch.ends[i]};
}

// The batch from its last primitive to its first, and the numbers that it refers to.
class Reversed {
 public:
  explicit Reversed(const Batch& batch) : batch_(batch), numbers_(reversed_numbers(batch)) {
    std::size_t end = 0;
    for (std::size_t i = batch.size(); i-- > 0;) {
      const auto [first, behind] = vertices_of(batch, i);
      ends_.push_back(end += behind - first);
    }
    batch_.numbers = std::span<const double>(numbers_);
    if (batch.vertices == 0) batch_.ends = ends_;
  }
  Reversed(const Reversed&) = delete;
  Reversed& operator=(const Reversed&) = delete;

  const Batch& batch() const { return batch_; }

 private:
  Batch batch_;
  std::vector<double> numbers_;
  std::vector<std::size_t> ends_;
};

// What was found so far, by primitive.
class Findings {
 public:
  explicit Findings(const Answers& expected) : expected_(expected) {}

  // `other` has the answer to primitive i at place(i); or to the first ones alone.
  template <class Place>
  void compare(const Answers& other, std::string_view reason, const Place& place) {
    for (std::size_t i = 0; i < other.size(); ++i) {
      if (!has_same_bits(expected_[i], other[place(i)])) found_.emplace(i, reason);
    }
  }
  // What stays in its output as it was found there differs with that, and with nothing else.
  void compare_filled(const Answers& one, const Answers& other, const Answers& one_again) {
    for (std::size_t i = 0; i < expected_.size(); ++i) {
      if (has_same_bits(one[i], other[i]) || !has_same_bits(one[i], one_again[i])) continue;
      found_.emplace(i, "leaves numbers as they were before, in its output");
    }
  }
  void compare(const Answers& other, std::string_view reason) {
    compare(other, reason, [](std::size_t i) { return i; });
  }

  std::vector<Misconduct> all() const {
    std::vector<Misconduct> list;
    for (const auto& [primitive, reason] : found_) list.push_back({primitive, std::string(reason)});
    return list;
  }

 private:
  const Answers& expected_;
  std::map<std::size_t, std::string_view> found_;
};

Answers answers_of(Runner& runner, std::size_t count) {
  runner.clip(0, 0, count);
  return runner.answers();
}

Answers filled_answers(PluginRunner& runner, unsigned char byte, std::size_t count) {
  runner.fill_output(byte);
  return answers_of(runner, count);
}

void ask_in_threads(PluginRunner& runner, std::size_t count, Findings& findings) {
  for (int i = 0; i < kTimesInThreads; ++i) {
    const Answers second = runner.clip_twice(0, 0, count), first = runner.answers();
    findings.compare(first, "answers otherwise in two threads at once");
    findings.compare(second, "answers otherwise in two threads at once");
  }
}

}  // namespace

std::vector<double> reversed_numbers(const Batch& batch) {
  std::vector<double> numbers;
  for (std::size_t i = batch.size(); i-- > 0;) {
    const auto [first, end] = vertices_of(batch, i);
    for (std::size_t n = first * batch.stride(); n < end * batch.stride(); ++n) {
      numbers.push_back(batch.number(n));
    }
  }
  return numbers;
}

std::vector<Misconduct> conduct(const Contestant& contestant, const Batch& batch,
                                const Answers& given) {
  const std::size_t count = batch.size();
  if (count == 0) return {};
  const std::unique_ptr<Runner> runner = contestant.prepare(std::span(&batch, 1));
  auto* const plugin = dynamic_cast<PluginRunner*>(&runner->worker());
  // Of a plug-in that was prepared for it; a program is started anew for each question.
  const Answers expected = plugin != nullptr ? answers_of(*runner, count) : given;
  Findings findings(expected);
  if (plugin != nullptr) {
    const Answers one = filled_answers(*plugin, kOneByte, count);
    const Answers other = filled_answers(*plugin, kOtherByte, count);
    findings.compare_filled(one, other, filled_answers(*plugin, kOneByte, count));
  }
  findings.compare(answers_of(*runner, count), "answers otherwise when it is asked again");
  if (count > 1) {
    const Reversed reversed(batch);
    findings.compare(clip(contestant, reversed.batch()), "answers otherwise in another order",
                     [&](std::size_t i) { return count - 1 - i; });
  }
  if (plugin == nullptr) return findings.all();
  plugin->start_anew();
  findings.compare(answers_of(*plugin, count), "answers otherwise in a fresh process");
  if (plugin->is_thread_safe()) ask_in_threads(*plugin, std::min(count, kMostAtOnce), findings);
  return findings.all();
}

}  // namespace clipscope::experiments
