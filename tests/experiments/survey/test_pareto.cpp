// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Pareto frontier on points small enough to judge by eye.
#include <limits>
#include <random>

#include "experiments/survey/pareto.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

FrontierPoint point(double time, double error, double spread = 0) {
  return {{time, time - spread, time + spread}, error};
}

std::vector<bool> on_frontier(const std::vector<FrontierPoint>& points) {
  std::vector<bool> on;
  for (const FrontierRank& rank : pareto_frontier(points)) {
    on.push_back(rank.standing == Standing::frontier);
  }
  return on;
}

}  // namespace

TEST_CASE("pareto: who is slower and less accurate than one other is dominated, by name") {
  const std::vector<FrontierPoint> points = {point(1, 5), point(2, 1), point(3, 2), point(4, 0)};
  CHECK(on_frontier(points) == std::vector{true, true, false, true});
  CHECK(pareto_frontier(points)[2].dominated_by == 1u);
  CHECK_FALSE(pareto_frontier(points)[0].dominated_by);
}

TEST_CASE("pareto: equal points are both on the frontier") {
  CHECK(on_frontier({point(1, 1), point(1, 1)}) == std::vector{true, true});
}

TEST_CASE("pareto: of the same error the slower is dominated only if the intervals are apart") {
  CHECK(on_frontier({point(10, 1, 0.4), point(11, 1, 0.4)}) == std::vector{true, false});
  CHECK(on_frontier({point(10, 1, 0.5), point(11, 1, 0.5)}) == std::vector{true, true});
  CHECK(on_frontier({point(10, 1, 2), point(11, 1, 2)}) == std::vector{true, true});
}

TEST_CASE("pareto: a smaller error dominates at the same median, whatever the intervals") {
  CHECK(on_frontier({point(10, 2, 3), point(10, 1, 3)}) == std::vector{false, true});
}

TEST_CASE("pareto: a lower median keeps one on the frontier though the intervals overlap") {
  CHECK(on_frontier({point(9.9, 2, 3), point(10, 1, 3)}) == std::vector{true, true});
}

TEST_CASE("pareto: without a time or with a NaN for an error nobody is ranked nor dominates") {
  const std::vector<FrontierPoint> points = {point(kNan, 0), point(1, kNan), point(kInfinity, 0),
                                             point(5, 5)};
  const auto ranks = pareto_frontier(points);
  CHECK(ranks[0].standing == Standing::unranked);
  CHECK(ranks[1].standing == Standing::unranked);
  CHECK(ranks[2].standing == Standing::unranked);
  CHECK(ranks[3].standing == Standing::frontier);
}

TEST_CASE("pareto: an infinite error takes part, and the fastest with it is on the frontier") {
  CHECK(on_frontier({point(1, kInfinity), point(2, kInfinity), point(3, 0)}) ==
        std::vector{true, false, true});
}

TEST_CASE("pareto: no points, no ranks; one point is the frontier") {
  CHECK(pareto_frontier({}).empty());
  CHECK(on_frontier({point(1, 1)}) == std::vector{true});
}

TEST_CASE("pareto: the dominator named is the fastest member of the frontier that dominates") {
  const std::vector<FrontierPoint> points = {point(9, 9), point(3, 1), point(2, 8), point(8, 8)};
  const auto ranks = pareto_frontier(points);
  CHECK(ranks[0].dominated_by == 2u);
  CHECK(ranks[3].dominated_by == 2u);
}

TEST_CASE("pareto: of random points each dominated one is dominated by a member, no member is") {
  std::mt19937_64 generator(7);
  for (int repetition = 0; repetition < 200; ++repetition) {
    std::vector<FrontierPoint> points;
    for (int i = 0; i < 25; ++i) {
      points.push_back(point(static_cast<double>(generator() % 8 + 1),
                             static_cast<double>(generator() % 6),
                             static_cast<double>(generator() % 4)));
    }
    const auto ranks = pareto_frontier(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool beaten = std::any_of(points.begin(), points.end(), [&](const FrontierPoint& p) {
        return dominates(p, points[i]);
      });
      REQUIRE(beaten == (ranks[i].standing == Standing::dominated));
      if (!beaten) continue;
      REQUIRE(ranks[i].dominated_by);
      REQUIRE(ranks[*ranks[i].dominated_by].standing == Standing::frontier);
      REQUIRE(dominates(points[*ranks[i].dominated_by], points[i]));
    }
  }
}

TEST_CASE("pareto: dominance is transitive, and nobody dominates himself") {
  std::vector<FrontierPoint> points;
  for (const double time : {1.0, 2.0, 3.0}) {
    for (const double error : {0.0, 1.0, 2.0}) {
      for (const double spread : {0.0, 0.5, 1.5}) points.push_back(point(time, error, spread));
    }
  }
  for (const FrontierPoint& a : points) {
    CHECK_FALSE(dominates(a, a));
    for (const FrontierPoint& b : points) {
      for (const FrontierPoint& c : points) {
        if (dominates(a, b) && dominates(b, c)) REQUIRE(dominates(a, c));
      }
    }
  }
}

TEST_CASE("pareto: steps go from the fastest on, each with a smaller error, one for each error") {
  const std::vector<FrontierPoint> points = {point(4, 0, 1), point(1, 5), point(3.5, 0, 1),
                                             point(2, 1), point(6, 3)};
  const auto ranks = pareto_frontier(points);
  CHECK(frontier_steps(points, ranks) == std::vector<std::size_t>{1, 3, 2});
}
