// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads Wavefront OBJ files.
//
// Source: Wavefront, "Advanced Visualizer Manual", appendix B1, "Object Files", version 3.0.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "experiments/scenes/mesh_builder.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

// Keywords of the specification (the last line: of versions before 3.0) and two that other programs
// write: lines that have no part in the polygons.
constexpr std::string_view kUnused[] = {
    "vp",     "cstype",     "deg",       "bmat",  "step",   "p",      "l",
    "curv",   "curv2",      "surf",      "parm",  "trim",   "hole",   "scrv",
    "sp",     "end",        "con",       "g",     "s",      "mg",     "o",
    "bevel",  "c_interp",   "d_interp",  "lod",   "usemtl", "mtllib", "usemap",
    "maplib", "shadow_obj", "trace_obj", "ctech", "stech",  "csh",    "bsp",
    "bzp",    "cdc",        "cdp",       "res",   "vw",     "t"};

constexpr std::uint32_t kNone = UINT32_MAX;

// Vertices, texture coordinates and normals: how many are defined, and the first references that
// were past that, each farther than those before; the end of the file decides about them.
struct Numbered {
  const char *singular, *plural;
  std::int64_t defined = 0;
  struct Ahead {
    std::size_t line;
    std::int64_t index;  // negative: so many back
  };
  std::vector<Ahead> ahead = {};

  std::string are_defined() const {
    return counted(defined, singular, plural) + (defined == 1 ? " is defined" : " are defined");
  }
};

class ObjReader {
 public:
  ObjReader(const std::string& name, std::string_view content)
      : name_(name), content_(content), file_(name, content, kForm), builder_(name) {}

  Mesh read() {
    while (file_.next_words()) read_line(file_.word(0));
    check_references_ahead();
    if (!has_faces_) file_.fail("the file has no face ('f' line), hence no triangle");
    if (has_corners_) add_corners();
    return builder_.finish(
        [this](std::size_t vertex, VertexValue what) { return place_of(vertex, what); });
  }

 private:
  static constexpr TextForm kForm{.comment = '#', .continuation = '\\'};

  // A vertex with the texture coordinate and the normal that a face gives it.
  struct Corner {
    std::uint32_t vertex, texture, normal;
    std::uint32_t next;  // of the same vertex
  };

  void read_line(std::string_view keyword) {
    if (keyword == "v") return read_vertex();
    if (keyword == "f" || keyword == "fo") return read_face();
    if (keyword == "vt") return read_texture();
    if (keyword == "vn") return read_normal();
    if (std::ranges::find(kUnused, keyword) != std::end(kUnused)) return;
    if (keyword == "call") file_.fail("'call' includes another file, which is not read");
    file_.fail(
        "'{}' is no OBJ keyword; v, vt, vn, f, another keyword of the format or a comment ('#') expected",
        keyword);
  }

  // The words after the keyword.
  std::size_t count() const { return file_.words().size() - 1; }

  void require_count(std::size_t least, std::size_t most, const char* what) const {
    if (least <= count() && count() <= most) return;
    file_.fail("{} has {}; at least {} expected", what, counted(count(), "entry", "entries"),
               least);
  }

  // x y z, with w (a rational vertex) or with r g b (a common extension).
  void read_vertex() {
    if (count() != 3 && count() != 4 && count() != 6) {
      file_.fail("the vertex has {}; 3 (x y z), 4 (x y z w) or 6 (x y z r g b) expected",
                 counted(count(), "number", "numbers"));
    }
    std::array<double, 3> position;
    std::array<float, 3> rounded;
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] = file_.number(k + 1, "xyz"[k], "the vertex");
      rounded[k] = to_float(file_.word(k + 1), position[k]);
    }
    ++kinds_[0].defined;
    if (count() != 4) return builder_.add_vertex(position, rounded);
    const double w = file_.number(4, 'w', "the vertex");
    if (w == 0) file_.fail("w of the vertex is 0, a point at infinity; a finite one was expected");
    builder_.add_vertex({position[0] / w, position[1] / w, position[2] / w});
  }

  void read_texture() {
    require_count(1, 3, "a texture coordinate");
    const double u = file_.number(1, 'u', "the texture coordinate");
    const double v = count() > 1 ? file_.number(2, 'v', "the texture coordinate") : 0;
    textures_.push_back({to_float(file_.word(1), u), count() > 1 ? to_float(file_.word(2), v) : 0});
    ++kinds_[1].defined;
  }

  void read_normal() {
    require_count(3, 3, "a normal");
    std::array<float, 3>& normal = normals_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] = to_float(file_.word(k + 1), file_.number(k + 1, "xyz"[k], "the normal"));
    }
    ++kinds_[2].defined;
  }

  // Each word is v, v/vt, v//vn or v/vt/vn.
  void read_face() {
    require_count(3, file_.words().size(), "a face");
    corners_of_face_.clear();
    for (std::size_t i = 1; i <= count(); ++i) {
      std::array<std::uint32_t, 3> indices = {kNone, kNone, kNone};
      std::string_view rest = file_.word(i);
      for (std::size_t kind = 0; kind < 3; ++kind) {
        const std::string_view reference = rest.substr(0, rest.find('/'));
        if (!reference.empty() || kind == 0) indices[kind] = resolve(reference, kinds_[kind]);
        const bool ends = reference.size() == rest.size();
        rest.remove_prefix(ends ? rest.size() : reference.size() + 1);
        if (ends) break;
      }
      if (!rest.empty()) {
        file_.fail("'{}' has more than three parts; v, v/vt, v//vn or v/vt/vn expected",
                   file_.word(i));
      }
      corners_of_face_.push_back(corner_of(indices));
    }
    builder_.add_polygon(corners_of_face_, file_.line());
    has_faces_ = true;
  }

  // The index, counted from 0, that a reference means. Texture coordinates or normals that the file
  // never defines are used for nothing, so that references to them are let be.
  std::uint32_t resolve(std::string_view word, Numbered& kind) {
    const std::int64_t given = file_.require_integer(word, "a vertex reference");
    if (given == 0) file_.fail("the face refers to {} 0; they are counted from 1", kind.singular);
    if (-given > kind.defined) {
      if (&kind == &kinds_[0] || kind.defined > 0) fail_back(file_.line(), -given, kind);
      if (kind.ahead.empty()) kind.ahead.push_back({file_.line(), given});
      return kNone;
    }
    if (given > kind.defined && (kind.ahead.empty() || given > kind.ahead.back().index)) {
      kind.ahead.push_back({file_.line(), given});
    }
    // A file of so many bytes defines fewer; such a reference fails in the end.
    const std::int64_t index = given > 0 ? given - 1 : kind.defined + given;
    return static_cast<std::uint32_t>(
        std::min({index, static_cast<std::int64_t>(content_.size()), std::int64_t{kNone} - 1}));
  }

  [[noreturn]] void fail_back(std::size_t line, std::int64_t back, const Numbered& kind) const {
    file_.fail_at(line, fmt::format("the face refers {} back, but only {} so far",
                                    counted(back, kind.singular, kind.plural), kind.are_defined()));
  }

  void check_references_ahead() const {
    for (const Numbered& kind : kinds_) {
      if (&kind != &kinds_[0] && kind.defined == 0) continue;
      for (const auto& [line, index] : kind.ahead) {
        if (index < 0) fail_back(line, -index, Numbered{kind.singular, kind.plural, 0, {}});
        if (index <= kind.defined) continue;
        file_.fail_at(line, fmt::format("the face refers to {} {}, but only {}", kind.singular,
                                        index, kind.are_defined()));
      }
    }
  }

  // The builder's vertex for a corner. As long as no face has more than vertices, these are one and
  // the same.
  std::uint32_t corner_of(const std::array<std::uint32_t, 3>& indices) {
    const auto [vertex, texture, normal] = indices;
    if (!has_corners_) {
      if (texture == kNone && normal == kNone) return vertex;
      make_corners();
    }
    if (vertex >= first_corner_.size()) first_corner_.resize(vertex + std::size_t{1}, kNone);
    for (std::uint32_t i = first_corner_[vertex]; i != kNone; i = corners_[i].next) {
      if (corners_[i].texture == texture && corners_[i].normal == normal) return i;
    }
    const auto added = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back({vertex, texture, normal, first_corner_[vertex]});
    return first_corner_[vertex] = added;
  }

  // Makes a corner of each vertex that a face may have referred to.
  void make_corners() {
    has_corners_ = true;
    if (!has_faces_ && corners_of_face_.empty()) return;
    const Numbered& vertices = kinds_[0];
    const std::int64_t ahead = vertices.ahead.empty() ? 0 : vertices.ahead.back().index;
    const std::int64_t count =
        std::min(std::max(vertices.defined, ahead), static_cast<std::int64_t>(content_.size()) + 1);
    for (std::uint32_t i = 0; i < count; ++i) {
      corners_.push_back({i, kNone, kNone, kNone});
      first_corner_.push_back(i);
    }
  }

  // Gives each corner a vertex of its own, and what the face says of it.
  void add_corners() {
    std::vector<std::uint32_t> sources;
    sources.reserve(corners_.size());
    for (const Corner& corner : corners_) sources.push_back(corner.vertex);
    builder_.copy_vertices(sources);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto [vertex, texture, normal, next] = corners_[i];
      if (texture != kNone && !textures_.empty()) {
        builder_.set_texture(i, textures_[texture][0], textures_[texture][1]);
      }
      if (normal != kNone && !normals_.empty()) {
        const auto& [x, y, z] = normals_[normal];
        builder_.set_normal(i, {x, y, z});
      }
    }
  }

  std::string place_of(std::size_t vertex, VertexValue what) const {
    const auto axis = static_cast<std::size_t>(what);
    if (axis < 3) {
      const std::size_t source = has_corners_ ? corners_[vertex].vertex : vertex;
      return fmt::format("{}:{}: {} of the vertex", name_, line_of("v", source), "xyz"[axis]);
    }
    if (what == VertexValue::normal) {
      return fmt::format("{}:{}: the normal's length", name_,
                         line_of("vn", corners_[vertex].normal));
    }
    return fmt::format("{}:{}: {} of the texture coordinate", name_,
                       line_of("vt", corners_[vertex].texture), "uv"[axis - 3]);
  }

  // The line of definition i, found by reading the file again: only errors need it.
  std::size_t line_of(std::string_view keyword, std::size_t i) const {
    TextFile again(name_, content_, kForm);
    for (std::size_t seen = 0; again.next_words();) {
      if (again.word(0) == keyword && seen++ == i) break;
    }
    return again.line();
  }

  const std::string& name_;
  std::string_view content_;
  TextFile file_;
  MeshBuilder builder_;
  std::array<Numbered, 3> kinds_ = {Numbered{"vertex", "vertices"},
                                    Numbered{"texture coordinate", "texture coordinates"},
                                    Numbered{"normal", "normals"}};
  std::vector<std::array<float, 2>> textures_;
  std::vector<std::array<float, 3>> normals_;
  bool has_faces_ = false;
  std::vector<std::uint32_t> corners_of_face_;
  bool has_corners_ = false;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> first_corner_;  // of each vertex
};

}  // namespace

Mesh read_obj(const std::string& name, std::string_view content) {
  return ObjReader(name, content).read();
}

}  // namespace clipscope::experiments
