// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/builtin.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/machine/errors.hpp"
#include "spaces/planes.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/mesh_bits.hpp"
#include "tests/experiments/scenes/messages.hpp"

namespace clipscope::experiments {
namespace {

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const SceneInfo& info : builtin_scenes()) all.emplace_back(info.name);
  return all;
}

bool same_bits(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.attributes == b.attributes && a.triangles == b.triangles;
}

struct Crossings {
  int none = 0, near = 0, far = 0, sides = 0, w0 = 0;
};

Crossings crossings_of(const Scene& scene, const View& view) {
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  view_triangles(scene, view, 0, triangles);
  Crossings found;
  for (const SceneTriangle& t : triangles) {
    const auto code = [&](std::size_t i) { return view_outcode(view.frustum, t[i].position); };
    const OutcodeSummary both = summarize_outcodes(ClipVolume{}, t, code);
    const Outcode crossed = both.any & ~both.all;
    found.none += crossed == 0;
    found.near += (crossed & bit(Plane::near)) != 0;
    found.far += (crossed & bit(Plane::far)) != 0;
    found.sides += (crossed & 0xf) != 0;
    const auto [lo, hi] = std::minmax({t[0].position[2], t[1].position[2], t[2].position[2]});
    found.w0 += lo < 0 && hi > 0;
  }
  return found;
}

TEST_CASE("scenes: each has finite numbers, indices in range, a view and valid frusta") {
  const std::string name = GENERATE(from_range(names()));
  const bool quick = GENERATE(true, false);
  const Scene scene = make_builtin_scene(name, {.seed = 5, .quick = quick});
  INFO(name);
  CHECK(scene.name == name);
  CHECK(!scene.description.empty());
  CHECK(!scene.mesh.triangles.empty());
  CHECK(scene.mesh.positions.size() == scene.mesh.attributes.size());
  const auto is_finite = [](const auto& values) {
    return std::ranges::all_of(values, [](float x) { return std::isfinite(x); });
  };
  CHECK(std::ranges::all_of(scene.mesh.positions, is_finite));
  CHECK(std::ranges::all_of(scene.mesh.attributes, is_finite));
  CHECK(std::ranges::all_of(scene.mesh.attributes, [](const auto& a) {
    return std::abs(a[2]) <= 1 && std::abs(a[3]) <= 1;
  }));
  CHECK(std::ranges::all_of(scene.mesh.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t i) { return i < scene.mesh.positions.size(); });
  }));
  REQUIRE(!scene.views.empty());
  CHECK(std::ranges::all_of(scene.views, [](const View& view) { return is_valid(view.frustum); }));
}

TEST_CASE("scenes: the same options give the same bits") {
  const std::string name = GENERATE(from_range(names()));
  const SceneOptions options{.seed = 9, .quick = true};
  CHECK(same_bits(make_builtin_scene(name, options).mesh, make_builtin_scene(name, options).mesh));
}

TEST_CASE("scenes: seed 1 gives the same bits on every platform") {
  const auto hash = [](const char* name) {
    return hash_of(make_builtin_scene(name, {.seed = 1, .quick = true}).mesh);
  };
  CHECK(hash("teapot") == 0xf1dfde061f97ee61u);
  CHECK(hash("floor") == 0xbb41c0a286611707u);
  CHECK(hash("corridor") == 0xe748f494dac29515u);
  CHECK(hash("terrain") == 0x1820d3a141bb9501u);
  CHECK(hash("soup") == 0x6e4195ef9615d684u);
  CHECK(hash("slivers") == 0x171352dd71fe3288u);
}

TEST_CASE("scenes: the random ones change with the seed") {
  const std::string name =
      GENERATE("terrain", "soup", "soup_inside", "soup_outside", "soup_straddling", "soup_behind",
               "soup_several_planes", "slivers");
  const auto mesh = [&](std::uint64_t seed) {
    return make_builtin_scene(name, {.seed = seed, .quick = true}).mesh;
  };
  CHECK(!same_bits(mesh(1), mesh(2)));
}

TEST_CASE("scenes: quick is smaller") {
  const std::string name = GENERATE(from_range(names()));
  const auto triangles = [&](bool quick) {
    return make_builtin_scene(name, {.quick = quick}).mesh.triangles.size();
  };
  CHECK(3 * triangles(true) < triangles(false));
}

TEST_CASE("scenes: an unknown name is refused with the list of the known ones") {
  const std::string message = message_of<UsageError>([] { make_builtin_scene("teapod", {}); });
  CHECK(contains(message, "'teapod'"));
  for (const std::string& name : names()) CHECK(contains(message, name));
}

TEST_CASE("scenes: each triangle of the corridor crosses a plane and w = 0 in each view") {
  const Scene scene = make_builtin_scene("corridor", {});
  for (const View& view : scene.views) {
    const Crossings found = crossings_of(scene, view);
    CHECK(found.none == 0);
    CHECK(found.w0 == static_cast<int>(scene.mesh.triangles.size()));
  }
}

TEST_CASE("scenes: teapot, floor and terrain have views across near, far, the sides and w = 0") {
  const std::string name = GENERATE("teapot", "floor", "terrain");
  const Scene scene = make_builtin_scene(name, {});
  Crossings most;
  for (const View& view : scene.views) {
    const Crossings found = crossings_of(scene, view);
    most.near = std::max(most.near, found.near);
    most.far = std::max(most.far, found.far);
    most.sides = std::max(most.sides, found.sides);
    most.w0 = std::max(most.w0, found.w0);
  }
  INFO(name);
  CHECK(most.near > 0);
  CHECK(most.far > 0);
  CHECK(most.sides > 0);
  CHECK(most.w0 > 0);
}

TEST_CASE("scenes: the soup is 60 % inside, 35 % outside and 5 % straddling") {
  const Scene scene = make_builtin_scene("soup", {});
  int inside = 0, outside = 0;
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  const Frustum<double> frustum = frustum_cast<double>(scene.views[0].frustum);
  view_triangles(scene, scene.views[0], 0, triangles);
  for (const SceneTriangle& t : triangles) {
    const auto code = [&](std::size_t i) {
      return view_outcode(frustum, Vec3<double>(t[i].position));
    };
    const OutcodeSummary both = summarize_outcodes(ClipVolume{}, t, code);
    inside += both.any == 0;
    outside += both.all != 0;
  }
  CHECK(triangles.size() == 20000);
  CHECK(inside == 12000);
  CHECK(outside == 7000);
}

TEST_CASE("scenes: slivers reach over ten decades and across every kind of plane") {
  const Scene scene = make_builtin_scene("slivers", {});
  double shortest = 1e30, longest = 0;
  for (const auto& t : scene.mesh.triangles) {
    const auto &a = scene.mesh.positions[t[0]], &b = scene.mesh.positions[t[1]];
    const double length = std::hypot(double{a[0]} - b[0], double{a[1]} - b[1], double{a[2]} - b[2]);
    shortest = length > 0 ? std::min(shortest, length) : shortest;
    longest = std::max(longest, length);
  }
  CHECK(shortest < 2e-4);
  CHECK(longest > 5e5);
  const Crossings found = crossings_of(scene, scene.views[0]);
  CHECK(found.near > 1000);
  CHECK(found.far > 1000);
  CHECK(found.sides > 1000);
  CHECK(found.w0 > 1000);
}

}  // namespace
}  // namespace clipscope::experiments
