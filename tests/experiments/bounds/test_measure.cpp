// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding volumes of objects: nothing visible is lost, nothing cut is accepted, and a wrong answer
// shows.
#include <algorithm>
#include <cmath>

#include "experiments/bounds/rows.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::bounds;

namespace {

const Contestant& clipper() { return find_contestant("homogeneous/sutherland_hodgman", "float"); }

// One view of a scene, in clusters, with the exact verdicts.
struct Setting {
  Scene scene;
  Objects objects;
  std::vector<SceneTriangle> triangles;
  ExactView exact;

  Setting(Scene s, std::size_t view, std::uint32_t most)
      : scene(std::move(s)), objects(clusters(scene.mesh, most)) {
    std::vector<SceneTriangle> all(scene.mesh.triangles.size());
    view_triangles(scene, scene.views[view], 0, all);
    for (const std::uint32_t t : objects.order) triangles.push_back(all[t]);
    exact = judge_view(objects, triangles, scene.views[view].frustum, 0);
  }
};

std::vector<Visibility> answers_of(const Setting& setting, std::size_t view, std::size_t kind) {
  std::vector<Visibility> answers(setting.objects.ranges.size());
  const auto culler = bound_kinds()[kind].make(setting.scene.mesh, setting.objects);
  culler(setting.scene.views[view], answers);
  return answers;
}

Scene quick_scene(std::string_view name) {
  return make_builtin_scene(name, {.seed = 3, .quick = true});
}

// A scene in view space with the one triangle.
Scene single(const std::array<std::array<float, 3>, 3>& corners, const Frustum<float>& frustum) {
  Scene scene;
  for (const auto& corner : corners) {
    scene.mesh.positions.push_back(corner);
    scene.mesh.attributes.push_back({});
  }
  scene.mesh.triangles = {{0, 1, 2}};
  scene.views = {{"as made", glm::dmat4(1.0), frustum}};
  return scene;
}

std::size_t kind_of(std::string_view name) {
  for (std::size_t kind = 0; kind < bound_kinds().size(); ++kind) {
    if (bound_kinds()[kind].name == name) return kind;
  }
  FAIL("there is no bound " << name);
  return 0;
}

long count(const std::vector<Visibility>& answers, Visibility answer) {
  return std::ranges::count(answers, answer);
}

}  // namespace

TEST_CASE("bounds: around single triangles no bound loses a visible one or accepts a cut one") {
  for (const std::string_view name : {"teapot", "terrain", "floor", "corridor", "slivers"}) {
    for (std::size_t view = 0; view < quick_scene(name).views.size(); view += 2) {
      const Setting setting(quick_scene(name), view, 1);
      CulledView culled(clipper(), setting.scene.views[view], setting.objects, setting.triangles);
      for (std::size_t kind = 0; kind < bound_kinds().size(); ++kind) {
        INFO(name << ", " << setting.scene.views[view].label << ", " << bound_kinds()[kind].name);
        const auto answers = answers_of(setting, view, kind);
        CullTally tally;
        add(setting.objects, answers, setting.exact, tally);
        CHECK(tally.judged == tally.triangles);
        CHECK(tally.visible_lost == 0);
        CHECK(tally.accepted_cut == 0);
        CHECK(tally.settled <= tally.settleable);
        if (!bound_kinds()[kind].name.ends_with("all axes")) {
          CHECK(culled.first_difference(answers).empty());
        }
      }
    }
  }
}

TEST_CASE("bounds: all axes reject slivers that only rounding shows") {
  const Setting setting(quick_scene("slivers"), 0, 1);
  CulledView culled(clipper(), setting.scene.views[0], setting.objects, setting.triangles);
  const auto answers = answers_of(setting, 0, kind_of("axis box, all axes"));
  CullTally tally;
  add(setting.objects, answers, setting.exact, tally);
  CHECK(tally.visible_lost == 0);
  CHECK_FALSE(culled.first_difference(answers).empty());
}

TEST_CASE("bounds: a hierarchy of boxes answers as the boxes of its leaves do") {
  for (const std::uint32_t most : {4u, 64u}) {
    for (const std::size_t view : {0u, 2u, 4u}) {
      const Setting setting(quick_scene("terrain"), view, most);
      CHECK(answers_of(setting, view, kind_of("box hierarchy")) ==
            answers_of(setting, view, kind_of("axis box")));
    }
  }
}

TEST_CASE("bounds: a hierarchy of spheres or oriented boxes settles what its leaves settle") {
  for (const char* name : {"sphere", "oriented box"}) {
    for (const std::size_t view : {0u, 2u, 4u}) {
      const Setting setting(quick_scene("terrain"), view, 16);
      const auto leaves = answers_of(setting, view, kind_of(name));
      const auto tree = answers_of(setting, view, kind_of(std::string(name) + " hierarchy"));
      for (std::size_t i = 0; i < leaves.size(); ++i) {
        if (leaves[i] != Visibility::look_closer) CHECK(tree[i] == leaves[i]);
      }
    }
  }
}

TEST_CASE("bounds: all axes reject what the planes reject, and more") {
  long more = 0;
  for (const char* name : {"axis box", "oriented box"}) {
    for (const std::size_t view : {0u, 2u, 4u}) {
      const Setting setting(quick_scene("terrain"), view, 16);
      const auto planes = answers_of(setting, view, kind_of(name));
      const auto axes = answers_of(setting, view, kind_of(std::string(name) + ", all axes"));
      for (std::size_t i = 0; i < planes.size(); ++i) {
        if (planes[i] != Visibility::look_closer) CHECK(axes[i] == planes[i]);
      }
      more += count(axes, Visibility::rejected) - count(planes, Visibility::rejected);
    }
  }
  CHECK(more > 0);
}

TEST_CASE("bounds: an answer that is altered shows in the tally and in the polygons") {
  const Setting setting(quick_scene("teapot"), 2, 16);
  CulledView culled(clipper(), setting.scene.views[2], setting.objects, setting.triangles);
  const auto answers = answers_of(setting, 2, 0);
  // Alters the answer on an object of which exact arithmetic says the same.
  const auto alter = [&](Visibility from, Visibility to) {
    for (std::size_t object = 0; object < answers.size(); ++object) {
      const TriangleRange& range = setting.objects.ranges[object];
      if (answers[object] != from || setting.exact.object(range) != from) continue;
      auto altered = answers;
      altered[object] = to;
      CHECK_FALSE(culled.first_difference(altered).empty());
      CullTally tally;
      add(setting.objects, altered, setting.exact, tally);
      return std::pair{tally, range.count};
    }
    FAIL("no object to alter");
    return std::pair{CullTally{}, 0u};
  };
  const auto [lost, whole] = alter(Visibility::accepted, Visibility::rejected);
  CHECK(lost.visible_lost == whole);
  const auto [cut, invisible] = alter(Visibility::rejected, Visibility::accepted);
  CHECK(cut.accepted_cut == invisible);
  CHECK(alter(Visibility::look_closer, Visibility::rejected).first.visible_lost > 0);
  CHECK(alter(Visibility::look_closer, Visibility::accepted).first.accepted_cut > 0);
}

TEST_CASE("bounds: a triangle on a plane, or a few ulps beside it, is looked at closer") {
  Frustum<float> frustum;
  frustum.far = 1000;
  for (const float z : {-1.0f, -1000.0f}) {
    for (const float beside : {z, std::nextafter(z, 0.0f), std::nextafter(z, -2000.0f)}) {
      const Scene scene =
          single({{{-0.1f, 0, beside}, {0.1f, 0, beside}, {0, 0.1f, beside}}}, frustum);
      const Setting setting(scene, 0, 1);
      for (std::size_t kind = 0; kind < bound_kinds().size(); ++kind) {
        INFO("z = " << beside << ", " << bound_kinds()[kind].name);
        CHECK(answers_of(setting, 0, kind).front() == Visibility::look_closer);
      }
    }
  }
}

TEST_CASE("bounds: well inside is accepted, well outside of a plane is rejected") {
  const auto answer = [](float x, float z) {
    const Setting setting(single({{{x, 0, z}, {x + 0.1f, 0, z}, {x, 0.1f, z}}}, Frustum<float>{}),
                          0, 1);
    return answers_of(setting, 0, 1).front();
  };
  CHECK(answer(0, -2) == Visibility::accepted);
  CHECK(answer(3, -2) == Visibility::rejected);
  CHECK(answer(0, 2) == Visibility::rejected);
  CHECK(answer(0, -0.5f) == Visibility::rejected);
}

TEST_CASE("bounds: time is measured with and without, and exact verdicts cover what is asked for") {
  const ObjectScene field = teapot_field(1, true);
  const std::uint32_t each = field.objects.ranges.front().count;
  const auto results = measure(field, clipper(), {.rounds = 3, .judged_triangles = 2000});
  REQUIRE(results.size() == 5);  // pots are no hierarchy
  for (const Result& result : results) {
    CHECK(result.with.is_timed());
    CHECK(result.without.samples_ns.size() == 3);
    CHECK(result.with.samples_ns.size() == 3);
    REQUIRE(result.with.speedup);
    CHECK(result.with.speedup->low > 0);
    CHECK(result.tally.objects == 36 * 8);
    CHECK(result.tally.judged > 0);
    CHECK(result.tally.judged <= 8 * 2000 + 8 * each);
    CHECK(row_of(field, clipper(), result).polygons == kSame);
  }
}

TEST_CASE("bounds: a clipper that draws what is rejected is not timed") {
  ObjectScene scene{quick_scene("teapot"), "cluster of 64", {}};
  scene.objects = clusters(scene.scene.mesh, 64);
  const Contestant& naive = find_contestant("cvv/naive", "float");
  for (const Result& result : measure(scene, naive, {.rounds = 2})) {
    INFO(result.bound);
    CHECK(result.with.refused.find(" seen from ") != std::string::npos);
    CHECK(result.with.samples_ns.empty());
    const Row row = row_of(scene, naive, result);
    CHECK(row.polygons == result.with.refused);
    CHECK_FALSE(row.ns_with);
    CHECK_FALSE(row.speedup);
  }
}
