// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contest of segments against convex polygons.
#include <cmath>

#include "experiments/segments/convex_windows.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::segments;

namespace {

const ContestClock kBrief{.rounds = 5, .milliseconds_per_run = 0.05, .checked = 64};

ConvexRow row(std::int64_t edges, const char* method, double ns) {
  ConvexRow r{.edges = edges, .method = method};
  r.timing = Timing{};
  r.timing->ns = {ns, ns, ns};
  r.timing->speedup = MedianInterval{10 / ns, 10 / ns, 10 / ns};
  return r;
}

}  // namespace

TEST_CASE("convex windows: regular, counter-clockwise and strictly convex, in float too") {
  for (const int edges : kConvexEdges) {
    INFO(edges);
    const auto v = make_convex_case(edges, 0, 1).vertices;
    REQUIRE(v.size() == static_cast<std::size_t>(edges));
    bool convex = true;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Vec2<double> a(v[i]), b(v[(i + 1) % v.size()]), c(v[(i + 2) % v.size()]);
      const Vec2<double> first = b - a, second = c - b;
      convex = convex && first[0] * second[1] - first[1] * second[0] > 0;
      CHECK(std::hypot(first[0], first[1]) == Approx(2 * std::sin(M_PI / edges)).epsilon(1e-4));
    }
    CHECK(convex);
  }
}

TEST_CASE("convex windows: a seed gives the same segments again, another seed gives others") {
  const auto first = make_convex_case(8, 20, 5).segments;
  CHECK(first == make_convex_case(8, 20, 5).segments);
  CHECK(first != make_convex_case(8, 20, 6).segments);
  for (const Segment2<float>& s : first) {
    for (const Vec2<float>& p : s) CHECK(std::max(std::abs(p[0]), std::abs(p[1])) <= 2);
  }
}

TEST_CASE("convex windows: every method is judged, timed against Cyrus-Beck, and counted") {
  for (const int edges : {4, 128}) {
    const std::vector<ConvexRow> rows =
        measure_convex(make_convex_case(edges, 400, 2), 200, kBrief);
    REQUIRE(rows.size() > 2);
    for (const ConvexRow& r : rows) {
      INFO(r.method << " of " << edges);
      CHECK(r.edges == edges);
      CHECK(r.visible == rows.front().visible);
      CHECK(r.visible > 20);
      CHECK(r.lost + r.drawn == 0);
      CHECK(r.max_px > 0);
      CHECK(r.max_px < 1);
      REQUIRE(r.timing);
      CHECK(r.timing->ns.low > 0);
      REQUIRE(r.timing->speedup);
      const bool asks_each = r.method == "convex/cyrus_beck" || r.method == "convex/pruning";
      CHECK(r.divisions <= (asks_each ? edges : 4));
    }
    CHECK(rows.front().method == "convex/cyrus_beck");
    CHECK(rows.front().divisions == edges);
    CHECK(rows.front().timing->speedup->median == 1);
  }
}

TEST_CASE("convex windows: the plot is made from rows alone") {
  std::vector<ConvexRow> rows = {row(4, "slow", 10), row(4, "quick", 5), row(1024, "slow", 1),
                                 row(1024, "quick", 2)};
  rows[2].timing.reset();
  const Plot plot = convex_plot(rows);
  REQUIRE(plot.series.size() == 2);
  CHECK(plot.series[0].name == "slow");
  CHECK(plot.series[0].x == std::vector<double>{4});
  CHECK(plot.series[1].x == std::vector<double>{4, 1024});
  CHECK(plot.series[1].y == std::vector<double>{5, 2});
  CHECK(convex_plot({}).series.empty());
}
