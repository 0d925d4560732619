// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/objects.hpp"

#include <algorithm>
#include <numeric>

#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::bounds;

TEST_CASE("bounds: every triangle belongs to exactly one object") {
  const Mesh mesh = make_builtin_scene("terrain", {.seed = 3, .quick = true}).mesh;
  for (const Objects& objects : {clusters(mesh, 64), clusters(mesh, 1), instances(mesh, 32)}) {
    std::vector<std::uint32_t> sorted = objects.order, expected(mesh.triangles.size());
    std::iota(expected.begin(), expected.end(), 0u);
    std::ranges::sort(sorted);
    CHECK(sorted == expected);
    std::uint32_t next = 0;
    for (const TriangleRange& range : objects.ranges) {
      CHECK(range.first == next);
      CHECK(range.count > 0);
      next += range.count;
    }
    CHECK(next == mesh.triangles.size());
  }
}

TEST_CASE("bounds: the field of teapots is the same for a seed, and its pots are whole objects") {
  const ObjectScene field = teapot_field(5, true);
  CHECK(field.scene.mesh.positions == teapot_field(5, true).scene.mesh.positions);
  CHECK(field.scene.mesh.positions != teapot_field(6, true).scene.mesh.positions);
  const Objects& objects = field.objects;
  REQUIRE(objects.ranges.size() == 36);
  for (const TriangleRange& range : objects.ranges) {
    const auto positions = positions_of(field.scene.mesh, objects, range);
    const AxisBox<double> box = clipscope::bounding_box(std::span<const Vec3<double>>(positions));
    CHECK(box.upper[0] - box.lower[0] < 8);
    CHECK(box.upper[2] - box.lower[2] < 8);
  }
}

TEST_CASE(
    "bounds: by default the pots of the field are objects, and named scenes come in clusters") {
  CHECK(object_scenes({}).front().most == 0);
  Selection selection;
  selection.quick = true;
  selection.scenes = {"teapot"};
  const std::vector<ObjectSceneName> names = object_scenes(selection);
  REQUIRE(names.size() == 2);
  const ObjectScene scene = load_object_scene(selection, names[1]);
  CHECK(scene.object == "cluster of 256");
  for (const TriangleRange& range : scene.objects.ranges) CHECK(range.count <= 256);
}
