// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads STL files, text and binary. Normals are skipped unread, since the corners say all.
//
// Source: 3D Systems, "Stereolithography Interface Specification", 1989, as given by Burns,
// "Automated Fabrication", 1993, section 6.5.
#include <algorithm>
#include <array>
#include <cstdint>

#include "experiments/machine/files.hpp"
#include "experiments/scenes/mesh_builder.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kHeaderBytes = 84, kCountOffset = 80;
constexpr std::size_t kTriangleBytes = 50, kNormalBytes = 12;

std::size_t announced_bytes(std::string_view content) {
  return kHeaderBytes +
         kTriangleBytes * std::size_t{value_at<std::uint32_t>(content, kCountOffset)};
}

// A binary file may begin with "solid" too, and a text file may be of any size.
bool is_binary(const std::string& name, std::string_view content) {
  if (content.size() >= kHeaderBytes && announced_bytes(content) == content.size()) return true;
  const std::string_view text = without_mark(name, content);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start == std::string_view::npos ||
         lower_case(std::string(text.substr(start, 5))) != "solid" ||
         text.substr(0, 512).find('\0') != std::string_view::npos;
}

Mesh read_binary(const std::string& name, std::string_view content) {
  if (content.size() < kHeaderBytes) {
    refuse(
        name,
        "{} bytes are too few for an STL file: neither text ('solid ...') nor the {} bytes of a binary header",
        content.size(), kHeaderBytes);
  }
  const auto triangles = value_at<std::uint32_t>(content, kCountOffset);
  if (announced_bytes(content) != content.size()) {
    refuse(
        name,
        "no text, which begins with 'solid', and as a binary file it announces {} triangles, which take {} bytes, but the file has {}",
        triangles, announced_bytes(content), content.size());
  }
  MeshBuilder builder(name);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const auto vertices = value_at<std::array<float, 9>>(
        content, kHeaderBytes + kTriangleBytes * std::size_t{i} + kNormalBytes);
    for (std::size_t k = 0; k < 9; k += 3) {
      builder.add_vertex({vertices[k], vertices[k + 1], vertices[k + 2]});
    }
    builder.add_triangle(3 * i, 3 * i + 1, 3 * i + 2);
  }
  return builder.finish([&](std::size_t vertex, VertexValue what) {
    return fmt::format("{}: triangle {}, vertex {}: {}", name, vertex / 3, vertex % 3,
                       to_string(what));
  });
}

// What has been opened and not been closed yet.
enum class Open { nothing, solid, facet, loop, closed_loop };

// What each kind of line expects to be open, and leaves open.
struct StlLine {
  std::string_view keyword;
  Open before, after;
};
constexpr StlLine kStlLines[] = {
    {"vertex", Open::loop, Open::loop},           {"facet", Open::solid, Open::facet},
    {"outer", Open::facet, Open::loop},           {"endloop", Open::loop, Open::closed_loop},
    {"endfacet", Open::closed_loop, Open::solid}, {"solid", Open::nothing, Open::solid},
    {"endsolid", Open::solid, Open::nothing}};

class StlText {
 public:
  StlText(const std::string& name, std::string_view content)
      : name_(name), content_(content), file_(name, content), builder_(name) {}

  Mesh read() {
    while (file_.next_words()) read_line(lower_case(std::string(file_.word(0))));
    if (open_ != Open::nothing) {
      file_.fail("the file ends here, but '{}' is missing: it is truncated", next());
    }
    if (builder_.vertices() == 0) file_.fail("the file has no triangles ('facet' lines)");
    return builder_.finish([this](std::size_t vertex, VertexValue what) {
      return fmt::format("{}:{}: {} of the vertex", name_, line_of(vertex), to_string(what));
    });
  }

 private:
  void read_line(const std::string& keyword) {
    const auto line = std::ranges::find(kStlLines, keyword, &StlLine::keyword);
    if (line == std::end(kStlLines)) {
      file_.fail("'{}' is no STL keyword; '{}' was expected", file_.word(0), next());
    }
    if (line->before != open_) {
      file_.fail("'{}' comes too early or too late; '{}' was expected", file_.word(0), next());
    }
    open_ = line->after;
    if (keyword == "facet") {
      file_.require_words(5, "facet normal <x> <y> <z>");
    } else if (keyword == "outer") {
      file_.require_words(2, "outer loop");
      corners_ = 0;
    } else if (keyword == "vertex") {
      read_vertex();
    } else if (keyword == "endloop" && corners_ != 3) {
      file_.fail("the facet has {}; 3 expected", counted(corners_, "vertex", "vertices"));
    } else if (keyword == "endfacet") {
      const auto end = static_cast<std::uint32_t>(builder_.vertices());
      builder_.add_triangle(end - 3, end - 2, end - 1);
    }
  }

  void read_vertex() {
    const std::size_t given = file_.words().size() - 1;
    if (given != 3) file_.fail("the vertex has {} of 3 numbers", given);
    std::array<double, 3> position;
    std::array<float, 3> rounded;
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] = file_.number(k + 1, "xyz"[k], "the vertex");
      rounded[k] = to_float(file_.word(k + 1), position[k]);
    }
    builder_.add_vertex(position, rounded);
    ++corners_;
  }

  // What should come next.
  const char* next() const {
    constexpr std::array kNext = {"solid", "endsolid", "outer loop", "endloop", "endfacet"};
    if (open_ == Open::loop && corners_ < 3) return "vertex";
    return kNext[static_cast<std::size_t>(open_)];
  }

  // Found by reading the file again: only errors need it.
  std::size_t line_of(std::size_t vertex) const {
    TextFile again(name_, content_);
    for (std::size_t seen = 0; again.next_words();) {
      if (lower_case(std::string(again.word(0))) == "vertex" && seen++ == vertex) break;
    }
    return again.line();
  }

  const std::string& name_;
  std::string_view content_;
  TextFile file_;
  MeshBuilder builder_;
  Open open_ = Open::nothing;
  int corners_ = 0;  // of the facet
};

}  // namespace

Mesh read_stl(const std::string& name, std::string_view content) {
  return is_binary(name, content) ? read_binary(name, content) : StlText(name, content).read();
}

}  // namespace clipscope::experiments
