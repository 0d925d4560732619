// SPDX-License-Identifier: GPL-3.0-or-later
//
// What counts as moved between two runs, and what does not.
#include <limits>
#include <string>
#include <vector>

#include "experiments/store/diff.hpp"
#include "tests/catch.hpp"

namespace {

using namespace clipscope::experiments;

struct TimeRow {
  std::string clipper;
  double ns, low, high;
};

Table times(const std::vector<TimeRow>& rows) {
  Table table("times", "Times",
              {{"clipper", "clipper"},
               {"scalar", "scalar"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "low"},
               {"ns_high", "high"}});
  for (const TimeRow& r : rows) {
    table.add_row({r.clipper, std::string("float"), r.ns, r.low, r.high});
  }
  return table;
}

Table counts(const std::vector<std::vector<Cell>>& rows) {
  Table table("counts", "Counts", {{"k", "k"}, {"clipper", "clipper"}, {"failures", "fails"}});
  for (const auto& row : rows) table.add_row(row);
  return table;
}

Difference difference(const Table& a, const Table& b) {
  Difference d;
  add_difference(a, b, d);
  return d;
}

}  // namespace

TEST_CASE("diff: a figure within the other's interval has not moved, one beyond has") {
  const Table a = times({{"textbook", 10, 9, 11}, {"naive", 20, 19, 21}});
  const Difference d = difference(a, times({{"textbook", 11.5, 10.9, 12}, {"naive", 23, 22, 24}}));
  REQUIRE(d.moved.size() == 1);
  CHECK(d.moved[0].row == "naive");
  CHECK(d.moved[0].column == "ns_per_triangle");
  CHECK(d.moved[0].a == Cell(20.0));
  CHECK(d.moved[0].b == Cell(23.0));
  CHECK(d.figures == 4);  // the scalar and the time of each row
  CHECK(difference(times({{"naive", 23, 22, 24}}), times({{"naive", 20, 19, 21}})).moved.size() ==
        1);
}

TEST_CASE("diff: intervals that touch have a point in common") {
  const double next = std::nextafter(11.0, 12.0);
  CHECK(difference(times({{"t", 10, 9, 11}}), times({{"t", 12, 11, 13}})).moved.empty());
  CHECK(difference(times({{"t", 10, 9, 11}}), times({{"t", 12, next, 13}})).moved.size() == 1);
}

TEST_CASE("diff: an interval of another figure's name is no interval") {
  const auto table = [](double value, double low) {
    Table t("t", "", {{"n", ""}, {"max_px", ""}, {"ns_low", ""}, {"ns_high", ""}});
    t.add_row({std::int64_t{1}, value, low, 100.0});
    return t;
  };
  CHECK(difference(table(1, 0), table(2, 0)).moved.size() == 1);
  CHECK(difference(table(1, 0), table(1, 5)).moved.size() == 1);  // ns_low is a figure like others
}

TEST_CASE("diff: a figure without interval has moved if it differs at all") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto table = [](const Cell& value) {
    return counts({{std::int64_t{1}, std::string("t"), value}});
  };
  const auto moves = [&](const Cell& a, const Cell& b) {
    return !difference(table(a), table(b)).moved.empty();
  };
  CHECK(moves(0.1, std::nextafter(0.1, 1.0)));
  CHECK(moves(std::int64_t{1}, std::int64_t{2}));
  CHECK(moves(std::monostate(), 1.0));
  CHECK(moves(nan, 1.0));
  CHECK_FALSE(moves(nan, -nan));
  CHECK_FALSE(moves(0.0, -0.0));
  CHECK_FALSE(moves(std::monostate(), std::monostate()));
}

TEST_CASE("diff: rows are matched by as few leading columns as tell them apart, in any order") {
  const auto row = [](int k, const char* clipper, int failures) {
    return std::vector<Cell>{std::int64_t{k}, std::string(clipper), std::int64_t{failures}};
  };
  const Difference d = difference(counts({row(1, "a", 5), row(1, "b", 6), row(2, "a", 7)}),
                                  counts({row(2, "a", 7), row(1, "b", 9), row(3, "a", 8)}));
  REQUIRE(d.moved.size() == 1);
  CHECK(d.moved[0].row == "1, b");
  REQUIRE(d.lone.size() == 2);
  CHECK((d.lone[0].row == "1, a" && d.lone[0].in_a));
  CHECK((d.lone[1].row == "3, a" && !d.lone[1].in_a));
}

TEST_CASE("diff: a column of one run only is said, the others are compared") {
  Table other("counts", "Counts", {{"k", "k"}, {"clipper", "clipper"}, {"more", "more"}});
  other.add_row({std::int64_t{1}, std::string("b"), 2.0});
  const Difference d =
      difference(counts({{std::int64_t{1}, std::string("a"), std::int64_t{5}}}), other);
  REQUIRE(d.lone.size() == 2);
  CHECK(d.lone[0].column == "failures");
  CHECK(d.lone[1].column == "more");
  REQUIRE(d.moved.size() == 1);
  CHECK(d.moved[0].column == "clipper");
}

TEST_CASE("diff: a table equals itself") {
  const Table a = times({{"textbook", 10, 9, 11}, {"naive", 20, 19, 21}});
  const Difference d = difference(a, a);
  CHECK(d.moved.empty());
  CHECK(d.lone.empty());
  CHECK(d.figures == 4);
}

TEST_CASE("diff: rows that nothing tells apart are compared in their order") {
  const Table a = times({{"textbook", 10, 9, 11}, {"textbook", 10, 9, 11}, {"naive", 20, 19, 21}});
  const Difference d = difference(
      a, times({{"textbook", 10, 9, 11}, {"textbook", 30, 29, 31}, {"naive", 20, 19, 21}}));
  REQUIRE(d.moved.size() == 1);
  CHECK(d.moved[0].row == "textbook, float (2)");
  CHECK(d.lone.empty());
  CHECK(difference(a, a).moved.empty());
}
