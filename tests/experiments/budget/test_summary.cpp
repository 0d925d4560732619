// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/budget/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::budget;

namespace {

// Medians and largest errors of the parts, in the order of kParts.
std::vector<Row> rows_of_clipper(const std::string& clipper, std::array<Spread, 5> px) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    rows.push_back({"a scene", clipper, "float", kParts[i], px[i], px[i], 10, 0});
  }
  return rows;
}

const std::vector<Row> kRows = rows_of_clipper(
    "textbook", {Spread{1, 8}, Spread{2, 6}, Spread{0, 1}, Spread{1, 1}, Spread{3, 9}});

}  // namespace

TEST_CASE("budget: the finding names the largest part in the median and at the most") {
  CHECK(
      finding(kRows) ==
      "On a scene in float the largest part of the median error comes from the transform for every clipper: with the textbook clipper it is 2.00 of 3.00 px. The largest part of the greatest error comes from rounding the matrix for every clipper.");
  std::vector<Row> rows = kRows;
  const std::vector<Row> more = rows_of_clipper(
      "view/sutherland_hodgman", {Spread{0, 1}, Spread{1, 2}, Spread{3, 9}, Spread{0, 1}, {}});
  rows.insert(rows.end(), more.begin(), more.end());
  const std::string text = finding(rows);
  CHECK(faults_of_prose(text).empty());
  CHECK(
      text ==
      "On a scene in float the largest part of the median error comes from the transform for the textbook clipper, and the cut for view space: with the textbook clipper it is 2.00 of 3.00 px. The largest part of the greatest error comes from rounding the matrix for the textbook clipper, and the cut for view space.");
}

TEST_CASE("budget: the finding says so where nothing has a budget") {
  CHECK(finding({}) == "No contestant has a budget: only float and double round.");
  CHECK(finding({{"a scene", "textbook", "float", Part::total, {}, {}, 0, 10}}) ==
        "Nothing on a scene has a budget.");
}

TEST_CASE("budget: the plot has a bar per part for the main clippers that have a budget") {
  std::vector<Row> rows = kRows;
  rows.push_back({"a scene", "cvv/near_first", "float", Part::total, {}, {}, 0, 10});
  const Plot shown = plot(rows, "a scene", "float");
  CHECK(shown.name == "budget_a_scene_float");
  CHECK(shown.categories == std::vector<std::string>{"textbook"});
  REQUIRE(shown.series.size() == 5);
  CHECK(shown.series[1].y == std::vector<double>{2});
  CHECK(shown.series[4].muted);
  CHECK(plot(rows, "another", "float").categories.empty());
}
