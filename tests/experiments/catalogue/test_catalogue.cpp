// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/catalogue.hpp"

#include <algorithm>
#include <set>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;
using reference::Verdict;

using HandVertices = std::vector<std::array<Rational, 4>>;

HandVertices sorted(HandVertices vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

HandVertices positions(const reference::ExactPolygon& polygon) {
  HandVertices r;
  for (const reference::RationalVertex& v : vertex_set(polygon)) {
    r.push_back({v.x, v.y, v.z, v.inv_w});
  }
  return sorted(r);
}

TEST_CASE("catalogue: every outcome is what the exact reference says") {
  for (const HardCase& hard_case : builtin_catalogue()) {
    CAPTURE(hard_case.name);
    CHECK(hard_case.expected == exact_outcome(hard_case));
  }
}

TEST_CASE("catalogue: every vertex found by hand is one of the exact polygon, and all are found") {
  int done_by_hand = 0;
  for (const HardCase& hard_case : builtin_catalogue()) {
    if (hard_case.by_hand.empty()) continue;
    ++done_by_hand;
    CAPTURE(hard_case.name);
    CHECK(positions(exact_polygon(hard_case)) == sorted(hard_case.by_hand));
  }
  CHECK(done_by_hand >= 25);
}

TEST_CASE("catalogue: a file may begin with a byte order mark and end its lines as it likes") {
  const std::string text =
      "case a\nsource here\nwhy it is hard\nprimitive point\nspace clip gl\nvertex 0 0 0 1\n";
  const auto with_ends = [&](const std::string& end) {
    std::string changed = "\xEF\xBB\xBF";
    for (const char c : text) changed += c == '\n' ? end : std::string(1, c);
    return changed;
  };
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::vector<HardCase> cases = read_cases("marked.cases", with_ends(end));
    REQUIRE(cases.size() == 1);
    CHECK(cases[0].name == "marked/a");
    CHECK(cases[0].why == "it is hard");
  }
}

TEST_CASE("catalogue: names are unique, and every case says where it is from and why it is hard") {
  std::set<std::string> names;
  for (const HardCase& hard_case : builtin_catalogue()) {
    CAPTURE(hard_case.name);
    CHECK(names.insert(hard_case.name).second);
    CHECK_FALSE(hard_case.source.empty());
    CHECK_FALSE(hard_case.why.empty());
    CHECK(hard_case.name.find('/') != std::string::npos);
    CHECK(hard_case.line > 0);
  }
}

TEST_CASE("catalogue: there are cases of every primitive, in both spaces, with every outcome") {
  std::set<Primitive> primitives;
  std::set<Space> spaces;
  std::set<Verdict> verdicts;
  for (const HardCase& hard_case : builtin_catalogue()) {
    primitives.insert(hard_case.primitive);
    spaces.insert(hard_case.space);
    verdicts.insert(hard_case.expected.verdict);
  }
  CHECK(builtin_catalogue().size() >= 110);
  CHECK(primitives.size() == 4);
  CHECK(spaces.size() == 2);
  CHECK(verdicts.size() == 3);
}

TEST_CASE("catalogue: what is built in is what the folder holds") {
  const std::vector<HardCase> files = load_catalogue(CLIPSCOPE_CORPUS_PATH);
  const std::vector<HardCase>& builtin = builtin_catalogue();
  const auto names = [](const std::vector<HardCase>& cases) {
    std::set<std::string> r;
    for (const HardCase& hard_case : cases) r.insert(hard_case.name);
    return r;
  };
  CHECK(names(files) == names(builtin));
}

TEST_CASE("catalogue: coordinates and attributes are floats") {
  const auto is_float = [](double v) { return double{static_cast<float>(v)} == v; };
  for (const HardCase& hard_case : builtin_catalogue()) {
    CAPTURE(hard_case.name);
    for (const reference::InputVertex& v : hard_case.vertices) {
      CHECK(std::ranges::all_of(v.position, is_float));
      CHECK(std::ranges::all_of(v.attributes, is_float));
    }
    CHECK(hard_case.attribute_count >= kSceneAttributes);
  }
}

DepthClamp clamp_of(const std::string& line) {
  const std::string text = "case a\nsource s\nwhy w\nprimitive point\nspace clip gl\n" + line +
                           "\nvertex 0 0 0 1\nexpect accepted\n";
  return parse_catalogue("folder/theme.cases", text).at(0).volume.depth_clamp;
}

TEST_CASE("catalogue: depth_clamp stands for both planes or names one") {
  CHECK(clamp_of("depth_clamp") == DepthClamp(true));
  CHECK(clamp_of("depth_clamp near") == kClampNear);
  CHECK(clamp_of("depth_clamp far") == kClampFar);
  CHECK_THROWS_WITH(clamp_of("depth_clamp side"),
                    Catch::Contains("theme.cases:6") && Catch::Contains("'side'"));
}

OpenSides sides_of(const std::string& line) {
  const std::string text =
      "case a\nsource s\nwhy w\nprimitive point\nspace clip gl\n" + line + "\nvertex 0 0 0 1\n";
  return parse_catalogue("folder/theme.cases", text).at(0).volume.open_sides;
}

TEST_CASE("catalogue: half_open stands for the top-left rule or names the open sides") {
  CHECK(sides_of("half_open") == OpenSides(true));
  CHECK(sides_of("half_open right bottom") == OpenSides(true));
  CHECK(sides_of("half_open top left") == OpenSides(true, false, false, true));
  CHECK_THROWS_WITH(sides_of("half_open near"),
                    Catch::Contains("theme.cases:6") && Catch::Contains("'near'"));
  CHECK_THROWS_WITH(sides_of("half_open left left"), Catch::Contains("'left' twice"));
}

const std::string kHead =
    "case a\nsource s\nwhy w\nprimitive segment\nspace clip zero_to_one\n";  // 5 lines

TEST_CASE("catalogue: a case is read as it is written") {
  const std::string text = "# a comment\n\n" + kHead +
                           "depth_clamp\nclip_distances 1\nvertex 0 0x1p-2 -0x1.8p1 1 | 3\n"
                           "vertex 1 0 -0 2 | -1\nexpect clipped 2\nhand 0 1/4 -3 1\n";
  const std::vector<HardCase> cases = parse_catalogue("folder/theme.cases", text);
  REQUIRE(cases.size() == 1);
  const HardCase& c = cases[0];
  CHECK(c.name == "theme/a");
  CHECK(c.source == "s");
  CHECK(c.why == "w");
  CHECK(c.primitive == Primitive::segment);
  CHECK(c.space == Space::clip);
  CHECK(c.volume ==
        ClipVolume{.depth = DepthRange::zero_to_one, .depth_clamp = true, .clip_distances = 1});
  CHECK(c.vertices[0].position == std::array<double, 4>{0, .25, -3, 1});
  CHECK(std::signbit(c.vertices[1].position[2]));
  CHECK(c.expected == ExactOutcome{Verdict::clipped, 2});
  CHECK(c.by_hand == HandVertices{{0, Rational(1) / 4, -3, 1}});
  CHECK(c.file == "folder/theme.cases");
  CHECK(c.line == 3);
  // the clip distance given, then l0, l1, l2
  CHECK(c.attribute_count == 4);
  CHECK(c.vertices[1].attributes[0] == -1);
  CHECK(c.vertices[1].attributes[1] == 0);
  CHECK(c.vertices[1].attributes[2] == 1);
  CHECK(c.vertices[1].attributes[3] == 0);
}

TEST_CASE("catalogue: without attributes a triangle has its barycentric coordinates and 1") {
  const auto cases = parse_catalogue(
      "t.cases",
      "case a\nsource s\nwhy w\nprimitive triangle\nspace view perspective -1 1 -2 2 1 inf reversed\n"
      "vertex 0 0 -2\nvertex 1 0 -2\nvertex 0 1 -2\n");
  const HardCase& c = cases.at(0);
  CHECK(c.space == Space::view);
  CHECK(c.frustum.infinite_far);
  CHECK(c.frustum.depth == DepthRange::reversed);
  CHECK(c.vertices[2].position == std::array<double, 4>{0, 1, -2, 1});
  CHECK(c.expected == ExactOutcome{Verdict::accepted, 3});  // not stated, computed
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) CHECK(c.vertices[i].attributes[k] == (i == k ? 1 : 0));
    CHECK(c.vertices[i].attributes[3] == 1);
  }
}

TEST_CASE("catalogue: without attributes a polygon has its coordinates, which are affine over it") {
  const auto cases =
      parse_catalogue("t.cases",
                      "case a\nsource s\nwhy w\nprimitive polygon\nspace clip gl\n"
                      "vertex 0 0 0 1\nvertex 3 0 0 2\nvertex 3 1 0 2\nvertex 0 1 0 1\n");
  const HardCase& c = cases.at(0);
  CHECK(c.vertices[1].attributes[0] == 3);
  CHECK(c.vertices[1].attributes[3] == 2);
}

struct Mistake {
  std::string text, place, message;
};

TEST_CASE("catalogue: a mistake is told by file, line, what was found and what was expected") {
  const std::string v = "vertex 0 0 0 1\n";
  const auto m = GENERATE_COPY(
      as<Mistake>{}, Mistake{"", "t.cases:", "found no case"},
      Mistake{"source s\n", "t.cases:1:", "expected 'case NAME'"},
      Mistake{"case a b\n", "t.cases:1:", "expected 'case NAME'"},
      Mistake{kHead + "colour red\n", "t.cases:6:", "found 'colour'; expected case, source"},
      Mistake{kHead + "why again\n", "t.cases:6:", "found a second 'why'"},
      Mistake{kHead + v, "t.cases:1:", "found 1 vertices; expected 2 of a segment"},
      Mistake{kHead + v + v + v, "t.cases:1:", "found 3 vertices; expected 2 of a segment"},
      Mistake{kHead + "vertex 0 0 0\n", "t.cases:6:", "found 3 coordinates; expected 4"},
      Mistake{kHead + "vertex 0 0 0 x\n", "t.cases:6:", "found 'x'; expected a number"},
      Mistake{kHead + "vertex 0 0 0 0x\n", "t.cases:6:", "found '0x'; expected a number"},
      Mistake{kHead + "vertex 0.1 0 0 1\n", "t.cases:", "1 number was found that no float holds"},
      Mistake{kHead + "vertex 0.1 0 0 1\n" + v, "t.cases:", "t.cases:6: 0.1 -> 0x1.99999ap-4"},
      Mistake{kHead + "vertex 0.1 0 0 1\nvertex 0 0.2 0 1\nexpect rejected\n",
              "t.cases:", "t.cases:7: 0.2 -> 0x1.99999ap-3"},
      Mistake{kHead + "vertex 1e39 0 0 1\n", "t.cases:6:", "too large for a float"},
      Mistake{kHead + "vertex nan 0 0 1\n", "t.cases:6:", "NaN"},
      Mistake{kHead + v + "vertex 0 0 0 1 | 2\n", "t.cases:7:", "found 1 attributes; expected 0"},
      Mistake{kHead + "clip_distances 9\n", "t.cases:6:", "expected 1 to 8"},
      Mistake{kHead + "clip_distances 1\n" + v + v, "t.cases:1:", "at least the 1 clip distances"},
      Mistake{kHead + v + v + "expect clipped\n", "t.cases:8:", "expected 'expect rejected'"},
      Mistake{kHead + v + v + "expect rejected\n",
              "t.cases:8:", "found 'rejected'; the exact outcome is 'accepted 1'"},
      Mistake{kHead + "hand 1 2 3 1/0\n",
              "t.cases:6:", "found '1/0'; expected a whole number or a ratio"},
      Mistake{"case a\nsource s\nwhy w\nprimitive circle\n",
              "t.cases:4:", "found primitive 'circle'"},
      Mistake{"case a\nspace clip up\n", "t.cases:2:", "found depth range 'up'"},
      Mistake{"case a\nspace clip\n", "t.cases:2:", "expected 'space clip DEPTH'"},
      Mistake{"case a\nspace view perspective 1 -1 -1 1 1 2 gl\n",
              "t.cases:2:", "encloses no volume"},
      Mistake{"case a\nvertex 0 0 0 1\n", "t.cases:2:", "before the line 'space"},
      Mistake{"case a\nsource s\nwhy w\nprimitive point\n", "t.cases:1:", "found no line 'space'"},
      Mistake{"case a\nsource s\nwhy w\nprimitive polygon\nspace clip gl\n" + v +
                  "vertex 1 0 0 1\nvertex 1 1 0 1\nvertex 0 1 1 1\n",
              "t.cases:1:", "no planar convex polygon"},
      Mistake{kHead + v + "vertex 1 0 0 1\n" + kHead + v + "vertex 1 0 0 1\n",
              "t.cases:8:", "case 't/a' is already at t.cases:1"});
  CAPTURE(m.text);
  try {
    parse_catalogue("t.cases", m.text);
    FAIL("no error");
  } catch (const InputError& error) {
    CAPTURE(error.what());
    CHECK(std::string(error.what()).starts_with(m.place));
    CHECK(std::string(error.what()).find(m.message) != std::string::npos);
  }
}

TEST_CASE("catalogue: a case of one's own needs no source, reason or expectation") {
  const std::string text = "case a\nprimitive point\nspace clip gl\nvertex 0 0 0 1\n";
  const std::vector<HardCase> cases = parse_catalogue("own.cases", text);
  REQUIRE(cases.size() == 1);
  CHECK(cases[0].expected == ExactOutcome{Verdict::accepted, 1});
  CHECK(case_text(cases[0]) == text + "expect accepted 1\n");
}

TEST_CASE("catalogue: a file that isn't there is named") {
  CHECK_THROWS_WITH(load_catalogue("no/such.cases"), Catch::Contains("no/such.cases"));
}

const HardCase& builtin_case(std::string_view name) { return find_case(builtin_catalogue(), name); }

TEST_CASE("find case: by its name, by the part after the theme, and what is like it") {
  CHECK(builtin_case("w_sign/two_behind").name == "w_sign/two_behind");
  CHECK(builtin_case("two_behind").name == "w_sign/two_behind");
  const auto message = [](std::string_view name) {
    try {
      builtin_case(name);
    } catch (const UsageError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(message("w_sign/tow_behind").find("w_sign/two_behind") != std::string::npos);
  CHECK(message("kettnr").find("slivers_and_slopes/kettner") != std::string::npos);
  CHECK(message("gizmo").find("segments/gizmo_across") != std::string::npos);
  CHECK(message("inside").find("several cases are called 'inside'") != std::string::npos);
  CHECK(message("").find("no case") != std::string::npos);
}

}  // namespace
}  // namespace clipscope::experiments
