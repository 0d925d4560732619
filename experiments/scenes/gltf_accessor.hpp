// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accessors of a glTF file: where the elements of an attribute or index list lie, and their values.
#pragma once

#include <cstddef>
#include <string>

#include "experiments/scenes/gltf.hpp"

namespace clipscope::experiments {

// Component types: OpenGL's numbers.
inline constexpr std::size_t kFloat = 5126, kUnsignedByte = 5121, kUnsignedShort = 5123,
                             kUnsignedInt = 5125;

// An accessor whose elements all lie within Gltf::bytes.
struct GltfAccessor {
  std::string at;  // what messages call it
  std::string type;
  std::size_t component_type = 0, component_bytes = 0, components = 0;
  std::size_t count = 0;              // at least 1
  std::size_t start = 0, stride = 0;  // in bytes; start within Gltf::bytes

  std::size_t element_bytes() const { return component_bytes * components; }
  // From the start of the first element to the end of the last.
  std::size_t extent() const { return (count - 1) * stride + element_bytes(); }
};

// Errors: InputError where a part is missing or out of range, and for sparse accessors.
// Pre-condition: index < gltf.document.count_of("accessors").
GltfAccessor read_accessor(const Gltf& gltf, std::size_t index);

// A component as a number. Pre-condition: it is a float or an unsigned whole number.
double component_of(const Gltf& gltf, const GltfAccessor& accessor, std::size_t element,
                    std::size_t component);

}  // namespace clipscope::experiments
