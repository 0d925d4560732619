// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope explain on hard cases, and its pictures, as a user runs it.
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("cli: explain shows the three spaces and marks the first wrong digit") {
  const Folder folder;
  const Result r =
      folder.run("explain --perspective 90,1,1,10 --attributes 1", "0 0 -2 0  3 0 -2 1  0 1 2 1\n");
  REQUIRE(r.code == 0);
  for (const char* part : {"View space", "Clip space", "Canonical view volume", "outside right",
                           "near: distances", "outcome", "ulp"}) {
    CHECK(contains(r.out, part));
  }
  CHECK(contains(r.out, "["));
  CHECK(folder.run("explain --scene teapot --quick --triangle 7").code == 0);
  CHECK(folder.run("explain --scene teapot --quick --triangle 9999999").code == 2);
}

TEST_CASE("cli: explain --case shows a hard case of any primitive beside the exact answer") {
  const Folder folder;
  for (const char* name : {"points/citra", "segments/gizmo_across", "w_sign/eye_point_view",
                           "user_planes/one", "depth/clamped_near", "polygons/octagon_view"}) {
    const Result r = folder.run(std::string("explain --case ") + name);
    INFO(name << "\n" << r.err);
    CHECK(r.code == 0);
    CHECK(contains(r.out, std::string(name) + ": a "));
    CHECK(contains(r.out, "why it is hard: "));
    CHECK(contains(r.out, "Clip space: x y z w"));
    CHECK(contains(r.out, "outcome: "));
  }
}

TEST_CASE("cli: explain --case goes through a triangle's cuts and names clip distances") {
  const Folder folder;
  const Result view = folder.run("explain --case w_sign/eye_point_view --scalar double");
  CHECK(contains(view.out, "cuts in view space"));
  CHECK(contains(view.out, "near: distances -1 1 1; 3 vertices become 4"));
  CHECK(contains(view.out, "mirrored through the eye or at infinity"));
  const Result distance = folder.run("explain --case user_planes/one");
  CHECK(contains(distance.out, "clip distance 0: distances"));
}

TEST_CASE("cli: explain --case shows what is missing") {
  const Folder folder;
  const Result r = folder.run("explain --case w_sign/eye_point_view --clipper cvv/naive");
  CHECK(r.code == 0);
  CHECK(contains(r.out, "0 vertices, exact 4; outcome: missing"));
  CHECK(contains(r.out, "exact vertex 3"));
}

TEST_CASE("cli: explain takes the cases of a corpus of the user's") {
  const Folder folder;
  const auto corpus = folder.file("mine.cases",
                                  "case corner\nsource me\nwhy it is mine\nprimitive point\n"
                                  "space clip gl\nvertex 1 1 1 1\nexpect accepted\n");
  const Result r = folder.run("explain --case mine/corner --corpus " + corpus.string());
  INFO(r.err);
  CHECK(r.code == 0);
  CHECK(contains(r.out, "it is mine"));
  CHECK(contains(r.out, "outcome: exact"));
  const Result other = folder.run("explain --case w_sign/two_behind --corpus " + corpus.string());
  CHECK(other.code == 2);
  CHECK(contains(other.err, "mine/corner"));
  CHECK(folder.run("explain --case a --corpus /no/such/file").code == 3);
}

TEST_CASE("cli: explain --picture draws cases, triangles of a text and of a scene") {
  const Folder folder;
  const auto draws = [&](const std::string& arguments, const std::string& title) {
    const auto path = folder.path() / "a.svg";
    const Result r = folder.run("explain " + arguments + " --picture " + path.string(),
                                "0 0 -2  3 0 -2  0 1 2\n");
    INFO(arguments << "\n" << r.err);
    CHECK(r.code == 0);
    CHECK(contains(r.out, "outcome: "));
    CHECK(contains(read(path), "<title>" + title));
    std::filesystem::remove(path);
  };
  draws("--case planes_touched/nine_gon", "planes_touched/nine_gon");
  draws("--case polygons/octagon_view --scalar exact", "polygons/octagon_view");
  draws("--case segments/gizmo_across --clipper view/cyrus_beck", "segments/gizmo_across");
  draws("--perspective 90,1,1,10 --clipper textbook", "standard input:1");
  draws("--scene teapot --quick --triangle 7", "triangle 7 of teapot");
}

TEST_CASE("cli: explain names what is wrong with a case or a picture") {
  const Folder folder;
  const auto expect = [&](const std::string& arguments, int code, const std::string& message) {
    const Result r = folder.run("explain " + arguments);
    INFO(arguments << "\n" << r.out << r.err);
    CHECK(r.code == code);
    CHECK(r.out.empty());
    CHECK(contains(r.err, message));
  };
  expect("--case w_sign/tow_behind", 2, "w_sign/two_behind");
  expect("--case w_sign/two_behind --scene teapot", 2, "--scene");
  expect("--case w_sign/two_behind --space clip", 2, "--space");
  expect("--corpus tests/corpus", 2, "--case");
  expect("--case w_sign/two_behind --scalar half", 2, "double_double");
  expect("--case w_sign/two_behind --clipper view/sutherland_hodgman", 2, "not applicable");
  expect("--case segments/gizmo_across --clipper textbook", 2, "homogeneous/liang_barsky");
  expect("--case polygons/octagon_view --clipper textbook", 2, "homogeneous/polygon");
  expect("--case w_sign/two_behind --picture a.gif", 2, ".svg, .pdf or .png");
  const Result unwritable = folder.run("explain --case w_sign/two_behind --picture /proc/no/a.svg");
  CHECK(unwritable.code == 4);
  CHECK(contains(unwritable.err, "/proc/no/a.svg"));
}
