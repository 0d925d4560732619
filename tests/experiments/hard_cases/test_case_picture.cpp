// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of hard cases: that each can be drawn, what they are drawn from, and how they are written.
#include "experiments/hard_cases/case_picture.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/errors.hpp"
#include "experiments/hard_cases/case_geometry.hpp"
#include "experiments/hard_cases/find_case.hpp"
#include "experiments/hard_cases/panel.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using reference::Rational;

namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("clipscope-picture-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path operator/(const std::string& name) const { return path_ / name; }
  bool is_empty() const { return fs::is_empty(path_); }

 private:
  fs::path path_;
};

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Whether every element ends, innermost first, and no character stands that must be escaped. Enough for
// XML without comments, CDATA and '>' in attributes.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size();) {
    const std::size_t begin = xml.find('<', i);
    if (xml.substr(i, begin - i).find('>') != std::string::npos) return false;
    if (begin == std::string::npos) break;
    const std::size_t end = xml.find('>', begin);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(begin + 1, end - begin - 1);
    if (tag.find('<') != std::string::npos) return false;
    const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
    if (tag[0] == '/') {
      if (open.empty() || "/" + open.back() != tag) return false;
      open.pop_back();
    } else if (tag[0] != '?' && tag.back() != '/') {
      open.push_back(name);
    }
    i = end + 1;
  }
  return open.empty();
}

// No coordinate is NaN or infinite.
bool has_numbers_only(const std::string& svg) {
  const std::string shapes = svg.substr(svg.find("</title>"));
  return shapes.find("nan") == std::string::npos && shapes.find("inf") == std::string::npos;
}

const HardCase& builtin_case(std::string_view name) { return find_case(builtin_catalogue(), name); }

std::string svg_of(const HardCase& hard_case, const CaseAnswer& answer, const std::string& scalar) {
  const Folder folder;
  write_case_picture(folder / "a.svg",
                     {hard_case, truth_polygon(hard_case), answer, "some/clipper", scalar});
  return read(folder / "a.svg");
}

CaseAnswer answer_of(const HardCase& hard_case, const std::string& clipper,
                     const std::string& scalar) {
  const auto contestants = case_contestants(hard_case.primitive, clipper, {scalar});
  REQUIRE(!contestants.empty());
  return contestants.front().answer(hard_case, truth_polygon(hard_case));
}

ExactPosition position(Rational x, Rational y, Rational z = 0, Rational w = 1) {
  return {std::move(x), std::move(y), std::move(z), std::move(w)};
}

}  // namespace

TEST_CASE("case picture: every case of the catalogue is drawn with every clipper of a family") {
  const Folder folder;
  for (const char* pattern : {"cvv/*", "whole/*", "view/*", "point/*"}) {
    for (const HardCase& c : builtin_catalogue()) {
      const TruthPolygon truth = truth_polygon(c);
      for (const CaseContestant& contestant : case_contestants(c.primitive, pattern, {"float"})) {
        const CaseAnswer answer = contestant.answer(c, truth);
        const fs::path path = folder / "a.svg";
        write_case_picture(path, {c, truth, answer, contestant.clipper, contestant.scalar});
        const std::string svg = read(path);
        INFO(c.name << ", " << contestant.clipper);
        CHECK(svg.starts_with("<?xml"));
        CHECK(svg.ends_with("</svg>\n"));
        CHECK(svg.find("<title>" + c.name + ": ") != std::string::npos);
        CHECK(is_well_formed(svg));
        CHECK(has_numbers_only(svg));
      }
    }
  }
}

TEST_CASE("case picture: every scalar is drawn, also those that doubles only come near") {
  const HardCase& c = builtin_case("w_sign/w_3_to_minus_3");
  for (const char* scalar : {"float", "double", "double_double", "exact", "counting"}) {
    INFO(scalar);
    const CaseAnswer answer = answer_of(c, "homogeneous/sutherland_hodgman", scalar);
    CHECK(is_well_formed(svg_of(c, answer, scalar)));
  }
}

TEST_CASE("case picture: answers without end, out of range or not finite are drawn") {
  const HardCase& c = builtin_case("planes_touched/nine_gon");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CaseAnswer answer;
  answer.comparison.outcome = Outcome::not_finite;
  answer.polygon = {{0, 0, 0, 1},
                    {NAN, 0, 0, 1},
                    {kInfinity, -kInfinity, 0, 1},
                    {1e308, -1e308, 0, kInfinity},
                    {-1e308, 1e-320, 0, 1}};
  const std::string svg = svg_of(c, answer, "double");
  CHECK(is_well_formed(svg));
  CHECK(has_numbers_only(svg));
}

TEST_CASE("case picture: names and reasons may hold anything") {
  HardCase c = builtin_case("w_sign/two_behind");
  c.name = "a/<b>&\"c\" \xff\xc3";
  c.why = std::string(2000, 'x') + " \xe2\x82\xac <&> \x01\n" + std::string(300, ' ');
  for (int i = 0; i < 500; ++i) c.why += " word";
  const std::string svg = svg_of(c, answer_of(c, "cvv/naive", "float"), "float");
  CHECK(is_well_formed(svg));
  CHECK(svg.find("<title>a/&lt;b&gt;&amp;\"c\" ??: ") != std::string::npos);
}

TEST_CASE("case picture: the extension decides the format, others are refused") {
  const Folder folder;
  const HardCase& c = builtin_case("w_sign/two_behind");
  const TruthPolygon truth = truth_polygon(c);
  const CaseAnswer answer = answer_of(c, "cvv/naive", "float");
  const CasePicture picture = {c, truth, answer, "cvv/naive", "float"};
  for (const char* name : {"a.gif", "a", "a.svgz", ".svg"}) {
    INFO(name);
    CHECK_THROWS_AS(check_picture_path(folder / name), UsageError);
    CHECK_THROWS_AS(write_case_picture(folder / name, picture), UsageError);
  }
  CHECK(folder.is_empty());
  write_case_picture(folder / "a.pdf", picture);
  write_case_picture(folder / "a.PNG", picture);
  CHECK(read(folder / "a.pdf").starts_with("%PDF-"));
  CHECK(read(folder / "a.PNG").starts_with("\x89PNG\r\n"));
}

TEST_CASE("case picture: a path that can't be written is named") {
  const HardCase& c = builtin_case("w_sign/two_behind");
  const TruthPolygon truth = truth_polygon(c);
  const CaseAnswer answer = answer_of(c, "cvv/naive", "float");
  try {
    write_case_picture("/proc/no/a.svg", {c, truth, answer, "cvv/naive", "float"});
    FAIL("no error");
  } catch (const OutputError& e) {
    CHECK(std::string(e.what()).find("/proc/no/a.svg") != std::string::npos);
  }
}

TEST_CASE("case geometry: the exact result lies in each space where it was found by hand") {
  const HardCase& c = builtin_case("w_sign/eye_point_view");
  const CaseGeometry g = case_geometry(c, truth_polygon(c), {});
  // The near plane z = -1 cuts at (1/2, 1/2, -1), where w is 1 and z_clip -1.
  const Rational half(0.5);
  CHECK(std::ranges::count(g.visible_view, position(half, half, -1)) == 1);
  CHECK(std::ranges::count(g.visible_clip, position(half, half, -1, 1)) == 1);
  CHECK(std::ranges::count(g.visible_ndc, position(half, half, -1, 1)) == 1);
  CHECK(g.behind == std::vector<bool>{true, false, false});
  CHECK(g.places == std::vector<std::string>{"outside right top near", "inside", "inside"});
}

TEST_CASE("case geometry: an oblique projection is undone exactly") {
  const HardCase& c = builtin_case("frustum_conventions/oblique");
  const CaseGeometry g = case_geometry(c, truth_polygon(c), {});
  CHECK(std::ranges::count(g.visible_view, g.input_view[0]) == 1);
}

TEST_CASE("case geometry: the largest error is the farthest from a nearest vertex, in px") {
  CaseGeometry g;
  g.visible_ndc = {position(0, 0), position(1, 0), position(1, 1)};
  g.answer_ndc = g.visible_ndc;
  CHECK(!largest_screen_error(g));
  g.answer_ndc[2] = position(1, 0.75);
  g.answer_ndc.push_back(position(0, Rational(1) / 64));
  const auto error = largest_screen_error(g);
  REQUIRE(error);
  CHECK(error->px == 270);
  CHECK(error->exact == g.visible_ndc[2]);
  g.answer_ndc.clear();
  CHECK(!largest_screen_error(g));
}

TEST_CASE("panel: a window holds what it must, and of the rest what is not too far") {
  PanelAxis x{.coordinate = 0}, y{.coordinate = 1};
  fit_window(
      {.must = {position(0, 0), position(1, 0)}, .may = {position(0, 10), position(0, 1e37)}}, x,
      y);
  CHECK(y.high > 10);
  CHECK(y.high < 20);
  CHECK(x.size() == Approx(y.size()));
  for (const double size : {1e-320, 1e-45, 1.0, 1e38, 1e300}) {
    INFO(size);
    fit_window({.must = {position(0, 0)}, .may = {position(size, size), position(size, 0)}}, x, y);
    CHECK(x.low < x.high);
    CHECK(std::isfinite(x.size()));
    CHECK(x.low < size);
  }
  fit_window({}, x, y);
  CHECK(x.low < x.high);
}

TEST_CASE("panel: an edge between vertices at 1e37 passes where it should") {
  VectorPage page(PageFormat::svg, 300, 300, "");
  const Panel panel(page, {100, 100, 100, 100}, {.coordinate = 0}, {.coordinate = 1});
  // y = x / 2 + 1/4, far beyond the precision of doubles.
  const Rational big(0x1p123);
  const ExactShape edge = {position(-big, -big / 2 + Rational(0.25)),
                           position(big, big / 2 + Rational(0.25))};
  const Spot middle = panel.middle_of(edge);
  CHECK(middle.x == Approx(150));
  CHECK(middle.y == Approx(150 - 0.25 * 50));
  CHECK(panel.is_thin(edge));
}

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
