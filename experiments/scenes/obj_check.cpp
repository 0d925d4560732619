// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of Wavefront OBJ files.
//
// Source: Wavefront, "Advanced Visualizer Manual", appendix B1, "Object Files", version 3.0.
#include <algorithm>
#include <array>

#include "experiments/scenes/mesh_file.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

// Vertices, texture coordinates and normals: how many are defined, and references ahead of them.
struct Numbered {
  const char* singular;
  const char* plural;
  long long defined = 0;
  // References past what was defined at that line, each larger than those before; the end of the
  // file decides about them.
  struct Ahead {
    std::size_t line;
    long long index;
  };
  std::vector<Ahead> ahead = {};

  std::string are_defined() const {
    return counted(defined, singular, plural) + (defined == 1 ? " is defined" : " are defined");
  }
};

class ObjCheck {
 public:
  ObjCheck(const std::string& name, std::string_view content) : file_(name, content) {}

  std::string run() {
    while (file_.next_words('\\')) check_line();
    for (const Numbered& kind : kinds_) {
      for (const auto& [line, index] : kind.ahead) {
        if (index <= kind.defined) continue;
        file_.fail_at(line, fmt::format("the face refers to {} {}, but only {}", kind.singular,
                                        index, kind.are_defined()));
      }
    }
    if (faces_ == 0) file_.fail("the file has no face ('f' line), hence no triangle");
    return std::move(geometry_);
  }

 private:
  void check_line() {
    const auto is_comment = [](std::string_view word) { return word.starts_with('#'); };
    const auto& words = file_.words();
    count_ = static_cast<std::size_t>(std::ranges::find_if(words, is_comment) - words.begin()) - 1;
    const std::string_view keyword = file_.word(0);
    if (keyword == "v") {
      check_vertex();
      keep(count_ == 4 ? 4 : 3);
    } else if (keyword == "vt") {
      require_count(1, 3, "a texture coordinate");
      define(kinds_[1], "uvw", "the texture coordinate");
      keep(std::min<std::size_t>(count_, 2));
      // assimp wants u and v where the format is content with u.
      if (count_ == 1) geometry_.insert(geometry_.size() - 1, " 0");
    } else if (keyword == "vn") {
      require_count(3, 3, "a normal");
      define(kinds_[2], "xyz", "the normal");
      keep(3);
    } else if (keyword == "f") {
      require_count(3, words.size(), "a face");
      check_references();
      ++faces_;
      keep(count_);
    } else if (keyword == "l" || keyword == "p") {
      check_references();
    }
  }

  // Passes on the keyword and the first n words after it. assimp takes ".5" for no number.
  void keep(std::size_t n) {
    for (std::size_t i = 0; i <= n; ++i) {
      geometry_ += file_.word(i)[0] == '.' ? "0" : "";
      geometry_ += file_.word(i);
      geometry_ += i < n ? ' ' : '\n';
    }
  }

  void require_count(std::size_t least, std::size_t most, const char* what) const {
    if (least <= count_ && count_ <= most) return;
    file_.fail("{} has {}; at least {} expected", what, counted(count_, "entry", "entries"), least);
  }

  void define(Numbered& kind, std::string_view names, const char* what) {
    file_.require_numbers(1, names.substr(0, count_), what);
    ++kind.defined;
  }

  // x y z, with w (a rational vertex) or with r g b (a common extension).
  void check_vertex() {
    if (count_ != 3 && count_ != 4 && count_ != 6) {
      file_.fail("the vertex has {}; 3 (x y z), 4 (x y z w) or 6 (x y z r g b) expected",
                 counted(count_, "number", "numbers"));
    }
    define(kinds_[0], count_ == 6 ? "xyzrgb" : "xyzw", "the vertex");
    if (count_ == 4 && to_number(file_.word(4)) == 0.0) {
      file_.fail("w of the vertex is 0, a point at infinity; a finite one was expected");
    }
  }

  // Each word is v, v/vt, v//vn or v/vt/vn.
  void check_references() {
    for (std::size_t i = 1; i <= count_; ++i) {
      std::string_view rest = file_.word(i);
      bool ends = false;
      for (std::size_t kind = 0; kind < kinds_.size() && !ends; ++kind) {
        const std::string_view reference = rest.substr(0, rest.find('/'));
        if (!reference.empty() || kind == 0) check_reference(reference, kinds_[kind]);
        ends = reference.size() == rest.size();
        rest.remove_prefix(ends ? rest.size() : reference.size() + 1);
      }
      if (!rest.empty()) {
        file_.fail("'{}' has more than three parts; v, v/vt, v//vn or v/vt/vn expected",
                   file_.word(i));
      }
    }
  }

  void check_reference(std::string_view word, Numbered& kind) {
    const char* element = file_.word(0) == "f" ? "face" : "line or point";
    const long long index = file_.require_integer(word, "a vertex reference");
    if (index == 0) {
      file_.fail("the {} refers to {} 0; they are counted from 1", element, kind.singular);
    }
    if (index < 0 && -index > kind.defined) {
      file_.fail("the {} refers {} back, but only {} so far", element,
                 counted(-index, kind.singular, kind.plural), kind.are_defined());
    }
    if (index > kind.defined && (kind.ahead.empty() || index > kind.ahead.back().index)) {
      kind.ahead.push_back({file_.line(), index});
    }
  }

  TextFile file_;
  std::size_t count_ = 0;  // of the words after the line's keyword, up to a comment
  std::array<Numbered, 3> kinds_ = {Numbered{"vertex", "vertices"},
                                    Numbered{"texture coordinate", "texture coordinates"},
                                    Numbered{"normal", "normals"}};
  long long faces_ = 0;
  std::string geometry_;
};

}  // namespace

std::string geometry_of_obj(const std::string& name, std::string content) {
  return ObjCheck(name, content).run();
}

}  // namespace clipscope::experiments
