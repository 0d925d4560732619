// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of Wavefront OBJ files.
//
// Source: Wavefront, "Advanced Visualizer Manual", appendix B1, "Object Files", version 3.0.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "experiments/scenes/mesh_checks.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

// Vertices, texture coordinates and normals: how many are defined, and references ahead of them.
struct Numbered {
  const char* singular;
  const char* plural;
  long long defined = 0;
  // References past what was defined at that line, each larger than those before; to be judged at the
  // end of the file.
  struct Ahead {
    std::size_t line;
    long long index;
  };
  std::vector<Ahead> ahead = {};
};

class ObjCheck {
 public:
  ObjCheck(const std::string& name, std::string_view content) : file_(name, content) {}

  std::string run() {
    while (file_.next_words('\\')) {
      check_line();
    }
    for (const Numbered& kind : kinds_) {
      for (const auto& [line, index] : kind.ahead) {
        if (index > kind.defined) {
          fail_beyond(line, index, kind);
        }
      }
    }
    if (faces_ == 0) {
      file_.fail("the file has no face ('f' line), hence no triangle");
    }
    return std::move(geometry_);
  }

 private:
  void check_line() {
    const std::string_view keyword = file_.word(0);
    if (keyword == "v") {
      check_vertex();
    } else if (keyword == "vt") {
      require_count(1, 3, "a texture coordinate");
      file_.require_numbers(1, std::string_view("uvw").substr(0, count()),
                            "the texture coordinate");
      ++kinds_[1].defined;
      keep_texture_coordinate();
    } else if (keyword == "vn") {
      require_count(3, 3, "a normal");
      file_.require_numbers(1, "xyz", "the normal");
      ++kinds_[2].defined;
      keep(3);
    } else if (keyword == "f") {
      require_count(3, file_.words().size(), "a face");
      check_references();
      ++faces_;
      keep(count());
    } else if (keyword == "l" || keyword == "p") {
      check_references();
    }
  }

  // assimp wants u and v where the format is content with u.
  void keep_texture_coordinate() {
    keep(std::min<std::size_t>(count(), 2));
    if (count() == 1) {
      geometry_.insert(geometry_.size() - 1, " 0");
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

  // The number of words after the keyword, up to a comment.
  std::size_t count() const {
    const auto& words = file_.words();
    const auto is_comment = [](std::string_view word) { return word.starts_with('#'); };
    return static_cast<std::size_t>(std::ranges::find_if(words, is_comment) - words.begin()) - 1;
  }

  void require_count(std::size_t least, std::size_t most, const char* what) const {
    if (count() < least || count() > most) {
      file_.fail(fmt::format("{} has {}; at least {} expected", what,
                             counted(static_cast<long long>(count()), "entry", "entries"), least));
    }
  }

  // x y z, with w (a rational vertex) or with r g b (a common extension).
  void check_vertex() {
    const std::size_t n = count();
    if (n != 3 && n != 4 && n != 6) {
      file_.fail(
          fmt::format("the vertex has {}; 3 (x y z), 4 (x y z w) or 6 (x y z r g b) expected",
                      counted(static_cast<long long>(n), "number", "numbers")));
    }
    file_.require_numbers(1, std::string_view(n == 6 ? "xyzrgb" : "xyzw").substr(0, n),
                          "the vertex");
    if (n == 4 && to_number(file_.word(4)) == 0.0) {
      file_.fail("w of the vertex is 0, a point at infinity; a finite one was expected");
    }
    ++kinds_[0].defined;
    keep(n == 4 ? 4 : 3);
  }

  // Each word is v, v/vt, v//vn or v/vt/vn.
  void check_references() {
    for (std::size_t i = 1; i <= count(); ++i) {
      std::string_view word = file_.word(i);
      for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        const std::size_t slash = word.find('/');
        const std::string_view reference = word.substr(0, slash);
        if (!reference.empty() || kind == 0) {
          check_reference(reference, kinds_[kind]);
        }
        if (slash == std::string_view::npos) {
          word = {};
          break;
        }
        word.remove_prefix(slash + 1);
      }
      if (!word.empty()) {
        file_.fail(fmt::format("'{}' has more than three parts; v, v/vt, v//vn or v/vt/vn expected",
                               file_.word(i)));
      }
    }
  }

  void check_reference(std::string_view word, Numbered& kind) {
    const long long index = file_.require_integer(word, "a vertex reference");
    if (index == 0) {
      file_.fail(
          fmt::format("the {} refers to {} 0; they are counted from 1", element(), kind.singular));
    }
    if (index < 0 && -index > kind.defined) {
      file_.fail(fmt::format("the {} refers {} back, but only {} so far", element(),
                             counted(-index, kind.singular, kind.plural), are_defined(kind)));
    }
    if (index > kind.defined && (kind.ahead.empty() || index > kind.ahead.back().index)) {
      kind.ahead.push_back({file_.line(), index});
    }
  }

  [[noreturn]] void fail_beyond(std::size_t line, long long index, const Numbered& kind) const {
    file_.fail_at(line, fmt::format("the face refers to {} {}, but only {}", kind.singular, index,
                                    are_defined(kind)));
  }

  static std::string are_defined(const Numbered& kind) {
    return counted(kind.defined, kind.singular, kind.plural) +
           (kind.defined == 1 ? " is defined" : " are defined");
  }

  const char* element() const { return file_.word(0) == "f" ? "face" : "line or point"; }

  TextFile file_;
  std::array<Numbered, 3> kinds_ = {Numbered{"vertex", "vertices"},
                                    Numbered{"texture coordinate", "texture coordinates"},
                                    Numbered{"normal", "normals"}};
  long long faces_ = 0;
  std::string geometry_;
};

}  // namespace

std::string geometry_of_obj(const std::string& name, std::string_view content) {
  return ObjCheck(name, content).run();
}

}  // namespace clipscope::experiments
