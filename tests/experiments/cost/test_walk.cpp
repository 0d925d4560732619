// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/walk.hpp"

#include <set>
#include <utility>
#include <vector>

#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::cost;

namespace {

using Calls = std::vector<std::pair<std::size_t, std::size_t>>;  // first, count

// The calls of one run.
Calls run(Walk& walk, const Load& load) {
  Calls calls;
  walk = walk.over(load,
                   [&](std::size_t first, std::size_t count) { calls.emplace_back(first, count); });
  return calls;
}

}  // namespace

TEST_CASE("walk: a run of small lists has other triangles than the run before it") {
  Walk walk{.first = 0, .size = 10'000};
  std::set<std::size_t> firsts;
  for (int i = 0; i < 5; ++i) {
    for (const auto& [first, count] : run(walk, {.list = 1000, .total = 2000})) {
      CHECK(count == 1000);
      firsts.insert(first);
    }
  }
  CHECK(firsts.size() == 10);
  CHECK(run(walk, {.list = 1000, .total = 1000}) == Calls{{0, 1000}});  // it was gone through
}

TEST_CASE("walk: a long list comes in calls that end with it") {
  Walk walk{.first = 0, .size = 100'000};
  const Calls calls = run(walk, {.list = 10'000, .total = 20'000});
  const std::size_t rest = 10'000 - 2 * kStageBlock;
  CHECK(calls == Calls{{0, kStageBlock},
                       {kStageBlock, kStageBlock},
                       {2 * kStageBlock, rest},
                       {10'000, kStageBlock},
                       {10'000 + kStageBlock, kStageBlock},
                       {10'000 + 2 * kStageBlock, rest}});
}

TEST_CASE("walk: a list longer than the part goes through it again and again") {
  Walk walk{.first = 500, .size = 3000};
  CHECK(run(walk, {.list = 8000, .total = 8000}) == Calls{{500, 3000}, {500, 3000}, {500, 2000}});
  CHECK(walk.next == 2000);
}
