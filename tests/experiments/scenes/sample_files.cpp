// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/scenes/sample_files.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace clipscope::experiments {
namespace {

constexpr std::array<std::array<int, 3>, 6> kTriangles = {
    {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};

template <class T>
void append(std::string& bytes, T value, bool big_endian = false) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (big_endian) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text.push_back(i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63]);
    }
  }
  return text;
}

}  // namespace

std::filesystem::path FolderOfFiles::write(const std::string& name,
                                           const std::string& content) const {
  std::ofstream(path() / name, std::ios::binary) << content;
  return path() / name;
}

std::string sample_obj() {
  return "# a pyramid\n"
         "mtllib pyramid.mtl\n"
         "o pyramid\n"
         "v 0 0 0\n"
         "v 1 0 0\n"
         "v 1 1 0\n"
         "v 0 1 0\n"
         "v 0.5 0.5 1\n"
         "vt 0 0\n"
         "vt 0.25 0.75\n"
         "usemtl stone\n"
         "f 1/1 2/1 3/1 4/1\n"
         "f 1/1 2/1 5/2\n"
         "f 2/1 3/1 5/2\n"
         "f -3/1 -2/1 -1/2\n"
         "f 4/1 1/1 5/2\n";
}

std::string sample_ply_text() {
  return "ply\n"
         "format ascii 1.0\n"
         "comment a pyramid\n"
         "element vertex 5\n"
         "property float x\n"
         "property float y\n"
         "property float z\n"
         "property float nx\n"
         "property float ny\n"
         "property float nz\n"
         "element face 5\n"
         "property list uchar int vertex_indices\n"
         "end_header\n"
         "0 0 0 0 0 -1\n"
         "1 0 0 0 0 -1\n"
         "1 1 0 0 0 -1\n"
         "0 1 0 0 0 -1\n"
         "0.5 0.5 1 3 0 4\n"
         "4 0 1 2 3\n"
         "3 0 1 4\n"
         "3 1 2 4\n"
         "3 2 3 4\n"
         "3 3 0 4\n";
}

std::string sample_ply_binary(bool big_endian) {
  std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\n"
                      "element vertex 5\n"
                      "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                      "element face 6\n"
                      "property list uchar int vertex_index\n"
                      "end_header\n";
  for (const auto& p : kPyramid) {
    for (const float c : p) append(bytes, c, big_endian);
    append(bytes, std::uint8_t{200});
  }
  for (const auto& t : kTriangles) {
    append(bytes, std::uint8_t{3});
    for (const std::int32_t i : t) append(bytes, i, big_endian);
  }
  return bytes;
}

std::string sample_ply_strips() {
  return "ply\n"
         "format ascii 1.0\n"
         "element vertex 5\n"
         "property double x\nproperty double y\nproperty double z\n"
         "element tristrips 2\n"
         "property list int int vertex_indices\n"
         "end_header\n"
         "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n"
         // Two strips in one list, and one that repeats its last corner.
         "9 0 1 4 2 3 -1 4 3 0\n"
         "6 1 2 0 3 3 3\n";
}

std::string sample_stl_text() {
  std::string text = "solid a pyramid\n";
  for (const auto& t : kTriangles) {
    text += "facet normal 0 0 1\n outer loop\n";
    for (const int i : t) {
      text += "  vertex";
      for (const float c : kPyramid[i]) text += c == 0.5f ? " 5e-1" : c == 1 ? " 1" : " 0";
      text += "\n";
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid a pyramid\n";
}

std::string sample_stl_binary() {
  std::string bytes(80, ' ');
  append(bytes, std::uint32_t{kTriangles.size()});
  for (const auto& t : kTriangles) {
    for (const float c : {0.0f, t[2] == 4 ? 0.8f : 0.0f, 0.6f}) append(bytes, c);
    for (const int i : t) {
      for (const float c : kPyramid[i]) append(bytes, c);
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string sample_gltf_buffer() {
  std::string bytes;
  for (const auto& p : kPyramid) {
    for (const float c : p) append(bytes, c);
  }
  for (const auto& p : kPyramid) {
    append(bytes, p[0]);
    append(bytes, p[1]);
  }
  for (const auto& t : kTriangles) {
    for (const int i : t) append(bytes, static_cast<std::uint16_t>(i));
  }
  return bytes;
}

std::string sample_gltf_json(const std::string& uri_member) {
  return R"({"asset":{"version":"2.0"},
"buffers":[{)" +
         uri_member + R"("byteLength":136}],
"bufferViews":[{"buffer":0,"byteLength":60},
{"buffer":0,"byteOffset":60,"byteLength":40},
{"buffer":0,"byteOffset":100,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"},
{"bufferView":1,"componentType":5126,"count":5,"type":"VEC2"},
{"bufferView":2,"componentType":5123,"count":18,"type":"SCALAR"}],
"materials":[{"name":"stone"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],
"nodes":[{"children":[1],"translation":[10,20,30]},{"mesh":0,"scale":[2,2,2]}],
"scenes":[{"nodes":[0]}],"scene":0})";
}

std::string sample_gltf() {
  return sample_gltf_json("\"uri\":\"data:application/octet-stream;base64," +
                          base64(sample_gltf_buffer()) + "\",");
}

std::string as_glb(const std::string& json, const std::string& buffer) {
  const std::string padding(-json.size() % 4, ' ');
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(28 + json.size() + padding.size() + buffer.size()));
  append(bytes, static_cast<std::uint32_t>(json.size() + padding.size()));
  bytes += "JSON" + json + padding;
  append(bytes, static_cast<std::uint32_t>(buffer.size()));
  bytes += std::string("BIN\0", 4) + buffer;
  return bytes;
}

std::string sample_glb() { return as_glb(sample_gltf_json(""), sample_gltf_buffer()); }

std::string sample_sparse_glb() {
  std::string json = replaced(sample_gltf_json(""), "\"byteLength\":136", "\"byteLength\":140");
  json = replaced(json, "\"byteLength\":36}",
                  "\"byteLength\":36},{\"buffer\":0,\"byteOffset\":136,\"byteLength\":4}");
  json = replaced(json, "{\"bufferView\":0,\"componentType\":5126",
                  R"({"sparse":{"count":4,"indices":{"bufferView":3,"componentType":5121},
"values":{"bufferView":0,"byteOffset":12}},"componentType":5126)");
  return as_glb(json, sample_gltf_buffer() + "\1\2\3\4");
}

std::vector<SampleFile> sample_files() {
  return {{"a.obj", sample_obj()},
          {"text.ply", sample_ply_text()},
          {"little.ply", sample_ply_binary(false)},
          {"big.ply", sample_ply_binary(true)},
          {"strips.ply", sample_ply_strips()},
          {"text.stl", sample_stl_text()},
          {"binary.stl", sample_stl_binary()},
          {"a.gltf", sample_gltf()},
          {"a.glb", sample_glb()},
          {"sparse.glb", sample_sparse_glb()}};
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::logic_error("the sample has no '" + part + "'");
  return text.replace(at, part.size(), by);
}

}  // namespace clipscope::experiments
