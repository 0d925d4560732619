// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of a glTF file's accessors: dense, sparse or all zeros, of any component type,
// normalised or not.
//
// Source: Khronos Group, "glTF 2.0 Specification", 2021, sections 3.6.2 and 3.11.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/scenes/gltf.hpp"

namespace clipscope::experiments {

class GltfAccessor : public GltfValue {
 public:
  // The accessor that an index refers to. Errors: InputError where a part is missing or out of
  // range. The file must outlive this.
  explicit GltfAccessor(const GltfValue& index);

  // Fails because the elements are not of the shape that is expected of what they hold.
  [[noreturn]] void fail_shape(const char* holds, const char* expected) const {
    fail("{}is of type '{}' and componentType {}{}; {} expected", holds, type_, component_type_,
         is_normalized_ ? ", normalized" : "", expected);
  }

  std::size_t count() const { return count_; }  // at least 1
  std::size_t components() const { return components_; }
  std::size_t component_type() const { return component_type_; }  // OpenGL's number
  bool is_float() const;
  bool is_normalized() const { return is_normalized_; }

  // Exactly for plain numbers; a normalised one is the fraction that it means, in [-1, 1] or
  // [0, 1], rounded once to double.
  double component(std::size_t element, std::size_t i) const;

 private:
  // Elements in bytes; no stride and no bytes: all are zero.
  struct Elements {
    std::string_view bytes;
    std::size_t stride = 0;

    double at(const NumberType& type, std::size_t element, std::size_t i) const {
      return type.at(bytes, element * stride + i * type.bytes);
    }
  };

  void read_shape();
  // The bytes of `count` elements of `size` bytes, from `offset` on within the buffer view.
  Elements elements_in(const GltfValue& owner, std::size_t count, std::size_t size,
                       bool may_have_stride) const;
  void read_sparse(const GltfValue& sparse);

  std::string type_;
  std::size_t component_type_ = 0, components_ = 0, count_ = 0;
  bool is_normalized_ = false;
  NumberType number_ = {};
  Elements elements_;
  // The elements that are replaced, rising, and by what.
  std::vector<std::size_t> replaced_;
  Elements replacements_;
};

}  // namespace clipscope::experiments
