// SPDX-License-Identifier: GPL-3.0-or-later
//
// The correctly rounded clipper in view space against the truth of the frustum's exact numbers,
// rounded once: every bit of every coordinate.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "experiments/catalogue/catalogue.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/barycentric/correctly_rounded.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/barycentric/rounded_rows.hpp"
#include "tests/spaces/barycentric/view_cases.hpp"

namespace clipscope::reference {
namespace {

using barycentric::CountStages;
using barycentric::Stage;

Projection<float> projection_of(const ViewCase& c) {
  Projection<float> projection;
  projection.frustum = c.frustum;
  projection.volume = c.volume;
  return projection;
}

Rows clipped(const ViewCase& c, CountStages& count) {
  NdcPolygon<float, kAttributes> out;
  CorrectlyRounded{}(projection_of(c), c.triangle, out, count);
  return rows(out);
}

Rows clipped(const ViewCase& c) {
  CountStages count;
  return clipped(c, count);
}

ExactPolygon exact_polygon(const ViewCase& c) {
  return clip(Truth::of_frustum(frustum_cast<double>(c.frustum), c.volume),
              input_triangle(c.triangle));
}

Rows expected(const ViewCase& c) { return rounded(exact_polygon(c)); }

TEST_CASE("correctly rounded: in view space every bit is that of the exact polygon rounded once") {
  for (const ViewCaseSet& set : kViewCaseSets) {
    INFO(set.name);
    const Compared r = compare_with_reference(set.make, clipped, exact_polygon, 15000, 1);
    CHECK(r.coordinates > 5000);
    CHECK(r.stages[Stage::sign_filtered] > 0);
  }
}

// Run by name.
TEST_CASE("correctly rounded: a long comparison in view space", "[.long]") {
  compare_at_length(kViewCaseSets, clipped, exact_polygon);
}

TEST_CASE("correctly rounded: every bit is right in the catalogue's view-space cases") {
  int compared = 0;
  for (const experiments::HardCase& hard_case : experiments::builtin_catalogue()) {
    if (hard_case.primitive != experiments::Primitive::triangle || hard_case.space != Space::view) {
      continue;
    }
    CAPTURE(hard_case.name);
    ViewCase c{frustum_cast<float>(hard_case.frustum), hard_case.volume, {}};
    if (c.volume.clip_distances > kAttributes || !is_valid(c.frustum)) continue;
    set_vertices(hard_case, c.triangle);
    CHECK(agrees(clipped(c), exact_polygon(c)));
    ++compared;
  }
  CHECK(compared > 30);
}

ViewVertex<float, kAttributes> vertex(float x, float y, float z, float a = 0, float b = 0,
                                      float c = 0) {
  return {{x, y, z}, {{a, b, c}}};
}

// Left, right, bottom and top at -1 and 1 where w = 1: the near plane, on which all vertices lie.
const Frustum<float> kUnit{.near = 1, .far = 2};
const Frustum<float> kParallelUnit{.kind = ProjectionKind::parallel, .near = 1, .far = 2};

// The right plane cuts the edge 0-1 in its middle, as in clip space.
TEST_CASE("correctly rounded: in view space a tie goes to the even float") {
  const Frustum<float> frustum = GENERATE(kUnit, kParallelUnit);
  const float ulp = 0x1p-24f, odd = 0.5f + ulp;
  const ViewCase c = {frustum,
                      {},
                      {vertex(0, 0.5f, -1, 0.5f, odd, 0),
                       vertex(2, odd, -1, odd, odd + ulp, kSmallest), vertex(0, -0.5f, -1)}};
  CountStages count;
  const Rows r = clipped(c, count);
  REQUIRE(same_bits(r, expected(c)));
  REQUIRE(r.size() == 4);
  CHECK(r[1] == Row{1, 0.5f, -1, 1, 0.5f, odd + ulp, 0});
  CHECK(count[Stage::quotient_tie] == 5);
}

TEST_CASE("correctly rounded: in view space what is next to a tie goes to its own side") {
  const Frustum<float> frustum = GENERATE(kUnit, kParallelUnit);
  const float even = 0.5f, odd = 0.5f + 0x1p-24f,
              tiny = GENERATE(as<float>{}, 0x1p-60f, -0x1p-60f, 0x1p-120f);
  const ViewCase c = {
      frustum, {}, {vertex(tiny, even, -1), vertex(2, odd, -1), vertex(0, -0.5f, -1)}};
  CountStages count;
  const Rows r = clipped(c, count);
  REQUIRE(same_bits(r, expected(c)));
  REQUIRE(r.size() == 4);
  CHECK(r[1][1] == (tiny > 0 ? even : odd));
  CHECK(count[Stage::quotient_midpoint] == 1);
  CHECK(count[Stage::quotient_tie] == 0);
}

// y is half, or three halves, of the smallest float in the middle of the edge 0-1.
TEST_CASE("correctly rounded: in view space a subnormal tie goes to the even float") {
  const int units = GENERATE(1, 3, -1, -3);
  const float y = static_cast<float>(units) * kSmallest;
  const ViewCase c = {kUnit, {}, {vertex(0, 0, -1), vertex(2, y, -1), vertex(0, -0.5f, -1)}};
  CountStages count;
  const Rows r = clipped(c, count);
  REQUIRE(same_bits(r, expected(c)));
  const auto on_edge =
      std::ranges::find_if(r, [](const Row& row) { return row[0] == 1 && row[1] > -0.1f; });
  REQUIRE(on_edge != r.end());
  CHECK(std::abs((*on_edge)[1]) == (std::abs(units) == 1 ? 0 : 2 * kSmallest));
  CHECK(std::signbit((*on_edge)[1]) == (units < 0));
  CHECK(count[Stage::quotient_tie] == 1);
}

// The edge 0-1 meets the top plane in its middle, where x = 1 + tiny / 2.
TEST_CASE("correctly rounded: in view space a vertex is on its own side of a plane") {
  const Frustum<float> frustum = GENERATE(kUnit, kParallelUnit);
  const float tiny = GENERATE(as<float>{}, 0x1p-70f, -0x1p-70f, 0.0f);
  const ViewCase c = {frustum, {}, {vertex(tiny, 0, -1), vertex(2, 2, -1), vertex(-0.5f, 1, -1)}};
  CountStages count;
  const Rows r = clipped(c, count);
  CHECK(same_bits(r, expected(c)));
  CHECK(r.size() == (tiny > 0 ? 4 : 3));
  CHECK(count[Stage::sign_exact] > 0);
}

// On the left plane but for shear z = 2^-140 or its negative.
TEST_CASE("correctly rounded: a product far below the other terms of a sheared row decides") {
  const float tiny = GENERATE(0x1p-70f, -0x1p-70f);
  Frustum<float> frustum = kParallelUnit;
  frustum.near = -1;
  frustum.shear_x = 0x1p-70f;
  const ViewCase c = {
      frustum, {}, {vertex(-1, 0, tiny), vertex(0, 0.5f, tiny), vertex(0, 0, tiny)}};
  const Rows r = clipped(c);
  CHECK(same_bits(r, expected(c)));
  CHECK(r.size() == (tiny > 0 ? 3 : 4));
}

// Three components: x - left is 1 + 2^-60, and shear z is 2^-140.
TEST_CASE("correctly rounded: a sheared row is exact in three components") {
  Frustum<float> frustum = kParallelUnit;
  frustum.left = -0x1p-60f;
  frustum.shear_x = 0x1p-70f;
  const ViewTriangle<float, 0> triangle = {{{{1, 0, 0x1p-70f}, {}}, {{1, 0, 0}, {}}, {}}};
  const barycentric::Line row = barycentric::view_row(frustum, Plane::left, triangle);
  CHECK(row.rounded == barycentric::Values{1, 1, 0x1p-60});
  CHECK(row.error == barycentric::Values{0x1p-60, 0x1p-60, 0});
  CHECK(row.rest == barycentric::Values{0x1p-140, 0, 0});
}

TEST_CASE("correctly rounded: 1/w overflows to infinity only if it rounds there") {
  Frustum<float> f{.near = 0x1p-149f, .infinite_far = true};
  f.left = f.bottom = -kSmallest;
  f.right = f.top = kSmallest;
  const float w = GENERATE(as<float>{}, 0x1p-128f, 0x1p-127f, 0x1p-140f);
  const ViewCase c = {f, {}, {vertex(0, 0, -w), vertex(w / 2, 0, -w), vertex(0, w / 2, -w)}};
  const Rows r = clipped(c);
  CHECK(same_bits(r, expected(c)));
  REQUIRE(r.size() == 3);
  CHECK(std::isinf(r[0][3]) == (w < 0x1p-127f));
}

TEST_CASE("correctly rounded: in view space with depth clamp an infinite z draws nothing") {
  const Frustum<float> f{.near = 0x1p100f, .far = 0x1p120f};
  ViewCase c = {f, {.depth_clamp = true}, {vertex(0, 0, -kSmallest), vertex(0, 0, -1), {}}};
  c.triangle[2] = vertex(1, 0, -2);
  CHECK(expected(c).empty());
  CHECK(clipped(c).empty());
  c.triangle[0].position[2] = -1;
  c.triangle[1] = vertex(0, 1, -2);
  CHECK(clipped(c).size() >= 3);
  CHECK(same_bits(clipped(c), expected(c)));
}

TEST_CASE("correctly rounded: in view space the number of attributes is of no consequence") {
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    ViewCase c = scattered_in_view(random);
    c.volume.clip_distances = 0;
    ViewTriangle<float, kRunTime> at_run_time;
    for (std::size_t v = 0; v < 3; ++v) {
      at_run_time[v].position = c.triangle[v].position;
      at_run_time[v].attributes.resize(1);
      at_run_time[v].attributes[0] = c.triangle[v].attributes[0];
    }
    NdcPolygon<float, kRunTime> out;
    CorrectlyRounded{}(projection_of(c), at_run_time, out);
    const Rows r = clipped(c);
    REQUIRE(out.size() == static_cast<int>(r.size()));
    for (int v = 0; v < out.size(); ++v) {
      const Row& row = r[static_cast<std::size_t>(v)];
      REQUIRE(out[v].position == Vec4<float>(row[0], row[1], row[2], row[3]));
      REQUIRE(out[v].attributes[0] == row[4]);
    }
  }
}

TEST_CASE("correctly rounded: in view space no vertex is the first") {
  for (const ViewCaseSet& set : kViewCaseSets) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) check_that_no_vertex_is_first(set.make(random), clipped);
  }
}

TEST_CASE("correctly rounded: stages are counted over batches") {
  Random random(7);
  std::vector<ViewTriangle<float, kAttributes>> triangles;
  const ViewCase c = scattered_in_view(random);
  CountStages one_by_one;
  for (int i = 0; i < 100; ++i) {
    ViewCase other = scattered_in_view(random);
    other.frustum = c.frustum;
    other.volume = c.volume;
    clipped(other, one_by_one);
    triangles.push_back(other.triangle);
  }
  const CountStages batch =
      CorrectlyRounded::count_stages(projection_of(c), std::span(std::as_const(triangles)));
  CHECK(batch.counts == one_by_one.counts);
}

}  // namespace
}  // namespace clipscope::reference
