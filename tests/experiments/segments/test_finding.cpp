// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of the line clippers, and that altered rows say otherwise.
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/segments/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::segments;

namespace {

constexpr const char* kCohenSutherland = "homogeneous/cohen_sutherland";
constexpr const char* kProducts = "homogeneous/liang_barsky_division_free";

TimeRow time_row(const char* mix, const char* clipper, double ns) {
  TimeRow r{.mix = mix, .clipper = clipper, .scalar = "float"};
  r.timing = Timing{};
  r.timing->ns = {ns, ns, ns};
  return r;
}

std::vector<OperationsRow> operations() {
  const auto row = [](const char* mix, const char* clipper) {
    OperationsRow r;
    r.mix = mix;
    r.clipper = clipper;
    return r;
  };
  OperationsRow window = row("window_1_64", kCohenSutherland);
  window.rejected_free_percent = 95;
  OperationsRow cohen = row("cross_several", kCohenSutherland);
  cohen.divisions_per_shortened = 2.6;
  cohen.moved_ends_per_shortened = 1.9;
  OperationsRow products = row("cross_several", kProducts);
  products.divisions_per_shortened = 1.9;
  return {window, cohen, products};
}

ConvexRow convex_row(std::int64_t edges, const char* method, double ns) {
  ConvexRow row{.edges = edges, .method = method, .timing = Timing{}};
  row.timing->ns = {ns, ns, ns};
  return row;
}

std::string checked(const std::string& text) {
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

}  // namespace

TEST_CASE("segments: the finding names who is the fastest on most mixes") {
  std::vector<TimeRow> times = {time_row("a", kCohenSutherland, 1), time_row("a", kProducts, 2),
                                time_row("b", kCohenSutherland, 1), time_row("b", kProducts, 2),
                                time_row("c", kCohenSutherland, 2), time_row("c", kProducts, 1)};
  CHECK(checked(finding(times, {})) ==
        "Cohen-Sutherland in clip space is the fastest line clipper in float on 2 of 3 mixes.");
  times[0].timing.reset();
  times[2].timing->ns.median = 5;
  CHECK(
      checked(finding(times, {})) ==
      "Liang-Barsky by products in clip space is the fastest line clipper in float on all mixes.");
  CHECK(checked(finding({}, {})) == "No line clipper was timed.");
}

TEST_CASE("segments: the finding says what Cohen-Sutherland saves and what it wastes") {
  std::vector<OperationsRow> counted = operations();
  CHECK(
      checked(finding({}, counted)) ==
      "No line clipper was timed. Cohen-Sutherland rejects nearly all invisible lines without an intersection where the window is small; where several planes cut, it computes more intersections than it moves ends, unlike Liang-Barsky by products.");
  counted[0].rejected_free_percent = 10;
  counted[1].divisions_per_shortened = 1.9;
  CHECK(
      checked(finding({}, counted)) ==
      "No line clipper was timed. Cohen-Sutherland rejects few invisible lines without an intersection where the window is small; where several planes cut, it computes no more intersections than it moves ends, like Liang-Barsky by products.");
}

TEST_CASE("segments: the finding says whether right answers cost time") {
  std::vector<SegmentFrontierRow> rows(2);
  rows[0] = {.clipper = kCohenSutherland, .scalar = "float", .hard_wrong_percent = 5};
  rows[1] = {.clipper = kProducts, .scalar = "double", .hard_wrong_percent = 2};
  for (SegmentFrontierRow& row : rows) row.standing = Standing::frontier;
  CHECK(
      checked(frontier_finding(rows).substr(1)) ==
      "From view space on Cohen-Sutherland in clip space in float is the fastest and Liang-Barsky by products in clip space in double least often wrong on hard segments.");
  rows[1].standing = Standing::dominated;
  rows[0].hard_wrong_percent = 0;
  CHECK(
      checked(frontier_finding(rows).substr(1)) ==
      "Cohen-Sutherland in clip space in float is both the fastest from view space on and always right on hard segments.");
  CHECK(frontier_finding({}).empty());
}

TEST_CASE("segments: the finding says whether the number of edges decides in a convex window") {
  std::vector<ConvexRow> rows = {
      convex_row(4, "convex/pruning", 5), convex_row(4, "convex/skala_logarithmic", 10),
      convex_row(1024, "convex/pruning", 50), convex_row(1024, "convex/skala_logarithmic", 20)};
  CHECK(
      checked(convex_finding(rows).substr(1)) ==
      "In a convex window pruning is the fastest with few edges and Skala's logarithmic clipper with many.");
  rows[3].timing->ns.median = 60;
  CHECK(checked(convex_finding(rows).substr(1)) ==
        "In a convex window pruning is the fastest, however many edges it has.");
  CHECK(convex_finding({}).empty());
}
