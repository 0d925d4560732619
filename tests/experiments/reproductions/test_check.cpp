// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "experiments/reproductions/check.hpp"
#include "tests/experiments/reproductions/cases.hpp"

namespace clipscope::experiments {
namespace {

Check check_of_value(double exact, float returned, double size) {
  return check_of(corner_triangle(), {.quantity = Quantity::frag_coord,
                                      .kind = ViolationKind::wrong_value,
                                      .worst = {3, 4, 2, exact, returned},
                                      .size = size});
}

TEST_CASE("check: its tolerance lies between what is allowed and what came") {
  const Check check = check_of_value(0.5, 1.5f, 100);  // so 0.01 is allowed
  CHECK(check.least == 0.4f);
  CHECK(check.greatest == 0.6f);
  const Check unmeasured = check_of_value(0.5, 1.5f, HUGE_VAL);
  CHECK(unmeasured.least == 0);
  CHECK(unmeasured.greatest == 1);
  const Check nan = check_of_value(0.5, NAN, HUGE_VAL);
  CHECK(nan.least == -0.5f);
  CHECK(nan.greatest == 1.5f);
}

TEST_CASE("check: beyond the vertices' values is wrong, all between them is right") {
  const Check check = check_of(corner_triangle(), {.quantity = Quantity::smooth,
                                                   .kind = ViolationKind::outside_hull,
                                                   .worst = {3, 4, 1, 0.01, 3},
                                                   .size = 50});
  CHECK(check.least == -1);  // 0, and half as far beyond as what came
  CHECK(check.greatest == 2);
}

TEST_CASE("check: fragments are counted where a colour can't tell") {
  const auto counts = [](double right, float came) {
    return check_of(corner_triangle(), {.quantity = Quantity::hits,
                                        .kind = ViolationKind::shared_edge,
                                        .worst = {3, 4, 0, right, came}})
        .counts();
  };
  CHECK(!counts(1, 0));
  CHECK(!counts(0, 1));
  CHECK(counts(1, 2));
  CHECK(counts(2, 1));
}

TEST_CASE("depth range: it is another one exactly or not at all") {
  const DrawCall call = corner_triangle();
  const auto converted = in_depth_range(call, DepthRange::zero_to_one);
  REQUIRE(converted);
  CHECK(converted->vertices[0].position[2] == 0.75f);
  CHECK(converted->vertices[2].position[2] == 1.5f);
  CHECK(in_depth_range(*converted, DepthRange::minus_one_to_one) == call);
  DrawCall inexact = call;
  inexact.vertices[0].position[2] = 0x1p-30f;
  CHECK(!in_depth_range(inexact, DepthRange::zero_to_one));
  inexact.vertices[0].position[2] = 0x1p-100f;  // the sum is rounded in double, too
  CHECK(!in_depth_range(inexact, DepthRange::zero_to_one));
}

TEST_CASE("decimal text: it is the number itself, and every reader takes it for no integer") {
  CHECK(decimal_text(0.5f) == "0.5");
  CHECK(decimal_text(-3) == "-3.0");
  CHECK(decimal_text(-0.0f) == "-0.0");
  CHECK(decimal_text(0.1f) == "0.10000000149011612");
  CHECK(decimal_text(0x1p100f) == "1.2676506002282294e+30");
  CHECK(decimal_text(1e20f) == "1.0000000200408773e+20");
  CHECK(decimal_text(0x1p-20f) == "9.5367431640625e-07");
}

TEST_CASE("reproductions: the driver's own format comes first, and each says what is wrong") {
  const Claim claim = right_claims().front();
  for (const GraphicsApi api : {GraphicsApi::opengl, GraphicsApi::vulkan, GraphicsApi::webgl}) {
    DriverInfo info;
    info.api = api;
    info.renderer = "some <driver>";
    const auto all = reproductions(claim.call, claim.wrong, info);
    REQUIRE(all.size() == 3);
    const std::array<std::string, 3> names = {"smooth_not_finite.shader_test",
                                              "smooth_not_finite.amber", "smooth_not_finite.html"};
    CHECK(all[0].file_name == names[static_cast<std::size_t>(api)]);
    const Clause clause = clause_of(api, claim.call.topology, claim.wrong.kind, Quantity::smooth);
    for (const Reproduction& one : all) {
      CAPTURE(one.file_name);
      const bool is_page = one.file_name.ends_with(".html");
      CHECK(one.text.find(is_page ? "some &lt;driver&gt;" : "some <driver>") != std::string::npos);
      CHECK(one.text.find(std::string(clause.meaning.substr(0, 20))) != std::string::npos);
    }
  }
}

}  // namespace
}  // namespace clipscope::experiments
