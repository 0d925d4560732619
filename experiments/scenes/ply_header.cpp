// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/ply_header.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

namespace clipscope::experiments {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array kTypeNames = {
    TypeName{"char", PlyType::int8},      TypeName{"int8", PlyType::int8},
    TypeName{"uchar", PlyType::uint8},    TypeName{"uint8", PlyType::uint8},
    TypeName{"short", PlyType::int16},    TypeName{"int16", PlyType::int16},
    TypeName{"ushort", PlyType::uint16},  TypeName{"uint16", PlyType::uint16},
    TypeName{"int", PlyType::int32},      TypeName{"int32", PlyType::int32},
    TypeName{"uint", PlyType::uint32},    TypeName{"uint32", PlyType::uint32},
    TypeName{"float", PlyType::float32},  TypeName{"float32", PlyType::float32},
    TypeName{"double", PlyType::float64}, TypeName{"float64", PlyType::float64}};

class HeaderReader {
 public:
  explicit HeaderReader(TextFile& file) : file_(file) {}

  PlyHeader read() {
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
    if (file_.word(2) != "1.0") {
      file_.fail(fmt::format("the format version is '{}'; 1.0 expected", file_.word(2)));
    }
    if (name == "ascii") {
      header_.encoding = PlyEncoding::text;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
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
    require_properties();
    header_.elements.push_back({std::string(file_.word(1)), count, {}});
  }

  // Of the element read last.
  void require_properties() const {
    if (!header_.elements.empty() && header_.elements.back().properties.empty()) {
      file_.fail(
          fmt::format("the element '{}' before has no property", header_.elements.back().name));
    }
  }

  void read_property() {
    if (header_.elements.empty()) {
      file_.fail("a property comes before the first element");
    }
    auto& properties = header_.elements.back().properties;
    if (file_.words().size() > 1 && file_.word(1) == "list") {
      require_words(5, "property list <count type> <value type> <name>");
      const PlyType count = type_of(file_.word(2));
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

  PlyType type_of(std::string_view name) const {
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
    require_properties();
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

  std::vector<PlyElement>::const_iterator find(std::string_view name) const {
    const auto& elements = header_.elements;
    const auto count = std::ranges::count(elements, name, &PlyElement::name);
    if (count > 1) {
      file_.fail(fmt::format("the header has {} elements '{}'; one expected", count, name));
    }
    return std::ranges::find(elements, name, &PlyElement::name);
  }

  void require_coordinates(const PlyElement& vertex) const {
    for (const std::string_view name : {"x", "y", "z"}) {
      const auto found = std::ranges::find(vertex.properties, name, &PlyProperty::name);
      if (found == vertex.properties.end() || found->count) {
        file_.fail(fmt::format("the vertices have no number '{}'", name));
      }
    }
  }

  void require_indices(const PlyElement& face) const {
    const auto found = std::ranges::find_if(face.properties, &PlyProperty::is_vertex_index_list);
    if (found == face.properties.end()) {
      file_.fail("the faces have no list 'vertex_indices' or 'vertex_index'");
    }
    if (!is_integer(found->value)) {
      file_.fail("the vertex indices are no whole numbers");
    }
  }

  TextFile& file_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

PlyHeader read_ply_header(TextFile& file) { return HeaderReader(file).read(); }

}  // namespace clipscope::experiments
