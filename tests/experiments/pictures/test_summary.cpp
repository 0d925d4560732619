// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of pictures, and that altered rows say otherwise.
#include "experiments/pictures/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::pictures {
namespace {

std::string checked(const std::vector<Row>& rows) {
  const std::string text = finding(rows, 100);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

TEST_CASE("pictures: the finding counts those that are right, and says what the worst shows") {
  std::vector<Row> rows = {{"corridor", "homogeneous/sutherland_hodgman", 0, 0, 0},
                           {"corridor", "whole/all_outside", 30, 20, 10}};
  CHECK(
      checked(rows) ==
      "The side that is there shows in every pixel of 1 of 2 pictures. The worst is that of keeping triangles whole on the corridor: most pixels are holes, cover what is not there or show the wrong side.");
  rows[1].holes_px = 0;
  rows[1].extra_px = 0;
  CHECK(checked(rows).find("on the corridor: few pixels are holes") != std::string::npos);
  rows[1].flipped_px = 0;
  CHECK(checked(rows) == "The side that is there shows in every pixel of all pictures.");
  CHECK(checked({}) == "No clipper was asked for.");
}

}  // namespace
}  // namespace clipscope::experiments::pictures
