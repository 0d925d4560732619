// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
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
    if (pivot == rows.end()) continue;
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

// "scaled by 2^20" of "theme/name (scaled by 2^20)".
std::string label_of(const HardCase& variant) {
  const std::size_t begin = variant.name.find('(') + 1;
  return variant.name.substr(begin, variant.name.size() - begin - 1);
}

// How the exact result of a variant follows from the original's, vertex by vertex:
//   x', y' = x, y or y, x by swap_xy, then times sign_x, sign_y     z' = z_scale z + z_offset
//   (1/w)' = 2^inv_w_exponent (1/w)                                 attributes' = attributes
// The vertices are a set. Where the input has no area (see ExactPolygon), other vertices among
// those that coincide may have stayed, unless keeps_order.
struct Relation {
  bool swap_xy = false;
  int sign_x = 1, sign_y = 1;
  double z_scale = 1, z_offset = 0;
  int inv_w_exponent = 0;
  bool keeps_order = true;  // the vertices of the input are in the original's order
};

// Depth is near + s (far - near) with the same s in every range.
std::array<double, 2> depth_ends(DepthRange depth) {
  switch (depth) {
    case DepthRange::minus_one_to_one: return {-1, 1};
    case DepthRange::zero_to_one: return {0, 1};
    case DepthRange::reversed: return {1, 0};
  }
  return {0, 1};
}

// None for neighbours: only the exact reference knows.
std::optional<Relation> relation_of(const HardCase& original, const HardCase& variant) {
  const std::string label = label_of(variant);
  const std::string scaled = "scaled by 2^";
  if (label.starts_with(scaled)) {
    const bool w_is_one =
        original.space == Space::view && original.frustum.kind == ProjectionKind::parallel;
    return Relation{.inv_w_exponent = w_is_one ? 0 : -std::stoi(label.substr(scaled.size()))};
  }
  if (label.starts_with("rotated by") || label == "ends swapped" || label == "in reverse order") {
    return Relation{.keeps_order = false};
  }
  if (label == "x mirrored") return Relation{.sign_x = -1};
  if (label == "y mirrored") return Relation{.sign_y = -1};
  if (label == "x and y mirrored") return Relation{.sign_x = -1, .sign_y = -1};
  if (label == "x and y swapped") return Relation{.swap_xy = true};
  if (label == "depth mirrored") return Relation{.z_scale = -1};
  if (label == "near and far exchanged") return Relation{};
  if (label.starts_with("depth ")) {
    const auto from = depth_ends(original.volume.depth), to = depth_ends(variant.volume.depth);
    const double scale = (to[1] - to[0]) / (from[1] - from[0]);
    return Relation{.z_scale = scale, .z_offset = to[0] - scale * from[0]};
  }
  CHECK(label.ends_with("1 ulp"));
  return std::nullopt;
}

// The variant's exact vertices, sorted, from the original's.
std::vector<RationalVertex> related(const Relation& relation,
                                    std::vector<RationalVertex> original) {
  const Rational z_scale(relation.z_scale), z_offset(relation.z_offset);
  const Rational inv_w_scale(std::ldexp(1.0, relation.inv_w_exponent));
  for (RationalVertex& v : original) {
    if (relation.swap_xy) std::swap(v.x, v.y);
    v.x *= relation.sign_x;
    v.y *= relation.sign_y;
    v.z = z_scale * v.z + z_offset;
    v.inv_w *= inv_w_scale;
  }
  std::ranges::sort(original, [](const auto& a, const auto& b) { return a < b; });
  return original;
}

TEST_CASE("families: the exact result of every exact change follows from the original's") {
  std::size_t related_variants = 0;
  for (const HardCase& original : builtin_catalogue()) {
    const std::vector<RationalVertex> vertices = exact_vertices(original);
    const bool unique = has_extent(original);
    for (const HardCase& variant : family(original)) {
      CAPTURE(variant.name);
      const std::optional<Relation> relation = relation_of(original, variant);
      if (!relation) continue;
      ++related_variants;
      const std::vector<RationalVertex> expected = related(*relation, vertices);
      const std::vector<RationalVertex> found = exact_vertices(variant);
      CHECK(variant.expected.verdict == original.expected.verdict);
      CHECK(points(found) == points(expected));
      if (unique || relation->keeps_order) CHECK(found == expected);
    }
  }
  CHECK(related_variants > 2000);
}

TEST_CASE("families: every variant has floats for coordinates and a name of its own") {
  const auto is_float = [](double v) { return double{static_cast<float>(v)} == v; };
  for (const HardCase& original : builtin_catalogue()) {
    std::set<std::string> names;
    for (const HardCase& variant : family(original)) {
      CAPTURE(variant.name);
      CHECK(names.insert(variant.name).second);
      CHECK(variant.expected == exact_outcome(variant));
      for (const reference::InputVertex& v : variant.vertices) {
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
  const std::vector<HardCase> variants = family(original);
  const auto swapped = std::ranges::find(variants, "ends swapped", label_of);
  REQUIRE(swapped != variants.end());
  CHECK(swapped->vertices[0].position == original.vertices[1].position);
  CHECK(swapped->vertices[1].position == original.vertices[0].position);
}

TEST_CASE("families: what would overflow or lose bits isn't scaled") {
  const auto labels = [](const char* name) {
    std::set<std::string> r;
    for (const HardCase& variant : family(find(name))) r.insert(label_of(variant));
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
  for (const HardCase& variant : family(original)) {
    if (variant.name.find("ulp") == std::string::npos) continue;
    ++neighbours;
    int moved = 0;
    for (int i = 0; i < 3; ++i) {
      for (int c = 0; c < 4; ++c) {
        const auto before = static_cast<float>(original.vertices[i].position[c]);
        const auto after = static_cast<float>(variant.vertices[i].position[c]);
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
  const std::vector<HardCase> variants = special_values(original);
  CHECK(variants.size() == 11 * 12);
  int finite = 0;
  for (const HardCase& variant : variants) {
    if (is_finite(variant)) {
      ++finite;
      CHECK(variant.expected == exact_outcome(variant));
    }
  }
  CHECK(finite == 8 * 12);
  CHECK(special_values(find("frustum_conventions/perspective_gl")).size() == 11 * 9);
  CHECK(special_values(find("polygons/square_covers")).size() == 3 * 16);
}

}  // namespace
}  // namespace clipscope::experiments
