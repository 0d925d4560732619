// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/clock/thread_team.hpp"

#include <array>
#include <atomic>

#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("thread team: every thread does its part in each run") {
  std::array<std::atomic<int>, 3> done{};
  ThreadTeam team(3);
  for (int i = 0; i < 4; ++i) team.run([&](std::size_t thread) { ++done[thread]; });
  CHECK(team.size() == 3);
  for (const auto& times : done) CHECK(times == 4);
}
