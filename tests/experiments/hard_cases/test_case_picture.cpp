// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of hard cases: that each can be drawn, what they are drawn from, and how they are
// written.
#include "experiments/hard_cases/case_picture.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/draw/vector_page.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "experiments/survey/verdicts.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Whether every element ends, innermost first, and no character stands that must be escaped. Enough
// for XML without comments, CDATA and '>' in attributes.
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

std::string svg_of(const CasePicture& picture) {
  const TemporaryFolder folder;
  write_case_picture(folder / "a.svg", picture);
  return read(folder / "a.svg");
}

CasePicture picture_by(const HardCase& hard_case, const std::string& clipper,
                       const std::string& scalar = "float") {
  const auto contestants = case_contestants(hard_case.primitive, clipper, {scalar});
  REQUIRE(!contestants.empty());
  return picture_of(hard_case, *contestants.front());
}

TEST_CASE("case picture: every case of the catalogue is drawn with every clipper of a family") {
  const TemporaryFolder folder;
  for (const char* pattern : {"cvv/*", "whole/*", "view/*", "point/*"}) {
    for (const HardCase& c : builtin_catalogue()) {
      for (const Contestant* contestant : case_contestants(c.primitive, pattern, {"float"})) {
        const fs::path path = folder / "a.svg";
        write_case_picture(path, picture_of(c, *contestant));
        const std::string svg = read(path);
        INFO(c.name << ", " << contestant->clipper);
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
    CHECK(is_well_formed(svg_of(picture_by(c, "homogeneous/sutherland_hodgman", scalar))));
  }
}

TEST_CASE("case picture: answers without end, out of range or not finite are drawn") {
  const HardCase& c = builtin_case("planes_touched/nine_gon");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::string svg = svg_of({c,
                                  truth_polygon(c),
                                  {.outcome = Outcome::not_finite},
                                  {{0, 0, 0, 1},
                                   {NAN, 0, 0, 1},
                                   {kInfinity, -kInfinity, 0, 1},
                                   {1e308, -1e308, 0, kInfinity},
                                   {-1e308, 1e-320, 0, 1}},
                                  "some/clipper",
                                  kFormat<double>});
  CHECK(is_well_formed(svg));
  CHECK(has_numbers_only(svg));
}

TEST_CASE("case picture: names and reasons may hold anything") {
  HardCase c = builtin_case("w_sign/two_behind");
  c.name = "a/<b>&\"c\" \xff\xc3";
  c.why = std::string(2000, 'x') + " \xe2\x82\xac <&> \x01\n" + std::string(300, ' ');
  for (int i = 0; i < 500; ++i) c.why += " word";
  const std::string svg = svg_of(picture_by(c, "cvv/naive"));
  CHECK(is_well_formed(svg));
  CHECK(svg.find("<title>a/&lt;b&gt;&amp;&quot;c&quot; ??: ") != std::string::npos);
}

TEST_CASE("case picture: the extension decides the format, others are refused") {
  const TemporaryFolder folder;
  const CasePicture picture = picture_by(builtin_case("w_sign/two_behind"), "cvv/naive");
  for (const char* name : {"a.gif", "a", "a.svgz", ".svg"}) {
    INFO(name);
    CHECK_THROWS_AS(page_format(folder / name), UsageError);
    CHECK_THROWS_AS(write_case_picture(folder / name, picture), UsageError);
  }
  CHECK(fs::is_empty(folder.path()));
  write_case_picture(folder / "a.pdf", picture);
  write_case_picture(folder / "a.PNG", picture);
  CHECK(read(folder / "a.pdf").starts_with("%PDF-"));
  CHECK(read(folder / "a.PNG").starts_with("\x89PNG\r\n"));
}

TEST_CASE("case picture: a path that can't be written is named") {
  try {
    write_case_picture("/proc/no/a.svg",
                       picture_by(builtin_case("w_sign/two_behind"), "cvv/naive"));
    FAIL("no error");
  } catch (const OutputError& e) {
    CHECK(std::string(e.what()).find("/proc/no/a.svg") != std::string::npos);
  }
}

}  // namespace
}  // namespace clipscope::experiments::hard_cases
