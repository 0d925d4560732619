// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/gltf_accessor.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <cstring>
#include <utility>

namespace clipscope::experiments {
namespace {

using Json = GltfDocument::Json;

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

std::size_t components_of(const std::string& type) {
  for (const auto& [name, components] :
       {std::pair{"SCALAR", 1u}, {"VEC2", 2u}, {"VEC3", 3u}, {"VEC4", 4u}}) {
    if (type == name) {
      return components;
    }
  }
  return 0;
}

void read_shape(const GltfDocument& document, const Json& json, GltfAccessor& a) {
  const auto type = json.find("type");
  a.type = type != json.end() && type->is_string() ? type->get<std::string>() : "";
  a.component_type = document.size_in(json, "componentType", a.at);
  a.component_bytes = bytes_of(a.component_type);
  a.components = components_of(a.type);
  if (a.element_bytes() == 0) {
    document.fail(
        fmt::format("{} is of type '{}' and componentType {}; SCALAR, VEC2, VEC3 or VEC4 and "
                    "5120 to 5123, 5125 or 5126 expected",
                    a.at, a.type, a.component_type));
  }
  a.count = document.size_in(json, "count", a.at);
  if (a.count == 0) {
    document.fail(fmt::format("{}.count is 0; at least 1 expected", a.at));
  }
}

void place_in_view(const Gltf& gltf, const Json& json, GltfAccessor& a) {
  const GltfDocument& document = gltf.document;
  const std::size_t index = document.required_index_in(json, "bufferView", "bufferViews", a.at);
  const std::string at = GltfDocument::place("bufferViews", index);
  const Json& view = document.object_of("bufferViews", index);
  const std::size_t buffer = document.required_index_in(view, "buffer", "buffers", at);
  const std::size_t offset = document.size_in(view, "byteOffset", at, 0);
  const std::size_t length = document.size_in(view, "byteLength", at);
  const std::size_t available = gltf.buffer_start[buffer + 1] - gltf.buffer_start[buffer];
  if (offset + length > available) {
    document.fail(fmt::format("{} ends at byte {} of {}, which has {} bytes", at, offset + length,
                              GltfDocument::place("buffers", buffer), available));
  }
  a.stride = document.size_in(view, "byteStride", at, a.element_bytes());
  if (a.stride < a.element_bytes() || a.stride > 252) {
    document.fail(
        fmt::format("{}.byteStride is {}; {} to 252 expected", at, a.stride, a.element_bytes()));
  }
  const std::size_t inner = document.size_in(json, "byteOffset", a.at, 0);
  if (inner + a.extent() > length) {
    document.fail(fmt::format("{} ends at byte {} of {}, which has {} bytes", a.at,
                              inner + a.extent(), at, length));
  }
  a.start = gltf.buffer_start[buffer] + offset + inner;
}

template <class T>
T read_as(const char* source) {
  T value;
  std::memcpy(&value, source, sizeof value);
  return value;
}

}  // namespace

GltfAccessor read_accessor(const Gltf& gltf, std::size_t index) {
  GltfAccessor a;
  a.at = GltfDocument::place("accessors", index);
  const Json& json = gltf.document.object_of("accessors", index);
  if (json.contains("sparse")) {
    gltf.document.fail(fmt::format("{} is sparse; a plain one expected", a.at));
  }
  read_shape(gltf.document, json, a);
  place_in_view(gltf, json, a);
  return a;
}

double component_of(const Gltf& gltf, const GltfAccessor& a, std::size_t element,
                    std::size_t component) {
  const char* source =
      gltf.bytes.data() + a.start + element * a.stride + component * a.component_bytes;
  switch (a.component_type) {
    case kFloat: return read_as<float>(source);
    case kUnsignedByte: return read_as<std::uint8_t>(source);
    case kUnsignedShort: return read_as<std::uint16_t>(source);
    default: return read_as<std::uint32_t>(source);
  }
}

}  // namespace clipscope::experiments
