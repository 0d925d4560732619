// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of the catalogue, and that altered rows say otherwise.
#include "experiments/hard_cases/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

SummaryRow row(const char* clipper, const char* scalar, std::int64_t cases, std::int64_t failures) {
  return {Primitive::triangle, clipper, scalar, cases, failures, 0, ""};
}

std::string checked_finding(const std::vector<SummaryRow>& rows) {
  const std::string text = finding(rows);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

TEST_CASE("hard cases: the finding compares shares of the cases that a clipper takes") {
  std::vector<SummaryRow> rows = {row("view/sutherland_hodgman", "float", 40, 4),
                                  row("homogeneous/sutherland_hodgman", "float", 200, 10),
                                  row("cvv/near_first", "float", 200, 60)};
  CHECK(
      checked_finding(rows) ==
      "In float clip space gets the fewest hard triangles wrong, 5.00 % of those that it takes, and dividing behind a near cut the most, 30.0 %. View space lies between them.");
  rows[1].failures = 100;
  CHECK(
      checked_finding(rows) ==
      "In float view space gets the fewest hard triangles wrong, 10.0 % of those that it takes, and clip space the most, 50.0 %. Dividing behind a near cut lies between them.");
}

TEST_CASE("hard cases: the finding says whom exact arithmetic does not mend") {
  std::vector<SummaryRow> rows = {row("homogeneous/sutherland_hodgman", "float", 200, 10),
                                  row("barycentric/correctly_rounded", "float", 200, 0),
                                  row("homogeneous/sutherland_hodgman", "exact", 200, 0),
                                  row("cvv/perspective", "exact", 200, 50)};
  CHECK(
      checked_finding(rows) ==
      "In float 5.00 % of the hard triangles are wrong with clip space. The correctly rounded clipper gets none wrong. More digits do not mend dividing first, wrong in exact arithmetic, too.");
  rows[1].failures = 1;
  rows[3].failures = 0;
  CHECK(
      checked_finding(rows) ==
      "In float 5.00 % of the hard triangles are wrong with clip space. The correctly rounded clipper gets some wrong, too. In exact arithmetic none of these clippers gets any wrong.");
}

TEST_CASE("hard cases: the finding says so where no usual clipper was asked") {
  CHECK(checked_finding({row("textbook", "float", 9, 4)}) ==
        "No usual clipper was asked about hard triangles in float.");
  SummaryRow segment = row("cvv/perspective", "float", 9, 4);
  segment.primitive = Primitive::segment;
  CHECK(checked_finding({segment}) == "No usual clipper was asked about hard triangles in float.");
}

}  // namespace
}  // namespace clipscope::experiments::hard_cases
