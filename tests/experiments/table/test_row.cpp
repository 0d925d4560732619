// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/row.hpp"

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

enum class Kind { plain, fancy };
constexpr std::array<std::string_view, 2> names_of(Kind) { return {"plain", "fancy"}; }

struct Shape {
  std::int64_t corners = 0;
  double area = 0;
  bool convex = false;

  double area_per_corner() const { return area / static_cast<double>(corners); }

  static constexpr auto columns() {
    return std::tuple(column("corners", &Shape::corners), column("area", "area (px)", &Shape::area),
                      column("convex", &Shape::convex),
                      derived("area_per_corner", "area/corner", &Shape::area_per_corner));
  }
  friend bool operator==(const Shape&, const Shape&) = default;
};

struct Measured {
  std::string clipper;
  Kind kind = Kind::plain;
  std::optional<double> error = {};
  std::optional<Shape> shape = {};
  std::optional<MedianInterval> time = {};
  std::optional<Spread> ulps = {};
  std::array<int, 2> counts = {};

  static constexpr std::string_view kName = "measured", kTitle = "What was measured";
  static constexpr std::array<std::string_view, 1> kNotes = {"One note."};
  static constexpr auto columns() {
    return std::tuple(column("clipper", &Measured::clipper), column("kind", &Measured::kind),
                      column("error", &Measured::error), group(&Measured::shape),
                      interval("ns", "ns", "ns per triangle", &Measured::time),
                      spread("ulps", "ulps", &Measured::ulps),
                      columns_of_array(&Measured::counts, {"kept", "lost"}));
  }
};

const Measured kFull{.clipper = "a",
                     .kind = Kind::fancy,
                     .error = 0.5,
                     .shape = Shape{3, 2.25, true},
                     .time = MedianInterval{2, 1, 3},
                     .ulps = Spread{1, 4},
                     .counts = {7, 8}};

TableOf<Measured> two_rows() {
  TableOf<Measured> table;
  table.add(kFull);
  table.add({.clipper = "b"});
  return table;
}

}  // namespace

TEST_CASE("row: headings, title and notes are those of the type") {
  const TableOf<Measured> table;
  std::vector<std::string> keys;
  for (const Column& column : table.columns()) keys.push_back(column.key);
  CHECK(keys == std::vector<std::string>{"clipper", "kind", "error", "corners", "area", "convex",
                                         "area_per_corner", "ns", "ns_low", "ns_high",
                                         "median_ulps", "max_ulps", "kept", "lost"});
  CHECK(table.columns()[4].head == "area (px)");
  CHECK(table.name() == "measured");
  CHECK(table.notes() == std::vector<std::string>{"One note."});
}

TEST_CASE("row: what is written is read back, what is empty stays empty") {
  const std::vector<Measured> rows = two_rows().rows();
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].kind == Kind::fancy);
  CHECK(rows[0].error == 0.5);
  CHECK(rows[0].shape == Shape{3, 2.25, true});
  CHECK(rows[0].time->high == 3);
  CHECK(rows[0].ulps->max == 4);
  CHECK(rows[0].counts == std::array{7, 8});
  CHECK_FALSE(rows[1].error);
  CHECK_FALSE(rows[1].shape);
  CHECK_FALSE(rows[1].time);
  CHECK_FALSE(rows[1].ulps);
}

TEST_CASE("row: a derived figure is written, and follows from what is read back") {
  CHECK(std::get<double>(two_rows().Table::rows()[0][6]) == 0.75);
  CHECK(two_rows().rows()[0].shape->area_per_corner() == 0.75);
}

TEST_CASE("row: columns are found by their keys, in any order and among others") {
  Table table("t", "T",
              {{"area", "area"},
               {"other", "other"},
               {"corners", "corners"},
               {"convex", "convex"},
               {"area_per_corner", ""}});
  table.add_row({1.5, std::string("x"), std::int64_t{4}, std::string("yes"), {}});
  CHECK(rows_of<Shape>(table) == std::vector<Shape>{{4, 1.5, true}});
}

TEST_CASE("row: a table that lacks a column or holds something else is refused") {
  Table missing("t", "T", {{"area", "area"}});
  CHECK_THROWS_WITH(rows_of<Shape>(missing), Catch::Contains("corners"));
  Table wrong("t", "T", columns_of<Shape>());
  wrong.add_row({std::string("four"), 1.5, std::string("yes"), 0.0});
  CHECK_THROWS_AS(rows_of<Shape>(wrong), MissingFigure);
  Table maybe("t", "T", columns_of<Shape>());
  maybe.add_row({std::int64_t{4}, 1.5, std::string("maybe"), 0.0});
  CHECK_THROWS_WITH(rows_of<Shape>(maybe), Catch::Contains("maybe"));
  Table unknown("t", "T", columns_of<Measured>());
  auto cells = cells_of(kFull);
  cells[1] = std::string("neither");
  unknown.add_row(cells);
  CHECK_THROWS_WITH(rows_of<Measured>(unknown), Catch::Contains("neither"));
}

TEST_CASE("row: rows are found by their members") {
  const std::vector<Measured> rows = two_rows().rows();
  REQUIRE(find_row(rows, &Measured::clipper, "b") != nullptr);
  CHECK(find_row(rows, &Measured::clipper, "b", &Measured::kind, Kind::fancy) == nullptr);
  CHECK(rows_where(rows, &Measured::kind, Kind::fancy).size() == 1);
  CHECK(distinct(rows, &Measured::clipper) == std::vector<std::string>{"a", "b"});
  CHECK(conditions_text<Measured>(&Measured::clipper, "b", &Measured::kind, Kind::plain) ==
        " clipper=b kind=plain");
}

}  // namespace clipscope::experiments
