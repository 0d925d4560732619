// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/families.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "experiments/catalogue/catalogue.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;
using reference::RationalVertex;
using Row = std::array<Rational, 4>;

// The number of independent vertices in homogeneous coordinates; below that of the primitive's kind
// it has no length, or no area, in NDC.
int rank(std::vector<Row> rows) {
  int rank = 0;
  for (int column = 0; column < 4; ++column) {
    const auto top = rows.begin() + rank;
    const auto pivot = std::find_if(top, rows.end(), [&](const Row& r) { return r[column] != 0; });
    if (pivot == rows.end()) {
      continue;
    }
    std::iter_swap(top, pivot);
    for (auto row = top + 1; row != rows.end(); ++row) {
      const Rational factor = (*row)[column] / (*top)[column];
      for (int c = 0; c < 4; ++c) (*row)[c] -= factor * (*top)[c];
    }
    ++rank;
  }
  return rank;
}

bool has_extent(const HardCase& hard_case) {
  std::vector<Row> rows;
  for (const reference::InputVertex& v : hard_case.vertices) {
    rows.push_back(truth_of(hard_case).clip_position(v));
  }
  return rank(rows) == std::min<int>(3, static_cast<int>(rows.size()));
}

std::vector<RationalVertex> exact_vertices(const HardCase& hard_case) {
  return vertex_set(exact_polygon(hard_case));
}

std::set<std::array<Rational, 3>> points(const std::vector<RationalVertex>& vertices) {
  std::set<std::array<Rational, 3>> r;
  for (const RationalVertex& v : vertices) r.insert({v.x, v.y, v.z});
  return r;
}

TEST_CASE("families: what a relation says of the exact result holds for every case") {
  std::size_t related_variants = 0;
  for (const HardCase& original : builtin_catalogue()) {
    const std::vector<RationalVertex> vertices = exact_vertices(original);
    const bool unique = has_extent(original);
    for (const CaseVariant& variant : family(original)) {
      if (!variant.relation) {
        continue;
      }
      ++related_variants;
      CAPTURE(variant.hard_case.name);
      const std::vector<RationalVertex> expected = related(*variant.relation, vertices);
      const std::vector<RationalVertex> found = exact_vertices(variant.hard_case);
      CHECK(variant.hard_case.expected.verdict == original.expected.verdict);
      CHECK(points(found) == points(expected));
      if (unique || variant.relation->keeps_order) {
        CHECK(found == expected);
      }
    }
  }
  CHECK(related_variants > 2000);
}

TEST_CASE("families: every variant has floats for coordinates and a label of its own") {
  const auto is_float = [](double v) { return double{static_cast<float>(v)} == v; };
  for (const HardCase& original : builtin_catalogue()) {
    std::set<std::string> labels;
    for (const CaseVariant& variant : family(original)) {
      CAPTURE(variant.hard_case.name);
      CHECK(labels.insert(variant.label).second);
      CHECK(variant.hard_case.expected == exact_outcome(variant.hard_case));
      for (const reference::InputVertex& v : variant.hard_case.vertices) {
        CHECK(std::ranges::all_of(v.position, is_float));
      }
    }
  }
}

const HardCase& find(std::string_view name) {
  const std::vector<HardCase>& cases = builtin_catalogue();
  const auto found = std::ranges::find(cases, name, &HardCase::name);
  REQUIRE(found != cases.end());
  return *found;
}

TEST_CASE("families: a triangle in clip space has 38 variants") {
  // 6 scalings, 2 rotations and the reverse order, 4 mirrored, 1 depth, 24 neighbours
  CHECK(family(find("planes_touched/covers")).size() == 38);
}

TEST_CASE("families: a segment has its ends swapped") {
  const HardCase& original = find("segments/through");
  const std::vector<CaseVariant> variants = family(original);
  const auto swapped = std::ranges::find(variants, "ends swapped", &CaseVariant::label);
  REQUIRE(swapped != variants.end());
  CHECK(swapped->hard_case.vertices[0].position == original.vertices[1].position);
  CHECK(swapped->hard_case.vertices[1].position == original.vertices[0].position);
}

TEST_CASE("families: what would overflow or lose bits isn't scaled") {
  const auto labels = [](const char* name) {
    std::set<std::string> r;
    for (const CaseVariant& variant : family(find(name))) r.insert(variant.label);
    return r;
  };
  CHECK_FALSE(labels("scale/largest_float").contains("scaled by 2^1"));
  CHECK(labels("scale/largest_float").contains("scaled by 2^-20"));
  CHECK_FALSE(labels("scale/smallest_float").contains("scaled by 2^-1"));
  CHECK(labels("scale/smallest_float").contains("scaled by 2^60"));
}

TEST_CASE("families: neighbours of every coordinate of every vertex are one ulp away") {
  const HardCase& original = find("far/sweep_1e1");
  int neighbours = 0;
  for (const CaseVariant& variant : family(original)) {
    if (variant.label.find("ulp") == std::string::npos) {
      continue;
    }
    ++neighbours;
    int moved = 0;
    for (int i = 0; i < 3; ++i) {
      for (int c = 0; c < 4; ++c) {
        const auto before = static_cast<float>(original.vertices[i].position[c]);
        const auto after = static_cast<float>(variant.hard_case.vertices[i].position[c]);
        moved += before == after ? 0 : 1;
        CHECK((before == after || std::nextafter(before, after) == after));
      }
    }
    CHECK(moved == 1);
  }
  CHECK(neighbours == 24);
}

TEST_CASE("families: special values reach every coordinate, and finite ones have an outcome") {
  const HardCase& original = find("planes_touched/covers");
  const std::vector<CaseVariant> variants = special_values(original);
  CHECK(variants.size() == 11 * 12);
  int finite = 0;
  for (const CaseVariant& variant : variants) {
    if (is_finite(variant)) {
      ++finite;
      CHECK(variant.hard_case.expected == exact_outcome(variant.hard_case));
    }
  }
  CHECK(finite == 8 * 12);
  CHECK(special_values(find("frustum_conventions/perspective_gl")).size() == 11 * 9);
  CHECK(special_values(find("polygons/square_covers")).size() == 3 * 16);
}

}  // namespace
}  // namespace clipscope::experiments
