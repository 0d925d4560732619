// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cracks of real clippers on real meshes; a promise that is not kept must be found out.
#include <tbb/global_control.h>

#include <cstdlib>
#include <filesystem>

#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/watertight/measure.hpp"
#include "experiments/watertight/rows.hpp"
#include "experiments/watertight/scenes.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::watertight {
namespace {

Scene teapot() { return make_builtin_scene("teapot", {.quick = true}); }

Scene corridor() { return make_builtin_scene("corridor", {.quick = true}); }

Measured measure_one(const Scene& scene, const Contestant& contestant, std::size_t edges = 200) {
  return measure(scene, {&contestant}, {.edges_per_view = edges}).front();
}

Measured measure_one(const Scene& scene, std::string_view clipper,
                     std::string_view scalar = "float") {
  return measure_one(scene, find_contestant(clipper, scalar));
}

}  // namespace

TEST_CASE(
    "watertight: textbook cuts in its own winding's direction and cracks in float, not exactly") {
  const Measured in_float = measure_one(corridor(), "textbook");
  CHECK(in_float.row.all.crack_px > 1e-4);
  CHECK(in_float.row.all.t_junctions > 0);
  CHECK(in_float.worst.crack_px == in_float.row.all.crack_px);
  const GapTally exact = measure_one(corridor(), "textbook", "exact").row.all;
  CHECK(exact.edges > 0);
  CHECK(exact.identical == exact.edges);
}

TEST_CASE("watertight: a clipper that cuts from one end has the same bits on both sides") {
  for (const char* name :
       {"homogeneous/pipeline", "homogeneous/blinn_newell", "barycentric/distance_matrix",
        "homogeneous/sutherland_hodgman", "homogeneous/from_inside"}) {
    INFO(name);
    const GapTally tally = measure_one(corridor(), name).row.all;
    CHECK(tally.edges > 100);
    CHECK(tally.identical == tally.edges);
    CHECK(tally.absent == 0);
  }
}

TEST_CASE(
    "watertight: promises hold where only one neighbour crosses a plane, careful others part") {
  const Scene grazing = make_grazing_scene(4000, 1);
  for (const Contestant* c : select_contestants("*", {"float"})) {
    INFO(c->clipper);
    const Verdict expected = c->promise.watertight ? Verdict::kept : Verdict::not_promised;
    CHECK(measure_one(grazing, *c, 0).row.promise == expected);
  }
  const Contestant& parting = find_contestant("homogeneous/from_inside", "float");
  CHECK(measure_one(grazing, parting, 0).row.all.t_junctions > 0);
}

TEST_CASE("watertight: a promise that is not kept is broken, in the table and in the finding") {
  Contestant liar = find_contestant("textbook", "float");
  liar.promise.watertight = true;
  const auto measured =
      measure(corridor(), {&liar, &find_contestant("homogeneous/pipeline", "float")},
              {.edges_per_view = 200});
  CHECK(measured[0].row.promise == Verdict::broken);
  CHECK(measured[1].row.promise == Verdict::kept);
  const std::vector<SummaryRow> summary = summary_rows({measured[0].row, measured[1].row});
  CHECK(summary[0].promise == Verdict::broken);
  const std::string text = finding({}, summary);
  CHECK(text.find("are BROKEN by") != std::string::npos);
  CHECK(text.find("the textbook clipper in float") != std::string::npos);
}

TEST_CASE("watertight: a clipper that drops triangles loses neighbours and has no crack") {
  const GapTally tally = measure_one(teapot(), "whole/any_outside").row.all;
  CHECK(tally.lost > 0);
  CHECK(tally.lost_px > 10);
  CHECK(tally.identical == tally.absent);
  CHECK(tally.crack_px == 0);
}

TEST_CASE("watertight: the classes of edges add up, whatever the number of threads") {
  const Measured parallel = measure_one(teapot(), "textbook");
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Measured serial = measure_one(teapot(), "textbook");
  CHECK(parallel.row.all.crack_px == serial.row.all.crack_px);
  CHECK(parallel.row.all.t_junctions == serial.row.all.t_junctions);
  std::int64_t edges = 0, different = 0;
  for (const auto& [key, tally] : serial.by_class) {
    edges += tally.edges;
    if (key.second == Neighbours::different) different += tally.edges;
  }
  CHECK(edges == serial.row.all.edges);
  CHECK(different == serial.row.different.edges);
  CHECK(different > 0);
}

TEST_CASE("watertight: the input of a crack reads back bit for bit") {
  const Scene scene = corridor();
  const View& view = scene.views.front();
  const SharedEdge edge = shared_edges(scene.mesh).front();
  const WorstInput worst = worst_input(scene, {.scene = "corridor",
                                               .clipper = "textbook",
                                               .scalar = "float",
                                               .view = view.label,
                                               .first_triangle = edge.triangles[0],
                                               .second_triangle = edge.triangles[1]});
  const char* next = worst.input.c_str();
  for (const std::uint32_t number : edge.triangles) {
    SceneTriangle triangle;
    view_triangles(scene, view, number, std::span(&triangle, 1));
    for (const auto& v : triangle) {
      for (int i = 0; i < 3; ++i) {
        char* end = nullptr;
        CHECK(std::strtof(next, &end) == v.position[i]);
        next = end;
      }
    }
  }
  CHECK(*next == '\0');
  CHECK(worst.replay.find("--clipper textbook --scalar float --frustum ") != std::string::npos);
}

TEST_CASE("watertight: the widest crack becomes a picture, a mesh's before a grazing edge's") {
  const Scene scene = corridor(), grazing = make_grazing_scene(500, 1);
  const Contestant& textbook = find_contestant("textbook", "float");
  const WorstRow in_mesh = measure_one(scene, textbook, 0).worst;
  const WorstRow in_grazing = measure_one(grazing, textbook, 0).worst;
  CHECK(in_mesh.crack_px > 0);
  CHECK(in_grazing.crack_px > 0);
  CHECK_FALSE(widest_crack({}));
  REQUIRE(widest_crack({in_grazing, in_mesh}));
  CHECK(widest_crack({in_grazing, in_mesh})->scene == "corridor");

  const Crack crack = crack_of(scene, in_mesh);
  CHECK(crack.gap.crack_px == in_mesh.crack_px);
  const auto path = std::filesystem::temp_directory_path() / "clipscope_crack_test.svg";
  write_picture(path, crack, "a crack");
  CHECK(std::filesystem::file_size(path) > 1000);
  std::filesystem::remove(path);
}

}  // namespace clipscope::experiments::watertight
