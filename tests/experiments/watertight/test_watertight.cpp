// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cracks of real clippers on real meshes; a promise that is not kept must be found out.
#include <tbb/global_control.h>

#include <cstdlib>
#include <filesystem>

#include "experiments/scenes/builtin.hpp"
#include "experiments/watertight/crack_picture.hpp"
#include "experiments/watertight/grazing.hpp"
#include "experiments/watertight/tables.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const Contestant<float>& contestant(std::string_view clipper) {
  return *std::get<const Contestant<float>*>(find_contestant(clipper, "float"));
}

Scene teapot() { return make_builtin_scene("teapot", {.quick = true}); }

Scene corridor() { return make_builtin_scene("corridor", {.quick = true}); }

WatertightTally measure(const Scene& scene, const AnyContestant& c) {
  return measure_watertight(scene, std::array{c}, {.edges_per_view = 200}).front();
}

}  // namespace

TEST_CASE(
    "watertight: textbook cuts in its own winding's direction and cracks in float, not exactly") {
  const WatertightTally in_float = measure(corridor(), &contestant("textbook"));
  CHECK(in_float.total().crack_px > 1e-4);
  CHECK(in_float.total().t_junctions > 0);
  CHECK(in_float.worst.gap.crack_px == in_float.total().crack_px);
  const GapTally exact = measure(corridor(), find_contestant("textbook", "exact")).total();
  CHECK(exact.edges > 0);
  CHECK(exact.identical == exact.edges);
}

TEST_CASE("watertight: a clipper that cuts from the inside end has the same bits on both sides") {
  for (const char* name : {"homogeneous/pipeline", "homogeneous/blinn_newell",
                           "barycentric/distance_matrix", "homogeneous/sutherland_hodgman"}) {
    INFO(name);
    const GapTally tally = measure(corridor(), &contestant(name)).total();
    CHECK(tally.edges > 100);
    CHECK(tally.identical == tally.edges);
    CHECK(tally.absent == 0);
  }
}

TEST_CASE(
    "watertight: promises hold where only one neighbour crosses a plane, careful others part") {
  const Scene grazing = make_grazing_scene(4000, 1);
  for (const Contestant<float>& c : contestants<float>()) {
    INFO(c.name);
    const GapTally tally =
        measure_watertight(grazing, std::array{AnyContestant{&c}}, {}).front().total();
    CHECK(watertight_verdict(&c, tally) == (c.promise.watertight ? "kept" : "-"));
  }
  const AnyContestant parting = &contestant("view/sutherland_hodgman");
  CHECK(measure_watertight(grazing, std::array{parting}, {}).front().total().t_junctions > 0);
}

TEST_CASE("watertight: a promise that is not kept is broken, in the table and in the finding") {
  Contestant<float> liar = contestant("textbook");
  liar.promise.watertight = true;
  const std::array<AnyContestant, 2> both = {&liar, &contestant("homogeneous/pipeline")};
  const auto tallies = measure_watertight(corridor(), both, {.edges_per_view = 200});
  CHECK(watertight_verdict(both[0], tallies[0].total()) == "broken");
  CHECK(watertight_verdict(both[1], tallies[1].total()) == "kept");
  Table table = watertight_table();
  add_scene("corridor", both, tallies, table);
  const Table summary = summary_table(table);
  CHECK(RowView(summary, 0).text("promise") == "broken");
  const std::string finding = watertight_finding(summary);
  CHECK(finding.find("BROKEN: 1 of 2") != std::string::npos);
  CHECK(finding.find("textbook in float") != std::string::npos);
}

TEST_CASE("watertight: a clipper that drops triangles loses neighbours and has no crack") {
  const GapTally tally = measure(teapot(), &contestant("whole/any_outside")).total();
  CHECK(tally.lost > 0);
  CHECK(tally.lost_px > 10);
  CHECK(tally.identical == tally.absent);
  CHECK(tally.crack_px == 0);
}

TEST_CASE("watertight: the classes of edges add up, whatever the number of threads") {
  const AnyContestant c = &contestant("textbook");
  const WatertightTally parallel = measure(teapot(), c);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const WatertightTally serial = measure(teapot(), c);
  CHECK(parallel.total().crack_px == serial.total().crack_px);
  CHECK(parallel.total().t_junctions == serial.total().t_junctions);
  std::int64_t edges = 0, different = 0;
  for (const auto& both : serial.by_class) {
    edges += both[0].edges + both[1].edges;
    different += both[1].edges;
  }
  CHECK(edges == serial.total().edges);
  CHECK(different == serial.with_different_neighbours().edges);
  CHECK(different > 0);
}

TEST_CASE("watertight: the input of a crack reads back bit for bit") {
  const Scene scene = corridor();
  const View& view = scene.views.front();
  const SharedEdge edge = shared_edges(scene.mesh).front();
  const auto triangles = neighbours_of(scene, view, edge);
  const std::string text = input_text(triangles);
  const char* next = text.c_str();
  for (const SceneTriangle& t : triangles) {
    for (const auto& v : t) {
      for (int i = 0; i < 3; ++i) {
        char* end = nullptr;
        CHECK(std::strtof(next, &end) == v.position[i]);
        next = end;
      }
    }
  }
  CHECK(*next == '\0');
  const std::string command = replay_command(&contestant("textbook"), view, triangles);
  CHECK(command.find("--clipper textbook --scalar float --frustum ") != std::string::npos);
}

TEST_CASE("watertight: the widest crack becomes a picture, a mesh's before a grazing edge's") {
  const Scene scene = corridor(), grazing = make_grazing_scene(500, 1);
  const std::array<AnyContestant, 1> c = {&contestant("textbook")};
  Table worst = worst_table();
  CHECK_FALSE(widest_crack(worst));
  CellRecord record;
  add_worst(scene, c, measure_watertight(scene, c, {}), worst, record);
  add_worst(grazing, c, measure_watertight(grazing, c, {}), worst, record);
  REQUIRE(worst.rows().size() == 2);
  CHECK(record.worst_inputs.size() == 2);
  REQUIRE(widest_crack(worst));
  CHECK(widest_crack(worst)->text("scene") == "corridor");

  const WatertightTally tally = measure_watertight(scene, c, {}).front();
  const View& view = scene.views[tally.worst.view];
  const auto triangles = neighbours_of(scene, view, tally.worst.edge.edge);
  const ClippedPair pair = clipped_pair(c[0], view, triangles, tally.worst.edge);
  CHECK(pair.gap.crack_px == tally.worst.gap.crack_px);
  const auto path = std::filesystem::temp_directory_path() / "clipscope_crack_test.svg";
  write_crack_picture(path, {pair, "a crack"});
  CHECK(std::filesystem::file_size(path) > 1000);
  std::filesystem::remove(path);
}
