// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/gltf_accessor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace clipscope::experiments {
namespace {

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

// An accessor without bytes costs a file nothing; beyond this many elements it is a mistake.
constexpr std::size_t kMostZeros = std::size_t{1} << 28;

NumberType number_type(const GltfValue& component_type) {
  const std::size_t number = component_type.number();
  const auto found = std::ranges::find(kComponentTypes, number, &ComponentType::number);
  return found == kComponentTypes.end() ? NumberType{} : found->type;
}

}  // namespace

GltfAccessor::GltfAccessor(const GltfValue& index)
    : GltfValue(index.file()["accessors"].object_at(index.index_into("accessors"))) {
  read_shape();
  const GltfValue sparse = (*this)["sparse"];
  if ((*this)["bufferView"]) {
    elements_ = elements_in(*this, count_, number_.bytes * components_, true);
  } else if (count_ > kMostZeros) {
    fail("has no bufferView and a count of {}; at most {} zeros expected", count_, kMostZeros);
  }
  if (sparse) read_sparse(sparse);
}

bool GltfAccessor::is_float() const { return component_type_ == kFloat; }

double GltfAccessor::component(std::size_t element, std::size_t i) const {
  const Elements* from = &elements_;
  if (!replaced_.empty()) {
    const auto found = std::ranges::lower_bound(replaced_, element);
    if (found != replaced_.end() && *found == element) {
      from = &replacements_;
      element = static_cast<std::size_t>(found - replaced_.begin());
    }
  }
  if (from->bytes.empty()) return 0;
  const double value = from->at(number_, element, i);
  if (!is_normalized_) return value;
  const double largest =
      std::ldexp(1.0, static_cast<int>(8 * number_.bytes) - (number_.is_signed ? 1 : 0)) - 1;
  return std::max(value / largest, -1.0);
}

void GltfAccessor::read_shape() {
  const GltfValue type = (*this)["type"], normalized = (*this)["normalized"];
  if (type && type->is_string()) type_ = type->get<std::string>();
  is_normalized_ = normalized && normalized->is_boolean() && normalized->get<bool>();
  component_type_ = (*this)["componentType"].number();
  number_ = number_type((*this)["componentType"]);
  for (const auto& [name, components] :
       {std::pair{"SCALAR", 1u}, {"VEC2", 2u}, {"VEC3", 3u}, {"VEC4", 4u}}) {
    if (type_ == name) components_ = components;
  }
  if (number_.bytes * components_ == 0) {
    fail_shape("", "SCALAR, VEC2, VEC3 or VEC4 and 5120 to 5123, 5125 or 5126");
  }
  if (is_normalized_ && (!number_.is_integer || number_.bytes > 2)) {
    fail_shape("", "5120 to 5123 of normalized numbers");
  }
  count_ = (*this)["count"].number();
  if (count_ == 0) (*this)["count"].fail("is 0; at least 1 expected");
}

GltfAccessor::Elements GltfAccessor::elements_in(const GltfValue& owner, std::size_t count,
                                                 std::size_t size, bool may_have_stride) const {
  const GltfValue views = file()["bufferViews"];
  const GltfValue view = views.object_at(owner["bufferView"].index_into("bufferViews"));
  if (view["extensions"]["EXT_meshopt_compression"]) {
    view.fail("is compressed (EXT_meshopt_compression); a plain one expected");
  }
  const std::size_t buffer = view["buffer"].index_into("buffers");
  const std::size_t offset = view["byteOffset"].number(0), length = view["byteLength"].number();
  const std::size_t available = file().buffers[buffer].size();
  if (offset + length > available) {
    view.fail("ends at byte {} of buffers[{}], which has {} bytes", offset + length, buffer,
              available);
  }
  const std::size_t stride = may_have_stride ? view["byteStride"].number(size) : size;
  if (stride < size || stride > 252) {
    view["byteStride"].fail("is {}; {} to 252 expected", stride, size);
  }
  const std::size_t inner = owner["byteOffset"].number(0);
  const std::size_t extent = (count - 1) * stride + size;
  if (inner + extent > length) {
    owner.fail("ends at byte {} of {}, which has {} bytes", inner + extent, view.place(), length);
  }
  return {file().buffers[buffer].substr(offset + inner, extent), stride};
}

void GltfAccessor::read_sparse(const GltfValue& sparse) {
  const std::size_t count = sparse["count"].number();
  if (count == 0 || count > count_) sparse["count"].fail("is {}; 1 to {} expected", count, count_);
  const GltfValue indices = sparse["indices"], values = sparse["values"];
  const NumberType type = number_type(indices["componentType"]);
  if (!type.is_integer || type.is_signed) {
    indices["componentType"].fail("is {}; 5121, 5123 or 5125 expected",
                                  indices["componentType"].number());
  }
  const Elements at = elements_in(indices, count, type.bytes, false);
  for (std::size_t i = 0; i < count; ++i) {
    const auto element = static_cast<std::size_t>(at.at(type, i, 0));
    if (element >= count_ || (i > 0 && element <= replaced_.back())) {
      indices.fail("has the element {} at place {}; rising numbers below {} expected", element, i,
                   count_);
    }
    replaced_.push_back(element);
  }
  replacements_ = elements_in(values, count, number_.bytes * components_, false);
}

}  // namespace clipscope::experiments
