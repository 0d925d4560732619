// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks the geometry of a glTF file and repacks it alone.
//
// Not supported, and said so: sparse accessors, compressed meshes, positions that are not floats.
// Texture coordinates and normals that are not floats are left out.
#include <array>
#include <cstdint>

#include "experiments/scenes/gltf.hpp"
#include "experiments/scenes/mesh_file.hpp"

namespace clipscope::experiments {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostNested = 1000;  // assimp descends recursively
constexpr std::size_t kTriangles = 4, kTriangleFan = 6;

// OpenGL's numbers.
struct ComponentType {
  std::size_t number;
  NumberType type;
};
constexpr std::size_t kFloat = 5126;
constexpr std::array kComponentTypes = {ComponentType{5120, kNumberType<std::int8_t>},
                                        ComponentType{5121, kNumberType<std::uint8_t>},
                                        ComponentType{5122, kNumberType<std::int16_t>},
                                        ComponentType{5123, kNumberType<std::uint16_t>},
                                        ComponentType{5125, kNumberType<std::uint32_t>},
                                        ComponentType{kFloat, kNumberType<float>}};

// Where the elements of an attribute or index list lie, all of them within Gltf::bytes.
class Accessor : public GltfValue {
 public:
  // Errors: InputError where a part is missing or out of range, and for sparse accessors.
  explicit Accessor(const GltfValue& index)
      : GltfValue(index.file()["accessors"].object_at(index.index_into("accessors"))) {
    if ((*this)["sparse"]) fail("is sparse; a plain one expected");
    read_shape();
    place_in_view();
  }

  // Fails because the elements are not of the shape that is expected of what they hold.
  [[noreturn]] void fail_shape(const char* holds, const char* expected) const {
    fail("{}is of type '{}' and componentType {}; {} expected", holds, type_, component_type_,
         expected);
  }

  std::size_t count() const { return count_; }  // at least 1
  bool is_float(std::size_t components) const {
    return component_type_ == kFloat && components_ == components;
  }
  bool is_index() const { return number_.is_integer && !number_.is_signed && components_ == 1; }

  double component(std::size_t element, std::size_t i) const {
    return number_.at(file().bytes, start_ + element * stride_ + i * number_.bytes);
  }

  // Adds the accessor with a view of its own to a document and yields its index.
  std::size_t add_to(Json& document) const {
    Json& views = document["bufferViews"];
    Json& accessors = document["accessors"];
    Json view = {{"buffer", 0}, {"byteOffset", start_}, {"byteLength", extent()}};
    if (stride_ != element_bytes()) view["byteStride"] = stride_;
    accessors.push_back({{"bufferView", views.size()},
                         {"componentType", component_type_},
                         {"count", count_},
                         {"type", type_}});
    views.push_back(std::move(view));
    return accessors.size() - 1;
  }

 private:
  void read_shape() {
    const GltfValue type = (*this)["type"];
    if (type && type->is_string()) type_ = type->get<std::string>();
    component_type_ = (*this)["componentType"].number();
    for (const auto& [number, number_type] : kComponentTypes) {
      if (number == component_type_) number_ = number_type;
    }
    for (const auto& [name, components] :
         {std::pair{"SCALAR", 1u}, {"VEC2", 2u}, {"VEC3", 3u}, {"VEC4", 4u}}) {
      if (type_ == name) components_ = components;
    }
    if (element_bytes() == 0) {
      fail_shape("", "SCALAR, VEC2, VEC3 or VEC4 and 5120 to 5123, 5125 or 5126");
    }
    count_ = (*this)["count"].number();
    if (count_ == 0) (*this)["count"].fail("is 0; at least 1 expected");
  }

  void place_in_view() {
    const GltfValue views = file()["bufferViews"], buffers = file()["buffers"];
    const GltfValue view = views.object_at((*this)["bufferView"].index_into("bufferViews"));
    const std::size_t buffer = view["buffer"].index_into("buffers");
    const std::size_t offset = view["byteOffset"].number(0), length = view["byteLength"].number();
    const std::size_t available = file().buffer_start[buffer + 1] - file().buffer_start[buffer];
    if (offset + length > available) {
      view.fail("ends at byte {} of buffers[{}], which has {} bytes", offset + length, buffer,
                available);
    }
    stride_ = view["byteStride"].number(element_bytes());
    if (stride_ < element_bytes() || stride_ > 252) {
      view["byteStride"].fail("is {}; {} to 252 expected", stride_, element_bytes());
    }
    const std::size_t inner = (*this)["byteOffset"].number(0);
    if (inner + extent() > length) {
      fail("ends at byte {} of {}, which has {} bytes", inner + extent(), view.place(), length);
    }
    start_ = file().buffer_start[buffer] + offset + inner;
  }

  std::size_t element_bytes() const { return number_.bytes * components_; }
  // From the start of the first element to the end of the last.
  std::size_t extent() const { return (count_ - 1) * stride_ + element_bytes(); }

  std::string type_;
  std::size_t component_type_ = 0, components_ = 0, count_ = 0;
  NumberType number_ = {};
  std::size_t start_ = 0, stride_ = 0;  // in bytes; start within Gltf::bytes
};

// Builds the file that holds the geometry alone.
class Packer {
 public:
  explicit Packer(const Gltf& gltf) : gltf_(gltf) {}

  std::string pack() {
    check_asset();
    packed_["asset"]["version"] = "2.0";
    packed_["buffers"] = Json::array({{{"byteLength", gltf_.bytes.size()}}});
    for (const char* list : {"accessors", "bufferViews", "meshes", "nodes"}) {
      packed_[list] = Json::array();
    }
    const GltfValue meshes = gltf_["meshes"], nodes = gltf_["nodes"];
    for (std::size_t i = 0; i < meshes.size(); ++i) pack_mesh(meshes.object_at(i));
    for (std::size_t i = 0; i < nodes.size(); ++i) pack_node(nodes.object_at(i));
    pack_scene();
    return as_binary_file();
  }

 private:
  void check_asset() const {
    const GltfValue version = gltf_["asset"]["version"];
    const Json found = version ? *version : Json();
    if (!found.is_string() || !found.get_ref<const std::string&>().starts_with("2.")) {
      version.fail("is {}; \"2.0\" expected", found.dump());
    }
    const GltfValue required = gltf_["extensionsRequired"];
    if (!required) return;
    for (const Json& extension : *required) {
      if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression") {
        refuse(gltf_.name, "the meshes are compressed ({}); plain ones expected", extension.dump());
      }
    }
  }

  void pack_mesh(const GltfValue& mesh) {
    const GltfValue primitives = mesh["primitives"];
    if (!primitives || !primitives->is_array() || primitives->empty()) {
      primitives.fail("is missing or empty");
    }
    Json packed = Json::array();
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      packed.push_back(pack_primitive(primitives.object_at(i)));
    }
    packed_["meshes"].push_back({{"primitives", packed}});
  }

  Json pack_primitive(const GltfValue& primitive) {
    const std::size_t mode = primitive["mode"].number(kTriangles);
    if (mode > kTriangleFan) primitive["mode"].fail("is {}; 0 to 6 expected", mode);
    const GltfValue attributes = primitive["attributes"];
    const Accessor positions(attributes["POSITION"]);
    check_positions(positions);
    Json packed = {{"mode", mode}, {"attributes", {{"POSITION", positions.add_to(packed_)}}}};
    for (const auto& [name, components] : {std::pair{"NORMAL", 3u}, {"TEXCOORD_0", 2u}}) {
      const GltfValue attribute = attributes[name];
      if (!attribute) continue;
      const Accessor values(attribute);
      if (values.count() != positions.count()) {
        values.fail("holds {} of {} vertices; {} expected", name, values.count(),
                    positions.count());
      }
      if (values.is_float(components)) packed["attributes"][name] = values.add_to(packed_);
    }
    std::size_t corners = positions.count();
    if (primitive["indices"]) {
      const Accessor indices(primitive["indices"]);
      check_indices(indices, positions.count());
      packed["indices"] = indices.add_to(packed_);
      corners = indices.count();
    }
    if (mode >= kTriangles && (corners < 3 || (mode == kTriangles && corners % 3 != 0))) {
      primitive.fail("has {} corners; {} expected", corners,
                     mode == kTriangles ? "a multiple of 3" : "at least 3");
    }
    return packed;
  }

  void check_positions(const Accessor& positions) const {
    if (!positions.is_float(3)) {
      positions.fail_shape("holds positions and ", "VEC3 and 5126 (float)");
    }
    for (std::size_t i = 0; i < positions.count(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        require_finite(positions.component(i, k), [&] {
          return fmt::format("{}: {}: vertex {}: {}", gltf_.name, positions.place(), i, "xyz"[k]);
        });
      }
    }
  }

  void check_indices(const Accessor& indices, std::size_t vertices) const {
    if (!indices.is_index()) {
      indices.fail_shape("holds indices and ", "SCALAR and 5121, 5123 or 5125");
    }
    for (std::size_t i = 0; i < indices.count(); ++i) {
      const double index = indices.component(i, 0);
      if (index < static_cast<double>(vertices)) continue;
      refuse(gltf_.name, "{}: index {} refers to vertex {}, but there are only {}", indices.place(),
             i, index, vertices);
    }
  }

  void pack_node(const GltfValue& node) {
    Json packed = Json::object();
    if (const GltfValue mesh = node["mesh"]) packed["mesh"] = mesh.index_into("meshes");
    const auto& children = children_.emplace_back(node["children"].indices_into("nodes"));
    if (!children.empty()) packed["children"] = children;
    for (const auto& [name, count] :
         {std::pair{"matrix", 16u}, {"translation", 3u}, {"rotation", 4u}, {"scale", 3u}}) {
      const GltfValue numbers = node[name];
      if (numbers) packed[name] = numbers.numbers(count);
    }
    packed_["nodes"].push_back(std::move(packed));
  }

  // The nodes of the default scene, or else all that are nobody's child.
  void pack_scene() {
    std::vector<bool> seen = mark_children();
    std::vector<std::size_t> roots;
    const GltfValue scenes = gltf_["scenes"], scene = gltf_["scene"];
    if (scenes.size() > 0) {
      const std::size_t shown = scene ? scene.index_into("scenes") : 0;
      roots = scenes.object_at(shown)["nodes"].indices_into("nodes");
    } else {
      for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i]) roots.push_back(i);
      }
    }
    for (const std::size_t root : roots) {
      if (seen[root]) {
        refuse(gltf_.name, "nodes[{}] is a root of the scene and appears a second time", root);
      }
      seen[root] = true;
    }
    check_nesting(roots);
    packed_["scenes"] = Json::array({{{"nodes", roots}}});
    packed_["scene"] = 0;
  }

  // With at most one parent for each node and roots without any, what hangs from a root is a tree.
  std::vector<bool> mark_children() const {
    std::vector<bool> is_child(children_.size(), false);
    for (std::size_t node = 0; node < is_child.size(); ++node) {
      for (const std::size_t child : children_[node]) {
        if (is_child[child]) refuse(gltf_.name, "nodes[{}] is the child of two nodes", child);
        is_child[child] = true;
      }
    }
    return is_child;
  }

  void check_nesting(std::vector<std::size_t> level) const {
    for (std::size_t depth = 0; !level.empty(); ++depth) {
      if (depth == kMostNested) {
        refuse(gltf_.name, "nodes are nested more than {} deep", kMostNested);
      }
      std::vector<std::size_t> next;
      for (const std::size_t node : level) {
        next.insert(next.end(), children_[node].begin(), children_[node].end());
      }
      level = std::move(next);
    }
  }

  std::string as_binary_file() const {
    std::string json = packed_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t padded = (gltf_.bytes.size() + 3) / 4 * 4;
    const std::size_t total = 12 + 8 + json.size() + 8 + padded;
    if (total > UINT32_MAX) refuse(gltf_.name, "more than 4 GiB of geometry can't be read");
    std::string file;
    file.reserve(total);
    const auto append_word = [&](std::size_t word) {
      append_value(file, static_cast<std::uint32_t>(word));
    };
    file += "glTF";
    append_word(2);
    append_word(total);
    append_word(json.size());
    file += "JSON" + json;
    append_word(padded);
    file += std::string_view("BIN\0", 4);
    file += gltf_.bytes;
    file.resize(total, '\0');
    return file;
  }

  const Gltf& gltf_;
  Json packed_;
  std::vector<std::vector<std::size_t>> children_ = {};  // of each node
};

}  // namespace

std::string geometry_of_gltf(const std::string& name, std::string content) {
  return Packer(read_gltf(name, content)).pack();
}

}  // namespace clipscope::experiments
