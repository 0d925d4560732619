// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/ply_header.hpp"

#include <algorithm>
#include <cstdint>

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

struct NamedFormat {
  std::string_view name;
  PlyFormat format;
};
constexpr NamedFormat kPlyFormats[] = {{"ascii", PlyFormat::text},
                                       {"binary_little_endian", PlyFormat::little_endian},
                                       {"binary_big_endian", PlyFormat::big_endian}};

class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(TextFile& file) : file_(file) {}

  PlyHeader read() {
    if (!file_.next_line() || file_.words().size() != 1 || file_.word(0) != "ply") {
      file_.fail_at(1, "the file does not begin with the line 'ply'");
    }
    while (file_.next_words() && file_.word(0) != "end_header") read_line(file_.word(0));
    if (file_.words().empty()) {
      file_.fail("the header ends without 'end_header': the file is truncated");
    }
    check();
    return {*format_, std::move(elements_)};
  }

 private:
  void read_line(std::string_view keyword) {
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
    const auto found = std::ranges::find(kPlyFormats, file_.word(1), &NamedFormat::name);
    if (found == std::end(kPlyFormats)) {
      file_.fail("the format is '{}'; ascii, binary_little_endian or binary_big_endian expected",
                 file_.word(1));
    }
    format_ = found->format;
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

  void check() const {
    if (!format_) file_.fail("the header has no 'format' line");
    require_properties();
    const auto vertex = find("vertex"), face = find("face"), strips = find("tristrips");
    if (vertex == elements_.end() || vertex->count == 0) {
      file_.fail("the header announces no vertices ('element vertex')");
    }
    for (const std::string_view name : {"x", "y", "z"}) {
      const auto found = std::ranges::find(vertex->properties, name, &PlyProperty::name);
      if (found == vertex->properties.end() || found->count) {
        file_.fail("the vertices have no number '{}'", name);
      }
    }
    const auto has_some = [this](auto element) {
      return element != elements_.end() && element->count > 0;
    };
    if (!has_some(face) && !has_some(strips)) {
      file_.fail("the header announces no faces ('element face'), hence no triangles");
    }
    for (const auto& element : {face, strips}) {
      if (has_some(element)) check_indices(*element, element < vertex);
    }
  }

  void check_indices(const PlyElement& element, bool comes_before) const {
    const char* what = element.name == "face" ? "faces" : "triangle strips";
    if (comes_before) file_.fail("the {} come before the vertices; the other order expected", what);
    const auto lists =
        std::ranges::count_if(element.properties, &PlyProperty::is_vertex_index_list);
    if (lists != 1) {
      file_.fail("the {} have {} list 'vertex_indices' or 'vertex_index'{}", what,
                 lists == 0 ? "no" : "more than one", lists == 0 ? "" : "; one expected");
    }
    const auto indices =
        std::ranges::find_if(element.properties, &PlyProperty::is_vertex_index_list);
    if (!indices->value.is_integer) file_.fail("the vertex indices are no whole numbers");
  }

  std::vector<PlyElement>::const_iterator find(std::string_view name) const {
    const auto count = std::ranges::count(elements_, name, &PlyElement::name);
    if (count > 1) file_.fail("the header has {} elements '{}'; one expected", count, name);
    return std::ranges::find(elements_, name, &PlyElement::name);
  }

  TextFile& file_;
  std::optional<PlyFormat> format_;
  std::vector<PlyElement> elements_;
};

}  // namespace

PlyHeader read_ply_header(TextFile& file) { return PlyHeaderReader(file).read(); }

}  // namespace clipscope::experiments
