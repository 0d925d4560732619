// SPDX-License-Identifier: GPL-3.0-or-later
//
// The correctly rounded clipper in view space against the truth of the frustum's exact numbers, rounded
// once: every bit of every coordinate.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>

#include "experiments/catalogue/catalogue.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/barycentric/correctly_rounded.hpp"
#include "tests/catch.hpp"
#include "tests/reference/rounded_rows.hpp"
#include "tests/reference/view_cases.hpp"

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

Rows expected(const ViewCase& c) {
  return rounded(clip(Truth::of_frustum(frustum_cast<double>(c.frustum), c.volume),
                      input_triangle(c.triangle)));
}

struct Compared {
  std::int64_t triangles = 0, coordinates = 0;
  CountStages stages;
};

// Fails at the first triangle that differs.
Compared compare_with_reference(ViewCase (*make)(Random&), int triangles, std::uint64_t seed) {
  Random random(seed);
  Compared r;
  for (; r.triangles < triangles; ++r.triangles) {
    ViewCase c = make(random);
    add_zero(c);
    const Rows computed = clipped(c, r.stages), exact = expected(c);
    r.coordinates += static_cast<std::int64_t>(exact.size() * Row{}.size());
    if (!same_bits(computed, exact)) {
      FAIL(describe(c) << "has " << computed.size() << " vertices, exactly " << exact.size());
    }
  }
  return r;
}

TEST_CASE("correctly rounded: in view space every bit is that of the exact polygon rounded once") {
  for (const ViewCaseSet& set : kViewCaseSets) {
    INFO(set.name);
    const Compared r = compare_with_reference(set.make, 15000, 1);
    CHECK(r.coordinates > 5000);
    CHECK(r.stages[Stage::sign_filtered] > 0);
  }
}

// Run by name, for a longer look, each time another one: prints what was compared and which stage settled it.
TEST_CASE("correctly rounded: a long comparison in view space", "[.long]") {
  const std::uint64_t seed = std::random_device{}();
  INFO("seed " << seed);
  std::int64_t total = 0;
  for (const ViewCaseSet& set : kViewCaseSets) {
    const Compared r = compare_with_reference(set.make, 600000, seed);
    total += r.coordinates;
    std::ostringstream s;
    s << set.name << ": " << r.coordinates << " coordinates; stages";
    for (const std::int64_t n : r.stages.counts) s << ' ' << n;
    WARN(s.str());
  }
  WARN(total << " coordinates");
}

}  // namespace
}  // namespace clipscope::reference
