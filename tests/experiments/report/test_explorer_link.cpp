// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page reads such fragments in tests of its own (experiments/explorer/tests/report_links.mjs).
#include <string>

#include "experiments/report/explorer_link.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/case_batch.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

std::string fragment_of(const std::string& input, const std::string& clipper = "textbook",
                        const std::string& scalar = "float") {
  return explorer_fragment("accuracy", {clipper, scalar, "position_px", 1, input, ""});
}

const std::string kVertices =
    " : 0x1p+0 0x0p+0 0x0p+0 0x1p+1 -0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1.8p+0 0x0p+0 0x1p+0";
const std::string kClip = "--space clip --depth gl --attributes 0" + kVertices;

}  // namespace

TEST_CASE("explorer link: options and numbers are those of the input") {
  CHECK(
      fragment_of(kClip) ==
      "v1&space=clip&depth=gl&a=0x1p+0,0x0p+0,0x0p+0,0x1p+1&b=-0x1p+0,0x0p+0,0x0p+0,0x1p+0&c=0x0p+0,0x1.8p+0,0x0p+0,0x1p+0&scalar=float&clippers=textbook,barycentric/distance_matrix&source=accuracy%3A%20worst%20input%20of%20textbook%20in%20float");
}

TEST_CASE("explorer link: of what replay_text writes nothing is lost") {
  HardCase hard_case;
  hard_case.space = Space::view;
  hard_case.frustum = {.kind = ProjectionKind::parallel, .depth = DepthRange::reversed};
  hard_case.volume = {.depth = DepthRange::reversed,
                      .depth_clamp = kClampFar,
                      .clip_distances = 2,
                      .open_sides = {true, false, false, true}};
  hard_case.vertices = {{{0, 0, -2, 1}, {1, 2, 3, 4, 5}},
                        {{1, 0, -2, 1}, {1, 2, 3, 4, 5}},
                        {{0, 1, -2, 1}, {1, 2, 3, 4, 5}}};
  hard_case.attribute_count = 5;
  CHECK(
      fragment_of(replay_text(CaseBatch(hard_case), 0), "cvv/naive", "double") ==
      "v1&space=view&ortho=-0x1p+0,0x1p+0,-0x1p+0,0x1p+0,0x1p+0,0x1.4p+3&depth=reversed&depth-clamp=far&half-open=left,top&clip-distances=2&a=0x0p+0,0x0p+0,-0x1p+1;0x1p+0,0x1p+1,0x1.8p+1,0x1p+2&b=0x1p+0,0x0p+0,-0x1p+1;0x1p+0,0x1p+1,0x1.8p+1,0x1p+2&c=0x0p+0,0x1p+0,-0x1p+1;0x1p+0,0x1p+1,0x1.8p+1,0x1p+2&scalar=double&clippers=cvv/naive,barycentric/distance_matrix&source=accuracy%3A%20worst%20input%20of%20cvv/naive%20in%20double");
}

TEST_CASE("explorer link: a scene's worst input has one") {
  const Scene scene = make_builtin_scene("corridor", {.quick = true});
  const View& view = scene.views.front();
  SceneTriangle triangle;
  view_triangles(scene, view, 0, std::span(&triangle, 1));
  const WorstInput worst = worst_input(Selection{}, scene, find_contestant("textbook", "float"),
                                       {view, triangle, 0, "position_px", 1});
  const std::string fragment = explorer_fragment("accuracy", worst);
  CHECK(fragment.starts_with("v1&space=view&frustum="));
  CHECK(worst.replay.starts_with("clipscope explain --scene corridor"));
}

TEST_CASE("explorer link: there is none where the explorer has no such question") {
  CHECK(fragment_of("--space clip --primitive segment --depth gl --attributes 0" + kVertices)
            .empty());
  CHECK(fragment_of("--space view --matrix 1,0 --depth gl --attributes 0" + kVertices).empty());
  CHECK(
      fragment_of("--space clip --depth gl --clip-distances 5 --attributes 5" + kVertices).empty());
  CHECK(fragment_of("--space view --depth gl --attributes 0" + kVertices).empty());
  CHECK(fragment_of("--space clip --depth gl --attributes 0 : 0x1p+0").empty());
  CHECK(fragment_of("0x1p+0 0x1p+0").empty());
  CHECK(fragment_of("").empty());
  CHECK(fragment_of(kClip, "no/such").empty());
  CHECK(fragment_of(kClip, "textbook", "exact").empty());
  CHECK(fragment_of(kClip, "barycentric/correctly_rounded", "double").empty());
  CHECK_FALSE(fragment_of(kClip, "barycentric/correctly_rounded").empty());
  CHECK(
      fragment_of(
          "--space clip --depth gl --attributes 0 : nan 0x0p+0 0x0p+0 0x1p+1 -0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1.8p+0 0x0p+0 0x1p+0")
          .empty());
}

TEST_CASE("explorer link: no clipper is compared with itself") {
  CHECK(fragment_of(kClip, "barycentric/distance_matrix")
            .find("clippers=barycentric/distance_matrix,homogeneous/sutherland_hodgman") !=
        std::string::npos);
}
