// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/lattice.hpp"

#include <algorithm>
#include <set>

#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using Triangle = std::array<LatticePoint, 3>;

// Written again: x, y and perhaps z negated, x and y exchanged.
std::set<Triangle> images(const Triangle& triangle, bool mirror_z) {
  std::set<Triangle> r;
  for (const float sx : {1.0f, -1.0f}) {
    for (const float sy : {1.0f, -1.0f}) {
      for (const float sz : {1.0f, -1.0f}) {
        for (const bool exchange : {false, true}) {
          if (sz < 0 && !mirror_z) continue;
          Triangle image = triangle;
          for (LatticePoint& p : image) {
            p = {sx * p[0], sy * p[1], sz * p[2], p[3]};
            if (exchange) std::swap(p[0], p[1]);
          }
          std::sort(image.begin(), image.end());
          r.insert(image);
        }
      }
    }
  }
  return r;
}

std::vector<LatticeTriangle> all(const Lattice& lattice) {
  std::vector<LatticeTriangle> r;
  for (std::size_t chunk = 0; chunk < lattice.chunks(); ++chunk) {
    lattice.visit_chunk(chunk, [&](const LatticeTriangle& t) { r.push_back(t); });
  }
  return r;
}

TEST_CASE("lattice: one triangle of every class is visited, its first image") {
  const DepthRange depth = GENERATE(DepthRange::minus_one_to_one, DepthRange::reversed);
  const bool mirror_z = depth == DepthRange::minus_one_to_one;
  const float coordinates[] = {-1, 0, 1}, ws[] = {-1, 2};
  const Lattice lattice(coordinates, ws, depth);
  CHECK(lattice.points() == 54);
  CHECK(lattice.triangles() == 54 * 55 * 56 / 6);

  std::set<Triangle> reached;
  std::uint64_t visited = 0;
  for (const LatticeTriangle& t : all(lattice)) {
    ++visited;
    const std::set<Triangle> same = images(t.vertices, mirror_z);
    REQUIRE(*same.begin() == t.vertices);
    REQUIRE(static_cast<int>(same.size()) == t.class_size);
    for (const Triangle& image : same) REQUIRE(reached.insert(image).second);
  }
  CHECK(visited == lattice.classes());
  CHECK(reached.size() == lattice.triangles());
}

// One coordinate, 0, and w of 1, 2, 3: no symmetry moves anything, and all 3 4 5 / 6 = 10 multisets
// are classes.
TEST_CASE("lattice: points that no symmetry moves, by hand") {
  const float zero[] = {0}, ws[] = {1, 2, 3};
  const Lattice lattice(zero, ws, DepthRange::minus_one_to_one);
  CHECK(lattice.triangles() == 10);
  CHECK(lattice.classes() == 10);
  CHECK(all(lattice).size() == 10);
}

// Thrice the same corner: 1 class. Twice one and another: 5, by the difference, along x or y, along
// z, along both x and y, along z and one of them, along all. Three corners at one z: 1. Two at one
// z and one at the other: the two are neighbours or not, the third is across from one of them or
// not: 4.
TEST_CASE("lattice: the corners of a cube are 11 classes, by hand") {
  const float corners[] = {-1, 1}, ws[] = {1};
  const Lattice lattice(corners, ws, DepthRange::minus_one_to_one);
  CHECK(lattice.triangles() == 120);
  const std::vector<LatticeTriangle> triangles = all(lattice);
  CHECK(lattice.classes() == 11);
  CHECK(triangles.size() == 11);
  int sum = 0;
  for (const LatticeTriangle& t : triangles) sum += t.class_size;
  CHECK(sum == 120);
}

TEST_CASE(
    "lattice: the small one has as many classes as it says, and stands for all its triangles") {
  const Lattice lattice = named_lattice("small");
  std::uint64_t visited = 0, stands_for = 0;
  for (std::size_t chunk = 0; chunk < lattice.chunks(); ++chunk) {
    lattice.visit_chunk(chunk, [&](const LatticeTriangle& t) {
      ++visited;
      stands_for += static_cast<std::uint64_t>(t.class_size);
    });
  }
  CHECK(visited == lattice.classes());
  CHECK(stands_for == lattice.triangles());
}

TEST_CASE("lattice: the named ones have the sizes that their header states") {
  struct Size {
    std::string_view name;
    std::uint64_t points, triangles, classes;
  };
  const Size size =
      GENERATE(Size{"small", 375, 8859500, 581274}, Size{"medium", 625, 40885625, 2673030},
               Size{"full", 1715, 842171330, 53480200});
  const Lattice lattice = named_lattice(size.name);
  CHECK(lattice.points() == size.points);
  CHECK(lattice.triangles() == size.triangles);
  CHECK(lattice.classes() == size.classes);
}

TEST_CASE("lattice: three lattices have names") { CHECK(lattice_names().size() == 3); }

TEST_CASE("lattice: a chunk visits the same triangles whenever it is visited") {
  const Lattice lattice = named_lattice("small");
  const std::size_t chunk = lattice.chunks() / 2;
  std::vector<Triangle> first, second;
  lattice.visit_chunk(chunk, [&](const LatticeTriangle& t) { first.push_back(t.vertices); });
  lattice.visit_chunk(chunk / 2, [](const LatticeTriangle&) {});
  lattice.visit_chunk(chunk, [&](const LatticeTriangle& t) { second.push_back(t.vertices); });
  CHECK(first == second);
}

reference::InputTriangle input_triangle(const Triangle& triangle) {
  reference::InputTriangle r;
  for (std::size_t i = 0; i < 3; ++i) {
    std::ranges::copy(triangle[i], r.vertices[i].position.begin());
  }
  return r;
}

TEST_CASE("lattice: triangles of a class have exact results of the same size") {
  const float coordinates[] = {-2, 0, 2}, ws[] = {-1, 1};
  const Lattice lattice(coordinates, ws, DepthRange::minus_one_to_one);
  const auto truth = reference::Truth::of_clip(lattice.depth());
  const auto size = [&](const Triangle& t) {
    return reference::clip(truth, input_triangle(t)).vertices.size();
  };
  for (const LatticeTriangle& t : all(lattice)) {
    const std::size_t expected = size(t.vertices);
    for (const Triangle& image : images(t.vertices, true)) REQUIRE(size(image) == expected);
  }
}

}  // namespace
}  // namespace clipscope::experiments
