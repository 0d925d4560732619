// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/messages.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

std::string gltf_refusal(const std::string& name, const std::string& content) {
  const FolderOfFiles folder;
  const auto path = folder.write(name, content);
  return message_of<InputError>([&] { load_mesh(path); });
}

// The message for the sample with a part of its JSON replaced.
std::string with(const std::string& part, const std::string& by) {
  return gltf_refusal("a.glb",
                      as_glb(replaced(sample_gltf_json(""), part, by), sample_gltf_buffer()));
}

TEST_CASE("bad glTF: broken JSON is found at its byte") {
  CHECK(
      contains(gltf_refusal("a.gltf", "{\"asset\":"), "a.gltf: the JSON is broken at its byte 10"));
  CHECK(contains(gltf_refusal("a.gltf", "[1]"), "a.gltf: the JSON is no object"));
  CHECK(contains(gltf_refusal("a.gltf", "\xff\xff"), "a.gltf: the JSON is broken"));
}

TEST_CASE("bad glTF: parts that are missing or of the wrong kind are named by their place") {
  CHECK(contains(with("\"2.0\"", "\"1.0\""), "asset.version is \"1.0\"; \"2.0\" expected"));
  CHECK(contains(with("{\"version\":\"2.0\"}", "{}"), "asset.version is null"));
  CHECK(contains(with("\"count\":5", "\"count\":-5"), "accessors[0].count is -5; a whole number"));
  CHECK(contains(with("\"count\":5,", ""), "accessors[0].count is missing"));
  CHECK(contains(with("\"count\":5", "\"count\":0"), "accessors[0].count is 0"));
  CHECK(contains(with("{\"POSITION\":0,", "{"),
                 "meshes[0].primitives[0].attributes.POSITION is missing"));
  CHECK(contains(with("\"translation\":[10,20,30]", "\"translation\":[10,20]"),
                 "nodes[0].translation is not a list of 3 numbers"));
  CHECK(contains(with("\"nodes\":[{", "\"nodes\":[7,{"), "nodes[0] is no object"));
  CHECK(contains(with("\"primitives\":[{", "\"primitives\":[],\"x\":[{"),
                 "meshes[0].primitives is missing or empty"));
  CHECK(contains(with("\"indices\":2", "\"mode\":9,\"indices\":2"), "primitives[0].mode is 9"));
}

TEST_CASE("bad glTF: references to what is not there are named with what there is") {
  CHECK(contains(with("\"POSITION\":0", "\"POSITION\":7"),
                 "refers to accessors[7], but the file has 3"));
  CHECK(
      contains(with("\"bufferView\":2", "\"bufferView\":3"), "bufferViews[3], but the file has 3"));
  CHECK(contains(with("\"mesh\":0", "\"mesh\":1"),
                 "nodes[1].mesh refers to meshes[1], but the file has 1"));
  CHECK(contains(with("\"children\":[1]", "\"children\":[2]"),
                 "nodes[0].children refers to nodes[2]"));
  CHECK(contains(with("\"scene\":0", "\"scene\":4"),
                 "scene refers to scenes[4], but the file has 1"));
}

TEST_CASE("bad glTF: what reaches past its buffer is named with both sizes") {
  CHECK(contains(with("\"byteLength\":136", "\"byteLength\":137"),
                 "buffers[0].byteLength is 137, but the binary chunk has only 136 bytes"));
  CHECK(contains(with("\"byteLength\":36", "\"byteLength\":37"),
                 "bufferViews[2] ends at byte 137 of buffers[0], which has 136 bytes"));
  CHECK(contains(with("\"count\":18", "\"count\":21"),
                 "accessors[2] ends at byte 42 of bufferViews[2], which has 36 bytes"));
  CHECK(contains(with("\"count\":5", "\"count\":1000000000000"), "ends at byte 12000000000000"));
  CHECK(contains(with("\"byteLength\":60", "\"byteStride\":4,\"byteLength\":60"),
                 "bufferViews[0].byteStride is 4; 12 to 252 expected"));
}

TEST_CASE("bad glTF: values that make no geometry are found at their element") {
  std::string buffer = sample_gltf_buffer();
  const float nan = NAN;
  std::memcpy(buffer.data() + 12 * 3 + 4, &nan, sizeof nan);
  CHECK(contains(gltf_refusal("a.glb", as_glb(sample_gltf_json(""), buffer)),
                 "accessors[0]: vertex 3: y is NaN"));
  buffer = sample_gltf_buffer();
  buffer[100 + 2 * 4] = 5;
  CHECK(contains(gltf_refusal("a.glb", as_glb(sample_gltf_json(""), buffer)),
                 "accessors[2]: index 4 refers to vertex 5, but there are only 5"));
  CHECK(contains(with("\"count\":18", "\"count\":17"), "has 17 corners; a multiple of 3 expected"));
  CHECK(contains(with("\"count\":5,\"type\":\"VEC2\"", "\"count\":4,\"type\":\"VEC2\""),
                 "accessors[1] holds TEXCOORD_0 of 4 vertices; 5 expected"));
  CHECK(
      contains(with("\"VEC3\"", "\"VEC2\""), "accessors[0] holds positions and is of type 'VEC2'"));
  CHECK(contains(with("5123", "5126"), "accessors[2] "));
}

TEST_CASE("bad glTF: nodes that form no tree are refused") {
  CHECK(contains(with("\"mesh\":0,\"scale\"", "\"children\":[1],\"mesh\":0,\"scale\""),
                 "nodes[1] is the child of two nodes"));
  CHECK(contains(with("\"mesh\":0,\"scale\"", "\"children\":[0],\"mesh\":0,\"scale\""),
                 "nodes[0] is a root of the scene and appears a second time"));
  CHECK(contains(with("\"nodes\":[0]", "\"nodes\":[0,0]"), "nodes[0] is a root of the scene"));
}

TEST_CASE("bad glTF: compressed meshes are refused by the name of their extension") {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    CHECK(contains(
        with("{\"asset\"", "{\"extensionsRequired\":[\"" + std::string(name) + "\"],\"asset\""),
        "the meshes are compressed (" + std::string(name) + "); plain ones expected"));
  }
  CHECK(contains(
      with("\"indices\":2", "\"extensions\":{\"KHR_draco_mesh_compression\":{}},\"indices\":2"),
      "meshes[0].primitives[0] is compressed (KHR_draco_mesh_compression)"));
  CHECK(contains(
      with("{\"buffer\":0,\"byteLength\":60}",
           "{\"buffer\":0,\"extensions\":{\"EXT_meshopt_compression\":{}},\"byteLength\":60}"),
      "bufferViews[0] is compressed (EXT_meshopt_compression)"));
}

TEST_CASE("bad glTF: a required extension that may change the geometry is refused by name") {
  const auto requiring = [](const char* name) {
    return replaced(sample_gltf(), "{\"asset\"",
                    "{\"extensionsRequired\":[\"" + std::string(name) + "\"],\"asset\"");
  };
  CHECK(contains(gltf_refusal("a.gltf", requiring("KHR_implicit_shapes")),
                 "extensionsRequired holds KHR_implicit_shapes, which is not known"));
  const FolderOfFiles folder;
  CHECK_NOTHROW(load_mesh(folder.write("a.gltf", requiring("KHR_materials_unlit"))));
}

TEST_CASE("bad glTF: sparse accessors must lie within their buffers and rise") {
  const auto sparse = [](const char* indices) {
    return with("\"count\":5,\"type\":\"VEC3\"",
                "\"count\":5,\"type\":\"VEC3\",\"sparse\":{\"count\":2,\"indices\":{" +
                    std::string(indices) + "},\"values\":{\"bufferView\":1}}");
  };
  CHECK(contains(with("\"count\":5", "\"sparse\":{},\"count\":5"),
                 "accessors[0].sparse.count is missing"));
  CHECK(contains(sparse("\"bufferView\":2,\"componentType\":5126"),
                 "accessors[0].sparse.indices.componentType is 5126; 5121, 5123 or 5125 expected"));
  CHECK(contains(sparse("\"bufferView\":2,\"componentType\":5123,\"byteOffset\":4"),
                 "has the element 0 at place 1; rising numbers below 5 expected"));
  CHECK(contains(sparse("\"bufferView\":2,\"componentType\":5123,\"byteOffset\":34"),
                 "sparse.indices ends at byte 38 of bufferViews[2], which has 36 bytes"));
}

TEST_CASE("bad glTF: quantized positions need the extension that allows them") {
  CHECK(contains(
      with("\"componentType\":5126,\"count\":5,\"type\":\"VEC3\"",
           "\"componentType\":5120,\"count\":5,\"type\":\"VEC3\""),
      "accessors[0] holds positions and is quantized; VEC3 and 5126 (float), or KHR_mesh_quantization among extensionsRequired expected"));
}

TEST_CASE("bad glTF: binary files must have the length and chunks that they announce") {
  const std::string good = sample_glb();
  CHECK(contains(gltf_refusal("a.glb", good.substr(0, 8)), "8 bytes are too few"));
  CHECK(contains(gltf_refusal("a.glb", good.substr(0, good.size() - 1)), "but the file has"));
  CHECK(contains(gltf_refusal("a.glb", replaced(good, "JSON", "JSOM")),
                 "the chunk at byte 12 is not of type JSON"));
  std::string version = good;
  version[4] = 1;
  CHECK(contains(gltf_refusal("a.glb", version), "the binary glTF version is 1; 2 expected"));
  std::string chunk = good;
  chunk[15] = 1;
  CHECK(contains(gltf_refusal("a.glb", chunk),
                 "the chunk at byte 12 reaches past the end of the file"));
}

TEST_CASE("bad glTF: buffers elsewhere must be there and long enough") {
  const FolderOfFiles folder;
  const auto path = folder.write("a.gltf", sample_gltf_json("\"uri\":\"a.bin\","));
  const auto message = [&] { return message_of<InputError>([&] { load_mesh(path); }); };
  CHECK(contains(message(), "a.bin: no such file"));
  folder.write("a.bin", "short");
  CHECK(contains(message(), "buffers[0].byteLength is 136, but '"));
  CHECK(contains(gltf_refusal("a.gltf", sample_gltf_json("\"uri\":\"data:;base64,AA!A\",")),
                 "buffers[0].uri is no base64 data URI"));
  CHECK(contains(gltf_refusal("a.gltf", sample_gltf_json("")), "buffers[0].uri is missing"));
}

TEST_CASE("bad glTF: a scene that shows no triangles is refused") {
  CHECK(contains(with("\"nodes\":[0]", "\"nodes\":[]"), "no triangles"));
  CHECK(contains(with("\"indices\":2", "\"mode\":1,\"indices\":2"), "no triangles"));
}

}  // namespace
}  // namespace clipscope::experiments
