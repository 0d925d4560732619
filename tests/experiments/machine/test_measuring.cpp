// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/measuring.hpp"

#include <ctime>
#include <thread>

#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("measuring: a thread keeps to one processor and is freed again") {
  cpu_set_t before, after;
  REQUIRE(sched_getaffinity(0, sizeof before, &before) == 0);
  {
    const MeasuringThread measuring;
    cpu_set_t during;
    REQUIRE(sched_getaffinity(0, sizeof during, &during) == 0);
    if (measuring.pinned()) CHECK(CPU_COUNT(&during) == 1);
  }
  REQUIRE(sched_getaffinity(0, sizeof after, &after) == 0);
  CHECK(CPU_EQUAL(&before, &after));
}

TEST_CASE("measuring: a thread is put on the processor that it is given") {
  for (const int processor : allowed_processors()) {
    const MeasuringThread measuring(processor);
    if (measuring.pinned()) CHECK(allowed_processors() == std::vector{processor});
  }
}

TEST_CASE("measuring: in real time a thread has the class while it measures, or is told why not") {
  const int before = sched_getscheduler(0);
  try {
    measure_in_real_time();
    CHECK(sched_getscheduler(0) == before);
    {
      const MeasuringThread measuring;
      CHECK(sched_getscheduler(0) == SCHED_FIFO);
    }
    CHECK(sched_getscheduler(0) == before);
  } catch (const UsageError& refused) {
    CHECK(std::string(refused.what()).find("rtprio") != std::string::npos);
  }
}

TEST_CASE("measuring: who gives up the processor by itself was not interrupted") {
  const std::int64_t before = involuntary_switches();
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK(involuntary_switches() - before <= 1);  // one by chance
}

TEST_CASE(
    "measuring: a machine is busy where others took more than a tenth of runs or processors") {
  CHECK_FALSE(Interruptions{}.is_busy());
  CHECK_FALSE(Interruptions{.runs = 100, .redone = 10}.is_busy());
  CHECK(Interruptions{.runs = 100, .redone = 6, .disturbed = 5}.is_busy());
  CHECK_FALSE(Interruptions{.runs = 100, .seconds = 10, .others_seconds = 1}.is_busy());
  CHECK(Interruptions{.runs = 100, .seconds = 10, .others_seconds = 1.1}.is_busy());
  CHECK(busy_text({.runs = 100, .redone = 10}).empty());
  CHECK(busy_text({.runs = 100, .redone = 30}).find("busy") != std::string::npos);
}

TEST_CASE("measuring: what was interrupted is said in words") {
  CHECK(Interruptions{.runs = 7}.text() == "none of 7 runs under the clock lost the processor");
  CHECK(Interruptions{.runs = 100, .redone = 3}.text() ==
        "3 of 100 runs under the clock lost the processor and were done again");
  CHECK(Interruptions{.runs = 100, .redone = 3, .disturbed = 1}.text() ==
        "4 of 100 runs under the clock lost the processor: 3 done again, 1 kept all the same");
}

TEST_CASE(
    "measuring: what others took of the processors and what we did is not more than there is") {
  const ProcessorTime before = processor_time();
  if (before.all == 0) return;  // the system doesn't say
  const std::clock_t start = std::clock();
  volatile double sum = 0;
  for (int i = 0; i < 100'000'000; ++i) sum = sum + i;
  const double own = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const ProcessorTime after = processor_time();
  constexpr double kTicks = 0.1;  // that the system may count late, in seconds
  CHECK(own > 0);
  CHECK(after.others - before.others <= after.all - before.all - own + kTicks);
  CHECK(after.others - before.others >= -kTicks);
}

TEST_CASE("measuring: runs add up, and what came later is the difference") {
  const Interruptions a{1, 2, 3, 4, 1}, b{10, 20, 30, 40, 10};
  CHECK(a + b == Interruptions{11, 22, 33, 44, 11});
  CHECK((a + b) - a == b);
  const Interruptions before = interruptions_so_far();
  count_runs(a);
  CHECK(interruptions_so_far() - before == a);
}
