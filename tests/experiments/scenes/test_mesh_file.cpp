// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "tests/catch.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

using Point = std::array<float, 3>;

// The surface as a set of triangles by position, each rotated so that its least corner comes first.
std::multiset<std::array<Point, 3>> surface_of(const Mesh& mesh) {
  std::multiset<std::array<Point, 3>> surface;
  for (const auto& t : mesh.triangles) {
    std::array<Point, 3> corners = {mesh.positions[t[0]], mesh.positions[t[1]],
                                    mesh.positions[t[2]]};
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    surface.insert(corners);
  }
  return surface;
}

std::multiset<std::array<Point, 3>> pyramid(float scale, const Point& shift) {
  Mesh mesh;
  for (const Point& p : kPyramid) {
    mesh.positions.push_back(
        {p[0] * scale + shift[0], p[1] * scale + shift[1], p[2] * scale + shift[2]});
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return surface_of(mesh);
}

TEST_CASE("mesh files: every format gives the pyramid, glTF with its nodes' transforms applied") {
  const SampleFile file = GENERATE(from_range(sample_files()));
  const FolderOfFiles folder;
  INFO(file.name);
  const Mesh mesh = load_mesh(folder.write(file.name, file.content));
  const bool moved = file.name.ends_with(".gltf") || file.name.ends_with(".glb");
  CHECK(surface_of(mesh) == (moved ? pyramid(2, {10, 20, 30}) : pyramid(1, {0, 0, 0})));
  CHECK(mesh.attributes.size() == mesh.positions.size());
}

TEST_CASE("mesh files: vertices that are equal in every bit are stored once") {
  const SampleFile file = GENERATE(from_range(sample_files()));
  const FolderOfFiles folder;
  INFO(file.name);
  CHECK(load_mesh(folder.write(file.name, file.content)).positions.size() == 5);
}

TEST_CASE("mesh files: texture coordinates are the file's where it has them") {
  const FolderOfFiles folder;
  const Mesh mesh = load_mesh(folder.write("a.obj", sample_obj()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const bool apex = mesh.positions[i][2] == 1;
    CHECK(mesh.attributes[i][0] == (apex ? 0.25f : 0.0f));
    CHECK(mesh.attributes[i][1] == (apex ? 0.75f : 0.0f));
  }
}

TEST_CASE(
    "mesh files: without texture coordinates and normals they are places in the bounding box") {
  const FolderOfFiles folder;
  const Mesh mesh = load_mesh(folder.write("a.stl", sample_stl_binary()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto& [x, y, z] = mesh.positions[i];
    CHECK(mesh.attributes[i] == std::array{x, y, 2 * x - 1, 2 * z - 1});
  }
}

TEST_CASE("mesh files: normals are scaled to length 1") {
  const FolderOfFiles folder;
  const Mesh mesh = load_mesh(folder.write("a.ply", sample_ply_text()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    // The apex has the normal (3, 0, 4).
    CHECK(mesh.attributes[i][2] == (mesh.positions[i][2] == 1 ? 0.6f : 0.0f));
    CHECK(mesh.attributes[i][3] == 0);
  }
}

TEST_CASE("mesh files: text with nine digits gives back the float it was printed from") {
  std::string text;
  std::vector<float> values;
  for (int i = 0; i < 300; ++i) {
    values.push_back(std::ldexp(1 + static_cast<float>(i * i % 997) / 997, i % 21 - 10));
    char line[40];
    std::snprintf(line, sizeof line, i % 3 == 0 ? "v %.9g" : " %.9g", double{values.back()});
    text += line;
    text += i % 3 == 2 ? "\n" : "";
  }
  for (int i = 1; i <= 98; ++i) {
    text +=
        "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  }
  const FolderOfFiles folder;
  const Mesh mesh = load_mesh(folder.write("digits.obj", text));
  REQUIRE(mesh.triangles.size() == 98);
  for (std::size_t i = 0; i < 98; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = mesh.positions[mesh.triangles[i][k]];
      CHECK(p == Point{values[3 * (i + k)], values[3 * (i + k) + 1], values[3 * (i + k) + 2]});
    }
  }
}

TEST_CASE("mesh files: the extension counts in any case, and the path may have spaces") {
  const FolderOfFiles folder;
  CHECK(load_mesh(folder.write("a pyramid.OBJ", sample_obj())).triangles.size() == 6);
}

TEST_CASE("OBJ: comments, continued lines, colours, rational vertices and CR line ends are read") {
  const FolderOfFiles folder;
  const std::string obj =
      "v 0 0 0 # origin\r\n"
      "v 2 0 \\\r\n 0 2\r\n"
      "v 0 1 0 0.5 0.5 0.5\r\n"
      "f 1 \\\r\n 2 3 # a face\r\n";
  const Mesh mesh = load_mesh(folder.write("a.obj", obj));
  REQUIRE(mesh.triangles.size() == 1);
  CHECK(std::ranges::find(mesh.positions, Point{1, 0, 0}) != mesh.positions.end());
}

TEST_CASE("OBJ: a comment that ends in a backslash ends with its line") {
  const FolderOfFiles folder;
  const auto path = folder.write("a.obj", "# C:\\models\\\n" + sample_obj());
  CHECK(load_mesh(path).triangles.size() == 6);
}

TEST_CASE("OBJ: numbers may be written in every way that C prints them") {
  const FolderOfFiles folder;
  const Mesh mesh =
      load_mesh(folder.write("a.obj", "v 1. .5 -.25\nv +1e+2 1E-2 -1e2\nv 0 1 1e-50\nf 1 2 3\n"));
  REQUIRE(mesh.positions.size() == 3);
  CHECK(mesh.positions[0] == Point{1, 0.5f, -0.25f});
  CHECK(mesh.positions[1] == Point{100, 0.01f, -100});
  CHECK(mesh.positions[2] == Point{0, 1, 0});
}

TEST_CASE("OBJ: a texture coordinate may be u alone, or u, v and w") {
  const FolderOfFiles folder;
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .25\nvt 1 2 3\nf 1/1 2/1 3/2\n";
  const Mesh mesh = load_mesh(folder.write("a.obj", obj));
  REQUIRE(mesh.attributes.size() == 3);
  CHECK(mesh.attributes[0][0] == 0.25f);
  CHECK(mesh.attributes[2][1] == 2);
}

TEST_CASE(
    "STL: text with nine digits gives back the float it was printed from, at every magnitude") {
  std::vector<float> values;
  std::string text = "solid\n";
  for (int i = 0; i < 90; ++i) {
    if (i % 9 == 0) text += "facet normal 0 0 0\nouter loop\n";
    values.push_back(std::ldexp(1 + static_cast<float>(i * i % 97) / 97, 3 * i - 140));
    char word[40];
    std::snprintf(word, sizeof word, i % 3 == 0 ? "vertex %.9g" : " %.9g", double{values.back()});
    text += word;
    if (i % 3 == 2) text += "\n";
    if (i % 9 == 8) text += "endloop\nendfacet\n";
  }
  const FolderOfFiles folder;
  const Mesh mesh = load_mesh(folder.write("digits.stl", text + "endsolid\n"));
  REQUIRE(mesh.triangles.size() == 10);
  for (std::size_t i = 0; i < 90; ++i) {
    CHECK(mesh.positions[mesh.triangles[i / 9][i / 3 % 3]][i % 3] == values[i]);
  }
}

TEST_CASE("OBJ: a face may come before its vertices") {
  const FolderOfFiles folder;
  CHECK(load_mesh(folder.write("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")).triangles.size() ==
        1);
}

TEST_CASE("OBJ: keywords of the format that make no polygon are skipped unread") {
  const FolderOfFiles folder;
  const std::string unused =
      "l 1 2 99\np 4\nvp 0.5\ns off\ng a b\nusemtl nonsense/#1\ncstype bspline\nvw 1 2\nt crease\n";
  CHECK(load_mesh(folder.write("a.obj", sample_obj() + unused)).triangles.size() == 6);
}

TEST_CASE("OBJ: no file that it names is needed") {
  const FolderOfFiles folder;
  folder.write("pyramid.mtl", "newmtl stone\nmap_Kd missing.png\nKd nonsense\n");
  CHECK(load_mesh(folder.write("a.obj", sample_obj())).triangles.size() == 6);
}

TEST_CASE("glTF: a buffer in a file next to it is found, also under a name with a space") {
  const FolderOfFiles folder;
  folder.write("the bytes.bin", sample_gltf_buffer());
  const auto path = folder.write("a.gltf", sample_gltf_json("\"uri\":\"the%20bytes.bin\","));
  CHECK(load_mesh(path).triangles.size() == 6);
}

TEST_CASE("glTF: strips and fans are taken apart with their winding") {
  const FolderOfFiles folder;
  // The base as a strip would need 0 1 3 2; the indices start with 0 1 2 0.
  const std::string json = replaced(replaced(sample_gltf_json(""), "\"count\":18", "\"count\":4"),
                                    "\"indices\":2", "\"mode\":5,\"indices\":2");
  const Mesh mesh = load_mesh(folder.write("a.glb", as_glb(json, sample_gltf_buffer())));
  REQUIRE(mesh.triangles.size() == 2);
  const auto x = [&](int t, int k) { return (mesh.positions[mesh.triangles[t][k]][0] - 10) / 2; };
  CHECK(std::array{x(0, 0), x(0, 1), x(0, 2)} == std::array{0.0f, 1.0f, 1.0f});
}

TEST_CASE("glTF: a mesh that two nodes show is there twice, and only the default scene counts") {
  const FolderOfFiles folder;
  const std::string json =
      replaced(replaced(sample_gltf_json(""), "\"scale\":[2,2,2]}",
                        "\"scale\":[2,2,2]},{\"mesh\":0},{\"mesh\":0,\"translation\":[50,0,0]}"),
               "{\"nodes\":[0]}],\"scene\":0", "{\"nodes\":[0]},{\"nodes\":[2,3]}],\"scene\":1");
  const Mesh mesh = load_mesh(folder.write("a.glb", as_glb(json, sample_gltf_buffer())));
  CHECK(mesh.triangles.size() == 12);
  CHECK(bounding_box(mesh).lo == glm::dvec3(0, 0, 0));
  CHECK(bounding_box(mesh).hi == glm::dvec3(51, 1, 1));
}

}  // namespace
}  // namespace clipscope::experiments
