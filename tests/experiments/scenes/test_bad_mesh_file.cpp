// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each kind of bad file is refused, and the message says where and why.
#include <cmath>
#include <cstring>
#include <fstream>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

// The message for a file with that content; it names the file.
std::string mesh_refusal(const std::string& name, const std::string& content) {
  const FolderOfFiles folder;
  const auto path = folder.write(name, content);
  const std::string message = message_of<InputError>([&] { load_mesh(path); });
  CHECK(message.starts_with(path.string() + ":"));
  return message.substr(path.parent_path().string().size() + 1);
}

std::string with_float(std::string bytes, std::size_t offset, float value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
  return bytes;
}

TEST_CASE("bad files: a missing file, a directory, an empty file and a strange one") {
  const FolderOfFiles folder;
  const auto message = [&](const std::string& name) {
    return message_of<InputError>([&] { load_mesh(folder.path() / name); });
  };
  CHECK(contains(message("none.obj"), "none.obj: no such file"));
  std::filesystem::create_directory(folder.path() / "folder.obj");
  CHECK(contains(message("folder.obj"), "folder.obj: a directory; a mesh file expected"));
  folder.write("empty.ply", "");
  CHECK(contains(message("empty.ply"), "empty.ply: the file is empty"));
  folder.write("a.xyz", "1 2 3");
  CHECK(contains(message("a.xyz"), "'.xyz' is no mesh format; .obj, .ply, .stl, .gltf or .glb"));
  folder.write("plain", "1 2 3");
  CHECK(contains(message("plain"), "'' is no mesh format"));
  CHECK(contains(message("a.xyz/b.obj"), "b.obj: "));
}

TEST_CASE("bad files: one that may not be read") {
  const FolderOfFiles folder;
  const auto path = folder.write("locked.obj", sample_obj());
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (std::ifstream(path)) {
    SUCCEED("permissions don't bind this user");
    return;
  }
  CHECK(contains(message_of<InputError>([&] { load_mesh(path); }), "can't be opened: "));
}

TEST_CASE("bad OBJ: each fault is found at its line") {
  const auto with = [](const char* part, const char* by) {
    return mesh_refusal("a.obj", replaced(sample_obj(), part, by));
  };
  CHECK(contains(with("f 1/1 2/1 5/2", "f 1/1 2/1 99/2"),
                 "a.obj:13: the face refers to vertex 99, but only 5 vertices are defined"));
  CHECK(contains(with("f 1/1 2/1 5/2", "f 1/1 2/1 5/3"),
                 "a.obj:13: the face refers to texture coordinate 3, but only 2 "));
  CHECK(contains(with("f 1/1 2/1 5/2", "vn 0 0 1\nf 1/1/1 2/1/1 5/2/2"),
                 "a.obj:14: the face refers to normal 2, but only 1 normal is defined"));
  CHECK(
      contains(with("f -3/1", "f -6/1"), "a.obj:15: the face refers 6 vertices back, but only 5 "));
  CHECK(contains(with("f 1/1 2/1 5/2", "f 0/1 2/1 5/2"), "a.obj:13: the face refers to vertex 0;"));
  CHECK(contains(with("f 1/1 2/1 5/2", "f 1/1 2/1"), "a.obj:13: a face has 2 entries; at least 3"));
  CHECK(
      contains(with("f 1/1 2/1 5/2", "f 1/1 2/1 five"), "a.obj:13: a vertex reference is 'five'"));
  CHECK(contains(with("f 1/1 2/1 5/2", "f 1/1 2/1 1.5"), "'1.5'; a whole number was expected"));
  CHECK(contains(with("f 1/1 2/1 5/2", "f 1/1 2/1 1/1/1/1"), "more than three parts"));
  CHECK(contains(with("v 1 1 0", "v 1 1"), "a.obj:6: the vertex has 2 numbers; 3 (x y z)"));
  CHECK(contains(with("v 1 1 0", "v 1 nan 0"), "a.obj:6: y of the vertex is NaN;"));
  CHECK(contains(with("v 1 1 0", "v 1 1 -inf"), "a.obj:6: z of the vertex is infinite;"));
  CHECK(contains(with("v 1 1 0", "v 1e39 1 0"), "a.obj:6: x of the vertex is 1e+39, too large"));
  CHECK(contains(with("v 1 1 0", "v 1 1 0 0"), "a.obj:6: w of the vertex is 0"));
  CHECK(contains(with("v 1 1 0", "v 1 x 0"), "a.obj:6: y of the vertex is 'x'; a number"));
  CHECK(contains(with("v 1 1 0", "v 1,5 1 0"), "'1,5'"));
  CHECK(contains(with("vt 0 0", "vt 0 inf"), "a.obj:9: v of the texture coordinate is infinite"));
}

TEST_CASE("bad OBJ: a file of vertices alone has no triangles") {
  CHECK(
      contains(mesh_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n"), "no face ('f' line)"));
  CHECK(contains(mesh_refusal("a.obj", "# not a mesh\n"), "no face ('f' line)"));
}

TEST_CASE(
    "bad OBJ: a word that is no keyword is named at its line, invisible characters included") {
  const auto with = [](const char* by) {
    return mesh_refusal("a.obj", replaced(sample_obj(), "v 1 1 0", by));
  };
  CHECK(contains(with("V 1 1 0"), "a.obj:6: 'V' is no OBJ keyword; v, vt, vn, f, another keyword"));
  CHECK(contains(with("\xC2\xA0v 1 1 0"), "a.obj:6: '<U+00A0 no-break space>v' is no OBJ keyword"));
  CHECK(contains(with("\xEF\xBB\xBFv 1 1 0"), "'<U+FEFF byte order mark>v' is no OBJ keyword"));
  CHECK(contains(with("v 1 1\xC2\xA0 x"), "y of the vertex is '1<U+00A0 no-break space>'"));
  CHECK(contains(with("v 1 1 \xE2\x88\x92.5"), "z of the vertex is '<U+2212 minus sign>.5'"));
  CHECK(contains(with("v 1 1 \xFF"), "z of the vertex is '<0xFF>'"));
  CHECK(contains(with("call other.obj"), "a.obj:6: 'call' includes another file"));
}

TEST_CASE("bad PLY: each fault of a text file is found at its line") {
  const auto with = [](const char* part, const char* by) {
    return mesh_refusal("a.ply", replaced(sample_ply_text(), part, by));
  };
  CHECK(contains(with("ply\n", "plie\n"), "a.ply:1: the file does not begin with the line 'ply'"));
  CHECK(contains(with("format ascii", "format asci"), "a.ply:2: the format is 'asci'"));
  CHECK(contains(with("ascii 1.0", "ascii 2.0"),
                 "a.ply:2: the format version is '2.0'; 1.0 expected"));
  CHECK(contains(with("element vertex 5", "element vertex five"),
                 "a.ply:4: the element count is 'five'"));
  CHECK(
      contains(with("element vertex 5", "element vertex -5"), "a.ply:4: the element count is -5"));
  CHECK(contains(with("property float y", "property real y"), "a.ply:6: 'real' is no type"));
  CHECK(contains(with("property float y", "property float Y"), "the vertices have no number 'y'"));
  CHECK(contains(with("vertex_indices", "corners"), "no list 'vertex_indices' or 'vertex_index'"));
  CHECK(contains(with("end_header\n", ""), "is no header keyword"));
  CHECK(contains(with("1 1 0 0 0 -1", "1 nan 0 0 0 -1"), "a.ply:16: vertex 2: y is NaN"));
  CHECK(contains(with("1 1 0 0 0 -1", "1 1 0 0 0"),
                 "a.ply:16: vertex 2 has too few values: nz is missing"));
  CHECK(contains(with("1 1 0 0 0 -1", "1 1 0 0 0 -1 9"),
                 "a.ply:16: vertex 2 has 7 values; 6 expected"));
  CHECK(contains(with("1 1 0 0 0 -1", "1 1 0 0 0 x"), "a.ply:16: nz of vertex 2 is 'x'"));
  CHECK(contains(with("3 1 2 4", "3 1 2 5"),
                 "a.ply:21: face 2: refers to vertex 5, but there are only 5"));
  CHECK(contains(with("3 1 2 4", "3 1 2 -1"), "a.ply:21: face 2: refers to vertex -1"));
  CHECK(contains(with("3 1 2 4", "2 1 2"), "a.ply:21: face 2: has 2 vertices; at least 3"));
  CHECK(contains(with("3 3 0 4\n", ""), "the file ends after 4 of 5 elements 'face'"));
  CHECK(contains(with("element face 5", "element face 4"), "goes on after the last element"));
  CHECK(contains(with("element face 5", "element face 0"), "announces no faces"));
}

TEST_CASE("bad PLY: faults of binary files are found at their element") {
  const std::string good = sample_ply_binary(false);
  const std::size_t body = good.find("end_header\n") + 11;
  // A vertex takes 13 bytes, a face 13 as well.
  CHECK(contains(mesh_refusal("a.ply", with_float(good, body + 13 * 3 + 4, NAN)),
                 "a.ply: vertex 3: y is NaN"));
  CHECK(contains(mesh_refusal("a.ply", with_float(good, body + 13 * 3, INFINITY)),
                 "vertex 3: x is infinite"));
  std::string bad = good;
  bad[body + 65 + 13 * 2 + 1] = 9;
  CHECK(contains(mesh_refusal("a.ply", bad),
                 "a.ply: face 2: refers to vertex 9, but there are only 5"));
  CHECK(contains(mesh_refusal("a.ply", good.substr(0, good.size() - 1)),
                 "a.ply: the file ends within face 5 of 6: it is truncated"));
  CHECK(contains(mesh_refusal("a.ply", good + "x"), "1 bytes follow the last element"));
  CHECK(contains(mesh_refusal("a.ply", replaced(good, "vertex 5", "vertex 4000000000")),
                 "truncated"));
}

TEST_CASE("bad STL: each fault of a text file is found at its line") {
  const auto with = [](const char* part, const char* by) {
    return mesh_refusal("a.stl", replaced(sample_stl_text(), part, by));
  };
  CHECK(contains(with("vertex 1 0 0", "vertex 1 nan 0"), "a.stl:5: y of the vertex is NaN"));
  CHECK(contains(with("vertex 1 0 0", "vertex 1 0"), "a.stl:5: the vertex has 2 of 3 numbers"));
  CHECK(contains(with("vertex 1 0 0", "vertex 1 0 zero"), "a.stl:5: z of the vertex is 'zero'"));
  CHECK(contains(with("  vertex 1 0 0\n", ""), "a.stl:6: the facet has 2 vertices; 3 expected"));
  CHECK(contains(with("  vertex 1 0 0\n", "  vertex 1 0 0\n  vertex 1 0 0\n"), "has 4 vertices"));
  CHECK(contains(with("endloop", "endlop"), "a.stl:7: 'endlop' is no STL keyword; 'endloop' was"));
  CHECK(contains(with("endfacet", "outer loop"), "'endfacet' was expected"));
  CHECK(contains(with("facet normal", "facet"), "a.stl:2: 'facet normal <x> <y> <z>' expected"));
  CHECK(contains(with("endsolid a pyramid\n", ""), "'endsolid' is missing: it is truncated"));
  CHECK(contains(mesh_refusal("a.stl", "solid nothing\nendsolid nothing\n"), "no triangles"));
}

TEST_CASE("bad PLY: vertex references must be whole numbers") {
  CHECK(contains(mesh_refusal("a.ply", replaced(sample_ply_text(), "3 1 2 4", "3 1 2 3.5")),
                 "a.ply:21: face 2: refers to vertex 3.5; a whole number was expected"));
  CHECK(contains(mesh_refusal("a.ply", replaced(sample_ply_text(), "3 1 2 4", "3.5 1 2 4")),
                 "a.ply:21: face 2: has a list of 3.5 values"));
}

TEST_CASE("bad STL: a binary file's size must fit its triangle count") {
  const std::string good = sample_stl_binary();
  CHECK(contains(mesh_refusal("a.stl", good.substr(0, 300)),
                 "announces 6 triangles, which take 384 bytes, but the file has 300"));
  CHECK(contains(mesh_refusal("a.stl", good + "x"), "but the file has 385"));
  CHECK(
      contains(mesh_refusal("a.stl", good.substr(0, 50)), "50 bytes are too few for an STL file"));
  CHECK(contains(mesh_refusal("a.stl", good.substr(0, 80) + std::string(4, '\0')), "no triangles"));
  // Triangle 2 begins at byte 84 + 2 * 50, its second vertex 24 bytes later.
  CHECK(contains(mesh_refusal("a.stl", with_float(good, 84 + 100 + 24 + 8, NAN)),
                 "a.stl: triangle 2, vertex 1: z is NaN"));
}

}  // namespace
}  // namespace clipscope::experiments
