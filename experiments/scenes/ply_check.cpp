// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of PLY files, text and binary of both byte orders.
//
// Source: Turk, "The PLY Polygon File Format", 1994.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

#include "experiments/errors.hpp"
#include "experiments/scenes/mesh_checks.hpp"
#include "experiments/scenes/ply_header.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

// What both encodings check of a value, once read: an empty text if it is sound.
struct Rules {
  const PlyHeader& header;
  long long vertices;

  explicit Rules(const PlyHeader& h)
      : header(h), vertices(std::ranges::find(h.elements, "vertex", &PlyElement::name)->count) {}

  std::string defect(const PlyElement& element, const PlyProperty& property, double value) const {
    if (element.name == "vertex" && !property.count && !is_integer(property.value)) {
      const std::string found = defect_of(value);
      return found.empty()
                 ? found
                 : fmt::format("{} is {}; a finite number was expected", property.name, found);
    }
    if (element.name == "face" && property.is_vertex_index_list() &&
        !(0 <= value && value < static_cast<double>(vertices))) {
      return fmt::format("refers to vertex {}, but there are only {} (0 to {})", value, vertices,
                         vertices - 1);
    }
    return {};
  }

  std::string count_defect(const PlyElement& element, const PlyProperty& property,
                           double count) const {
    if (element.name == "face" && property.is_vertex_index_list() && count < 3) {
      return fmt::format("has {}; at least 3 expected",
                         counted(static_cast<long long>(count), "vertex", "vertices"));
    }
    return count < 0 ? fmt::format("has a list of {} values", count) : std::string{};
  }
};

// One line per element.
class TextBody {
 public:
  TextBody(TextFile& file, const PlyHeader& header) : file_(file), rules_(header) {}

  void check() {
    for (const PlyElement& element : rules_.header.elements) {
      for (long long i = 0; i < element.count; ++i) {
        if (!file_.next_words()) {
          file_.fail(fmt::format("the file ends after {} of {} elements '{}'", i, element.count,
                                 element.name));
        }
        check_element(element, i);
      }
    }
    if (file_.next_words()) {
      file_.fail("the file goes on after the last element that its header announces");
    }
  }

 private:
  void check_element(const PlyElement& element, long long index) {
    next_ = 0;
    for (const PlyProperty& property : element.properties) {
      long long count = 1;
      if (property.count) {
        const double n = next_value(element, index, property);
        require(element, index, rules_.count_defect(element, property, n));
        count = static_cast<long long>(n);
      }
      for (long long i = 0; i < count; ++i) {
        const double value = next_value(element, index, property);
        require(element, index, rules_.defect(element, property, value));
      }
    }
    if (next_ != file_.words().size()) {
      file_.fail(fmt::format("{} {} has {} values; {} expected", element.name, index,
                             file_.words().size(), next_));
    }
  }

  double next_value(const PlyElement& element, long long index, const PlyProperty& property) {
    if (next_ == file_.words().size()) {
      file_.fail(fmt::format("{} {} has too few values: {} is missing", element.name, index,
                             property.name));
    }
    const std::string_view word = file_.word(next_++);
    const std::optional<double> value = to_number(word);
    if (!value) {
      file_.fail(fmt::format("{} of {} {} is '{}'; a number was expected", property.name,
                             element.name, index, word));
    }
    return *value;
  }

  void require(const PlyElement& element, long long index, const std::string& defect) const {
    if (!defect.empty()) {
      file_.fail(fmt::format("{} {}: {}", element.name, index, defect));
    }
  }

  TextFile& file_;
  Rules rules_;
  std::size_t next_ = 0;
};

// All elements packed one after the other.
class BinaryBody {
 public:
  BinaryBody(const std::string& name, std::string_view bytes, const PlyHeader& header)
      : name_(name),
        bytes_(bytes),
        rules_(header),
        swap_((header.encoding == PlyEncoding::big_endian) !=
              (std::endian::native == std::endian::big)) {}

  void check() {
    for (const PlyElement& element : rules_.header.elements) {
      for (long long i = 0; i < element.count; ++i) {
        check_element(element, i);
      }
    }
    if (!bytes_.empty()) {
      throw InputError(fmt::format("{}: {} bytes follow the last element that the header announces",
                                   name_, bytes_.size()));
    }
  }

 private:
  void check_element(const PlyElement& element, long long index) {
    for (const PlyProperty& property : element.properties) {
      long long count = 1;
      if (property.count) {
        const double n = next_value(element, index, *property.count);
        require(element, index, rules_.count_defect(element, property, n));
        count = static_cast<long long>(n);
      }
      for (long long i = 0; i < count; ++i) {
        const double value = next_value(element, index, property.value);
        require(element, index, rules_.defect(element, property, value));
      }
    }
  }

  template <class T>
  double take() {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    if (swap_) {
      std::ranges::reverse(raw);
    }
    return static_cast<double>(std::bit_cast<T>(raw));
  }

  double next_value(const PlyElement& element, long long index, PlyType type) {
    if (bytes_.size() < size_of(type)) {
      throw InputError(fmt::format("{}: the file ends within {} {} of {}: it is truncated", name_,
                                   element.name, index, element.count));
    }
    switch (type) {
      case PlyType::int8: return take<std::int8_t>();
      case PlyType::uint8: return take<std::uint8_t>();
      case PlyType::int16: return take<std::int16_t>();
      case PlyType::uint16: return take<std::uint16_t>();
      case PlyType::int32: return take<std::int32_t>();
      case PlyType::uint32: return take<std::uint32_t>();
      case PlyType::float32: return take<float>();
      case PlyType::float64: return take<double>();
    }
    return 0;
  }

  void require(const PlyElement& element, long long index, const std::string& defect) const {
    if (!defect.empty()) {
      throw InputError(fmt::format("{}: {} {}: {}", name_, element.name, index, defect));
    }
  }

  const std::string& name_;
  std::string_view bytes_;
  Rules rules_;
  bool swap_;
};

}  // namespace

void check_ply(const std::string& name, std::string_view content) {
  TextFile file(name, content);
  const PlyHeader header = read_ply_header(file);
  if (header.encoding == PlyEncoding::text) {
    TextBody(file, header).check();
  } else {
    BinaryBody(name, file.rest(), header).check();
  }
}

}  // namespace clipscope::experiments
