// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>
#include <utility>

#include "experiments/clock/clock.hpp"
#include "experiments/machine/measuring.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

// Takes so many steps for its whole work, of 100 items.
Task counting(int steps, double least = 1, double most = 1) {
  return {.work =
              [=](double share) {
                volatile double sum = 0;
                for (int i = 0; i < steps * share; ++i) sum = sum + i;
                return static_cast<std::size_t>(100 * share);
              },
          .check = nothing_to_check,
          .least_share = least,
          .most_share = most};
}

constexpr ClockOptions kFew{.rounds = 7, .milliseconds_per_run = 0.2, .baseline = 0};

}  // namespace

TEST_CASE("clock: each task has one sample per round, a sane interval, and its ratio") {
  const std::vector<Task> tasks = {counting(20000), counting(200000)};
  const std::vector<Timing> timings = time_in_turn(tasks, kFew);
  REQUIRE(timings.size() == 2);
  for (const Timing& t : timings) {
    CHECK(t.is_timed());
    CHECK(t.samples_ns.size() == 7);
    CHECK(t.ns.low > 0);
    CHECK(t.ns.low <= t.ns.median);
    CHECK(t.ns.median <= t.ns.high);
  }
  CHECK(timings[0].speedup.value().median == 1);
  CHECK(timings[1].speedup.value().median < 0.5);
}

TEST_CASE("clock: a task whose answer is wrong is not timed, and the others are") {
  int runs = 0;
  Task wrong = counting(1000);
  wrong.work = [&](double) -> std::size_t { return ++runs; };
  wrong.check = [] { return "it is wrong"; };
  const std::vector<Timing> timings = time_in_turn(std::vector{counting(1000), wrong}, kFew);
  CHECK(timings[0].is_timed());
  CHECK(timings[1].refused == "it is wrong");
  CHECK(timings[1].samples_ns.empty());
  CHECK(runs == 0);
}

TEST_CASE("clock: without its baseline a task has a time and no ratio") {
  Task wrong = counting(1000);
  wrong.check = [] { return "it is wrong"; };
  const std::vector<Timing> timings = time_in_turn(std::vector{wrong, counting(1000)}, kFew);
  CHECK(timings[1].is_timed());
  CHECK_FALSE(timings[1].speedup);
}

TEST_CASE("clock: a run that is held up while the share is chosen makes it no smaller") {
  std::vector<double> shares;
  Task task = counting(200000, 0.001, 1);
  const auto work = task.work;
  task.work = [&](double share) {
    shares.push_back(share);
    if (shares.size() == 2) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return work(share);
  };
  time_in_turn(std::vector{task}, kFew);
  CHECK(shares.back() > 10 * 0.001);
}

TEST_CASE("clock: a slow task does a share of its work, a quick one its work several times") {
  std::vector<double> shares;
  const auto noted = [&](Task task) {
    return Task{.work =
                    [&shares, task](double share) {
                      shares.push_back(share);
                      return task.work(share);
                    },
                .check = nothing_to_check,
                .least_share = task.least_share,
                .most_share = task.most_share};
  };
  time_in_turn(std::vector{noted(counting(50'000'000, 0.001))}, kFew);
  CHECK(shares.back() < 0.5);
  CHECK(shares.back() >= 0.001);
  time_in_turn(std::vector{noted(counting(100, 1, kRepeated))}, kFew);
  CHECK(shares.back() > 1);
  CHECK(shares.back() == std::floor(shares.back()));
}

namespace {

constexpr std::size_t kTasks = 5, kManyRounds = 40;

// Who ran when, the warm runs left out.
std::vector<std::size_t> order_of_turns(std::uint64_t seed) {
  std::vector<std::size_t> order;
  std::vector<Task> tasks(kTasks);
  for (std::size_t i = 0; i < kTasks; ++i) {
    tasks[i] = {.work = [&order, i](double) -> std::size_t {
                  order.push_back(i);
                  return 1;
                },
                .check = nothing_to_check,
                .interruptions = [] { return 0; }};
  }
  time_in_turn(tasks, {.rounds = kManyRounds, .seed = seed});
  order.erase(order.begin(), order.begin() + kTasks);
  return order;
}

}  // namespace

TEST_CASE("clock: each task runs once in every round") {
  const std::vector<std::size_t> order = order_of_turns(1);
  REQUIRE(order.size() == kTasks * kManyRounds);
  for (std::size_t first = 0; first < order.size(); first += kTasks) {
    const auto round = order.begin() + static_cast<std::ptrdiff_t>(first);
    CHECK(std::set(round, round + kTasks).size() == kTasks);
  }
}

TEST_CASE("clock: every task has each of the others before it in some round") {
  const std::vector<std::size_t> order = order_of_turns(1);
  std::set<std::pair<std::size_t, std::size_t>> neighbours;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i - 1] != order[i]) neighbours.insert({order[i - 1], order[i]});
  }
  CHECK(neighbours.size() == kTasks * (kTasks - 1));
}

TEST_CASE("clock: the order of turns is that of the seed") {
  CHECK(order_of_turns(1) == order_of_turns(1));
  CHECK(order_of_turns(1) != order_of_turns(2));
}

namespace {

// Loses the processor in those of its runs that are named, counted from 0; the warm run is one.
// Says what it was told in each run.
struct Unlucky {
  std::set<int> runs_hit;
  int runs = 0, hits = 0;

  Task task() {
    return {.work = [this](double) -> std::size_t {
              hits += runs_hit.contains(runs);
              ++runs;
              return 1;
            },
            .check = nothing_to_check,
            .interruptions = [this] { return hits; }};
  }
};

Task lucky() {
  return {.work = [](double) -> std::size_t { return 1; },
          .check = nothing_to_check,
          .interruptions = [] { return 0; }};
}

}  // namespace

TEST_CASE("clock: a run that lost the processor is done again in its round and does not count") {
  Unlucky unlucky{{1, 2, 5}};
  const Interruptions before = interruptions_so_far();
  const auto timings = time_in_turn(std::vector{unlucky.task(), lucky()}, {.rounds = 6});
  CHECK(unlucky.runs == 1 + 6 + 3);
  CHECK(timings[0].rounds == 6);
  CHECK(timings[0].samples_ns.size() == 6);
  CHECK(timings[0].redone == 3);
  CHECK(timings[0].disturbed == 0);
  CHECK(timings[1].redone == 0);
  const Interruptions runs = interruptions_so_far() - before;
  CHECK(runs.runs == 15);
  CHECK(runs.redone == 3);
  CHECK(runs.disturbed == 0);
}

TEST_CASE(
    "clock: who loses the processor again and again counts at last, so that rounds are whole") {
  Unlucky unlucky{{1, 2, 3, 4}};  // of the first round
  const Interruptions before = interruptions_so_far();
  const auto timings = time_in_turn(std::vector{unlucky.task(), lucky()}, {.rounds = 2});
  CHECK(timings[0].redone == kMostRepeats);
  CHECK(timings[0].disturbed == 1);
  CHECK(timings[0].samples_ns.size() == timings[1].samples_ns.size());
  CHECK((interruptions_so_far() - before).is_busy());
}

TEST_CASE("clock: a task that competes for its processor is noticed") {
  const MeasuringThread here;
  if (!here.pinned()) return;
  std::atomic<bool> done = false;
  std::thread rival([&] {  // on the same processor, by inheritance
    while (!done) continue;
  });
  const Task yielding = {.work = [](double) -> std::size_t {
                           std::this_thread::yield();
                           return 1;
                         },
                         .check = nothing_to_check};
  // Long enough for the scheduler to give the rival its turn.
  const Task long_one = counting(30'000'000);
  const auto timings = time_in_turn(std::vector{yielding, long_one}, {.rounds = 3});
  done = true;
  rival.join();
  for (const Timing& t : timings) CHECK(t.redone + t.disturbed > 0);
}

namespace {

// A contender whose run takes so many times as long as that of 1.
Task contender(double slower, std::vector<double> inaccuracy = {}) {
  Task task = counting(static_cast<int>(20000 * slower));
  task.inaccuracy = std::move(inaccuracy);
  return task;
}

std::vector<std::int64_t> rounds_of(const std::vector<Task>& tasks,
                                    std::optional<std::size_t> baseline = {}) {
  std::vector<std::int64_t> rounds;
  const ClockOptions options{
      .rounds = 15, .milliseconds_per_run = .1, .baseline = baseline, .far = 4};
  for (const Timing& t : time_in_turn(tasks, options)) {
    CHECK(t.samples_ns.size() == static_cast<std::size_t>(t.rounds));
    rounds.push_back(t.rounds);
  }
  return rounds;
}

constexpr std::int64_t kFewest = kLeastRounds;

}  // namespace

TEST_CASE("clock: a contender far slower than another leaves the race after the least rounds") {
  CHECK(rounds_of({contender(1), contender(40), contender(1.2)}) ==
        std::vector<std::int64_t>{15, kFewest, 15});
}

TEST_CASE("clock: a contender stays in the race while every rival is less accurate in something") {
  CHECK(rounds_of({contender(1, {2, 5}), contender(40, {3, 4})}) ==
        std::vector<std::int64_t>{15, 15});
  CHECK(rounds_of({contender(1, {2, 4}), contender(40, {3, 4})}) ==
        std::vector<std::int64_t>{15, kFewest});
}

TEST_CASE("clock: the baseline and who is no contender get all rounds and drive nobody out") {
  CHECK(rounds_of({contender(40), contender(1)}, 0) == std::vector<std::int64_t>{15, 15});
  CHECK(rounds_of({counting(20000), contender(40), counting(800000)}) ==
        std::vector<std::int64_t>{15, 15, 15});
}

TEST_CASE("clock: who left the race has its ratio from the rounds that it got") {
  const ClockOptions options{.rounds = 15, .milliseconds_per_run = .1, .baseline = 0};
  const auto timings = time_in_turn(std::vector{contender(1), contender(100)}, options);
  CHECK(timings[1].rounds == kFewest);
  CHECK(timings[1].speedup.value().median < 0.1);
}

TEST_CASE("clock: the least rounds leave a 95 % interval inside of the range of the samples") {
  std::vector<double> samples;
  for (std::size_t i = 0; i < kLeastRounds; ++i) samples.push_back(static_cast<double>(i));
  const MedianInterval interval = median_interval(samples);
  CHECK(interval.low > samples.front());
  CHECK(interval.high < samples.back());
}

TEST_CASE("clock: ratios are formed sample by sample, of the rounds that both have") {
  CHECK(ratios(std::vector{6.0, 8.0, 9.0}, std::vector{2.0, 4.0}) == std::vector{3.0, 2.0});
  CHECK(ratios(std::vector{2.0, 9.0}, std::vector{1.0, 3.0}) == std::vector{2.0, 3.0});
}
