// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads PLY files, text and binary of both byte orders, faces and triangle strips.
//
// Source: Turk, "The PLY Polygon File Format", 1994. Strips as the Stanford tools write them: an
// index of -1 ends a strip and begins another.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "experiments/scenes/mesh_builder.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "experiments/scenes/ply_header.hpp"

namespace clipscope::experiments {
namespace {

// The numbers of a vertex that are used, and the names that they go by.
enum Slot : std::size_t { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kSlots, kUnusedSlot = kSlots };
constexpr std::array<std::array<std::string_view, 3>, kSlots> kSlotNames = {
    {{"x"},
     {"y"},
     {"z"},
     {"nx"},
     {"ny"},
     {"nz"},
     {"u", "s", "texture_u"},
     {"v", "t", "texture_v"}}};

class PlyReader {
 public:
  PlyReader(const std::string& name, std::string_view content)
      : name_(name),
        content_(content),
        file_(name, content),
        header_(read_ply_header(file_)),
        bytes_(file_.rest()),
        builder_(name, is_text() ? "line" : "face") {}

  Mesh read() {
    for (const PlyElement& element : header_.elements) {
      element_ = &element;
      if (element.name == "vertex") {
        read_vertices();
      } else {
        read_others();
      }
    }
    require_end();
    return builder_.finish([&](std::size_t vertex, VertexValue what) {
      return fmt::format("{}{}: vertex {}: {}", name_, line_of_vertex(vertex), vertex,
                         to_string(what));
    });
  }

 private:
  void read_vertices() {
    std::vector<std::size_t> slots;
    for (const PlyProperty& property : element_->properties) slots.push_back(slot_of(property));
    const auto has = [&](Slot slot) { return std::ranges::count(slots, slot) > 0; };
    const bool has_normals = has(kNx) && has(kNy) && has(kNz), has_texture = has(kU) && has(kV);
    for (index_ = 0; index_ < element_->count; ++index_) {
      begin_element();
      for (std::size_t i = 0; i < slots.size(); ++i) {
        const PlyProperty& property = element_->properties[i];
        if (slots[i] == kUnusedSlot) {
          skip(property);
        } else {
          values_[slots[i]] = read_value(property, property.value);
        }
      }
      end_element();
      builder_.add_vertex({values_[kX], values_[kY], values_[kZ]});
      const auto vertex = static_cast<std::size_t>(index_);
      if (has_texture) builder_.set_texture(vertex, values_[kU], values_[kV]);
      if (has_normals) builder_.set_normal(vertex, {values_[kNx], values_[kNy], values_[kNz]});
    }
  }

  static std::size_t slot_of(const PlyProperty& property) {
    const auto has_name = [&](const auto& names) {
      return std::ranges::find(names, property.name) != names.end();
    };
    const auto found = std::ranges::find_if(kSlotNames, has_name);
    return property.count ? kUnusedSlot : static_cast<std::size_t>(found - kSlotNames.begin());
  }

  // Elements other than vertices; of faces and strips the vertex indices are used.
  void read_others() {
    const bool is_strips = element_->name == "tristrips";
    const bool has_indices = is_strips || element_->name == "face";
    for (index_ = 0; index_ < element_->count; ++index_) {
      begin_element();
      for (const PlyProperty& property : element_->properties) {
        if (!has_indices || !property.is_vertex_index_list()) {
          skip(property);
        } else if (is_strips) {
          read_strips(property);
        } else {
          read_face(property);
        }
      }
      end_element();
    }
  }

  void read_face(const PlyProperty& property) {
    const std::size_t count = read_count(property);
    if (count < 3) {
      refuse(place(), "has {}; at least 3 expected", counted(count, "vertex", "vertices"));
    }
    corners_.clear();
    for (std::size_t i = 0; i < count; ++i) corners_.push_back(read_corner(property));
    builder_.add_polygon(corners_, number());
  }

  void read_strips(const PlyProperty& property) {
    for (std::size_t i = read_count(property); i > 0; --i) {
      const double index = read_value(property, property.value);
      if (index == -1) {
        add_corners_of_strip();
      } else {
        corners_.push_back(checked_corner(index));
      }
    }
    add_corners_of_strip();
  }

  void add_corners_of_strip() {
    add_strip(corners_, [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      builder_.add_triangle(a, b, c);
    });
    corners_.clear();
  }

  std::uint32_t read_corner(const PlyProperty& property) {
    return checked_corner(read_value(property, property.value));
  }

  std::uint32_t checked_corner(double index) const {
    const std::size_t vertices = builder_.vertices();
    if (!(0 <= index && index < static_cast<double>(vertices))) {
      refuse(place(), "refers to vertex {}, but there are only {} (0 to {})", index, vertices,
             vertices - 1);
    }
    if (index != std::floor(index)) {
      refuse(place(), "refers to vertex {}; a whole number was expected", index);
    }
    return static_cast<std::uint32_t>(index);
  }

  std::size_t read_count(const PlyProperty& property) {
    const double count = read_value(property, *property.count);
    if (!(0 <= count && count <= UINT32_MAX && count == std::floor(count))) {
      refuse(place(), "has a list of {} values; a whole number >= 0 expected", count);
    }
    return static_cast<std::size_t>(count);
  }

  // Passes over a number or a list that nothing uses; of text not even its words are looked at.
  void skip(const PlyProperty& property) {
    const std::size_t count = property.count ? read_count(property) : 1;
    if (!is_text()) return remove_bytes(count, property.value.bytes);
    if (count > file_.words().size() - words_read_) fail_missing(property);
    words_read_ += count;
  }

  void begin_element() {
    if (!is_text()) return;
    if (!file_.next_words()) {
      file_.fail("the file ends after {} of {} elements '{}'", index_, element_->count,
                 element_->name);
    }
    words_read_ = 0;
    if (index_ == 0 && element_->name == "vertex") first_vertex_line_ = file_.line();
  }

  void end_element() const {
    if (is_text() && words_read_ != file_.words().size()) {
      file_.fail("{} {} has {} values; {} expected", element_->name, index_, file_.words().size(),
                 words_read_);
    }
  }

  void require_end() {
    if (is_text() && file_.next_words()) {
      file_.fail("the file goes on after the last element that its header announces");
    }
    if (!is_text() && !bytes_.empty()) {
      refuse(name_, "{} bytes follow the last element that the header announces", bytes_.size());
    }
  }

  bool is_text() const { return header_.format == PlyFormat::text; }

  double read_value(const PlyProperty& property, const NumberType& type) {
    return is_text() ? read_word(property, type) : read_bytes(type);
  }

  // A number that the header calls a float is rounded to one, whatever its digits say.
  double read_word(const PlyProperty& property, const NumberType& type) {
    if (words_read_ == file_.words().size()) fail_missing(property);
    const std::string_view word = file_.word(words_read_++);
    const std::optional<double> value = to_number(word);
    if (!value) {
      file_.fail("{} of {} {} is '{}'; a number was expected", property.name, element_->name,
                 index_, word);
    }
    const bool is_float = !type.is_integer && type.bytes == sizeof(float);
    return is_float && defect_of(*value).empty() ? double{to_float(word, *value)} : *value;
  }

  [[noreturn]] void fail_missing(const PlyProperty& property) const {
    file_.fail("{} {} has too few values: {} is missing", element_->name, index_, property.name);
  }

  double read_bytes(const NumberType& type) {
    std::array<char, 8> swapped = {};
    std::string_view value = bytes_;
    remove_bytes(1, type.bytes);
    if (header_.format == PlyFormat::big_endian) {
      std::ranges::reverse_copy(value.substr(0, type.bytes), swapped.begin());
      value = {swapped.data(), swapped.size()};
    }
    return type.at(value, 0);
  }

  void remove_bytes(std::size_t count, std::size_t size) {
    if (bytes_.size() / size < count) {
      refuse(name_, "the file ends within {} {} of {}: it is truncated", element_->name, index_,
             element_->count);
    }
    bytes_.remove_prefix(count * size);
  }

  // What tells an element from others in messages: its line in text, else its index.
  std::size_t number() const { return is_text() ? file_.line() : static_cast<std::size_t>(index_); }

  std::string place() const {
    const std::string line = is_text() ? fmt::format(":{}", file_.line()) : "";
    return fmt::format("{}{}: {} {}", name_, line, element_->name, index_);
  }

  // ":LINE" in text, found by reading the file again: only errors need it.
  std::string line_of_vertex(std::size_t vertex) const {
    if (!is_text()) return "";
    TextFile again(name_, content_);
    while (again.next_words() && again.line() < first_vertex_line_) {
    }
    for (std::size_t i = 0; i < vertex; ++i) again.next_words();
    return fmt::format(":{}", again.line());
  }

  const std::string& name_;
  std::string_view content_;
  TextFile file_;
  PlyHeader header_;
  std::string_view bytes_;  // after the header, those that are still to be read
  MeshBuilder builder_;
  const PlyElement* element_ = nullptr;  // the one that is read
  long long index_ = 0;
  std::size_t words_read_ = 0, first_vertex_line_ = 0;
  std::array<double, kSlots> values_ = {};  // of a vertex
  std::vector<std::uint32_t> corners_;
};

}  // namespace

Mesh read_ply(const std::string& name, std::string_view content) {
  return PlyReader(name, content).read();
}

}  // namespace clipscope::experiments
