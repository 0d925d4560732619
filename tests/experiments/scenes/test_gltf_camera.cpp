// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/gltf_camera.hpp"

#include <cmath>
#include <glm/vec4.hpp>

#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

// Node 0 moves and quarter-turns about y, its child has the perspective camera, node 2 the parallel
// one, and node 3 is in no scene.
constexpr const char* kJson = R"({"asset":{"version":"2.0"},
"cameras":[{"name":"door","type":"perspective","perspective":{"yfov":0.75,"aspectRatio":1.5,"znear":0.25}},
{"type":"orthographic","orthographic":{"xmag":4,"ymag":3,"znear":0,"zfar":100}}],
"nodes":[{"translation":[10,0,0],"rotation":[0,0.7071067811865476,0,0.7071067811865476],"children":[1]},
{"translation":[0,2,0],"camera":0},{"camera":1},{"camera":0}],
"scenes":[{"nodes":[0,2]}]})";

std::vector<GltfCamera> cameras_of(const std::string& json) {
  const FolderOfFiles folder;
  return read_gltf_cameras(folder.write("a.gltf", json));
}

std::string camera_refusal(const std::string& part, const std::string& by) {
  return message_of<InputError>([&] { cameras_of(replaced(kJson, part, by)); });
}

TEST_CASE("glTF cameras: those of the shown nodes are read with their numbers") {
  const std::vector<GltfCamera> cameras = cameras_of(kJson);
  REQUIRE(cameras.size() == 2);
  CHECK(cameras[0].name == "door");
  CHECK(cameras[0].kind == ProjectionKind::perspective);
  CHECK(cameras[0].fovy == 0.75);
  CHECK(cameras[0].aspect == 1.5);
  CHECK(cameras[0].near == 0.25);
  CHECK_FALSE(cameras[0].far);
  CHECK(cameras[1].name == "nodes[2]");
  CHECK(cameras[1].kind == ProjectionKind::parallel);
  CHECK(cameras[1].xmag == 4);
  CHECK(cameras[1].far == 100.0);
}

TEST_CASE("glTF cameras: a camera stands where its node and that node's parents put it") {
  const glm::dmat4 m = cameras_of(kJson)[0].world_from_camera;
  const glm::dvec4 eye = m * glm::dvec4(0, 0, 0, 1), ahead = m * glm::dvec4(0, 0, -1, 0);
  CHECK(eye == glm::dvec4(10, 2, 0, 1));
  // A quarter turn about y takes -z to -x; 1e-15 is nine roundings of numbers up to 1.
  CHECK(std::abs(ahead.x + 1) < 1e-15);
  CHECK(std::abs(ahead.z) < 1e-15);
  CHECK(cameras_of(kJson)[1].world_from_camera == glm::dmat4(1.0));
}

TEST_CASE("glTF cameras: a matrix is read column by column, and a scale stays in the pose") {
  const std::string json = replaced(kJson, "{\"camera\":1}",
                                    "{\"camera\":1,\"matrix\":[2,0,0,0,0,2,0,0,0,0,2,0,5,6,7,1]}");
  CHECK(cameras_of(json)[1].world_from_camera ==
        glm::dmat4({2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {5, 6, 7, 1}));
}

TEST_CASE("glTF cameras: a file without any has none") { CHECK(cameras_of(sample_gltf()).empty()); }

TEST_CASE("glTF cameras: numbers that make no volume are named by their place") {
  CHECK(contains(camera_refusal("\"yfov\":0.75", "\"yfov\":3.2"),
                 "cameras[0].perspective.yfov is 3.2; radians below pi expected"));
  CHECK(contains(camera_refusal("\"znear\":0.25", "\"znear\":0"),
                 "perspective.znear is 0; a number > 0"));
  CHECK(contains(camera_refusal(",\"znear\":0.25", ""), "perspective.znear is missing"));
  CHECK(contains(camera_refusal("\"znear\":0.25", "\"znear\":0.25,\"zfar\":0.25"),
                 "perspective.zfar is 0.25; more than znear, which is 0.25, expected"));
  CHECK(contains(camera_refusal(",\"zfar\":100", ""), "cameras[1].orthographic.zfar is missing"));
  CHECK(contains(camera_refusal("\"orthographic\",", "\"fisheye\","),
                 "cameras[1].type is \"fisheye\""));
  CHECK(contains(camera_refusal("\"camera\":0}", "\"camera\":2}"), "refers to cameras[2]"));
  CHECK(contains(camera_refusal("0.7071067811865476,0,0.7071067811865476", "0,0,0"),
                 "nodes[0].rotation has length 0"));
}

}  // namespace
}  // namespace clipscope::experiments
