// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks the geometry of a glTF file and repacks it alone.
//
// Not supported, and said so: sparse accessors, compressed meshes, positions that are not floats.
// Texture coordinates and normals that are not floats are left out.
#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/scenes/gltf.hpp"
#include "experiments/scenes/gltf_accessor.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

using Json = GltfDocument::Json;

constexpr std::size_t kMostNested = 1000;  // assimp descends recursively
constexpr std::size_t kTriangles = 4, kTriangleFan = 6;

// Builds the file that holds the geometry alone.
class Packer {
 public:
  explicit Packer(const Gltf& gltf) : gltf_(gltf), document_(gltf.document) {}

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
    const GltfAccessor positions = read_accessor(
        gltf_, document_.required_index_in(attributes, "POSITION", "accessors", inner));
    check_positions(positions);
    Json packed = {{"mode", mode}, {"attributes", {{"POSITION", add(positions)}}}};
    for (const auto& [name, components] : {std::pair{"NORMAL", 3u}, {"TEXCOORD_0", 2u}}) {
      if (const auto extra = document_.index_in(attributes, name, "accessors", inner)) {
        add_attribute(packed, name, components, read_accessor(gltf_, *extra), positions.count);
      }
    }
    std::size_t corners = positions.count;
    if (const auto list = document_.index_in(primitive, "indices", "accessors", at)) {
      const GltfAccessor indices = read_accessor(gltf_, *list);
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

  void check_positions(const GltfAccessor& positions) const {
    if (positions.component_type != kFloat || positions.components != 3) {
      document_.fail(
          fmt::format("{} holds positions and is of type '{}' and componentType {}; VEC3 "
                      "and 5126 (float) expected",
                      positions.at, positions.type, positions.component_type));
    }
    for (std::size_t i = 0; i < positions.count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string defect = defect_of(component_of(gltf_, positions, i, k));
        if (!defect.empty()) {
          document_.fail(fmt::format("{}: vertex {}: {} is {}; a finite number was expected",
                                     positions.at, i, "xyz"[k], defect));
        }
      }
    }
  }

  void check_indices(const GltfAccessor& indices, std::size_t vertices) const {
    const bool is_unsigned = indices.component_type == kUnsignedByte ||
                             indices.component_type == kUnsignedShort ||
                             indices.component_type == kUnsignedInt;
    if (!is_unsigned || indices.components != 1) {
      document_.fail(
          fmt::format("{} holds indices and is of type '{}' and componentType {}; SCALAR "
                      "and 5121, 5123 or 5125 expected",
                      indices.at, indices.type, indices.component_type));
    }
    for (std::size_t i = 0; i < indices.count; ++i) {
      const double index = component_of(gltf_, indices, i, 0);
      if (index >= static_cast<double>(vertices)) {
        document_.fail(fmt::format("{}: index {} refers to vertex {}, but there are only {}",
                                   indices.at, i, index, vertices));
      }
    }
  }

  void add_attribute(Json& packed, const char* name, std::size_t components,
                     const GltfAccessor& accessor, std::size_t vertices) {
    if (accessor.count != vertices) {
      document_.fail(fmt::format("{} holds {} of {} vertices; {} expected", accessor.at, name,
                                 accessor.count, vertices));
    }
    if (accessor.component_type == kFloat && accessor.components == components) {
      packed["attributes"][name] = add(accessor);
    }
  }

  // Adds the accessor with a view of its own and yields its index.
  std::size_t add(const GltfAccessor& a) {
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
  Json packed_;
};

}  // namespace

std::string geometry_of(const Gltf& gltf) { return Packer(gltf).pack(); }

}  // namespace clipscope::experiments
