// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/clock/thread_team.hpp"

#include <array>
#include <atomic>
#include <sched.h>
#include <set>
#include <thread>

#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("thread team: every thread does its part in each run") {
  std::array<std::atomic<int>, 3> done{};
  ThreadTeam team(3);
  for (int i = 0; i < 4; ++i) team.run([&](std::size_t thread) { ++done[thread]; });
  CHECK(team.size() == 3);
  for (const auto& times : done) CHECK(times == 4);
}

TEST_CASE("thread team: the threads keep to different processors while there are enough") {
  const std::vector<int> processors = allowed_processors();
  ThreadTeam team(processors.size());
  std::vector<int> seen(team.size());
  team.run([&](std::size_t thread) { seen[thread] = sched_getcpu(); });
  CHECK(std::set(seen.begin(), seen.end()).size() == processors.size());
}

TEST_CASE("thread team: it notices that one of its threads lost its processor") {
  ThreadTeam team(1);
  const std::int64_t before = team.interruptions();
  std::atomic<bool> done = false;
  std::thread rival([&] {
    const MeasuringThread beside(allowed_processors().front());
    while (!done) continue;
  });
  team.run([](std::size_t) {
    volatile double sum = 0;
    for (int i = 0; i < 50'000'000; ++i) sum = sum + i;
  });
  done = true;
  rival.join();
  CHECK(team.interruptions() > before);
}
