// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <bit>

#include "experiments/cost/growth.hpp"
#include "experiments/cost/thread_team.hpp"
#include "spaces/planes.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const GrowthOptions kSmall{
    .seed = 1,
    .soup = 2000,
    .most = 10'000,
    .attribute_soup = 300,
    .crossing = 8,
    .timing = {.rounds = 3, .milliseconds_per_run = 0.05, .check = {.triangles = 300, .exact = 4}}};

}  // namespace

TEST_CASE("growth: crossing triangles cross exactly so many planes, and each comes as often") {
  for (int planes = 1; planes <= kPlanes; ++planes) {
    const StageInput input = crossing_input(planes, 6, 3, 1);
    REQUIRE(input.array_size() > 0);
    CHECK(input.array_size() % 3 == 0);
    for (std::size_t t = 0; t < input.array_size(); ++t) {
      Outcode all = ~Outcode{0}, any = 0;
      for (std::size_t v = 0; v < 3; ++v) {
        const float* p = input.vertex(StageContract::copy, t, v);
        const Outcode code = clip_outcode(input.volume.depth, Vec4<float>(p[0], p[1], p[2], p[3]));
        all &= code;
        any |= code;
      }
      CHECK(all == 0);
      CHECK(std::popcount(any) == planes);
    }
  }
}

TEST_CASE("growth: triangles grow tenfold, and beyond the soup it streams through again") {
  std::vector<std::int64_t> sizes;
  for (const GrowthPoint& p : measure_growth(Growing::triangles, kSmall)) {
    REQUIRE(p.timing.refused.empty());
    if (sizes.empty() || sizes.back() != p.n) sizes.push_back(p.n);
    CHECK(p.triangles >= static_cast<double>(p.n));
    CHECK(p.timing.ns.median > 0);
    CHECK_FALSE((p.clipper == "textbook" && p.n > 2000));
  }
  CHECK(sizes == std::vector<std::int64_t>{1000, 10'000});
}

TEST_CASE(
    "growth: each of the others has a point per step for the textbook and the batch clippers") {
  const auto steps = [](Growing growing) { return measure_growth(growing, kSmall).size() / 5; };
  CHECK(steps(Growing::attributes) == 7);
  CHECK(steps(Growing::planes) == 6);
  CHECK(steps(Growing::threads) == 2);
}

TEST_CASE("thread team: every thread does its part in each run") {
  std::array<std::atomic<int>, 3> done{};
  ThreadTeam team(3);
  for (int i = 0; i < 4; ++i) {
    CHECK(team.run([&](std::size_t thread) { ++done[thread]; }) > 0);
  }
  for (const auto& times : done) CHECK(times == 4);
}
