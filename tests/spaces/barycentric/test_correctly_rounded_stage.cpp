// SPDX-License-Identifier: GPL-3.0-or-later
//
// The correctly rounded clipper's stage before the divide, against the exact reference rounded
// once.
#include <algorithm>
#include <cmath>

#include "reference/exact_clip.hpp"
#include "spaces/barycentric/correctly_rounded.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/barycentric/clip_cases.hpp"
#include "tests/spaces/barycentric/rounded_rows.hpp"

namespace clipscope::reference {
namespace {

Rows staged(const Case& c) { return rows(CorrectlyRounded::cut(c.volume, c.triangle)); }

// x_ndc / (1/w) and so on.
float round_clip(const Fraction& ndc, const Fraction& inv_w) {
  return round_to<float>(
      Fraction{ndc.numerator * inv_w.denominator, ndc.denominator * inv_w.numerator});
}

// No polygon of fewer than three vertices.
Rows expected(const Case& c) {
  const ExactPolygon exact = clip(Truth::of_clip(c.volume), input_triangle(c.triangle));
  Rows r;
  if (exact.vertices.size() < 3) return r;
  const Fraction one{1, 1};
  for (const ExactVertex& v : exact.vertices) {
    Row& row = r.emplace_back(Row{round_clip(v.x, v.inv_w), round_clip(v.y, v.inv_w),
                                  round_clip(v.z, v.inv_w), round_clip(one, v.inv_w)});
    for (int k = 0; k < kAttributes; ++k) row[4 + k] = round_to<float>(v.attributes[k]);
  }
  return r;
}

// Whether all of `part` is in `whole`, in order.
bool is_subsequence(const Rows& part, const Rows& whole) {
  std::size_t found = 0;
  for (const Row& row : whole) {
    if (found < part.size() && same_bits(row, part[found])) ++found;
  }
  return found == part.size();
}

// Equal, or vertices more that are one point in NDC.
bool agrees(const Rows& computed, const Rows& exact) {
  if (exact.empty() || computed.size() <= exact.size()) {
    return same_bits(computed, exact) || exact.empty();
  }
  return is_subsequence(exact, computed);
}

TEST_CASE("correctly rounded: every bit of the stage is that of the exact clip polygon rounded") {
  for (const CaseSet& set : kCaseSets) {
    INFO(set.name);
    const bool has_area = set.make != without_area;
    Random random(11);
    int drawn = 0, same = 0;
    for (int i = 0; i < 8000; ++i) {
      Case c = set.make(random);
      add_zero(c);
      // A vertex of the triangle comes out as it is; the reference knows but one zero.
      for (FloatTriangle::value_type& v : c.triangle) v.position += 0.0f;
      const Rows computed = staged(c), exact = expected(c);
      if (!agrees(computed, exact)) {
        FAIL(describe(c) << "has " << computed.size() << " vertices, exactly " << exact.size());
      }
      drawn += exact.empty() ? 0 : 1;
      same += same_bits(computed, exact) ? 1 : 0;
    }
    CHECK(drawn > 100);
    CHECK((!has_area || same > 7000));
  }
}

TEST_CASE("correctly rounded: what lies on a plane does so in the stage to the bit") {
  Random random(12);
  int on_planes = 0;
  for (int i = 0; i < 4000; ++i) {
    Case c = scattered(random);
    c.volume = {.depth = DepthRange::zero_to_one};
    for (ClipVertex<float, kAttributes>& v : c.triangle) v.attributes.values = {1, 1, 1};
    for (const Row& v : staged(c)) {
      CHECK((std::abs(v[0]) <= v[3] && std::abs(v[1]) <= v[3] && 0 <= v[2] && v[2] <= v[3]));
      CHECK(!std::signbit(v[2]));
      on_planes += std::abs(v[0]) == v[3] || std::abs(v[1]) == v[3] || v[2] == 0 || v[2] == v[3];
    }
  }
  CHECK(on_planes > 2000);
}

TEST_CASE("correctly rounded: a triangle inside is its own stage") {
  const Case c = {{}, {{{{0, 0, 0, 1}, {{1, 2, 3}}}, {{1, 0, 0, 1}, {}}, {{0, 1, -2, 2}, {}}}}};
  const Rows r = staged(c);
  REQUIRE(r.size() == 3);
  CHECK(r[0] == Row{0, 0, 0, 1, 1, 2, 3});
  CHECK(r[2] == Row{0, 1, -2, 2, 0, 0, 0});
}

TEST_CASE("correctly rounded: nothing is staged of what is outside or not finite") {
  Case c = {{}, {{{{3, 0, 0, 1}, {}}, {{2, 0, 0, 1}, {}}, {{4, 1, 0, 1}, {}}}}};
  CHECK(staged(c).empty());
  c.triangle[0].position[0] = kInfinity;
  CHECK(staged(c).empty());
  c.triangle[0].position = c.triangle[1].position = c.triangle[2].position = {0, 0, 0, 0};
  CHECK(staged(c).empty());
}

}  // namespace
}  // namespace clipscope::reference
