// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/depth/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::depth;

namespace {

PrecisionRow row(const char* convention, Stored buffer, double lost_percent) {
  PrecisionRow row;
  row.convention = convention;
  row.buffer = buffer;
  row.far_near_ratio = 1e5;
  row.tied_percent = lost_percent;
  return row;
}

}  // namespace

TEST_CASE("depth: the finding follows the rows") {
  std::vector<PrecisionRow> precision = {
      row("reversed", Stored::float32, 1), row("zero_to_one", Stored::float32, 2),
      row("gl", Stored::float32, 3), row("zero_to_one", Stored::unorm24, 5),
      row("reversed", Stored::unorm24, 4)};
  std::vector<FormRow> forms = {
      {Form::quadratic, "lines stay straight", "exact", 10, 10, 10, 1.25, 3},
      {Form::linear, "lines stay straight", "exact", 10, 10, 0, 0, 0}};
  const auto checked = [&] {
    const std::string text = finding(precision, forms);
    INFO(text);
    CHECK(faults_of_prose(text).empty());
    return text;
  };
  CHECK(
      checked() ==
      "In a float buffer reversed depth is the most precise: where far over near is a hundred thousand, a float pipeline fails to order 1.00 % of neighbours with it, and up to 3.00 % with the other conventions. In 24-bit fixed point reversing helps, too. A depth that is linear in distance bends straight edges; the hyperbolic one does not.");
  precision[0].tied_percent = 2;
  precision[4].tied_percent = 6;
  forms[0].max_deviation_ndc = 0;
  const std::string turned = checked();
  CHECK(turned.find("reversed depth is no more precise:") != std::string::npos);
  CHECK(turned.find("reversing harms.") != std::string::npos);
  CHECK(turned.find("does not bend straight edges") != std::string::npos);
  precision[4].tied_percent = 5;
  CHECK(checked().find("reversing changes little.") != std::string::npos);
}

TEST_CASE("depth: the finding says so where nothing was measured") {
  CHECK(finding({}, {}) == "No depth was measured.");
}

TEST_CASE("depth: plots leave out infinite far planes, and transforms in double") {
  PrecisionRow in_double = row("gl", Stored::float32, 7);
  in_double.transform = Arithmetic::in_double;
  const Plot plot = lost_order_plot({row("gl", Stored::float32, 3), in_double});
  REQUIRE(plot.series.size() == 2);
  CHECK(plot.series[1].name == "gl, float32");
  CHECK(plot.series[1].y == std::vector{3.0});
  CHECK(curve_plot({{"gl_infinite", Stored::float32, 1, 1}, {"gl", Stored::float32, 1, 1}})
            .series.size() == 1);
}
