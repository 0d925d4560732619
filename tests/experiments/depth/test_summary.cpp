// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/depth/rows.hpp"
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
  CHECK(finding({}, {}).empty());
  const FormRow bent{Form::quadratic, "lines stay straight", "exact", 10, 10, 10, 1.25, 3};
  CHECK_THAT(finding({}, {bent}), Catch::Contains("1.25"));
  const std::vector<PrecisionRow> precision = {
      row("reversed", Stored::float32, 1), row("zero_to_one", Stored::float32, 2),
      row("gl", Stored::float32, 3), row("zero_to_one", Stored::unorm24, 4),
      row("reversed", Stored::unorm24, 5)};
  CHECK_THAT(finding(precision, {}), Catch::Contains("1.00 % of neighbours with reversed depth"));
  CHECK_THAT(finding(precision, {}), Catch::Contains("reversing changes 4.00 % to 5.00 %"));
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
