// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time that can be believed: the one clock of the project.
//
// Inputs are prepared before. Each task's answer is checked first, and one that breaks its promise
// is not timed. Then the tasks run in turn, round after round, each once per round; a slow one does
// a share of its work, a quick one its work several times over. From the rounds come the median
// time per item with its 95 % interval and, round by round, the ratio to the baseline's time in
// that same round, so that a drift of the machine's speed cancels.
//
// Every round has an order of its own, drawn from a seed: in a rotation each task has the same one
// before it for ever, and with it what that one leaves in the caches. What tasks leave there is a
// matter of the experiment, which has to choose: tasks whose input shall come from memory go on
// where the one before them, whoever that was, has stopped (stage/stage_timing.hpp); tasks whose
// input shall be in cache take the same one in all rounds, or touch it in `prepare`
// (survey/contest_clock.hpp, cost/growth.cpp).
//
// The thread keeps to one processor, where that is allowed, and is in the real-time class where the
// user asked for it (machine/measuring.hpp). A run that loses the processor all the same does not
// count and is done again after the others of its round, up to kMostRepeats times; if it loses it
// each time, the last one counts, so that rounds stay whole, and the timing says how many did.
//
// Time is spent where it decides something. After kLeastRounds rounds, once, a contender that is
// out of the race leaves it: one that has a rival, at most as inaccurate in every measure, of which
// the interval times `far` ends below its own. Its figures are of the rounds that it got, ratios of
// the same rounds of the baseline. Whether it leaves depends on nothing that is looked at again, so
// that intervals stay honest; kLeastRounds are what a 95 % interval by order statistics needs for
// not being the whole range of its samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/table/row.hpp"
#include "experiments/table/statistics.hpp"

namespace clipscope::experiments {

struct Task {
  // Does this share of the work (above 1: so many times all of it); the number of items it did.
  std::function<std::size_t(double share)> work;
  // What is wrong with the answer; empty if nothing is.
  std::function<std::string()> check;
  // Makes ready for the work before each run, and cleans up after it, off the clock; null where
  // nothing is to be done.
  std::function<void()> prepare = nullptr, finish = nullptr;
  // The clock chooses the share between these, so that a run takes about as long as it should.
  double least_share = 1, most_share = 1;
  // Of a contender, measures of how inaccurate its answers are, as many for all; none: as much as
  // those of others. Who is none, such as a pass over memory, gets all rounds and is no rival.
  std::optional<std::vector<double>> inaccuracy = {};
  // How often those that do the work have lost their processor so far; null: the calling thread
  // does it, and its involuntary context switches are counted.
  std::function<std::int64_t()> interruptions = nullptr;
};

inline constexpr std::size_t kLeastRounds = 9;
inline constexpr std::int64_t kMostRepeats = 3;  // of one run in one round

inline constexpr double kRepeated = std::numeric_limits<double>::infinity();  // as most_share

// The check of a task that answers nothing, such as a pass over memory.
inline std::string nothing_to_check() { return ""; }

struct ClockOptions {
  int rounds = 25;
  double milliseconds_per_run = 2.0;      // a task's part of a round
  std::optional<std::size_t> baseline{};  // the task that ratios refer to; gets all rounds
  double far = 10;                        // times as slow as a rival: out of the race
  std::uint64_t seed = 1;                 // of the order in each round
};

struct Timing {
  MedianInterval ns;                      // per item
  std::optional<MedianInterval> speedup;  // the baseline's time over this one's: above 1 is faster
  std::vector<double> samples_ns;         // one per round that it got
  std::int64_t rounds = 0;                // as many
  std::int64_t redone = 0;                // runs that lost the processor and were done again
  std::int64_t disturbed = 0;             // rounds whose run lost it each time
  std::string refused;                    // why it was not timed; then the rest is empty

  bool is_timed() const { return refused.empty(); }

  // item: what is counted; baseline: the name of who ratios refer to, and how a heading has it.
  static constexpr auto columns(std::string_view key = "ns_per_triangle",
                                std::string_view head = "ns/tri",
                                std::string_view speedup_key = "speedup_to_textbook",
                                std::string_view speedup_head = "x textbook") {
    return std::tuple(interval(key, "ns", head, &Timing::ns),
                      interval(speedup_key, "speedup", speedup_head, &Timing::speedup),
                      column("rounds", &Timing::rounds));
  }
};

// As the cells of a row: empty for a task that was not timed.
inline std::optional<Timing> if_timed(const Timing& timing) {
  return timing.is_timed() ? std::optional(timing) : std::nullopt;
}

// One timing per task, in their order. Its runs count among those of machine/measuring.hpp.
std::vector<Timing> time_in_turn(std::span<const Task> tasks, const ClockOptions& options);

// Round by round, one over the other, of the rounds that both got.
std::vector<double> ratios(std::span<const double> numerators,
                           std::span<const double> denominators);

}  // namespace clipscope::experiments
