// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of the papers, and that altered rows say otherwise.
#include "experiments/history/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::history {
namespace {

Row row(const char* clipper, Field field, double speedup, double right_percent) {
  Row r;
  r.year = 1978;
  r.clipper = clipper;
  r.field = field;
  r.speedup = speedup;
  r.hard_right_percent = right_percent;
  return r;
}

std::vector<Row> measured() {
  return {row("window/cohen_sutherland", Field::plane, 1, 80),
          row("window/cyrus_beck", Field::plane, 1.5, 70),
          row("homogeneous/sutherland_hodgman", Field::triangles, 1, 90),
          row("homogeneous/blinn_newell", Field::triangles, 0.5, 95)};
}

std::string checked_finding(const std::vector<Row>& rows) {
  const std::string text = finding(rows);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

TEST_CASE("history: the finding says in which fields papers brought speed, and at what price") {
  std::vector<Row> rows = measured();
  CHECK(
      checked_finding(rows) ==
      "Published methods are faster than the usual one for segments in the plane, but not for triangles; the largest gain is that of Cyrus-Beck in the window (1978), 1.5 times as fast for segments in the plane. On hard cases it is right less often than the usual one. None of them is right on every hard case in float.");
  rows[1].speedup = 0.9;
  rows[3].speedup = 3;
  CHECK(
      checked_finding(rows) ==
      "Published methods are faster than the usual one for triangles, but not for segments in the plane; the largest gain is that of Blinn-Newell (1978), 3 times as fast for triangles. On hard cases it is right more often than the usual one. None of them is right on every hard case in float.");
}

TEST_CASE("history: without a gain the finding says so, and names who is always right") {
  std::vector<Row> rows = measured();
  rows[1].speedup = 1.01;
  rows[3].hard_right_percent = 100;
  CHECK(
      checked_finding(rows) ==
      "No published method is faster than the usual one for segments in the plane and triangles. Right on every hard case in float is Blinn-Newell.");
  for (Row& r : rows) r.hard_right_percent = 100;
  CHECK(checked_finding(rows).ends_with("Four of them are right on every hard case in float."));
}

TEST_CASE("history: a method that was not timed is not spoken of") {
  std::vector<Row> rows = measured();
  rows[1].speedup.reset();
  CHECK(checked_finding(rows).starts_with("No published method is faster"));
  CHECK(checked_finding({}) == "No published method was timed in float.");
}

}  // namespace
}  // namespace clipscope::experiments::history
