// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of shared edges, on rows made by hand.
#include "experiments/table/prose.hpp"
#include "experiments/watertight/rows.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::watertight {
namespace {

Row row(std::string scene, std::string clipper, std::string scalar, const GapTally& all,
        Verdict promise = Verdict::not_promised) {
  return {std::move(scene), std::move(clipper), std::move(scalar), all, {4, 3}, promise};
}

const GapTally kTight{8, 8}, kCracked{8, 6, 0, 0, 2, 0, 0.5};

// Two meshes and the grazing edges, two clippers, one of them in two scalars.
std::vector<Row> rows() {
  std::vector<Row> all;
  for (const char* scene : {"teapot", "floor", "grazing"}) {
    all.push_back(row(scene, "careful", "float", kTight, Verdict::kept));
    all.push_back(row(scene, "careless", "float", kCracked));
    all.push_back(row(scene, "careless", "double", {8, 7, 0, 0, 1, 0, 1e-9}));
  }
  return all;
}

std::string checked(const std::vector<MeshRow>& meshes, const std::vector<Row>& by_scene) {
  const std::string text = finding(meshes, summary_rows(by_scene));
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

}  // namespace

TEST_CASE("watertight: scenes are summed by clipper and scalar, grazing edges apart from meshes") {
  const std::vector<SummaryRow> summary = summary_rows(rows());
  REQUIRE(summary.size() == 6);
  CHECK(summary[1].edges_of == Kind::mesh);
  CHECK(summary[1].clipper == "careless");
  CHECK(summary[1].all.edges == 16);
  CHECK(summary[1].all.identical_percent() == 75);
  CHECK(summary[1].all.crack_px == 0.5);
  CHECK(summary[1].different_identical_percent == 75);
  CHECK(summary[3].edges_of == Kind::grazing);
  CHECK(summary[3].all.edges == 8);
  CHECK(summary[3].promise == Verdict::kept);
}

TEST_CASE("watertight: a promise broken in one scene is broken") {
  const Row broken = row("teapot", "careful", "float", kCracked, Verdict::broken);
  const Row kept = row("floor", "careful", "float", kTight, Verdict::kept);
  CHECK(summary_rows({broken, kept})[0].promise == Verdict::broken);
  CHECK(summary_rows({kept, broken})[0].promise == Verdict::broken);
}

TEST_CASE("watertight: the finding counts who is tight, and names the widest crack and loss") {
  std::vector<Row> measured = rows();
  CHECK(
      checked({}, measured) ==
      "Along mesh edges beside a cut 1 of 2 clippers leave both neighbours the same bits in float; along edges that graze a plane most do. The widest crack is that of careless. All promises to be watertight are kept.");
  for (Row& r : measured) r.all = kTight;
  CHECK(
      checked({}, measured) ==
      "Along mesh edges beside a cut all clippers leave both neighbours the same bits in float; along edges that graze a plane all do. No clipper cracks, and none loses a neighbour. All promises to be watertight are kept.");
  for (Row& r : measured) r.all = kCracked;
  CHECK(
      checked({}, measured)
          .starts_with(
              "Along mesh edges beside a cut none of the clippers leave both neighbours the same bits in float; along edges that graze a plane none do."));
  const Row lost = row("floor", "dropper", "float", {8, 4, 0, 4, 0, 20});
  CHECK(
      checked({}, {lost}) ==
      "Along mesh edges beside a cut all clippers leave both neighbours the same bits in float. The widest lost neighbour is that of dropper. None of them promises to be watertight.");
}

TEST_CASE("watertight: a broken promise is named") {
  const Row broken = row("teapot", "careful", "float", kCracked, Verdict::broken);
  CHECK(
      checked({}, {broken}).ends_with("Promises to be watertight are BROKEN by careful in float."));
}

TEST_CASE("watertight: what a mesh brought along is named first") {
  const MeshRow mesh{"tiles", 4, {.edges = 9, .open = 6, .t_junctions = 1}};
  const MeshRow closed{"teapot", 4, {.edges = 6}};
  CHECK(checked({closed, mesh}, rows())
            .starts_with("Before any clipping there may be cracks in tiles. Along mesh edges"));
}

TEST_CASE("watertight: where no edge lies beside a cut no promise is kept") {
  const Row none = row("teapot", "careful", "float", {}, Verdict::no_edge);
  CHECK(
      checked({}, {none}) ==
      "No edge lies beside a cut, so nothing was judged. No promise to be watertight could be judged.");
  CHECK(checked({}, {}) == "No clipper was asked for.");
  const Row kept = row("floor", "careful", "float", kTight, Verdict::kept);
  CHECK(summary_rows({kept, none})[0].promise == Verdict::kept);
}

TEST_CASE("watertight: the plot has a bar for each clipper with a crack, by scalar and kind") {
  const Plot plot = crack_plot(summary_rows(rows()));
  CHECK(plot.categories == std::vector<std::string>{"careful", "careless"});
  REQUIRE(plot.series.size() == 4);
  CHECK(plot.series[0].name == "float, mesh");
  CHECK(plot.series[3].name == "double, grazing");
  CHECK(plot.series[0].y == std::vector<double>{0, 0.5});
}

}  // namespace clipscope::experiments::watertight
