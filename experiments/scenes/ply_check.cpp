// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of PLY files, text and binary of both byte orders.
//
// Source: Turk, "The PLY Polygon File Format", 1994.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "experiments/scenes/mesh_file.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

struct PlyType {
  std::string_view name, sized_name;
  NumberType number;
};
constexpr PlyType kPlyTypes[] = {
    {"char", "int8", kNumberType<std::int8_t>},    {"uchar", "uint8", kNumberType<std::uint8_t>},
    {"short", "int16", kNumberType<std::int16_t>}, {"ushort", "uint16", kNumberType<std::uint16_t>},
    {"int", "int32", kNumberType<std::int32_t>},   {"uint", "uint32", kNumberType<std::uint32_t>},
    {"float", "float32", kNumberType<float>},      {"double", "float64", kNumberType<double>}};

struct PlyProperty {
  std::string name;
  std::optional<NumberType> count;  // of a list
  NumberType value;

  bool is_vertex_index_list() const {
    return count && (name == "vertex_indices" || name == "vertex_index");
  }
};

struct PlyElement {
  std::string name;
  long long count;  // 0 to 2^32 - 1
  std::vector<PlyProperty> properties;
};

class PlyCheck {
 public:
  PlyCheck(const std::string& name, std::string_view content) : name_(name), file_(name, content) {}

  void run() {
    read_header();
    check_header();
    bytes_ = file_.rest();
    for (const PlyElement& element : elements_) {
      element_ = &element;
      for (index_ = 0; index_ < element.count; ++index_) check_element();
    }
    if (is_text() && file_.next_words()) {
      file_.fail("the file goes on after the last element that its header announces");
    }
    if (!is_text() && !bytes_.empty()) {
      refuse(name_, "{} bytes follow the last element that the header announces", bytes_.size());
    }
  }

 private:
  // The header, up to and with its line 'end_header'.
  void read_header() {
    if (!file_.next_line() || file_.words().size() != 1 || file_.word(0) != "ply") {
      file_.fail_at(1, "the file does not begin with the line 'ply'");
    }
    while (file_.next_words()) {
      if (file_.word(0) == "end_header") return;
      read_header_line(file_.word(0));
    }
    file_.fail("the header ends without 'end_header': the file is truncated");
  }

  void read_header_line(std::string_view keyword) {
    if (keyword == "format") return read_format();
    if (keyword == "element") return read_element();
    if (keyword == "property") return read_property();
    if (keyword == "comment" || keyword == "obj_info") return;
    file_.fail(
        "'{}' is no header keyword; format, comment, element, property or end_header expected",
        keyword);
  }

  void read_format() {
    file_.require_words(3, "format ascii|binary_little_endian|binary_big_endian 1.0");
    if (file_.word(2) != "1.0") {
      file_.fail("the format version is '{}'; 1.0 expected", file_.word(2));
    }
    format_ = file_.word(1);
    if (format_ != "ascii" && format_ != "binary_little_endian" && format_ != "binary_big_endian") {
      file_.fail("the format is '{}'; ascii, binary_little_endian or binary_big_endian expected",
                 format_);
    }
  }

  void read_element() {
    file_.require_words(3, "element <name> <count>");
    const long long count = file_.require_integer(file_.word(2), "the element count");
    if (count < 0 || count > UINT32_MAX) {
      file_.fail("the element count is {}; 0 to {} expected", count, UINT32_MAX);
    }
    require_properties();
    elements_.push_back({std::string(file_.word(1)), count, {}});
  }

  // The element that was read last must have some.
  void require_properties() const {
    if (!elements_.empty() && elements_.back().properties.empty()) {
      file_.fail("the element '{}' before has no property", elements_.back().name);
    }
  }

  void read_property() {
    if (elements_.empty()) file_.fail("a property comes before the first element");
    PlyProperty property;
    const bool is_list = file_.words().size() > 1 && file_.word(1) == "list";
    if (is_list) {
      file_.require_words(5, "property list <count type> <value type> <name>");
      property.count = type_of(file_.word(2));
      if (!property.count->is_integer) {
        file_.fail("the count of a list is of type {}; a whole number type expected",
                   file_.word(2));
      }
    } else {
      file_.require_words(3, "property <type> <name>");
    }
    property.value = type_of(file_.word(is_list ? 3 : 1));
    property.name = file_.words().back();
    elements_.back().properties.push_back(std::move(property));
  }

  NumberType type_of(std::string_view name) const {
    for (const PlyType& type : kPlyTypes) {
      if (name == type.name || name == type.sized_name) return type.number;
    }
    file_.fail("'{}' is no type; char, uchar, short, ushort, int, uint, float or double expected",
               name);
  }

  // Leaves one element 'vertex' with numbers x, y and z, and after it one element 'face' with a
  // list of whole numbers vertex_indices or vertex_index; both counts are positive.
  void check_header() {
    if (format_.empty()) file_.fail("the header has no 'format' line");
    require_properties();
    const auto vertex = find("vertex"), face = find("face");
    if (vertex == elements_.end() || vertex->count == 0) {
      file_.fail("the header announces no vertices ('element vertex')");
    }
    for (const std::string_view name : {"x", "y", "z"}) {
      const auto found = std::ranges::find(vertex->properties, name, &PlyProperty::name);
      if (found == vertex->properties.end() || found->count) {
        file_.fail("the vertices have no number '{}'", name);
      }
    }
    if (face == elements_.end() || face->count == 0) {
      file_.fail("the header announces no faces ('element face'), hence no triangles");
    }
    if (face < vertex) file_.fail("the faces come before the vertices; the other order expected");
    const auto indices = std::ranges::find_if(face->properties, &PlyProperty::is_vertex_index_list);
    if (indices == face->properties.end()) {
      file_.fail("the faces have no list 'vertex_indices' or 'vertex_index'");
    }
    if (!indices->value.is_integer) file_.fail("the vertex indices are no whole numbers");
    vertices_ = vertex->count;
  }

  std::vector<PlyElement>::const_iterator find(std::string_view name) const {
    const auto count = std::ranges::count(elements_, name, &PlyElement::name);
    if (count > 1) file_.fail("the header has {} elements '{}'; one expected", count, name);
    return std::ranges::find(elements_, name, &PlyElement::name);
  }

  void check_element() {
    if (is_text() && !file_.next_words()) {
      file_.fail("the file ends after {} of {} elements '{}'", index_, element_->count,
                 element_->name);
    }
    words_read_ = 0;
    for (const PlyProperty& property : element_->properties) {
      long long count = 1;
      if (property.count) count = read_count(property);
      for (; count > 0; --count) check_value(property);
    }
    if (is_text() && words_read_ != file_.words().size()) {
      file_.fail("{} {} has {} values; {} expected", element_->name, index_, file_.words().size(),
                 words_read_);
    }
  }

  long long read_count(const PlyProperty& property) {
    const double count = read_value(property, *property.count);
    if (is_face_corner(property) && count < 3) {
      refuse(place(), "has {}; at least 3 expected",
             counted(static_cast<long long>(count), "vertex", "vertices"));
    }
    if (count < 0) refuse(place(), "has a list of {} values", count);
    return static_cast<long long>(count);
  }

  void check_value(const PlyProperty& property) {
    const double value = read_value(property, property.value);
    if (element_->name == "vertex" && !property.count && !property.value.is_integer) {
      require_finite(value, [&] { return fmt::format("{}: {}", place(), property.name); });
    }
    if (is_face_corner(property) && !(0 <= value && value < static_cast<double>(vertices_))) {
      refuse(place(), "refers to vertex {}, but there are only {} (0 to {})", value, vertices_,
             vertices_ - 1);
    }
  }

  bool is_face_corner(const PlyProperty& property) const {
    return element_->name == "face" && property.is_vertex_index_list();
  }

  bool is_text() const { return format_ == "ascii"; }

  double read_value(const PlyProperty& property, const NumberType& type) {
    return is_text() ? read_word(property) : read_bytes(type);
  }

  double read_word(const PlyProperty& property) {
    if (words_read_ == file_.words().size()) {
      file_.fail("{} {} has too few values: {} is missing", element_->name, index_, property.name);
    }
    const std::string_view word = file_.word(words_read_++);
    const std::optional<double> value = to_number(word);
    if (!value) {
      file_.fail("{} of {} {} is '{}'; a number was expected", property.name, element_->name,
                 index_, word);
    }
    return *value;
  }

  double read_bytes(const NumberType& type) {
    if (bytes_.size() < type.bytes) {
      refuse(name_, "the file ends within {} {} of {}: it is truncated", element_->name, index_,
             element_->count);
    }
    std::string value(bytes_.substr(0, type.bytes));
    bytes_.remove_prefix(type.bytes);
    if (format_ == "binary_big_endian") std::ranges::reverse(value);
    return type.at(value, 0);
  }

  std::string place() const {
    const std::string line = is_text() ? fmt::format(":{}", file_.line()) : "";
    return fmt::format("{}{}: {} {}", name_, line, element_->name, index_);
  }

  const std::string& name_;
  TextFile file_;
  std::string_view format_;
  std::vector<PlyElement> elements_;
  long long vertices_ = 0;
  std::string_view bytes_;               // after the header, those that are still to be read
  const PlyElement* element_ = nullptr;  // the one that is checked
  long long index_ = 0;
  std::size_t words_read_ = 0;
};

}  // namespace

std::string geometry_of_ply(const std::string& name, std::string content) {
  PlyCheck(name, content).run();
  return content;
}

}  // namespace clipscope::experiments
