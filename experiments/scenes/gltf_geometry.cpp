// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks the geometry of a glTF file and repacks it alone.
//
// Not supported, and said so: sparse accessors, compressed meshes, positions that are not floats.
// Texture coordinates and normals that are not floats are left out.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/scenes/gltf.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

using Json = GltfDocument::Json;

constexpr std::size_t kMostNested = 1000;  // assimp descends recursively
constexpr std::size_t kFloat = 5126, kUnsignedByte = 5121, kUnsignedShort = 5123,
                      kUnsignedInt = 5125;
constexpr std::size_t kTriangles = 4, kTriangleFan = 6;

std::size_t bytes_of(std::size_t component_type) {
  switch (component_type) {
    case 5120:
    case kUnsignedByte: return 1;
    case 5122:
    case kUnsignedShort: return 2;
    case kUnsignedInt:
    case kFloat: return 4;
    default: return 0;
  }
}

std::size_t components_of(const Json& type) {
  for (const auto& [name, components] :
       {std::pair{"SCALAR", 1u}, {"VEC2", 2u}, {"VEC3", 3u}, {"VEC4", 4u}}) {
    if (type == name) {
      return components;
    }
  }
  return 0;
}

// The elements of an accessor, checked to lie within the bytes.
struct Accessor {
  std::string at;
  Json type;
  std::size_t component_type = 0, component_bytes = 0, components = 0;
  std::size_t count = 0;
  std::size_t start = 0, stride = 0;  // in bytes; start within Gltf::bytes

  std::size_t element_bytes() const { return component_bytes * components; }
  std::size_t extent() const { return (count - 1) * stride + element_bytes(); }
};

// Reads accessors and their values.
class AccessorReader {
 public:
  explicit AccessorReader(const Gltf& gltf) : gltf_(gltf), document_(gltf.document) {}

  Accessor read(std::size_t index) const {
    Accessor a;
    a.at = GltfDocument::place("accessors", index);
    const Json& json = document_.object_of("accessors", index);
    if (json.contains("sparse")) {
      document_.fail(fmt::format("{} is sparse; a plain one expected", a.at));
    }
    a.component_type = document_.size_in(json, "componentType", a.at);
    a.component_bytes = bytes_of(a.component_type);
    a.type = json.value("type", Json());
    a.components = components_of(a.type);
    if (a.element_bytes() == 0) {
      document_.fail(
          fmt::format("{} is of type {} and componentType {}; SCALAR, VEC2, VEC3 or VEC4 and "
                      "5120 to 5123, 5125 or 5126 expected",
                      a.at, a.type.dump(), a.component_type));
    }
    a.count = document_.size_in(json, "count", a.at);
    if (a.count == 0) {
      document_.fail(fmt::format("{}.count is 0; at least 1 expected", a.at));
    }
    place_in_view(a, json);
    return a;
  }

  // A component as a number: floats and unsigned whole numbers only.
  double value(const Accessor& a, std::size_t element, std::size_t component) const {
    const char* source =
        gltf_.bytes.data() + a.start + element * a.stride + component * a.component_bytes;
    switch (a.component_type) {
      case kFloat: return read_as<float>(source);
      case kUnsignedByte: return read_as<std::uint8_t>(source);
      case kUnsignedShort: return read_as<std::uint16_t>(source);
      default: return read_as<std::uint32_t>(source);
    }
  }

 private:
  template <class T>
  static T read_as(const char* source) {
    T value;
    std::memcpy(&value, source, sizeof value);
    return value;
  }

  void place_in_view(Accessor& a, const Json& json) const {
    const auto index = document_.index_in(json, "bufferView", "bufferViews", a.at);
    if (!index) {
      document_.fail(fmt::format("{}.bufferView is missing", a.at));
    }
    const std::string at = GltfDocument::place("bufferViews", *index);
    const Json& view = document_.object_of("bufferViews", *index);
    const auto buffer = document_.index_in(view, "buffer", "buffers", at);
    if (!buffer) {
      document_.fail(fmt::format("{}.buffer is missing", at));
    }
    const std::size_t offset = document_.size_in(view, "byteOffset", at, 0);
    const std::size_t length = document_.size_in(view, "byteLength", at);
    const std::size_t available = gltf_.buffer_start[*buffer + 1] - gltf_.buffer_start[*buffer];
    if (offset + length > available) {
      document_.fail(fmt::format("{} ends at byte {} of {}, which has {} bytes", at,
                                 offset + length, GltfDocument::place("buffers", *buffer),
                                 available));
    }
    a.stride = document_.size_in(view, "byteStride", at, a.element_bytes());
    if (a.stride < a.element_bytes() || a.stride > 252) {
      document_.fail(
          fmt::format("{}.byteStride is {}; {} to 252 expected", at, a.stride, a.element_bytes()));
    }
    const std::size_t inner = document_.size_in(json, "byteOffset", a.at, 0);
    if (inner + a.extent() > length) {
      document_.fail(fmt::format("{} ends at byte {} of {}, which has {} bytes", a.at,
                                 inner + a.extent(), at, length));
    }
    a.start = gltf_.buffer_start[*buffer] + offset + inner;
  }

  const Gltf& gltf_;
  const GltfDocument& document_;
};

// Builds the file that holds the geometry alone.
class Packer {
 public:
  explicit Packer(const Gltf& gltf) : gltf_(gltf), document_(gltf.document), reader_(gltf) {}

  std::string pack() {
    check_asset();
    packed_["asset"]["version"] = "2.0";
    packed_["buffers"] = Json::array({{{"byteLength", gltf_.bytes.size()}}});
    for (const char* list : {"accessors", "bufferViews", "meshes", "nodes"}) {
      packed_[list] = Json::array();
    }
    for (std::size_t i = 0; i < document_.count_of("meshes"); ++i) {
      pack_mesh(i);
    }
    for (std::size_t i = 0; i < document_.count_of("nodes"); ++i) {
      pack_node(i);
    }
    pack_scene();
    return as_binary_file();
  }

 private:
  void check_asset() const {
    const auto asset = document_.root().find("asset");
    const Json version = asset != document_.root().end() && asset->is_object()
                             ? asset->value("version", Json())
                             : Json();
    if (!version.is_string() || !version.get_ref<const std::string&>().starts_with("2.")) {
      document_.fail(fmt::format("asset.version is {}; \"2.0\" expected", version.dump()));
    }
    const auto required = document_.root().find("extensionsRequired");
    if (required == document_.root().end()) {
      return;
    }
    for (const Json& extension : *required) {
      if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression") {
        document_.fail(
            fmt::format("the meshes are compressed ({}); plain ones expected", extension.dump()));
      }
    }
  }

  void pack_mesh(std::size_t mesh) {
    const std::string at = GltfDocument::place("meshes", mesh);
    const Json& json = document_.object_of("meshes", mesh);
    const auto primitives = json.find("primitives");
    if (primitives == json.end() || !primitives->is_array() || primitives->empty()) {
      document_.fail(fmt::format("{}.primitives is missing or empty", at));
    }
    Json packed = Json::array();
    for (std::size_t i = 0; i < primitives->size(); ++i) {
      const std::string inner = fmt::format("{}.primitives[{}]", at, i);
      if (!(*primitives)[i].is_object()) {
        document_.fail(fmt::format("{} is no object", inner));
      }
      packed.push_back(pack_primitive((*primitives)[i], inner));
    }
    packed_["meshes"].push_back({{"primitives", packed}});
  }

  Json pack_primitive(const Json& primitive, const std::string& at) {
    const std::size_t mode = document_.size_in(primitive, "mode", at, kTriangles);
    if (mode > kTriangleFan) {
      document_.fail(fmt::format("{}.mode is {}; 0 to 6 expected", at, mode));
    }
    const Json none = Json::object();
    const auto found = primitive.find("attributes");
    const Json& attributes = found != primitive.end() && found->is_object() ? *found : none;
    const std::string inner = at + ".attributes";
    const auto index = document_.index_in(attributes, "POSITION", "accessors", inner);
    if (!index) {
      document_.fail(fmt::format("{}.POSITION is missing", inner));
    }
    const Accessor positions = reader_.read(*index);
    check_positions(positions);
    Json packed = {{"mode", mode}, {"attributes", {{"POSITION", add(positions)}}}};
    for (const auto& [name, components] : {std::pair{"NORMAL", 3u}, {"TEXCOORD_0", 2u}}) {
      if (const auto extra = document_.index_in(attributes, name, "accessors", inner)) {
        add_attribute(packed, name, components, reader_.read(*extra), positions.count);
      }
    }
    std::size_t corners = positions.count;
    if (const auto list = document_.index_in(primitive, "indices", "accessors", at)) {
      const Accessor indices = reader_.read(*list);
      check_indices(indices, positions.count);
      packed["indices"] = add(indices);
      corners = indices.count;
    }
    if (mode >= kTriangles && (corners < 3 || (mode == kTriangles && corners % 3 != 0))) {
      document_.fail(fmt::format("{} has {} corners; {} expected", at, corners,
                                 mode == kTriangles ? "a multiple of 3" : "at least 3"));
    }
    return packed;
  }

  void check_positions(const Accessor& positions) const {
    if (positions.component_type != kFloat || positions.components != 3) {
      document_.fail(
          fmt::format("{} holds positions and is of type {} and componentType {}; \"VEC3\" "
                      "and 5126 (float) expected",
                      positions.at, positions.type.dump(), positions.component_type));
    }
    for (std::size_t i = 0; i < positions.count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string defect = defect_of(reader_.value(positions, i, k));
        if (!defect.empty()) {
          document_.fail(fmt::format("{}: vertex {}: {} is {}; a finite number was expected",
                                     positions.at, i, "xyz"[k], defect));
        }
      }
    }
  }

  void check_indices(const Accessor& indices, std::size_t vertices) const {
    const bool is_unsigned = indices.component_type == kUnsignedByte ||
                             indices.component_type == kUnsignedShort ||
                             indices.component_type == kUnsignedInt;
    if (!is_unsigned || indices.components != 1) {
      document_.fail(
          fmt::format("{} holds indices and is of type {} and componentType {}; \"SCALAR\" "
                      "and 5121, 5123 or 5125 expected",
                      indices.at, indices.type.dump(), indices.component_type));
    }
    for (std::size_t i = 0; i < indices.count; ++i) {
      const double index = reader_.value(indices, i, 0);
      if (index >= static_cast<double>(vertices)) {
        document_.fail(fmt::format("{}: index {} refers to vertex {}, but there are only {}",
                                   indices.at, i, index, vertices));
      }
    }
  }

  void add_attribute(Json& packed, const char* name, std::size_t components,
                     const Accessor& accessor, std::size_t vertices) {
    if (accessor.count != vertices) {
      document_.fail(fmt::format("{} holds {} of {} vertices; {} expected", accessor.at, name,
                                 accessor.count, vertices));
    }
    if (accessor.component_type == kFloat && accessor.components == components) {
      packed["attributes"][name] = add(accessor);
    }
  }

  // Adds the accessor with a view of its own and yields its index.
  std::size_t add(const Accessor& a) {
    Json& views = packed_["bufferViews"];
    Json& accessors = packed_["accessors"];
    Json view = {{"buffer", 0}, {"byteOffset", a.start}, {"byteLength", a.extent()}};
    if (a.stride != a.element_bytes()) {
      view["byteStride"] = a.stride;
    }
    accessors.push_back({{"bufferView", views.size()},
                         {"componentType", a.component_type},
                         {"count", a.count},
                         {"type", a.type}});
    views.push_back(std::move(view));
    return accessors.size() - 1;
  }

  void pack_node(std::size_t node) {
    const std::string at = GltfDocument::place("nodes", node);
    const Json& json = document_.object_of("nodes", node);
    Json packed = Json::object();
    if (const auto mesh = document_.index_in(json, "mesh", "meshes", at)) {
      packed["mesh"] = *mesh;
    }
    const std::vector<std::size_t> children = document_.indices_in(json, "children", "nodes", at);
    if (!children.empty()) {
      packed["children"] = children;
    }
    for (const auto& [name, count] :
         {std::pair{"matrix", 16u}, {"translation", 3u}, {"rotation", 4u}, {"scale", 3u}}) {
      document_.require_numbers(json, name, count, at);
      if (json.contains(name)) {
        packed[name] = json[name];
      }
    }
    packed_["nodes"].push_back(std::move(packed));
  }

  // The nodes of the default scene, or else all that are nobody's child.
  void pack_scene() {
    const std::vector<bool> is_child = mark_children();
    std::vector<std::size_t> roots;
    if (document_.count_of("scenes") > 0) {
      const std::size_t scene =
          document_.index_in(document_.root(), "scene", "scenes", "file").value_or(0);
      const std::string at = GltfDocument::place("scenes", scene);
      roots = document_.indices_in(document_.object_of("scenes", scene), "nodes", "nodes", at);
    } else {
      for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) {
          roots.push_back(i);
        }
      }
    }
    std::vector<bool> seen = is_child;
    for (const std::size_t root : roots) {
      if (seen[root]) {
        document_.fail(fmt::format("{} is a root of the scene and appears a second time",
                                   GltfDocument::place("nodes", root)));
      }
      seen[root] = true;
    }
    check_nesting(roots);
    packed_["scenes"] = Json::array({{{"nodes", roots}}});
    packed_["scene"] = 0;
  }

  // With at most one parent for each node and roots without any, what hangs from a root is a tree.
  std::vector<bool> mark_children() const {
    const Json& nodes = packed_["nodes"];
    std::vector<bool> is_child(nodes.size(), false);
    for (const Json& node : nodes) {
      for (const std::size_t child : node.value("children", std::vector<std::size_t>{})) {
        if (is_child[child]) {
          document_.fail(
              fmt::format("{} is the child of two nodes", GltfDocument::place("nodes", child)));
        }
        is_child[child] = true;
      }
    }
    return is_child;
  }

  void check_nesting(std::vector<std::size_t> level) const {
    for (std::size_t depth = 0; !level.empty(); ++depth) {
      if (depth == kMostNested) {
        document_.fail(fmt::format("nodes are nested more than {} deep", kMostNested));
      }
      std::vector<std::size_t> next;
      for (const std::size_t node : level) {
        const auto children = packed_["nodes"][node].value("children", std::vector<std::size_t>{});
        next.insert(next.end(), children.begin(), children.end());
      }
      level = std::move(next);
    }
  }

  std::string as_binary_file() const {
    std::string json = packed_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t padded = (gltf_.bytes.size() + 3) / 4 * 4;
    const std::size_t total = 12 + 8 + json.size() + 8 + padded;
    if (total > UINT32_MAX) {
      document_.fail("more than 4 GiB of geometry can't be read");
    }
    std::string file;
    file.reserve(total);
    const auto append_word = [&file](std::size_t word) {
      for (int shift = 0; shift < 32; shift += 8) {
        file.push_back(static_cast<char>(word >> shift & 0xff));
      }
    };
    file += "glTF";
    append_word(2);
    append_word(total);
    append_word(json.size());
    file += "JSON";
    file += json;
    append_word(padded);
    file += std::string_view("BIN\0", 4);
    file += gltf_.bytes;
    file.resize(total, '\0');
    return file;
  }

  const Gltf& gltf_;
  const GltfDocument& document_;
  AccessorReader reader_;
  Json packed_;
};

}  // namespace

std::string geometry_of(const Gltf& gltf) { return Packer(gltf).pack(); }

}  // namespace clipscope::experiments
