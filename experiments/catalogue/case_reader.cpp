// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the text format of hard cases (tests/corpus/README.md) and checks each against the exact
// reference.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/table/hex_float.hpp"
#include "reference/convex.hpp"

namespace clipscope::experiments {
namespace {

using reference::InputVertex;
using reference::Rational;
using reference::Verdict;

using Words = std::vector<std::string_view>;

constexpr std::size_t kMostPolygonVertices = 32;

std::optional<Rational> parse_ratio(std::string_view word) {
  const std::size_t slash = word.find('/');
  const auto numerator = to_integer(word.substr(0, slash));
  const auto denominator = slash == std::string_view::npos ? 1 : to_integer(word.substr(slash + 1));
  if (!numerator || !denominator || *denominator <= 0) return std::nullopt;
  const Rational n(static_cast<long>(*numerator)), d(static_cast<long>(*denominator));
  return Rational(n / d);
}

class CaseReader {
 public:
  CaseReader(const std::string& file, std::string_view text)
      : file_(file), theme_(std::filesystem::path(file).stem().string()), text_(file_, text) {}

  std::vector<HardCase> read() {
    while (text_.next_words()) {
      if (!text_.word(0).starts_with('#')) read_line();
    }
    finish();
    if (!inexact_.empty()) refuse_inexact();
    return std::move(cases_);
  }

 private:
  template <class... Args>
  void require(bool holds, fmt::format_string<Args...> form, Args&&... args) const {
    if (!holds) text_.fail(form, std::forward<Args>(args)...);
  }

  // Complains about the case as a whole.
  template <class... Args>
  void require_of_case(bool holds, fmt::format_string<Args...> form, Args&&... args) const {
    if (holds) return;
    text_.fail_at(case_.line, fmt::format("case '{}': {}", case_.name,
                                          fmt::format(form, std::forward<Args>(args)...)));
  }

  void read_line() {
    const std::string_view key = text_.word(0);
    if (key == "case") return start();
    require(is_open_, "found '{}' before any case; expected 'case NAME'", key);
    const bool may_repeat = key == "vertex" || key == "hand";
    require(seen_.insert(std::string(key)).second || may_repeat,
            "found a second '{}' in case '{}'; expected one", key, case_.name);
    read_property(key);
  }

  void read_property(std::string_view key) {
    if (key == "source") return read_text(case_.source);
    if (key == "why") return read_text(case_.why);
    if (key == "primitive") return read_primitive();
    if (key == "space") return read_space();
    if (key == "depth_clamp") return read_depth_clamp();
    if (key == "clip_distances") return read_clip_distances();
    if (key == "half_open") return read_half_open();
    if (key == "vertex") return read_vertex();
    if (key == "expect") return read_expected();
    if (key == "hand") return read_by_hand();
    text_.fail(
        "found '{}'; expected case, source, why, primitive, space, depth_clamp, clip_distances, half_open, vertex, expect or hand",
        key);
  }

  void start() {
    finish();
    require_words(2, "case NAME");
    is_open_ = true;
    case_ = HardCase();
    case_.name = theme_ + "/" + std::string(text_.word(1));
    case_.file = file_;
    case_.line = text_.line();
    seen_.clear();
    given_attributes_.reset();
  }

  void require_words(std::size_t count, const char* form) const {
    require(text_.words().size() == count, "found {} words; expected '{}'", text_.words().size(),
            form);
  }

  void read_text(std::string& to) const {
    to = fmt::format("{}", fmt::join(text_.words().begin() + 1, text_.words().end(), " "));
    require(!to.empty(), "found nothing after '{}'; expected a text", text_.word(0));
  }

  // The enumerator of that name.
  template <class E, std::size_t N>
  E one_of(const std::array<std::string_view, N>& names, std::string_view word,
           const char* what) const {
    const auto found = std::ranges::find(names, word);
    if (found == names.end()) {
      text_.fail("found {} '{}'; expected {} or {}", what, word,
                 fmt::join(names.begin(), names.end() - 1, ", "), names.back());
    }
    return static_cast<E>(found - names.begin());
  }

  void read_primitive() {
    require_words(2, "primitive point|segment|triangle|polygon");
    case_.primitive = one_of<Primitive>(names_of(Primitive{}), text_.word(1), "primitive");
  }

  // A number that a float holds exactly; others are noted, to be refused all at once.
  double number(std::string_view word) {
    const std::optional<double> value = to_number_or_hex(word);
    require(value.has_value(),
            "found '{}'; expected a number such as -0.25 or a hex float such as -0x1p-2", word);
    const std::string defect = defect_of(*value);
    require(defect.empty(), "found '{}', {}; expected a finite number", word, defect);
    const auto as_float = static_cast<float>(*value);
    if (double{as_float} != *value) {
      inexact_.push_back(
          fmt::format("{}:{}: {} -> {}", file_, text_.line(), word, hex_float(as_float)));
    }
    return as_float;
  }

  [[noreturn]] void refuse_inexact() const {
    constexpr std::size_t kMost = 20;
    const std::size_t shown = std::min(inexact_.size(), kMost);
    const std::string rest =
        shown < inexact_.size() ? fmt::format("\n  and {} more", inexact_.size() - shown) : "";
    refuse(
        file_, "{} that no float holds; expected ones that do, the nearest are:\n  {}{}",
        counted(inexact_.size(), "number was found", "numbers were found"),
        fmt::join(inexact_.begin(), inexact_.begin() + static_cast<std::ptrdiff_t>(shown), "\n  "),
        rest);
  }

  void read_space() {
    const Words& words = text_.words();
    const auto is = [&](std::size_t size, std::string_view space, std::string_view kind) {
      return words.size() == size && words[1] == space && (kind.empty() || words[2] == kind);
    };
    if (is(3, "clip", "")) {
      case_.space = Space::clip;
    } else if (is(10, "view", "perspective") || is(12, "view", "parallel")) {
      case_.space = Space::view;
      read_frustum(case_.frustum);
    } else {
      text_.fail(
          "expected 'space clip DEPTH', 'space view perspective LEFT RIGHT BOTTOM TOP NEAR FAR DEPTH' or 'space view parallel LEFT RIGHT BOTTOM TOP NEAR FAR SHEAR_X SHEAR_Y DEPTH'");
    }
    case_.volume.depth = one_of<DepthRange>(kDepthNames, words.back(), "depth range");
    case_.frustum.depth = case_.volume.depth;
    require(
        case_.space == Space::clip || is_valid(case_.frustum),
        "the frustum encloses no volume; expected left < right, bottom < top, near < far, and in perspective 0 < near, else a finite far");
  }

  void read_frustum(Frustum<double>& f) {
    const Words& words = text_.words();
    const bool parallel = words[2] == "parallel";
    f.kind = parallel ? ProjectionKind::parallel : ProjectionKind::perspective;
    auto word = words.begin() + 3;
    for (double* bound : {&f.left, &f.right, &f.bottom, &f.top, &f.near}) *bound = number(*word++);
    f.infinite_far = words[8] == "inf";
    f.far = f.infinite_far ? 0 : number(words[8]);
    f.shear_x = parallel ? number(words[9]) : 0;
    f.shear_y = parallel ? number(words[10]) : 0;
  }

  void read_depth_clamp() {
    const bool is_alone = text_.words().size() == 1;
    if (!is_alone) require_words(2, "depth_clamp [near|far]");
    const std::string_view plane = is_alone ? "" : text_.word(1);
    require(is_alone || plane == "near" || plane == "far",
            "found '{}'; expected 'depth_clamp', for both planes, or it and near or far", plane);
    case_.volume.depth_clamp = {plane != "far", plane != "near"};
  }

  void read_clip_distances() {
    require_words(2, "clip_distances N");
    const long long n = text_.require_integer(text_.word(1), "the number of clip distances");
    require(1 <= n && n <= kMaxClipDistances, "found {} clip distances; expected 1 to {}", n,
            kMaxClipDistances);
    case_.volume.clip_distances = static_cast<int>(n);
  }

  // half_open [SIDE ...]
  void read_half_open() {
    OpenSides& open = case_.volume.open_sides;
    if (text_.words().size() == 1) open = true;
    for (std::size_t i = 1; i < text_.words().size(); ++i) {
      bool* const side = find_side(open, text_.word(i));
      require(
          side != nullptr,
          "found '{}'; expected 'half_open', for right and bottom, or it and some of left, right, bottom and top",
          text_.word(i));
      require(!*side, "found the side '{}' twice; expected it once", text_.word(i));
      *side = true;
    }
  }

  // vertex X Y Z [W] [| ATTRIBUTE ...]
  void read_vertex() {
    require(seen_.contains("space"),
            "found a vertex before the line 'space ...'; expected it after");
    const Words& words = text_.words();
    const std::size_t dimension = case_.space == Space::view ? 3 : 4;
    const auto bar = std::ranges::find(words, "|");
    const auto coordinates = static_cast<std::size_t>(bar - words.begin()) - 1;
    require(coordinates == dimension, "found {} coordinates; expected {} in {} space", coordinates,
            dimension, dimension == 3 ? "view" : "clip");
    InputVertex& vertex = case_.vertices.emplace_back();
    for (std::size_t i = 0; i < dimension; ++i) vertex.position[i] = number(words[1 + i]);
    const Words attributes(bar == words.end() ? bar : bar + 1, words.end());
    require_attributes(attributes.size());
    for (std::size_t k = 0; k < attributes.size(); ++k) {
      vertex.attributes[k] = number(attributes[k]);
    }
  }

  void require_attributes(std::size_t count) {
    require(count <= kMaxAttributes, "found {} attributes; expected at most {}", count,
            kMaxAttributes);
    const std::size_t first = given_attributes_.value_or(count);
    require(count == first, "found {} attributes; expected {} as for the first vertex", count,
            first);
    given_attributes_ = count;
  }

  // expect rejected | accepted [N] | clipped N
  void read_expected() {
    const Words& words = text_.words();
    const std::string_view verdict = words.size() > 1 ? words[1] : std::string_view();
    const bool has_count = words.size() == 3;
    if (verdict == "rejected" && !has_count) {
      case_.expected.verdict = Verdict::rejected;
    } else if (verdict == "accepted") {
      case_.expected.verdict = Verdict::accepted;
    } else if (verdict == "clipped" && has_count) {
      case_.expected.verdict = Verdict::clipped;
    } else {
      text_.fail("expected 'expect rejected', 'expect accepted [N]' or 'expect clipped N'");
    }
    const auto count = has_count ? text_.require_integer(words[2], "the vertex count") : 0;
    case_.expected.vertices = static_cast<std::size_t>(count);
    expected_line_ = text_.line();
  }

  // hand X Y Z INV_W
  void read_by_hand() {
    require_words(5, "hand X Y Z INV_W");
    auto& vertex = case_.by_hand.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto ratio = parse_ratio(text_.word(i + 1));
      require(ratio.has_value(), "found '{}'; expected a whole number or a ratio such as -2/3",
              text_.word(i + 1));
      vertex[i] = *ratio;
    }
  }

  void finish() {
    // What is expected was said of the numbers given: without them there is nothing to check.
    if (!is_open_ || !inexact_.empty()) return;
    for (const char* key : {"primitive", "space"}) {
      require_of_case(seen_.contains(key), "found no line '{}'; expected one", key);
    }
    check_vertices();
    finish_attributes();
    check_expected();
    cases_.push_back(std::move(case_));
    is_open_ = false;
  }

  void check_vertices() const {
    const std::size_t found = case_.vertices.size(), needed = vertices_of(case_.primitive);
    require_of_case(needed != 0 || (3 <= found && found <= kMostPolygonVertices),
                    "found {} vertices; expected 3 to {} of a polygon", found,
                    kMostPolygonVertices);
    require_of_case(needed == 0 || found == needed, "found {} vertices; expected {} of a {}", found,
                    needed, to_string(case_.primitive));
    const auto distances = static_cast<std::size_t>(case_.volume.clip_distances);
    require_of_case(*given_attributes_ >= distances,
                    "found {} attributes; expected at least the {} clip distances",
                    *given_attributes_, distances);
  }

  void finish_attributes() {
    fill_attributes(case_, static_cast<int>(*given_attributes_));
    require_of_case(
        case_.primitive != Primitive::polygon ||
            reference::is_planar_convex(case_.vertices, case_.attribute_count),
        "the vertices are no planar convex polygon with affine attributes; expected one, or triangles");
  }

  void check_expected() {
    const ExactOutcome exact = exact_outcome(case_);
    ExactOutcome& expected = case_.expected;
    if (!seen_.contains("expect")) {
      expected = exact;
      return;
    }
    if (expected.verdict == Verdict::accepted && expected.vertices == 0) {
      expected.vertices = case_.vertices.size();
    }
    if (expected != exact) {
      text_.fail_at(expected_line_, fmt::format("case '{}': found '{}'; the exact outcome is '{}'",
                                                case_.name, to_string(expected), to_string(exact)));
    }
  }

  const std::string file_, theme_;
  TextFile text_;
  std::vector<HardCase> cases_;
  bool is_open_ = false;
  HardCase case_;               // the current one, while it is open
  std::set<std::string> seen_;  // its keys
  std::size_t expected_line_ = 0;
  std::optional<std::size_t> given_attributes_;
  std::vector<std::string> inexact_;  // numbers that no float holds: "file:line: 0.1 -> nearest"
};

}  // namespace

std::vector<HardCase> read_cases(const std::string& file, std::string_view text) {
  return CaseReader(file, text).read();
}

}  // namespace clipscope::experiments
