// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each format may hold beside plain lists of vertices and triangles.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/convex_quadrangle.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

Mesh mesh_of(const std::string& name, const std::string& content) {
  const FolderOfFiles folder;
  return load_mesh(folder.write(name, content));
}

std::string content_refusal(const std::string& name, const std::string& content) {
  return message_of<InputError>([&] { mesh_of(name, content); });
}

using Positions = std::vector<std::array<float, 3>>;

TEST_CASE("OBJ: a lost vertex is never silent") {
  const std::string rest = "v 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n";
  const Positions expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(mesh_of("a.obj", "\xEF\xBB\xBFv 0 0 0\n" + rest).positions == expected);
  for (const char* first : {"V 0 0 0\n", "\xC2\xA0v 0 0 0\n", "w 0 0 0\n"}) {
    CHECK(contains(content_refusal("a.obj", first + rest), "a.obj:1: "));
  }
}

TEST_CASE("OBJ: references to normals and texture coordinates that the file never has are let be") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const Mesh plain = mesh_of("a.obj", vertices + "f 1 2 3\n");
  for (const char* face :
       {"f 1//1 2//2 3//3\n", "f 1/1/1 2/2/2 3/3/3\n", "f 1//-1 2//-1 3//-1\n"}) {
    const Mesh mesh = mesh_of("a.obj", vertices + face);
    CHECK(mesh.positions == plain.positions);
    CHECK(mesh.attributes == plain.attributes);
  }
  CHECK(contains(content_refusal("a.obj", vertices + "f 1//-1 2//-1 3//-1\nvn 0 0 1\n"),
                 "a.obj:4: the face refers 1 normal back, but only 0 normals are defined so far"));
}

TEST_CASE("OBJ: what is not finite is refused where a face uses it, and nowhere else") {
  const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan nan nan\nvt 0 0\nvt nan 0\n";
  CHECK(mesh_of("a.obj", start + "f 1/1 2/1 3/1\n").positions.size() == 3);
  CHECK(contains(content_refusal("a.obj", start + "f 1/1 2/1 4/1\n"),
                 "a.obj:4: x of the vertex is NaN"));
  CHECK(contains(content_refusal("a.obj", start + "f 1/1 2/1 3/2\n"),
                 "a.obj:6: u of the texture coordinate is NaN"));
  CHECK(contains(content_refusal("a.obj", start + "vn inf 0 0\nf 1//1 2//1 3//1\n"),
                 "a.obj:7: the normal's length is infinite"));
}

TEST_CASE("OBJ: negative and interleaved references mean what was defined before them") {
  const Mesh mesh = mesh_of("a.obj",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25\nf -3/-1 -2/-1 -1/-1\n"
                            "v 0 0 7\nvt 0.75 1\nf -3/-1 3/1 -1/-1\n");
  REQUIRE(mesh.triangles.size() == 2);
  const auto corner = [&](int t, int k) { return mesh.triangles[t][k]; };
  CHECK(mesh.positions[corner(1, 0)] == std::array{1.0f, 0.0f, 0.0f});
  CHECK(mesh.attributes[corner(1, 0)][0] == 0.75f);
  CHECK(mesh.attributes[corner(0, 1)][0] == 0.5f);
  CHECK(corner(1, 1) == corner(0, 2));
  CHECK(mesh.positions[corner(1, 2)] == std::array{0.0f, 0.0f, 7.0f});
  CHECK(mesh.positions.size() == 5);
}

TEST_CASE("OBJ: faces with and without texture coordinates may follow each other") {
  const Mesh mesh =
      mesh_of("a.obj", "v 0 0 0\nv 4 0 0\nv 0 2 0\nvt 0.125 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1 3 2\n");
  REQUIRE(mesh.triangles.size() == 3);
  CHECK(mesh.positions.size() == 6);
  CHECK(mesh.attributes[mesh.triangles[0][1]][0] == 1);
  CHECK(mesh.attributes[mesh.triangles[1][1]][0] == 0.125f);
  CHECK(mesh.triangles[2] ==
        std::array{mesh.triangles[0][0], mesh.triangles[0][2], mesh.triangles[0][1]});
}

TEST_CASE("polygons: a concave one is tiled, a flat quadrangle is cut from its first corner") {
  const Mesh quad = mesh_of("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4 1\n");
  REQUIRE(quad.triangles.size() == 2);
  CHECK(quad.positions[quad.triangles[1][0]] == std::array{1.0f, 0.0f, 0.0f});
  // A dart, whose one diagonal lies outside.
  const Mesh dart = mesh_of("a.obj", "v 0 0 0\nv 4 -2 0\nv 1 0 0\nv 4 2 0\nf 2 3 4 1\n");
  REQUIRE(dart.triangles.size() == 2);
  for (const auto& t : dart.triangles) {
    const auto x = [&](int k) { return dart.positions[t[k]][0]; };
    CHECK(std::min({x(0), x(1), x(2)}) == 0);
    CHECK(std::max({x(0), x(1), x(2)}) == 4);
  }
  CHECK(dart.remarks.empty());
}

TEST_CASE("polygons: one that is not flat is cut as its projection is") {
  const Mesh mesh = mesh_of("a.obj", "v 0 0 0\nv 4 -2 9\nv 1 0 0\nv 4 2 9\nv 9 9 9\nf 1 2 3 4\n");
  REQUIRE(mesh.triangles.size() == 2);
  // Both triangles have the diagonal from the tip (0, 0, 0) to the notch (1, 0, 0).
  for (const auto& t : mesh.triangles) {
    CHECK(std::ranges::count(t, 0u) == 1);
    CHECK(std::ranges::count(t, 2u) == 1);
  }
}

TEST_CASE("polygons: what is not simple becomes a fan, and a remark counts it at its line") {
  const Mesh mesh = mesh_of(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 3 2 4\nf 1 2 2 1\nf 1 2 3 1\n");
  CHECK(mesh.triangles.size() == 8);
  REQUIRE(mesh.remarks.size() == 1);
  CHECK(contains(mesh.remarks[0], "a.obj: 3 polygons are not simple"));
  CHECK(contains(mesh.remarks[0], "the first in line 6;"));
}

TEST_CASE("polygons: a quadrangle is certainly convex unless a turn is straight or open") {
  using Points = std::vector<std::array<double, 3>>;
  CHECK(is_certainly_convex_quadrangle(Points{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}));
  CHECK(is_certainly_convex_quadrangle(Points{{0, 5, 0}, {0, 5, 1}, {1, 5, 1}, {1, 5, 0}}));
  CHECK_FALSE(is_certainly_convex_quadrangle(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}));
  CHECK_FALSE(is_certainly_convex_quadrangle(Points{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
  CHECK_FALSE(is_certainly_convex_quadrangle(Points{{0, 0, 0}, {4, -2, 0}, {1, 0, 0}, {4, 2, 0}}));
  CHECK_FALSE(is_certainly_convex_quadrangle(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  CHECK_FALSE(is_certainly_convex_quadrangle(
      Points{{0, 0, 0}, {1e-170, 0, 0}, {1e-170, 1e-170, 0}, {0, 1e-170, 0}}));
}

TEST_CASE("meshes keep doubles where a position of the file is no float") {
  CHECK(mesh_of("a.obj", "v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").double_positions.empty());
  const Mesh mesh = mesh_of("a.obj", "v 0.5 0 0\nv 1 0 0\nv 0 0.1 0\nf 1 2 3\n");
  REQUIRE(mesh.double_positions.size() == 3);
  CHECK(mesh.double_positions[0] == std::array{0.5, 0.0, 0.0});
  CHECK(mesh.double_positions[2] == std::array{0.0, 0.1, 0.0});
  CHECK(mesh.positions[2] == std::array{0.0f, 0.1f, 0.0f});
}

TEST_CASE("meshes keep vertices apart that only doubles tell apart") {
  const Mesh mesh =
      mesh_of("a.obj", "v 1e8 0 0\nv 100000001 0 0\nv 0 1 0\nv 1e8 0 0\nf 1 2 3\nf 4 2 3\n");
  CHECK(mesh.positions.size() == 3);
  CHECK(mesh.positions[0] == mesh.positions[1]);
}

TEST_CASE("PLY: numbers are floats or doubles as the header says, in text and in binary") {
  const std::string text = sample_ply_text();
  CHECK(mesh_of("a.ply", replaced(text, "0.5 0.5 1", "0.1 0.5 1")).double_positions.empty());
  const Mesh mesh = mesh_of("a.ply", replaced(replaced(text, "0.5 0.5 1", "0.1 0.5 1"),
                                              "property float x", "property double x"));
  REQUIRE(mesh.double_positions.size() == 5);
  CHECK(mesh.double_positions[4] == std::array{0.1, 0.5, 1.0});
}

TEST_CASE("PLY: vertices that no face uses may have no place, as organised point clouds have") {
  const std::string text = replaced(sample_ply_text(), "3 3 0 4\n", "3 3 0 4\n");
  const std::string more = replaced(replaced(text, "element vertex 5", "element vertex 6"),
                                    "4 0 1 2 3\n", "nan nan nan nan nan nan\n4 0 1 2 3\n");
  CHECK(mesh_of("a.ply", more).positions.size() == 5);
  CHECK(contains(content_refusal("a.ply", replaced(more, "3 1 2 4", "3 1 2 5")),
                 "a.ply:19: vertex 5: x is NaN"));
}

TEST_CASE("PLY: properties that nothing uses are skipped unread, lists too") {
  const std::string text = replaced(
      replaced(sample_ply_text(), "element face 5\n",
               "property list uchar float weights\nelement face 5\nproperty list uchar int more\n"),
      "0 0 0 0 0 -1\n", "0 0 0 0 0 -1 2 nan x\n");
  const std::string faces = replaced(text, "1 0 0 0 0 -1\n", "1 0 0 0 0 -1 0\n");
  std::string all = faces;
  for (const char* line : {"1 1 0 0 0 -1\n", "0 1 0 0 0 -1\n", "0.5 0.5 1 3 0 4\n"}) {
    all = replaced(all, line, std::string(line).substr(0, std::strlen(line) - 1) + " 0\n");
  }
  for (const char* line :
       {"\n4 0 1 2 3\n", "\n3 0 1 4\n", "\n3 1 2 4\n", "\n3 2 3 4\n", "\n3 3 0 4\n"}) {
    all = replaced(all, line, "\n1 9 " + std::string(line).substr(1));
  }
  CHECK(mesh_of("a.ply", all).triangles.size() == 6);
}

TEST_CASE("STL: normals are never read, in text as little as in binary") {
  const Mesh plain = mesh_of("a.stl", sample_stl_text());
  for (const char* normal : {"nan nan nan", "-1.#IND 0 0", "inf 0 0"}) {
    const std::string text =
        replaced(sample_stl_text(), "normal 0 0 1", std::string("normal ") + normal);
    CHECK(mesh_of("a.stl", text).positions == plain.positions);
  }
  std::string binary = sample_stl_binary();
  const float nan = NAN;
  std::memcpy(binary.data() + 84, &nan, sizeof nan);
  CHECK(mesh_of("a.stl", binary).triangles.size() == 6);
}

std::string quantized(const std::string& json_change, const std::string& by) {
  // Four corners of signed bytes, each padded to four bytes, and six indices.
  const std::string bytes("\0\0\0\0\x7f\0\0\0\0\x7f\0\0\0\0\x7f\0\0\1\2\0\2\3", 22);
  const std::string json =
      R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_mesh_quantization"],
"buffers":[{"byteLength":22}],
"bufferViews":[{"buffer":0,"byteLength":16,"byteStride":4},{"buffer":0,"byteOffset":16,"byteLength":6}],
"accessors":[{"bufferView":0,"componentType":5120,"normalized":true,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"nodes":[{"mesh":0,"scale":[2,2,2]}]})";
  return as_glb(replaced(json, json_change, by), bytes);
}

TEST_CASE("glTF: quantized positions are integers, or fractions where they are normalized") {
  const Mesh fractions = mesh_of("a.glb", quantized("2.0", "2.0"));
  CHECK(fractions.positions == Positions{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  const Mesh integers = mesh_of("a.glb", quantized("\"normalized\":true,", ""));
  CHECK(integers.positions == Positions{{0, 0, 0}, {254, 0, 0}, {0, 254, 0}, {0, 0, 254}});
}

TEST_CASE("glTF: instances of a node stand where each is put, and mirrored ones are turned round") {
  const std::string instanced =
      quantized("\"scale\":[2,2,2]}",
                R"("extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"SCALE":0}}}})");
  // The scales are 0 0 0, 1 0 0, 0 1 0 and 0 0 1: all flat.
  CHECK(mesh_of("a.glb", instanced).triangles.size() == 8);
  const Mesh plain = mesh_of("a.glb", quantized("2.0", "2.0"));
  const Mesh mirrored = mesh_of("a.glb", quantized("[2,2,2]", "[-2,2,2]"));
  CHECK(plain.triangles[0] == std::array{0u, 1u, 2u});
  CHECK(mirrored.triangles[0] == std::array{0u, 2u, 1u});
  CHECK(mirrored.positions[1] == std::array{-2.0f, 0.0f, 0.0f});
}

TEST_CASE("glTF: fans run around their first corner, and strips skip what joins them") {
  const Mesh fan = mesh_of("a.glb", quantized("\"indices\":1", "\"mode\":6,\"indices\":1"));
  // The corners are 0 1 2 0 2 3; the strip's third triangle would be 2 0 2.
  CHECK(fan.triangles.size() == 4);
  CHECK(fan.triangles[0] == std::array{0u, 1u, 2u});
  const Mesh strip = mesh_of("a.glb", quantized("\"indices\":1", "\"mode\":5,\"indices\":1"));
  CHECK(strip.triangles.size() == 3);
}

TEST_CASE("glTF: nodes may be nested as deep as a file has them") {
  std::string chain = "\"nodes\":[";
  for (int i = 0; i < 100000; ++i) chain += "{\"children\":[" + std::to_string(i + 1) + "]},";
  const std::string json = replaced(
      sample_gltf_json(""), "\"nodes\":[{\"children\":[1],\"translation\":[10,20,30]},", chain);
  CHECK(mesh_of("a.glb", as_glb(json, sample_gltf_buffer())).triangles.size() == 6);
}

TEST_CASE("glTF: texture coordinates may be normalized integers") {
  const std::string json =
      replaced(sample_gltf_json(""), "\"componentType\":5126,\"count\":5,\"type\":\"VEC2\"",
               "\"componentType\":5123,\"normalized\":true,\"count\":5,\"type\":\"VEC2\"");
  const Mesh mesh = mesh_of("a.glb", as_glb(json, sample_gltf_buffer()));
  // The floats 0 and 1 read as pairs of 16 bits: 1 is 0x3f800000.
  CHECK(mesh.attributes[1][0] == static_cast<float>(0x0000 / 65535.0));
  CHECK(std::ranges::any_of(
      mesh.attributes, [](const auto& a) { return a[1] == static_cast<float>(0x3f80 / 65535.0); }));
}

}  // namespace
}  // namespace clipscope::experiments
