// SPDX-License-Identifier: GPL-3.0-or-later
//
// The correctly rounded clipper against the exact reference rounded once: every bit of every
// coordinate.
#include "spaces/barycentric/correctly_rounded.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

#include "experiments/catalogue/catalogue.hpp"
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/barycentric/clip_cases.hpp"
#include "tests/spaces/barycentric/rounded_rows.hpp"

namespace clipscope::reference {
namespace {

using barycentric::CountStages;
using barycentric::Stage;

using Output = NdcPolygon<float, kAttributes>;

Rows clipped(const Case& c, CountStages& count) {
  Output out;
  CorrectlyRounded{}(c.volume, c.triangle, out, count);
  return rows(out);
}

Rows clipped(const Case& c) {
  CountStages count;
  return clipped(c, count);
}

ExactPolygon exact_polygon(const Case& c) {
  return clip(Truth::of_clip(c.volume), input_triangle(c.triangle));
}

Rows expected(const Case& c) { return rounded(exact_polygon(c)); }

TEST_CASE("correctly rounded: every bit is that of the exact polygon rounded once") {
  for (const CaseSet& set : kCaseSets) {
    INFO(set.name);
    const Compared r = compare_with_reference(set.make, clipped, exact_polygon, 15000, 1);
    CHECK(r.coordinates > 1000);  // the set is not empty talk
    CHECK(r.stages[Stage::sign_filtered] > 0);
  }
}

TEST_CASE("correctly rounded: every bit is right in the catalogue of hard cases") {
  int compared = 0;
  for (const experiments::HardCase& hard_case : experiments::builtin_catalogue()) {
    if (hard_case.primitive != experiments::Primitive::triangle || hard_case.space != Space::clip) {
      continue;
    }
    CAPTURE(hard_case.name);
    Case c{hard_case.volume, {}};
    if (c.volume.clip_distances > kAttributes) continue;
    set_vertices(hard_case, c.triangle);
    CHECK(agrees(clipped(c), exact_polygon(c)));
    ++compared;
  }
  CHECK(compared > 50);
}

// Run by name.
TEST_CASE("correctly rounded: a long comparison", "[.long]") {
  compare_at_length(kCaseSets, clipped, exact_polygon);
}

ClipVertex<float, kAttributes> vertex(float x, float y, float z, float w, float a = 0, float b = 0,
                                      float c = 0) {
  return {{x, y, z, w}, {{a, b, c}}};
}

// The right plane cuts the edge 0-1 in its middle, where y is between two floats, and so are the
// attributes: as far from an even float below as from an odd one above, and the other way round;
// and half of the smallest float, as on the edge 1-2.
TEST_CASE("correctly rounded: a tie goes to the even float") {
  const float ulp = 0x1p-24f, odd = 0.5f + ulp;
  const Case c = {{},
                  {vertex(0, 0.5f, 0, 1, 0.5f, odd, 0),
                   vertex(2, odd, 0, 1, odd, odd + ulp, kSmallest), vertex(0, -0.5f, 0, 1)}};
  CountStages count;
  const Rows r = clipped(c, count);
  REQUIRE(same_bits(r, expected(c)));
  REQUIRE(r.size() == 4);
  CHECK(r[1] == Row{1, 0.5f, 0, 1, 0.5f, odd + ulp, 0});
  CHECK(count[Stage::quotient_tie] == 5);
}

// The same edge, with w - x = 1 - 2^-60 and -1: the cut is so little before the middle, or behind
// it, that no double sees it.
TEST_CASE("correctly rounded: what is next to a tie goes to its own side") {
  const float even = 0.5f, odd = 0.5f + 0x1p-24f,
              tiny = GENERATE(as<float>{}, 0x1p-60f, -0x1p-60f, 0x1p-120f);
  const Case c = {{}, {vertex(tiny, even, 0, 1), vertex(2, odd, 0, 1), vertex(0, -0.5f, 0, 1)}};
  CountStages count;
  const Rows r = clipped(c, count);
  REQUIRE(same_bits(r, expected(c)));
  REQUIRE(r.size() == 4);
  CHECK(r[1][1] == (tiny > 0 ? even : odd));
  CHECK(count[Stage::quotient_midpoint] == 1);
  CHECK(count[Stage::quotient_tie] == 0);
}

// The edge 0-1 meets the top plane in its middle, where x = 1 + tiny / 2. That is where the polygon
// of the other two vertices has one more corner, or none.
TEST_CASE("correctly rounded: a vertex that double puts on a plane is on its own side of it") {
  const float tiny = GENERATE(as<float>{}, 0x1p-70f, -0x1p-70f, 0.0f);
  const Case c = {{}, {vertex(tiny, 0, 0, 1), vertex(2, 2, 0, 1), vertex(-0.5f, 1, 0, 1)}};
  CountStages count;
  const Rows r = clipped(c, count);
  CHECK(same_bits(r, expected(c)));
  CHECK(r.size() == (tiny > 0 ? 4 : 3));
  CHECK(count[Stage::sign_exact] > 0);
}

TEST_CASE("correctly rounded: only what rounds to infinity is infinite") {
  const float w = GENERATE(as<float>{}, 0x1p-128f, 0x1p-127f, 0x1p-140f);
  Case c = {{.depth = DepthRange::zero_to_one},
            {vertex(0, 0, 0, w), vertex(w, 0, 0, w), vertex(0, w, 0, w)}};
  const Rows r = clipped(c);
  CHECK(same_bits(r, expected(c)));
  REQUIRE(r.size() == 3);
  CHECK(std::isinf(r[0][3]) == (w < 0x1p-127f));
}

TEST_CASE("correctly rounded: with depth clamp an infinite z draws nothing") {
  Case c = {{.depth_clamp = true},
            {vertex(0, 0, 1, kSmallest), vertex(1, 0, 0, 1), vertex(0, 1, 0, 1)}};
  CHECK(clipped(c).empty());
  c.triangle[0].position[2] = kSmallest;
  CHECK(clipped(c).size() == 3);
}

TEST_CASE("correctly rounded: what is not finite draws nothing, or is an attribute") {
  const float bad =
      GENERATE(as<float>{}, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN());
  const Case whole = {{}, {vertex(0, 0, 0, 1), vertex(2, 0, 0, 1), vertex(0, 0.5f, 0, 1)}};
  for (int i = 0; i < 4; ++i) {
    Case c = whole;
    c.triangle[1].position[i] = bad;
    CHECK(clipped(c).empty());
  }
  Case c = whole;
  c.triangle[2].attributes[0] = bad;
  const Rows r = clipped(c);
  REQUIRE(r.size() == 4);
  CHECK(r[1][4] == 0);  // on the edge 0-1
  CHECK(std::isfinite(r[0][4]));
  CHECK(!std::isfinite(r[3][4]));
  c.volume.clip_distances = 1;
  c.triangle[1].attributes[0] = -1;
  CHECK(clipped(c).empty());
}

TEST_CASE("correctly rounded: the number of attributes is of no consequence to positions") {
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    Case c = scattered(random);
    c.volume.clip_distances = 0;
    ClipTriangle<float, 0> bare;
    ClipTriangle<float, kRunTime> at_run_time;
    for (int v = 0; v < 3; ++v) {
      bare[v].position = at_run_time[v].position = c.triangle[v].position;
      at_run_time[v].attributes.resize(1);
      at_run_time[v].attributes[0] = c.triangle[v].attributes[0];
    }
    NdcPolygon<float, 0> out;
    NdcPolygon<float, kRunTime> out_at_run_time;
    CorrectlyRounded{}(c.volume, bare, out);
    CorrectlyRounded{}(c.volume, at_run_time, out_at_run_time);
    const Rows r = clipped(c);
    REQUIRE(out.size() == static_cast<int>(r.size()));
    REQUIRE(out_at_run_time.size() == out.size());
    for (int v = 0; v < out.size(); ++v) {
      REQUIRE(out[v].position == out_at_run_time[v].position);
      REQUIRE(out[v].position[0] == r[v][0]);
      REQUIRE(out_at_run_time[v].attributes[0] == r[v][4]);
    }
  }
}

TEST_CASE("correctly rounded: no vertex is the first") {
  for (Case (*make)(Random&) :
       {scattered, on_lattice, grazing, of_wide_exponents, subnormal, without_area}) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) check_that_no_vertex_is_first(make(random), clipped);
  }
}

TEST_CASE("correctly rounded: positions times a power of two are the same positions") {
  Random random(4);
  for (int i = 0; i < 5000; ++i) {
    Case c = scattered(random);
    c.volume.clip_distances = 0;
    Rows r = clipped(c);
    const int exponent = static_cast<int>(random() % 121) - 60;
    for (ClipVertex<float, kAttributes>& v : c.triangle) {
      for (int k = 0; k < 4; ++k) v.position[k] = std::ldexp(v.position[k], exponent);
    }
    for (Row& row : r) row[3] = std::ldexp(row[3], -exponent);
    if (!same_bits(r, clipped(c))) FAIL(describe(c));
  }
}

// A row of a polygon whose coordinates lie on the edge between two vertices of a triangle: the
// third attribute is 1 at the vertex across from it, hence 0 on the edge alone.
Rows on_shared_edge(const Rows& polygon) {
  Rows r;
  std::ranges::copy_if(polygon, std::back_inserter(r), [](const Row& row) { return row[6] == 0; });
  std::ranges::sort(r);
  return r;
}

TEST_CASE("correctly rounded: two triangles have the bits of their common edge in common") {
  int shared = 0;
  for (Case (*make)(Random&) : {scattered, grazing}) {
    Random random(5);
    for (int i = 0; i < 3000; ++i) {
      Case a = make(random);
      a.volume.clip_distances = 0;
      Case b = make(random);
      b.volume = a.volume;
      a.triangle[0].attributes[2] = a.triangle[1].attributes[2] = 0;
      a.triangle[2].attributes[2] = b.triangle[2].attributes[2] = 1;
      b.triangle[0] = a.triangle[1];
      b.triangle[1] = a.triangle[0];
      const Rows in_a = clipped(a), in_b = clipped(b);
      if (in_a.empty() || in_b.empty()) continue;
      const Rows edge_a = on_shared_edge(in_a), edge_b = on_shared_edge(in_b);
      shared += edge_a.empty() ? 0 : 1;
      if (!same_bits(edge_a, edge_b)) FAIL(describe(a) << describe(b));
    }
  }
  CHECK(shared > 500);
}

}  // namespace
}  // namespace clipscope::reference
