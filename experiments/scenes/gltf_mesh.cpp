// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the meshes of glTF files, each as often as a shown node has it.
//
// Sources: Khronos Group, "glTF 2.0 Specification", 2021; the extensions KHR_mesh_quantization and
// EXT_mesh_gpu_instancing.
//
// Not supported, and said so: compressed meshes, and other extensions that a file requires and that
// may change its geometry. Skins and morph targets are left out: a mesh is read in its base shape.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>

#include "experiments/scenes/gltf_accessor.hpp"
#include "experiments/scenes/gltf_nodes.hpp"
#include "experiments/scenes/mesh_builder.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kQuantization = "KHR_mesh_quantization";

// Extensions of meshes that may be required, since they are read; and beginnings of the names of
// those that change materials, pictures, lights or notes, but no geometry.
constexpr std::string_view kRead[] = {kQuantization, "EXT_mesh_gpu_instancing"};
constexpr std::string_view kElsewhere[] = {
    "KHR_materials_",   "KHR_texture_",     "EXT_texture_",
    "MSFT_texture_",    "KHR_lights_",      "EXT_lights_",
    "KHR_xmp",          "KHR_audio",        "KHR_animation_",
    "MSFT_packing_",    "ADOBE_materials_", "FB_material_",
    "NV_materials_",    "AGI_stk_metadata", "EXT_structural_metadata",
    "EXT_mesh_features"};

enum Mode : std::size_t { kTriangles = 4, kStrip = 5, kFan = 6 };

bool lists(const GltfValue& names, std::string_view name) {
  return names && names->is_array() && std::ranges::count(*names, GltfValue::Json(name)) > 0;
}

void check_extensions(const Gltf& gltf) {
  const GltfValue required = gltf["extensionsRequired"];
  for (std::size_t i = 0; i < required.size(); ++i) {
    const GltfValue::Json& json = (*required)[i];
    if (!json.is_string()) required.fail("holds {}; names expected", json_text(json));
    const std::string& name = json.get_ref<const std::string&>();
    if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression" ||
        name == "KHR_meshopt_compression") {
      refuse(gltf.name, "the meshes are compressed ({}); plain ones expected", name);
    }
    const auto begins = [&](std::string_view start) { return name.starts_with(start); };
    if (std::ranges::find(kRead, name) != std::end(kRead)) continue;
    if (std::ranges::any_of(kElsewhere, begins)) continue;
    required.fail("holds {}, which is not known; it may change the geometry", name);
  }
}

void check_asset(const Gltf& gltf) {
  const GltfValue version = gltf["asset"]["version"];
  const GltfValue::Json found = version ? *version : GltfValue::Json();
  if (!found.is_string() || !found.get_ref<const std::string&>().starts_with("2.")) {
    version.fail("is {}; \"2.0\" expected", json_text(found));
  }
  check_extensions(gltf);
}

class GltfMeshes {
 public:
  explicit GltfMeshes(const Gltf& gltf)
      : gltf_(gltf),
        builder_(gltf.name),
        is_quantized_(lists(gltf["extensionsUsed"], kQuantization) ||
                      lists(gltf["extensionsRequired"], kQuantization)) {}

  Mesh read() {
    for (const auto& [index, world_from_node] : shown_nodes(gltf_)) {
      const GltfValue node = gltf_["nodes"].object_at(index);
      if (!node["mesh"]) continue;
      const GltfValue mesh = gltf_["meshes"].object_at(node["mesh"].index_into("meshes"));
      for (const glm::dmat4& instance : instances_of(node)) {
        add_mesh(mesh, world_from_node * instance);
      }
    }
    return builder_.finish(
        [this](std::size_t vertex, VertexValue what) { return place_of(vertex, what); });
  }

 private:
  // Where the vertices of a part begin, and what to call them.
  struct Part {
    std::size_t first;
    std::string place;
  };

  // Where copies of the node's mesh stand within the node.
  std::vector<glm::dmat4> instances_of(const GltfValue& node) const {
    const GltfValue instancing = node["extensions"]["EXT_mesh_gpu_instancing"];
    if (!instancing) return {glm::dmat4(1.0)};
    const GltfValue attributes = instancing["attributes"];
    std::vector<glm::dmat4> instances;
    const auto read = [&](const char* name, std::size_t components, const auto& apply) {
      if (!attributes[name]) return;
      const GltfAccessor values(attributes[name]);
      if (values.components() != components) {
        values.fail_shape("places instances and ", components == 3 ? "VEC3" : "VEC4");
      }
      instances.resize(std::max(instances.size(), values.count()), glm::dmat4(1.0));
      if (instances.size() != values.count()) {
        values.fail("has {} of {} instances", values.count(), instances.size());
      }
      for (std::size_t i = 0; i < values.count(); ++i) {
        glm::dvec4 v(0);
        for (std::size_t k = 0; k < components; ++k) v[int(k)] = values.component(i, k);
        apply(instances[i], v);
      }
    };
    // In this order the product is translation * rotation * scale.
    read("ROTATION", 4, [&](glm::dmat4& m, const glm::dvec4& q) {
      if (q == glm::dvec4(0)) attributes["ROTATION"].fail("holds a rotation of length 0");
      m = rotation_matrix(q);
    });
    read("SCALE", 3, [](glm::dmat4& m, const glm::dvec4& s) {
      for (int k = 0; k < 3; ++k) m[k] *= s[k];
    });
    read("TRANSLATION", 3,
         [](glm::dmat4& m, const glm::dvec4& t) { m[3] = glm::dvec4(t.x, t.y, t.z, 1); });
    if (instances.empty()) instancing.fail("has no instance (TRANSLATION, ROTATION or SCALE)");
    return instances;
  }

  void add_mesh(const GltfValue& mesh, const glm::dmat4& world_from_mesh) {
    const GltfValue primitives = mesh["primitives"];
    if (!primitives || !primitives->is_array() || primitives->empty()) {
      primitives.fail("is missing or empty");
    }
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const GltfValue primitive = primitives.object_at(i);
      const std::size_t mode = primitive["mode"].number(kTriangles);
      if (mode > kFan) primitive["mode"].fail("is {}; 0 to 6 expected", mode);
      if (primitive["extensions"]["KHR_draco_mesh_compression"]) {
        primitive.fail("is compressed (KHR_draco_mesh_compression); a plain one expected");
      }
      if (mode >= kTriangles) add_primitive(primitive, mode, world_from_mesh);
    }
  }

  void add_primitive(const GltfValue& primitive, std::size_t mode,
                     const glm::dmat4& world_from_mesh) {
    const GltfValue attributes = primitive["attributes"];
    const GltfAccessor positions(attributes["POSITION"]);
    require_shape(positions, "holds positions and ", "VEC3 and 5126 (float)", 3, false);
    const std::size_t first = builder_.vertices();
    parts_.push_back({first, positions.place()});
    add_positions(positions, world_from_mesh);
    add_texture(attributes["TEXCOORD_0"], first, positions.count());
    add_normals(attributes["NORMAL"], first, positions.count());
    const bool is_mirrored = glm::determinant(glm::dmat3(world_from_mesh)) < 0;
    add_triangles(primitive, mode, first, positions.count(), is_mirrored);
  }

  // Floats, or with KHR_mesh_quantization integers of 8 or 16 bits, normalized where they must be.
  void require_shape(const GltfAccessor& values, const char* holds, const char* expected,
                     std::size_t components, bool must_be_normalized) const {
    const std::size_t type = values.component_type();
    const bool is_small = 5120 <= type && type <= 5123;
    if (values.components() == components && is_small && !is_quantized_) {
      values.fail("{}is quantized; {}, or {} among extensionsRequired expected", holds, expected,
                  kQuantization);
    }
    const bool is_quantized = is_small && (values.is_normalized() || !must_be_normalized);
    if (values.components() == components && (values.is_float() || is_quantized)) return;
    values.fail_shape(holds, expected);
  }

  void add_positions(const GltfAccessor& positions, const glm::dmat4& world_from_mesh) {
    builder_.reserve(positions.count(), 0);
    const bool is_moved = world_from_mesh != glm::dmat4(1.0);
    for (std::size_t i = 0; i < positions.count(); ++i) {
      const glm::dvec3 p(positions.component(i, 0), positions.component(i, 1),
                         positions.component(i, 2));
      // What is not finite stays, since moving it would spread it over all coordinates.
      const bool moves = is_moved && std::isfinite(p.x + p.y + p.z);
      const glm::dvec3 q = moves ? glm::dvec3(world_from_mesh * glm::dvec4(p, 1.0)) : p;
      builder_.add_vertex({q.x, q.y, q.z});
    }
  }

  void add_texture(const GltfValue& index, std::size_t first, std::size_t vertices) {
    if (!index) return;
    const GltfAccessor values(index);
    require_count(values, "TEXCOORD_0", vertices);
    const bool is_unsigned = values.component_type() == 5121 || values.component_type() == 5123;
    const bool is_plain = values.components() == 2 && is_unsigned && values.is_normalized();
    if (!is_plain) {
      require_shape(values, "holds texture coordinates and ",
                    "VEC2 and 5126 (float), or normalized 5121 or 5123", 2, false);
    }
    for (std::size_t i = 0; i < vertices; ++i) {
      builder_.set_texture(first + i, values.component(i, 0), values.component(i, 1));
    }
  }

  void add_normals(const GltfValue& index, std::size_t first, std::size_t vertices) {
    if (!index) return;
    const GltfAccessor values(index);
    require_count(values, "NORMAL", vertices);
    require_shape(values, "holds normals and ", "VEC3 and 5126 (float)", 3, true);
    for (std::size_t i = 0; i < vertices; ++i) {
      builder_.set_normal(first + i,
                          {values.component(i, 0), values.component(i, 1), values.component(i, 2)});
    }
  }

  static void require_count(const GltfAccessor& values, const char* name, std::size_t vertices) {
    if (values.count() == vertices) return;
    values.fail("holds {} of {} vertices; {} expected", name, values.count(), vertices);
  }

  // The corners of a primitive as vertices of the builder.
  class Corners {
   public:
    Corners(const GltfValue& primitive, std::size_t first, std::size_t vertices)
        : first_(first), vertices_(vertices) {
      if (!primitive["indices"]) return;
      indices_.emplace(primitive["indices"]);
      const std::size_t type = indices_->component_type();
      if (indices_->components() != 1 || (type != 5121 && type != 5123 && type != 5125)) {
        indices_->fail_shape("holds indices and ", "SCALAR and 5121, 5123 or 5125");
      }
    }

    std::size_t size() const { return indices_ ? indices_->count() : vertices_; }

    std::uint32_t operator[](std::size_t i) const {
      const auto index = indices_ ? static_cast<std::size_t>(indices_->component(i, 0)) : i;
      if (index >= vertices_) {
        refuse(indices_->file().name, "{}: index {} refers to vertex {}, but there are only {}",
               indices_->place(), i, index, vertices_);
      }
      return static_cast<std::uint32_t>(first_ + index);
    }

   private:
    std::size_t first_, vertices_;
    std::optional<GltfAccessor> indices_;
  };

  // A transform that mirrors turns triangles round, so that their front stays in front.
  void add_triangles(const GltfValue& primitive, std::size_t mode, std::size_t first,
                     std::size_t vertices, bool is_mirrored) {
    if (builder_.vertices() > UINT32_MAX) {
      refuse(gltf_.name, "{} vertices are too many; fewer than 2^32 expected", builder_.vertices());
    }
    const Corners corners(primitive, first, vertices);
    const std::size_t count = corners.size();
    if (count < 3 || (mode == kTriangles && count % 3 != 0)) {
      primitive.fail("has {} corners; {} expected", count,
                     mode == kTriangles ? "a multiple of 3" : "at least 3");
    }
    builder_.reserve(0, mode == kTriangles ? count / 3 : count - 2);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (is_mirrored) std::swap(b, c);
      builder_.add_triangle(a, b, c);
    };
    if (mode == kStrip) return add_strip(corners, add);
    for (std::size_t i = 2; i < count; i += mode == kFan ? 1 : 3) {
      add(corners[mode == kFan ? 0 : i - 2], corners[i - 1], corners[i]);
    }
  }

  std::string place_of(std::size_t vertex, VertexValue what) const {
    const auto after = std::ranges::upper_bound(parts_, vertex, {}, &Part::first);
    const Part& part = *(after - 1);
    return fmt::format("{}: {}: vertex {}: {}", gltf_.name, part.place, vertex - part.first,
                       to_string(what));
  }

  const Gltf& gltf_;
  MeshBuilder builder_;
  bool is_quantized_;
  std::vector<Part> parts_;
};

}  // namespace

Mesh read_gltf_mesh(const std::string& name, std::string_view content) {
  const Gltf gltf = read_gltf(name, content);
  check_asset(gltf);
  return GltfMeshes(gltf).read();
}

}  // namespace clipscope::experiments
