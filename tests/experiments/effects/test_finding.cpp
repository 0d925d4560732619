// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of leaving effects out, and that altered rows say otherwise.
#include "experiments/effects/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::effects;

namespace {

Row row(const char* scene, double to_full, double to_bare) {
  Times times;
  times.to_full = {to_full, to_full, to_full};
  times.to_bare = {to_bare, to_bare, to_bare};
  return {scene, times, {.polygons = 10}, "none"};
}

std::string checked(const std::vector<Row>& rows) {
  const std::string text = finding(rows);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

}  // namespace

TEST_CASE("effects: the finding says that nothing is harmed, and what is saved where") {
  std::vector<Row> rows = {row("overlay", 0.35, 0.8), row("soup", 0.95, 1.6)};
  CHECK(
      checked(rows) ==
      "Leaving out what a scene does not call for changes no polygon, and attributes by no more than the tolerance. It saves 65 % of the full pipeline's time on the overlay, and 5 % on the game-like mix. On the overlay it is faster than transform and divide alone, of which it needs less.");
  rows[1].times->to_full = {1.2, 1.1, 1.3};
  rows[0].times->to_bare.high = 1.1;
  CHECK(checked(rows).ends_with("time on the overlay, and costs time on the game-like mix."));
  rows[1].times->to_full = {1.01, 0.9, 1.1};
  CHECK(checked(rows).ends_with("time on the overlay, and nothing on the game-like mix."));
}

TEST_CASE("effects: harm is said first") {
  std::vector<Row> rows = {row("overlay", 0.35, 1.8)};
  rows[0].harm.attribute_error = 0.5;
  CHECK(checked(rows).find("attributes by MORE than the tolerance") != std::string::npos);
  rows[0].harm.changed = 3;
  rows[0].times.reset();
  CHECK(checked(rows) == "Leaving out what a scene does not call for CHANGES 3 of 10 polygons.");
  CHECK(checked({}) == "No scene was looked at.");
}
