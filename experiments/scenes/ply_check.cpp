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
#include <vector>

#include "experiments/errors.hpp"
#include "experiments/scenes/mesh_checks.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct TypeName {
  std::string_view name;
  Type type;
};
constexpr std::array kTypeNames = {
    TypeName{"char", Type::int8},      TypeName{"int8", Type::int8},
    TypeName{"uchar", Type::uint8},    TypeName{"uint8", Type::uint8},
    TypeName{"short", Type::int16},    TypeName{"int16", Type::int16},
    TypeName{"ushort", Type::uint16},  TypeName{"uint16", Type::uint16},
    TypeName{"int", Type::int32},      TypeName{"int32", Type::int32},
    TypeName{"uint", Type::uint32},    TypeName{"uint32", Type::uint32},
    TypeName{"float", Type::float32},  TypeName{"float32", Type::float32},
    TypeName{"double", Type::float64}, TypeName{"float64", Type::float64}};

constexpr std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

constexpr bool is_integer(Type type) { return type != Type::float32 && type != Type::float64; }

struct Property {
  std::string name;
  std::optional<Type> count;  // of a list
  Type value;
};

struct Element {
  std::string name;
  long long count;
  std::vector<Property> properties;
};

enum class Encoding { text, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
};

class HeaderReader {
 public:
  explicit HeaderReader(TextFile& file) : file_(file) {}

  Header read() {
    if (!file_.next_line() || file_.words().size() != 1 || file_.word(0) != "ply") {
      file_.fail_at(1, "the file does not begin with the line 'ply'");
    }
    while (file_.next_words()) {
      const std::string_view keyword = file_.word(0);
      if (keyword == "end_header") {
        check();
        return std::move(header_);
      }
      read_line(keyword);
    }
    file_.fail("the header ends without 'end_header': the file is truncated");
  }

 private:
  void read_line(std::string_view keyword) {
    if (keyword == "format") {
      read_format();
    } else if (keyword == "element") {
      read_element();
    } else if (keyword == "property") {
      read_property();
    } else if (keyword != "comment" && keyword != "obj_info") {
      file_.fail(
          fmt::format("'{}' is no header keyword; format, comment, element, property or end_header "
                      "expected",
                      keyword));
    }
  }

  void read_format() {
    require_words(3, "format ascii|binary_little_endian|binary_big_endian 1.0");
    const std::string_view name = file_.word(1);
    if (name == "ascii") {
      header_.encoding = Encoding::text;
    } else if (name == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (name == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      file_.fail(
          fmt::format("the format is '{}'; ascii, binary_little_endian or binary_big_endian "
                      "expected",
                      name));
    }
    has_format_ = true;
  }

  void read_element() {
    require_words(3, "element <name> <count>");
    const long long count = file_.require_integer(file_.word(2), "the element count");
    if (count < 0 || count > UINT32_MAX) {
      file_.fail(fmt::format("the element count is {}; 0 to {} expected", count, UINT32_MAX));
    }
    header_.elements.push_back({std::string(file_.word(1)), count, {}});
  }

  void read_property() {
    if (header_.elements.empty()) {
      file_.fail("a property comes before the first element");
    }
    auto& properties = header_.elements.back().properties;
    if (file_.words().size() > 1 && file_.word(1) == "list") {
      require_words(5, "property list <count type> <value type> <name>");
      const Type count = type_of(file_.word(2));
      if (!is_integer(count)) {
        file_.fail(fmt::format("the count of a list is of type {}; a whole number type expected",
                               file_.word(2)));
      }
      properties.push_back({std::string(file_.word(4)), count, type_of(file_.word(3))});
    } else {
      require_words(3, "property <type> <name>");
      properties.push_back({std::string(file_.word(2)), std::nullopt, type_of(file_.word(1))});
    }
  }

  Type type_of(std::string_view name) const {
    const auto found = std::ranges::find(kTypeNames, name, &TypeName::name);
    if (found == kTypeNames.end()) {
      file_.fail(
          fmt::format("'{}' is no type; char, uchar, short, ushort, int, uint, float or double "
                      "expected",
                      name));
    }
    return found->type;
  }

  void require_words(std::size_t n, const char* pattern) const {
    if (file_.words().size() != n) {
      file_.fail(fmt::format("'{}' expected", pattern));
    }
  }

  void check() const {
    if (!has_format_) {
      file_.fail("the header has no 'format' line");
    }
    const auto find = [this](std::string_view name) {
      const auto& elements = header_.elements;
      const auto count = std::ranges::count(elements, name, &Element::name);
      if (count > 1) {
        file_.fail(fmt::format("the header has {} elements '{}'; one expected", count, name));
      }
      return std::ranges::find(elements, name, &Element::name);
    };
    const auto vertex = find("vertex"), face = find("face");
    if (vertex == header_.elements.end() || vertex->count == 0) {
      file_.fail("the header announces no vertices ('element vertex')");
    }
    require_coordinates(*vertex);
    if (face == header_.elements.end() || face->count == 0) {
      file_.fail("the header announces no faces ('element face'), hence no triangles");
    }
    if (face < vertex) {
      file_.fail("the faces come before the vertices; the other order expected");
    }
    require_indices(*face);
  }

  void require_coordinates(const Element& vertex) const {
    for (const std::string_view name : {"x", "y", "z"}) {
      const auto found = std::ranges::find(vertex.properties, name, &Property::name);
      if (found == vertex.properties.end() || found->count) {
        file_.fail(fmt::format("the vertices have no number '{}'", name));
      }
    }
  }

  void require_indices(const Element& face) const;

  TextFile& file_;
  Header header_;
  bool has_format_ = false;
};

bool is_index_list(const Property& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void HeaderReader::require_indices(const Element& face) const {
  const auto found = std::ranges::find_if(face.properties, is_index_list);
  if (found == face.properties.end()) {
    file_.fail("the faces have no list 'vertex_indices' or 'vertex_index'");
  }
  if (!is_integer(found->value)) {
    file_.fail("the vertex indices are no whole numbers");
  }
}

// What both encodings check of a value, once read: an empty text if it is sound.
struct Rules {
  const Header& header;
  long long vertices;

  explicit Rules(const Header& h)
      : header(h), vertices(std::ranges::find(h.elements, "vertex", &Element::name)->count) {}

  // `index`: of the element within its kind.
  std::string defect(const Element& element, const Property& property, double value) const {
    if (element.name == "vertex" && !property.count && !is_integer(property.value)) {
      const std::string found = defect_of(value);
      return found.empty()
                 ? found
                 : fmt::format("{} is {}; a finite number was expected", property.name, found);
    }
    if (element.name == "face" && is_index_list(property) &&
        !(0 <= value && value < static_cast<double>(vertices))) {
      return fmt::format("refers to vertex {}, but there are only {} (0 to {})", value, vertices,
                         vertices - 1);
    }
    return {};
  }

  std::string count_defect(const Element& element, const Property& property, double count) const {
    if (element.name == "face" && is_index_list(property) && count < 3) {
      return fmt::format("has {}; at least 3 expected",
                         counted(static_cast<long long>(count), "vertex", "vertices"));
    }
    return count < 0 ? fmt::format("has a list of {} values", count) : std::string{};
  }
};

// One line per element.
class TextBody {
 public:
  TextBody(TextFile& file, const Header& header) : file_(file), rules_(header) {}

  void check() {
    for (const Element& element : rules_.header.elements) {
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
  void check_element(const Element& element, long long index) {
    next_ = 0;
    for (const Property& property : element.properties) {
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

  double next_value(const Element& element, long long index, const Property& property) {
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

  void require(const Element& element, long long index, const std::string& defect) const {
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
  BinaryBody(const std::string& name, std::string_view bytes, const Header& header)
      : name_(name),
        bytes_(bytes),
        rules_(header),
        swap_((header.encoding == Encoding::big_endian) !=
              (std::endian::native == std::endian::big)) {}

  void check() {
    for (const Element& element : rules_.header.elements) {
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
  void check_element(const Element& element, long long index) {
    for (const Property& property : element.properties) {
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

  double next_value(const Element& element, long long index, Type type) {
    if (bytes_.size() < size_of(type)) {
      throw InputError(fmt::format("{}: the file ends within {} {} of {}: it is truncated", name_,
                                   element.name, index, element.count));
    }
    switch (type) {
      case Type::int8: return take<std::int8_t>();
      case Type::uint8: return take<std::uint8_t>();
      case Type::int16: return take<std::int16_t>();
      case Type::uint16: return take<std::uint16_t>();
      case Type::int32: return take<std::int32_t>();
      case Type::uint32: return take<std::uint32_t>();
      case Type::float32: return take<float>();
      case Type::float64: return take<double>();
    }
    return 0;
  }

  void require(const Element& element, long long index, const std::string& defect) const {
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
  const Header header = HeaderReader(file).read();
  if (header.encoding == Encoding::text) {
    TextBody(file, header).check();
  } else {
    BinaryBody(name, file.rest(), header).check();
  }
}

}  // namespace clipscope::experiments
