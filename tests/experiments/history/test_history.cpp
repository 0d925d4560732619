// SPDX-License-Identifier: GPL-3.0-or-later
//
// The history of clipping is made of the tables of a run alone.
#include <cmath>
#include <map>

#include "experiments/contestants/year.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/history/rows.hpp"
#include "experiments/segments/literature.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/claims/fabricated.hpp"

namespace clipscope::experiments::history {
namespace {

const std::string kCodes = "window/cohen_sutherland", kParameters = "window/liang_barsky";

Fabricated segments_in_plane() {
  using segments::PlaneRow;
  std::vector<PlaneRow> plane;
  const auto add = [&](const char* mix, const std::string& clipper, double ns, double speedup) {
    plane.push_back({.mix = mix,
                     .clipper = clipper,
                     .scalar = "float",
                     .timing = timing(ns, speedup),
                     .divisions = 2});
  };
  add("box_1", kCodes, 8, 1);
  add("box_1", kParameters, 2, 4);
  add("both_ends_out", kCodes, 2, 1);
  add("both_ends_out", kParameters, 2.5, 0.8);
  std::vector<segments::HardRow> hard;
  for (const std::string& clipper : {kCodes, kParameters}) {
    hard.push_back({.set = "borders",
                    .contract = Contract::plane,
                    .clipper = clipper,
                    .scalar = "float",
                    .segments = 200,
                    .wrong = clipper == kCodes ? 0 : 50});
  }
  Fabricated run;
  run.set(plane);
  run.set(hard);
  return run;
}

const Row& row_of(const std::vector<Row>& rows, const std::string& clipper) {
  const Row* found = find_row(rows, &Row::clipper, clipper);
  REQUIRE(found != nullptr);
  return *found;
}

}  // namespace

TEST_CASE("history: the year is the last word of a source, or there is none") {
  CHECK(year_of("Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, 1978") == 1978);
  CHECK_FALSE(year_of("OpenGL ES 3.2 Specification, Primitive Clipping"));
  CHECK_FALSE(year_of("19"));
  CHECK_FALSE(year_of(""));
}

TEST_CASE("history: means over the mixes, shares of wins and of hard cases right") {
  const std::vector<Row> rows = history(segments_in_plane().results());
  const Row &codes = row_of(rows, kCodes), &parameters = row_of(rows, kParameters);
  CHECK(codes.year == 1973);
  CHECK(codes.ns == Approx(4));
  CHECK(codes.speedup == Approx(1));
  CHECK(codes.fastest_on_percent == 50.0);
  CHECK(codes.hard_right_percent == 100.0);
  CHECK(parameters.year == 1984);
  CHECK(parameters.speedup == Approx(std::sqrt(3.2)));
  CHECK(parameters.hard_right_percent == 75.0);
  CHECK(parameters.divisions == 2.0);
  CHECK_FALSE(parameters.idea.empty());
}

TEST_CASE("history: methods come in the order of their years, those without figures too") {
  const std::vector<Row> rows = history(Fabricated().results());
  REQUIRE(rows.size() > 20);
  for (std::size_t i = 1; i < rows.size(); ++i) CHECK(rows[i - 1].year <= rows[i].year);
  for (const Row& row : rows) CHECK_FALSE(row.ns);
  CHECK(finding(rows) == "No published method was timed in float.");
  for (const Field field : {Field::plane, Field::segments, Field::triangles}) {
    CHECK(history_plot(rows, field).series.empty());
  }
}

TEST_CASE("history: triangles are measured against Sutherland-Hodgman, whatever the table's base") {
  Fabricated run;
  run.set<cost::Row>({{"soup", "homogeneous/sutherland_hodgman", "float", timing(20, 5)},
                      {"soup", "homogeneous/blinn_newell", "float", timing(10, 10)}});
  run.set<cost::OperationsRow>({{"soup", "homogeneous/blinn_newell", 1, 2, 3, 4}});
  using Hard = hard_cases::SummaryRow;
  run.set<Hard>({{Primitive::triangle, "homogeneous/blinn_newell", "float", 80, 20}});
  const std::vector<Row> rows = history(run.results());
  const Row& row = row_of(rows, "homogeneous/blinn_newell");
  CHECK(row.speedup == Approx(2));
  CHECK(row.divisions == 3.0);
  CHECK(row.hard_right_percent == 75.0);
  CHECK(row.fastest_on_percent == 100.0);
  CHECK(finding(rows).find("that of Blinn-Newell (1978), 2 times as fast for triangles") !=
        std::string::npos);
}

TEST_CASE("history: the plot has each timed method at its year, speed and share in two series") {
  const Plot plot = history_plot(history(segments_in_plane().results()), Field::plane);
  REQUIRE(plot.series.size() == 2);
  CHECK(plot.series[0].x == std::vector<double>{1973, 1984});
  CHECK(plot.series[0].labels == std::vector<std::string>{"cohen_sutherland", "liang_barsky"});
  CHECK(plot.series[1].y == std::vector<double>{1, 0.75});
}

}  // namespace clipscope::experiments::history
