// SPDX-License-Identifier: GPL-3.0-or-later
//
// Attributes after clipping: the triangles, the exact values, and the errors of contestants.
#include <bit>

#include "experiments/attributes/rows.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::attributes;

namespace {

constexpr int kPoints = 2;

reference::Truth truth() {
  return reference::Truth::of_frustum(frustum_cast<double>(attribute_frustum()));
}

Tally tally_of(const char* clipper, const char* scalar,
               const std::vector<AttributeTriangle>& triangles) {
  return measure_errors(find_contestant(clipper, scalar), triangles,
                        wanted_values(triangles, kPoints, 0));
}

// Within the volume: w = 2, 6 and 2, a = 0, 1 and 0.
AttributeTriangle inner_triangle() {
  AttributeTriangle t{};
  const std::array<std::array<double, 3>, 3> corners = {{{-1, 0, -2}, {3, 0, -6}, {-1, 1, -2}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) t[i].position[c] = corners[i][static_cast<std::size_t>(c)];
    const double a = i == 1 ? 1 : 0;
    t[i].attributes = {{a, -a * t[i].position[2], 0.25, 0.25 * static_cast<double>(i + 1)}};
  }
  return t;
}

}  // namespace

TEST_CASE("crossing triangles: exactly so many planes are crossed, and each can be seen") {
  const int planes = GENERATE(1, 2, 3, 4, 5, 6);
  const Projection<double> projection(frustum_cast<double>(attribute_frustum()));
  for (const AttributeTriangle& triangle : crossing_triangles(planes, 10, 1)) {
    Outcode crossed = 0;
    for (const auto& v : triangle) {
      CHECK(v.position[2] < 0);
      CHECK(v.attributes[kTimesW] == -v.attributes[kSmooth] * v.position[2]);
      CHECK(v.attributes[kProvoking] == triangle[0].attributes[kOwnFlat]);
      crossed |= view_outcode(projection.frustum, v.position);
    }
    CHECK(std::popcount(crossed) == planes);
    const auto exact = reference::clip(truth(), reference::input_triangle(triangle));
    CHECK(planes_with_edge(exact) == crossed);
    CHECK(static_cast<int>(exact.vertices.size()) >= std::max(3, planes));
    CHECK(static_cast<int>(exact.vertices.size()) <= 3 + planes);
  }
}

TEST_CASE("crossing triangles: a seed gives the same bits again, another one others") {
  const auto numbers = [](std::uint64_t seed) {
    std::string text;
    for (const AttributeTriangle& t : crossing_triangles(3, 5, seed)) text += hex_line(t);
    return text;
  };
  CHECK(numbers(4) == numbers(4));
  CHECK(numbers(4) != numbers(5));
}

TEST_CASE("wanted values: halfway on the screen is a quarter of the way from w = 2 to w = 6") {
  const auto value = values_at(truth(), inner_triangle(), {0, 0});
  CHECK(value[static_cast<std::size_t>(Mode::smooth)] == Exact(1) / Exact(4));
  CHECK(value[static_cast<std::size_t>(Mode::noperspective)] == Exact(1) / Exact(2));
  CHECK(value[static_cast<std::size_t>(Mode::flat)] == Exact(1) / Exact(4));
}

TEST_CASE("wanted values: at the vertices of a triangle within the volume they are its own") {
  const std::vector<AttributeTriangle> one = {inner_triangle()};
  const Wanted wanted = wanted_values(one, kPoints, 1).front();
  REQUIRE(wanted.vertices.size() == 3);
  REQUIRE(wanted.points.size() == kPoints);
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact a(inner_triangle()[i].attributes[kSmooth]);
    CHECK(reference::to_rational(wanted.vertices[i][0]) == a);
    CHECK(reference::to_rational(wanted.vertices[i][1]) == a);
  }
}

TEST_CASE(
    "attributes: in exact arithmetic smooth, a*w and flat are exact, at vertices and inside") {
  const char* clipper = GENERATE("homogeneous/sutherland_hodgman", "view/sutherland_hodgman",
                                 "cvv/perspective", "barycentric/distance_matrix", "textbook");
  const int planes = GENERATE(1, 4, 6);
  const Tally tally = tally_of(clipper, "exact", crossing_triangles(planes, 12, 2));
  CAPTURE(clipper, planes);
  CHECK(tally.triangles == 12);
  CHECK(tally.wrong == 0);
  CHECK(tally.constant_changed == 0);
  for (const Treatment treatment : {Treatment::smooth, Treatment::times_w, Treatment::flat}) {
    CHECK(tally[treatment].absolute.max() == 0);
    CHECK(tally[treatment].inside == 0);
  }
  const TreatmentErrors& as_is = tally[Treatment::noperspective];
  CHECK(as_is.absolute.max() > 0.01);
  CHECK(as_is.absolute.max() < 1);
  CHECK(as_is.inside < 1);
}

TEST_CASE("attributes: affine clipping in NDC is exact for noperspective and wrong for smooth") {
  const Tally tally = tally_of("cvv/naive", "exact", crossing_triangles(3, 12, 2));
  CHECK(tally.triangles == 12);
  CHECK(tally[Treatment::noperspective].absolute.max() == 0);
  CHECK(tally[Treatment::noperspective].inside == 0);
  CHECK(tally[Treatment::smooth].absolute.max() > 0.01);
  CHECK(tally[Treatment::flat].absolute.max() == 0);
}

TEST_CASE("attributes: an altered truth is noticed, by as much as it was altered") {
  const auto triangles = crossing_triangles(2, 4, 3);
  auto wanted = wanted_values(triangles, kPoints, 0);
  const reference::Fraction before = wanted[2].vertices[1][0];
  wanted[2].vertices[1][0] = {before.numerator * reference::Dyadic(1025),
                              before.denominator * reference::Dyadic(1024)};
  const Tally tally =
      measure_errors(find_contestant("homogeneous/sutherland_hodgman", "exact"), triangles, wanted);
  CHECK(tally[Treatment::smooth].absolute.max() ==
        Approx(reference::approximate(before) / 1024).epsilon(1e-12));
  CHECK(tally.worst_at == 2);
  CHECK(tally[Treatment::times_w].absolute.max() == 0);
}

TEST_CASE("attributes: an altered sample inside is noticed") {
  const auto triangles = crossing_triangles(2, 4, 3);
  auto wanted = wanted_values(triangles, kPoints, 0);
  wanted[1].points[0].value[0] += Exact(1) / Exact(8);
  const Tally tally =
      measure_errors(find_contestant("homogeneous/sutherland_hodgman", "exact"), triangles, wanted);
  CHECK(tally[Treatment::smooth].inside == 0.125);
  CHECK(tally[Treatment::times_w].inside == 0);
}

TEST_CASE("attributes: a triangle left whole keeps its flat values, whichever vertex provokes") {
  const Tally tally = tally_of("homogeneous/sutherland_hodgman", "float", {inner_triangle()});
  CHECK(tally.triangles == 1);
  CHECK(tally.first_changed == 0);
  CHECK(tally.last_changed == 0);
  CHECK(tally.constant_changed == 0);
}

TEST_CASE("attributes: a clipped polygon's own vertices give other flat values") {
  const Tally tally =
      tally_of("homogeneous/sutherland_hodgman", "float", crossing_triangles(6, 12, 2));
  CHECK(tally.triangles == 12);
  // A hexagon and more: no fan has one last vertex only.
  CHECK(tally.last_changed == 12);
  CHECK(tally.first_changed > 0);
  CHECK(tally.constant_changed == 0);
}

TEST_CASE("attributes: the plot of smooth attributes leaves out what would hide the others") {
  const auto row = [](const char* clipper, const char* scalar, int planes, double ulp) {
    return ErrorRow{.planes = planes, .clipper = clipper, .scalar = scalar, .median_ulp = ulp};
  };
  std::vector<ErrorRow> rows = {row("cvv/naive", "float", 1, 1), row("a", "float", 1, 2),
                                row("a", "exact", 1, 0), row("a", "float", 2, 3)};
  rows.push_back(row("a", "float", 3, 9));
  rows.back().treatment = Treatment::flat;
  const Plot plot = error_plot(rows);
  REQUIRE(plot.series.size() == 1);
  CHECK(plot.series[0].name == "a, float");
  CHECK(plot.series[0].x == std::vector<double>{1, 2});
  CHECK(plot.series[0].y == std::vector<double>{2, 3});
  CHECK(error_plot({rows[0]}).series.size() == 1);
  CHECK(error_plot({}).series.empty());
}

TEST_CASE("attributes: the finding says what the rows say, and nothing that they do not") {
  CHECK(finding({}, {}) == "No clipper of a chain of cuts was judged beside the originals.");
  const FlatRow quiet{1, "a", "float", 10, 0, 0, 100, 0};
  const FlatRow noisy{1, "b", "float", 10, 0, 50, 100, 10};
  CHECK(
      finding({}, {quiet}) ==
      "A flat value read from the clipped polygon is wrong for no triangles; given to all three vertices beforehand it keeps its bits in every clipper.");
  CHECK(
      finding({}, {quiet, noisy}) ==
      "A flat value read from the clipped polygon is wrong for some triangles; given to all three vertices beforehand it keeps its bits in all clippers but b.");
}

TEST_CASE("attributes: the finding says whether a chain of cuts costs accuracy, by the rows") {
  const auto row = [](Treatment treatment, const char* clipper, double ulp, double error) {
    return ErrorRow{.treatment = treatment,
                    .planes = 6,
                    .clipper = clipper,
                    .scalar = "float",
                    .triangles = 1,
                    .median_abs = 0,
                    .max_abs = error,
                    .median_ulp = ulp,
                    .max_ulp = 0,
                    .inside_max_abs = error};
  };
  std::vector<ErrorRow> rows = {
      row(Treatment::smooth, "homogeneous/sutherland_hodgman", 2, 1e-4),
      row(Treatment::smooth, "barycentric/distance_matrix", 1, 1e-6),
      row(Treatment::noperspective, "homogeneous/sutherland_hodgman", 9, 0.5),
      row(Treatment::times_w, "homogeneous/sutherland_hodgman", 1, 1e-6)};
  const auto checked = [&] {
    const std::string text = finding(rows, {});
    INFO(text);
    CHECK(faults_of_prose(text).empty());
    return text;
  };
  CHECK(
      checked() ==
      "A chain of cuts costs more accuracy of smooth attributes than computing every vertex from the original three: with six planes crossed the median error is 2.00 ulp against 1.00 ulp in float. Inside the polygon, where vertices in the wrong place bend what lies between, the chain is off more than ten times as far. A noperspective attribute must be carried times w: clipped as a smooth one it is wrong.");
  rows[0].median_ulp = 1;
  rows[0].inside_max_abs = 1e-6;
  rows[2].max_abs = 1e-6;
  const std::string turned = checked();
  CHECK(turned.starts_with("A chain of cuts costs no more accuracy"));
  CHECK(turned.find("the chain is off no farther") != std::string::npos);
  CHECK(turned.ends_with("A noperspective attribute may be clipped as a smooth one."));
}
