// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/results.hpp"

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

struct Row {
  std::string clipper, scalar;
  std::optional<double> ns = {};
  std::int64_t triangles = 0;

  static constexpr std::string_view kName = "t", kTitle = "Times";
  static constexpr auto columns() {
    return std::tuple(column("clipper", &Row::clipper), column("scalar", &Row::scalar),
                      column("ns", &Row::ns), column("triangles", &Row::triangles));
  }
};

// A row of that table with a column that it has not.
struct LongerRow : Row {
  double px = 0;

  static constexpr auto columns() { return std::tuple(column("px", &LongerRow::px)); }
};

// A table that no run has.
struct OtherRow : Row {
  static constexpr std::string_view kName = "u";
};

Results results_of(const std::vector<Row>& rows) {
  return Results([=](const std::string& name) -> std::optional<Table> {
    TableOf<Row> table;
    for (const Row& row : rows) table.add(row);
    return name == table.name() ? std::optional<Table>(table) : std::nullopt;
  });
}

Results three_rows() {
  return results_of({{"a", "float", 1.5, 3}, {"b", "float"}, {"b", "double", 7, 4}});
}

TEST_CASE("results: a row is found by what it says") {
  const Results results = three_rows();
  CHECK(results.rows<Row>().size() == 3);
  CHECK(results.row<Row>(&Row::clipper, "a").ns == 1.5);
  CHECK(results.row<Row>(&Row::clipper, "b", &Row::scalar, "double").ns == 7.0);
  CHECK(results.row<Row>(&Row::clipper, "b").scalar == "float");
}

TEST_CASE("results: empty cells are no figures") {
  const Results results = three_rows();
  CHECK(results.figures<Row>(&Row::ns) == std::vector{1.5, 7.0});
  CHECK(results.figures<Row>(&Row::ns, &Row::clipper, "b") == std::vector{7.0});
  CHECK_THROWS_AS(results.figures<Row>(&Row::ns, &Row::clipper, "b", &Row::scalar, "float"),
                  MissingFigure);
}

TEST_CASE("results: a figure is a member, or what a function says of a row") {
  const auto doubled = [](const Row& row) { return 2 * row.triangles; };
  CHECK(three_rows().figures<Row>(&Row::triangles) == std::vector{3.0, 0.0, 4.0});
  CHECK(three_rows().figures<Row>(doubled, &Row::scalar, "double") == std::vector{8.0});
}

TEST_CASE("results: what is missing is named") {
  const Results results = three_rows();
  CHECK_THROWS_WITH(results.rows<OtherRow>(), Catch::Contains("table u"));
  CHECK_THROWS_WITH(results.rows<LongerRow>(), Catch::Contains("no column px"));
  CHECK_THROWS_WITH(results.row<Row>(&Row::clipper, "c"), Catch::Contains("clipper=c"));
  CHECK_THROWS_WITH(results.figures<Row>(&Row::ns, &Row::clipper, "c"),
                    Catch::Contains("ns") && Catch::Contains("clipper=c"));
  CHECK_THROWS_WITH(results_of({}).rows<Row>(), Catch::Contains("table t has no row"));
}

TEST_CASE("results: a value that rows have is told once, in their order") {
  const Results results = three_rows();
  CHECK(distinct(results.rows<Row>(), &Row::clipper) == std::vector<std::string>{"a", "b"});
  CHECK(distinct(rows_where(results.rows<Row>(), &Row::clipper, "b"), &Row::scalar) ==
        std::vector<std::string>{"float", "double"});
}

}  // namespace
}  // namespace clipscope::experiments
