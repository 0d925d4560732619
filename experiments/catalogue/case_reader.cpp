// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/case_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "experiments/hex_float.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/text_file.hpp"
#include "reference/convex.hpp"

namespace clipscope::experiments {
namespace {

using reference::InputVertex;
using reference::Rational;
using reference::Verdict;

using Words = std::vector<std::string_view>;

constexpr std::size_t kMostPolygonVertices = 32;

// A decimal or hex float. Decimals are rounded to double.
std::optional<double> parse_number(std::string_view word) {
  const bool negative = word.starts_with('-');
  const std::string_view digits = negative ? word.substr(1) : word;
  if (!digits.starts_with("0x")) {
    return to_number(word);
  }
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data() + 2, end, value, std::chars_format::hex);
  if (stop != end || error != std::errc{} || digits.size() == 2) {
    return std::nullopt;
  }
  return negative ? -value : value;
}

std::optional<Rational> parse_ratio(std::string_view word) {
  const std::size_t slash = word.find('/');
  const auto numerator = to_integer(word.substr(0, slash));
  const auto denominator = slash == std::string_view::npos ? 1 : to_integer(word.substr(slash + 1));
  if (!numerator || !denominator || *denominator <= 0) {
    return std::nullopt;
  }
  const Rational n(static_cast<long>(*numerator)), d(static_cast<long>(*denominator));
  return Rational(n / d);
}

std::optional<DepthRange> parse_depth(std::string_view word) {
  if (word == "gl") return DepthRange::minus_one_to_one;
  if (word == "zero_to_one") return DepthRange::zero_to_one;
  if (word == "reversed") return DepthRange::reversed;
  return std::nullopt;
}

std::optional<Primitive> parse_primitive(std::string_view word) {
  if (word == "point") return Primitive::point;
  if (word == "segment") return Primitive::segment;
  if (word == "triangle") return Primitive::triangle;
  if (word == "polygon") return Primitive::polygon;
  return std::nullopt;
}

class CaseReader {
 public:
  CaseReader(const std::string& file, std::string_view text)
      : file_(file), theme_(std::filesystem::path(file).stem().string()), text_(file_, text) {}

  std::vector<HardCase> read() {
    while (text_.next_words()) {
      if (!text_.word(0).starts_with('#')) {
        read_line();
      }
    }
    finish();
    return std::move(cases_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { text_.fail(message); }

  void read_line() {
    const std::string_view key = text_.word(0);
    if (key == "case") {
      finish();
      start();
      return;
    }
    if (!current_) {
      fail(fmt::format("found '{}' before any case; expected 'case NAME'", key));
    }
    const bool may_repeat = key == "vertex" || key == "hand";
    if (!may_repeat && !seen_.insert(std::string(key)).second) {
      fail(fmt::format("found a second '{}' in case '{}'; expected one", key, current_->name));
    }
    read_property(key);
  }

  void read_property(std::string_view key) {
    if (key == "source") return read_text(current_->source);
    if (key == "why") return read_text(current_->why);
    if (key == "primitive") return read_primitive();
    if (key == "space") return read_space();
    if (key == "depth_clamp") return read_depth_clamp();
    if (key == "clip_distances") return read_clip_distances();
    if (key == "vertex") return read_vertex();
    if (key == "expect") return read_expected();
    if (key == "hand") return read_by_hand();
    fail(
        fmt::format("found '{}'; expected case, source, why, primitive, space, depth_clamp, "
                    "clip_distances, vertex, expect or hand",
                    key));
  }

  void start() {
    require_words(2, "case NAME");
    current_.emplace();
    current_->name = theme_ + "/" + std::string(text_.word(1));
    current_->file = file_;
    current_->line = text_.line();
    seen_.clear();
    given_attributes_.reset();
  }

  void require_words(std::size_t count, const char* form) const {
    if (text_.words().size() != count) {
      fail(fmt::format("found {} words; expected '{}'", text_.words().size(), form));
    }
  }

  void read_text(std::string& to) const {
    for (std::size_t i = 1; i < text_.words().size(); ++i) {
      to += (i > 1 ? " " : "") + std::string(text_.word(i));
    }
    if (to.empty()) {
      fail(fmt::format("found nothing after '{}'; expected a text", text_.word(0)));
    }
  }

  void read_primitive() {
    require_words(2, "primitive point|segment|triangle|polygon");
    const auto primitive = parse_primitive(text_.word(1));
    if (!primitive) {
      fail(fmt::format("found primitive '{}'; expected point, segment, triangle or polygon",
                       text_.word(1)));
    }
    current_->primitive = *primitive;
  }

  // A number that a float holds exactly.
  double number(std::string_view word) const {
    const std::optional<double> value = parse_number(word);
    if (!value) {
      fail(fmt::format("found '{}'; expected a number such as -0.25 or a hex float such as -0x1p-2",
                       word));
    }
    const std::string defect = defect_of(*value);
    if (!defect.empty()) {
      fail(fmt::format("found '{}', {}; expected a finite number", word, defect));
    }
    const auto as_float = static_cast<float>(*value);
    if (double{as_float} != *value) {
      fail(
          fmt::format("found '{}', which no float holds; expected one that does: the nearest is {}",
                      word, hex_float(as_float)));
    }
    return *value;
  }

  DepthRange depth(std::string_view word) const {
    const auto range = parse_depth(word);
    if (!range) {
      fail(fmt::format("found depth range '{}'; expected gl, zero_to_one or reversed", word));
    }
    return *range;
  }

  void read_space() {
    const Words& words = text_.words();
    if (words.size() == 3 && words[1] == "clip") {
      current_->space = Space::clip;
      set_depth(depth(words[2]));
    } else if (words.size() == 10 && words[1] == "view" && words[2] == "perspective") {
      read_frustum(ProjectionKind::perspective);
    } else if (words.size() == 12 && words[1] == "view" && words[2] == "parallel") {
      read_frustum(ProjectionKind::parallel);
    } else {
      fail(
          "expected 'space clip DEPTH', 'space view perspective LEFT RIGHT BOTTOM TOP NEAR FAR "
          "DEPTH' "
          "or 'space view parallel LEFT RIGHT BOTTOM TOP NEAR FAR SHEAR_X SHEAR_Y DEPTH'");
    }
  }

  void set_depth(DepthRange depth) { current_->frustum.depth = current_->volume.depth = depth; }

  void read_frustum(ProjectionKind kind) {
    const Words& words = text_.words();
    current_->space = Space::view;
    Frustum<double>& f = current_->frustum;
    f.kind = kind;
    f.left = number(words[3]);
    f.right = number(words[4]);
    f.bottom = number(words[5]);
    f.top = number(words[6]);
    f.near = number(words[7]);
    f.infinite_far = words[8] == "inf";
    f.far = f.infinite_far ? 0 : number(words[8]);
    if (kind == ProjectionKind::parallel) {
      f.shear_x = number(words[9]);
      f.shear_y = number(words[10]);
    }
    set_depth(depth(words.back()));
    if (!is_valid(f)) {
      fail(
          "the frustum encloses no volume; expected left < right, bottom < top, near < far, and in "
          "perspective 0 < near, else a finite far");
    }
  }

  void read_depth_clamp() {
    require_words(1, "depth_clamp");
    current_->volume.depth_clamp = true;
  }

  void read_clip_distances() {
    require_words(2, "clip_distances N");
    const long long n = text_.require_integer(text_.word(1), "the number of clip distances");
    if (n < 1 || n > kMaxClipDistances) {
      fail(fmt::format("found {} clip distances; expected 1 to {}", n, kMaxClipDistances));
    }
    current_->volume.clip_distances = static_cast<int>(n);
  }

  // vertex X Y Z [W] [| ATTRIBUTE ...]
  void read_vertex() {
    if (!seen_.contains("space")) {
      fail("found a vertex before the line 'space ...'; expected it after");
    }
    const Words& words = text_.words();
    const std::size_t dimension = current_->space == Space::view ? 3 : 4;
    const auto bar = std::ranges::find(words, "|");
    const auto coordinates = static_cast<std::size_t>(bar - words.begin()) - 1;
    if (coordinates != dimension) {
      fail(fmt::format("found {} coordinates; expected {} in {} space", coordinates, dimension,
                       dimension == 3 ? "view" : "clip"));
    }
    InputVertex vertex;
    for (std::size_t i = 0; i < dimension; ++i) {
      vertex.position[i] = number(words[1 + i]);
    }
    const Words attributes(bar == words.end() ? bar : bar + 1, words.end());
    require_attributes(attributes.size());
    for (std::size_t k = 0; k < attributes.size(); ++k) {
      vertex.attributes[k] = number(attributes[k]);
    }
    current_->vertices.push_back(vertex);
  }

  void require_attributes(std::size_t count) {
    if (count > kMaxAttributes) {
      fail(fmt::format("found {} attributes; expected at most {}", count, kMaxAttributes));
    }
    if (given_attributes_ && *given_attributes_ != count) {
      fail(fmt::format("found {} attributes; expected {} as for the first vertex", count,
                       *given_attributes_));
    }
    given_attributes_ = count;
  }

  // expect rejected | accepted [N] | clipped N
  void read_expected() {
    const Words& words = text_.words();
    const std::string_view verdict = words.size() > 1 ? words[1] : std::string_view();
    ExactOutcome& expected = current_->expected;
    const bool has_count = words.size() == 3;
    if (verdict == "rejected" && !has_count) {
      expected.verdict = Verdict::rejected;
    } else if (verdict == "accepted") {
      expected.verdict = Verdict::accepted;
    } else if (verdict == "clipped" && has_count) {
      expected.verdict = Verdict::clipped;
    } else {
      fail("expected 'expect rejected', 'expect accepted [N]' or 'expect clipped N'");
    }
    expected.vertices =
        has_count ? static_cast<std::size_t>(text_.require_integer(words[2], "the vertex count"))
                  : 0;
    expected_line_ = text_.line();
  }

  // hand X Y Z INV_W
  void read_by_hand() {
    require_words(5, "hand X Y Z INV_W");
    auto& vertex = current_->by_hand.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto ratio = parse_ratio(text_.word(i + 1));
      if (!ratio) {
        fail(fmt::format("found '{}'; expected a whole number or a ratio such as -2/3",
                         text_.word(i + 1)));
      }
      vertex[i] = *ratio;
    }
  }

  void finish() {
    if (!current_) {
      return;
    }
    for (const char* key : {"source", "why", "primitive", "space"}) {
      if (!seen_.contains(key)) {
        fail_case(fmt::format("found no line '{}'; expected one", key));
      }
    }
    check_vertices();
    fill_attributes();
    check_expected();
    cases_.push_back(std::move(*current_));
    current_.reset();
  }

  [[noreturn]] void fail_case(const std::string& message) const {
    text_.fail_at(current_->line, fmt::format("case '{}': {}", current_->name, message));
  }

  void check_vertices() const {
    const std::size_t found = current_->vertices.size();
    if (current_->primitive == Primitive::polygon) {
      if (found < 3 || found > kMostPolygonVertices) {
        fail_case(fmt::format("found {} vertices; expected 3 to {} of a polygon", found,
                              kMostPolygonVertices));
      }
    } else if (found != vertices_of(current_->primitive)) {
      fail_case(fmt::format("found {} vertices; expected {} of a {}", found,
                            vertices_of(current_->primitive), to_string(current_->primitive)));
    }
    const auto distances = static_cast<std::size_t>(current_->volume.clip_distances);
    if (*given_attributes_ < distances) {
      fail_case(fmt::format("found {} attributes; expected at least the {} clip distances",
                            *given_attributes_, distances));
    }
  }

  void fill_attributes() {
    const auto given = static_cast<int>(*given_attributes_);
    current_->attribute_count = std::max(given, kSceneAttributes);
    for (std::size_t i = 0; i < current_->vertices.size(); ++i) {
      InputVertex& v = current_->vertices[i];
      std::array<double, 4> filling = v.position;
      if (current_->primitive != Primitive::polygon) {
        filling = {0, 0, 0, 1};
        filling[i] = 1;
      }
      for (int k = given; k < kSceneAttributes; ++k) {
        v.attributes[k] = filling[k - given];
      }
    }
    if (current_->primitive == Primitive::polygon &&
        !reference::is_planar_convex(current_->vertices, current_->attribute_count)) {
      fail_case(
          "the vertices are no planar convex polygon with affine attributes; expected one, or "
          "triangles");
    }
  }

  void check_expected() {
    const ExactOutcome exact = exact_outcome(*current_);
    ExactOutcome& expected = current_->expected;
    if (!seen_.contains("expect")) {
      expected = exact;
      return;
    }
    if (expected.verdict == Verdict::accepted && expected.vertices == 0) {
      expected.vertices = current_->vertices.size();
    }
    if (expected != exact) {
      text_.fail_at(expected_line_,
                    fmt::format("case '{}': found '{}'; the exact outcome is '{}'", current_->name,
                                to_string(expected), to_string(exact)));
    }
  }

  const std::string file_, theme_;
  TextFile text_;
  std::vector<HardCase> cases_;
  std::optional<HardCase> current_;
  std::set<std::string> seen_;  // keys of the current case
  std::optional<std::size_t> given_attributes_;
  std::size_t expected_line_ = 0;
};

}  // namespace

std::vector<HardCase> read_cases(const std::string& file, std::string_view text) {
  return CaseReader(file, text).read();
}

}  // namespace clipscope::experiments
