// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of STL files, text and binary.
//
// Source: 3D Systems, "Stereolithography Interface Specification", 1989, as given by Burns,
// "Automated Fabrication", 1993, section 6.5.
#include <algorithm>
#include <array>
#include <cstdint>

#include "experiments/machine/files.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kHeaderBytes = 84, kCountOffset = 80;
constexpr std::size_t kTriangleBytes = 50, kAttributeBytes = 2;

std::size_t announced_bytes(std::string_view content) {
  return kHeaderBytes +
         kTriangleBytes * std::size_t{value_at<std::uint32_t>(content, kCountOffset)};
}

// A binary file may begin with "solid" too, and a text file may be of any size.
bool is_binary(std::string_view content) {
  if (content.size() >= kHeaderBytes && announced_bytes(content) == content.size()) return true;
  const std::size_t start = content.find_first_not_of(" \t\r\n");
  return start == std::string_view::npos ||
         lower_case(std::string(content.substr(start, 5))) != "solid" ||
         content.substr(0, 512).find('\0') != std::string_view::npos;
}

void check_binary(const std::string& name, std::string_view content) {
  if (content.size() < kHeaderBytes) {
    refuse(
        name,
        "{} bytes are too few for an STL file: neither text ('solid ...') nor the {} bytes of a binary header",
        content.size(), kHeaderBytes);
  }
  const auto triangles = value_at<std::uint32_t>(content, kCountOffset);
  if (announced_bytes(content) != content.size()) {
    refuse(name,
           "the binary header announces {} triangles, which take {} bytes, but the file has {}",
           triangles, announced_bytes(content), content.size());
  }
  if (triangles == 0) refuse(name, "the file has no triangles");
  for (std::size_t i = 0; i < triangles; ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t offset = kHeaderBytes + kTriangleBytes * i + 12 + 4 * k;
      require_finite(value_at<float>(content, offset), [&] {
        return fmt::format("{}: triangle {}, vertex {}: {}", name, i, k / 3, "xyz"[k % 3]);
      });
    }
  }
}

// What has been opened and not been closed yet.
enum class Open { nothing, solid, facet, loop, closed_loop };

// What each kind of line expects to be open, and leaves open.
struct StlLine {
  std::string_view keyword;
  Open before, after;
};
constexpr StlLine kStlLines[] = {
    {"solid", Open::nothing, Open::solid},      {"facet", Open::solid, Open::facet},
    {"outer", Open::facet, Open::loop},         {"vertex", Open::loop, Open::loop},
    {"endloop", Open::loop, Open::closed_loop}, {"endfacet", Open::closed_loop, Open::solid},
    {"endsolid", Open::solid, Open::nothing}};

// Turns text into the binary form.
class StlText {
 public:
  StlText(const std::string& name, std::string_view content) : file_(name, content) {}

  std::string as_binary() {
    while (file_.next_words()) read_line(lower_case(std::string(file_.word(0))));
    if (open_ != Open::nothing) {
      file_.fail("the file ends here, but '{}' is missing: it is truncated", next());
    }
    if (triangles_ == 0) file_.fail("the file has no triangles ('facet' lines)");
    std::memcpy(binary_.data() + kCountOffset, &triangles_, sizeof triangles_);
    return std::move(binary_);
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
      append_numbers(2, "the normal");
    } else if (keyword == "outer") {
      file_.require_words(2, "outer loop");
      vertices_ = 0;
    } else if (keyword == "vertex") {
      append_numbers(1, "the vertex");
      ++vertices_;
    } else if (keyword == "endloop" && vertices_ != 3) {
      file_.fail("the facet has {}; 3 expected", counted(vertices_, "vertex", "vertices"));
    } else if (keyword == "endfacet") {
      binary_.append(kAttributeBytes, '\0');
      ++triangles_;
    }
  }

  void append_numbers(std::size_t first, const char* what) {
    file_.require_numbers(first, "xyz", what);
    for (std::size_t i = first; i < first + 3; ++i) append_value(binary_, to_float(file_.word(i)));
  }

  // What should come next.
  const char* next() const {
    constexpr std::array kNext = {"solid", "endsolid", "outer loop", "endloop", "endfacet"};
    if (open_ == Open::loop && vertices_ < 3) return "vertex";
    return kNext[static_cast<std::size_t>(open_)];
  }

  TextFile file_;
  Open open_ = Open::nothing;
  long long vertices_ = 0;
  std::uint32_t triangles_ = 0;
  std::string binary_ = std::string(kHeaderBytes, ' ');
};

}  // namespace

std::string geometry_of_stl(const std::string& name, std::string content) {
  if (!is_binary(content)) return StlText(name, content).as_binary();
  check_binary(name, content);
  return content;
}

}  // namespace clipscope::experiments
