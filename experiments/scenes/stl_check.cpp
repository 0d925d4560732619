// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of STL files, text and binary.
//
// Source: 3D Systems, "Stereolithography Interface Specification", 1989, as given by Burns, "Automated
// Fabrication", 1993, section 6.5.
#include <fmt/core.h>

#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <utility>

#include "experiments/errors.hpp"
#include "experiments/scenes/mesh_checks.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read without a byte swap");

constexpr std::size_t kHeaderBytes = 84, kCountOffset = 80;
constexpr std::size_t kTriangleBytes = 50, kAttributeBytes = 2;

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return lower;
}

template <class T>
T value_at(std::string_view content, std::size_t offset) {
  T value;
  std::memcpy(&value, content.data() + offset, sizeof value);
  return value;
}

std::size_t announced_bytes(std::string_view content) {
  return kHeaderBytes +
         kTriangleBytes * std::size_t{value_at<std::uint32_t>(content, kCountOffset)};
}

// A binary file may begin with "solid" too, and a text file may be of any size.
bool is_binary(std::string_view content) {
  if (content.size() >= kHeaderBytes && announced_bytes(content) == content.size()) {
    return true;
  }
  const std::size_t start = content.find_first_not_of(" \t\r\n");
  return start == std::string_view::npos || lower_case(content.substr(start, 5)) != "solid" ||
         content.substr(0, 512).find('\0') != std::string_view::npos;
}

void check_binary(const std::string& name, std::string_view content) {
  if (content.size() < kHeaderBytes) {
    throw InputError(
        fmt::format("{}: {} bytes are too few for an STL file: neither text ('solid ...') "
                    "nor the {} bytes of a binary header",
                    name, content.size(), kHeaderBytes));
  }
  const std::uint32_t triangles = value_at<std::uint32_t>(content, kCountOffset);
  if (announced_bytes(content) != content.size()) {
    throw InputError(
        fmt::format("{}: the binary header announces {} triangles, which take {} bytes, "
                    "but the file has {}",
                    name, triangles, announced_bytes(content), content.size()));
  }
  if (triangles == 0) {
    throw InputError(fmt::format("{}: the file has no triangles", name));
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t offset = kHeaderBytes + kTriangleBytes * i + 12 + 4 * k;
      const std::string defect = defect_of(value_at<float>(content, offset));
      if (!defect.empty()) {
        throw InputError(
            fmt::format("{}: triangle {}, vertex {}: {} is {}; a finite number was expected", name,
                        i, k / 3, "xyz"[k % 3], defect));
      }
    }
  }
}

// Turns text into the binary form. One state per kind of line: what has been opened and not been
// closed yet.
class TextReader {
 public:
  TextReader(const std::string& name, std::string_view content) : file_(name, content) {}

  std::string run() {
    while (file_.next_words()) {
      check_line(lower_case(file_.word(0)));
    }
    if (state_ != State::outside) {
      file_.fail(
          fmt::format("the file ends here, but '{}' is missing: it is truncated", closing()));
    }
    if (triangles_ == 0) {
      file_.fail("the file has no triangles ('facet' lines)");
    }
    std::memcpy(binary_.data() + kCountOffset, &triangles_, sizeof triangles_);
    return std::move(binary_);
  }

 private:
  enum class State { outside, solid, facet, loop, loop_closed };

  void check_line(const std::string& keyword) {
    if (keyword == "solid") {
      step(State::outside, State::solid);
    } else if (keyword == "facet") {
      step(State::solid, State::facet);
      require_words(5, "facet normal <x> <y> <z>");
      append_numbers(2, "the normal");
    } else if (keyword == "outer") {
      step(State::facet, State::loop);
      require_words(2, "outer loop");
      vertices_ = 0;
    } else if (keyword == "vertex") {
      step(State::loop, State::loop);
      append_numbers(1, "the vertex");
      ++vertices_;
    } else if (keyword == "endloop") {
      step(State::loop, State::loop_closed);
      require_three();
    } else if (keyword == "endfacet") {
      step(State::loop_closed, State::solid);
      binary_.append(kAttributeBytes, '\0');
      ++triangles_;
    } else if (keyword == "endsolid") {
      step(State::solid, State::outside);
    } else {
      file_.fail(
          fmt::format("'{}' is no STL keyword; '{}' was expected", file_.word(0), closing()));
    }
  }

  void step(State from, State to) {
    if (state_ != from) {
      file_.fail(fmt::format("'{}' comes too early or too late; '{}' was expected", file_.word(0),
                             closing()));
    }
    state_ = to;
  }

  void require_words(std::size_t n, const char* pattern) const {
    if (file_.words().size() != n) {
      file_.fail(fmt::format("'{}' expected", pattern));
    }
  }

  void append_numbers(std::size_t first, const char* what) {
    file_.require_numbers(first, "xyz", what);
    for (std::size_t i = first; i < first + 3; ++i) {
      const float value = to_float(file_.word(i));
      binary_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }

  void require_three() const {
    if (vertices_ != 3) {
      file_.fail(
          fmt::format("the facet has {}; 3 expected", counted(vertices_, "vertex", "vertices")));
    }
  }

  const char* closing() const {
    switch (state_) {
      case State::outside: return "solid";
      case State::solid: return "endsolid";
      case State::facet: return "outer loop";
      case State::loop: return vertices_ < 3 ? "vertex" : "endloop";
      case State::loop_closed: return "endfacet";
    }
    return "";
  }

  TextFile file_;
  State state_ = State::outside;
  long long vertices_ = 0;
  std::uint32_t triangles_ = 0;
  std::string binary_ = std::string(kHeaderBytes, ' ');
};

}  // namespace

std::string geometry_of_stl(const std::string& name, std::string content) {
  if (is_binary(content)) {
    check_binary(name, content);
    return content;
  }
  return TextReader(name, content).run();
}

}  // namespace clipscope::experiments
