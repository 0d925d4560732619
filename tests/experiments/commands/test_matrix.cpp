// SPDX-License-Identifier: GPL-3.0-or-later
//
// A projection as people have it, as a user gives it: a matrix, intrinsics, a pose. Answers are
// checked by hand.
#include <algorithm>
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

// The sides at 45 degrees, near at 1 and far at infinity: x, y, -z - 2, -z.
constexpr const char* kRows = "1,0,0,0,0,1,0,0,0,0,-1,-2,0,0,-1,0";
constexpr const char* kColumns = "1,0,0,0,0,1,0,0,0,0,-1,-1,0,0,-2,0";
constexpr const char* kCrossing = "0 0 -4  8 0 -4  0 2 -4\n";
// x = 1 is reached halfway from 0 to 2; z = (4 - 2) / 4.
constexpr const char* kClipped =
    "triangle,vertex,x,y,z,inv_w\n"
    "0,0,0,0,0.5,0.25\n0,1,1,0,0.5,0.25\n0,2,1,0.25,0.5,0.25\n0,3,0,0.5,0.5,0.25\n";

}  // namespace

TEST_CASE("matrix: rows, columns, brackets and a file of 16 numbers give the same answer") {
  const Folder folder;
  const std::string file = folder.file("m.txt", "1 0 0 0\n0 1 0 0\n0 0 -1 -2\n0 0 -1 0\n").string();
  for (const std::string& options :
       {std::string("--matrix ") + kRows, std::string("--matrix-order column --matrix ") + kColumns,
        std::string("--matrix '[[1,0,0,0],[0,1,0,0],[0,0,-1,-2],[0,0,-1,0]]'"),
        "--matrix " + quoted(file)}) {
    const Result r = folder.run("clip " + options, kCrossing);
    INFO(options << "\n" << r.err);
    CHECK(r.code == 0);
    CHECK(r.out == kClipped);
  }
}

TEST_CASE("matrix: y down, left-handed and view-projection matrices are taken as given") {
  const Folder folder;
  // y goes down; the camera looks down +z; the camera stands at (10, 0, 0).
  const auto first = [&](const std::string& matrix, const std::string& input) {
    const Result r = folder.run("clip --matrix " + matrix, input);
    INFO(matrix << "\n" << r.err);
    REQUIRE(r.code == 0);
    return lines(r.out).at(3);
  };
  CHECK(first("1,0,0,0,0,-1,0,0,0,0,-1,-2,0,0,-1,0", "0 0 -4  1 0 -4  0 2 -4\n") ==
        "0,2,0,-0.5,0.5,0.25");
  CHECK(first("1,0,0,0,0,1,0,0,0,0,1,-2,0,0,1,0", "0 0 4  1 0 4  0 2 4\n") == "0,2,0,0.5,0.5,0.25");
  CHECK(first("1,0,0,-10,0,1,0,0,0,0,-1,-2,0,0,-1,0", "10 0 -4  11 0 -4  10 2 -4\n") ==
        "0,2,0,0.5,0.5,0.25");
}

TEST_CASE("matrix: polygons, segments and every scalar take one") {
  const Folder folder;
  for (const char* scalar : {"float", "double", "exact", "counting"}) {
    const Result r =
        folder.run(std::string("clip --matrix ") + kRows + " --scalar " + scalar, kCrossing);
    INFO(scalar << "\n" << r.err);
    CHECK(r.out == kClipped);
  }
  const Result wide =
      folder.run(std::string("clip --scalar double_double --matrix ") + kRows, kCrossing);
  CHECK(contains(wide.out, "0,2,1.00000000000000000000000000000000e+00,2.5000000000000000000"));
  const Result segment =
      folder.run(std::string("clip --primitive segment --matrix ") + kRows, "0 0 -4  8 0 -4\n");
  CHECK(contains(segment.out, "0,1,1,0,0.5,0.25"));
  const Result polygon = folder.run(std::string("clip --primitive polygon --matrix ") + kRows,
                                    "0 0 -4  8 0 -4  8 2 -4  0 2 -4\n");
  CHECK(contains(polygon.out, "0,0,2,1,0.5,0.5,0.25"));
}

TEST_CASE("matrix: a file of one may begin with a byte order mark, and UTF-16 is named") {
  const Folder folder;
  std::string rows = kRows;
  std::ranges::replace(rows, ',', '\r');
  const std::string file = folder.file("m.txt", "\xEF\xBB\xBF" + rows).string();
  const Result r = folder.run("clip --matrix " + file, kCrossing);
  CHECK(r.code == 0);
  CHECK(r.out == folder.run(std::string("clip --matrix ") + kRows, kCrossing).out);
  const std::string wide = folder.file("w.txt", std::string("\xFF\xFE\x31\0", 4)).string();
  const Result utf16 = folder.run("clip --matrix " + wide, kCrossing);
  CHECK(utf16.code == 2);
  CHECK(contains(utf16.err, "UTF-16"));
}

TEST_CASE("matrix: what is wrong with one is named") {
  const Folder folder;
  const auto expect = [&](const std::string& arguments, const std::string& message) {
    const Result r = folder.run(arguments, kCrossing);
    INFO(arguments << "\n" << r.out << r.err);
    CHECK(r.code == 2);
    CHECK(r.out.empty());
    CHECK(contains(r.err, message));
  };
  const std::string matrix = std::string(" --matrix ") + kRows;
  expect("clip --matrix 1,2,3", "3 numbers; 16 numbers expected");
  expect("clip --matrix nowhere.txt", "'nowhere.txt' is no file; 16 numbers expected");
  expect("clip --matrix 1,0,0,0,0,1,0,0,0,0,-1,-2,0,0,-1,x", "'x', which is no number");
  expect("clip --matrix 1e300,0,0,0,0,1,0,0,0,0,-1,-2,0,0,-1,0", "inf in float");
  expect("clip --space clip" + matrix, "--matrix goes with --space view");
  expect("clip --perspective 90,1,1,3" + matrix, "--perspective and --matrix are given");
  expect("clip --clipper view/sutherland_hodgman" + matrix, "not applicable");
  expect("explain --clipper view/sutherland_hodgman" + matrix, "not applicable");
  expect("verify --clipper view/batch --scene teapot --quick --eye 0,2,9" + matrix,
         "not applicable");
  expect("compare --clipper 'view/*' --scene teapot --quick --eye 0,2,9" + matrix,
         "not applicable");
  expect("verify --clipper textbook --scene teapot --fovy 50" + matrix, "--fovy");
  expect("run depth --quick" + matrix, "--matrix");
  expect("clip --intrinsics 500,500,320,240,640,480", "--near and --far");
  expect("clip --intrinsics 500,0,320,240,640,480 --near 1 --far 9", "FY is 0");
  expect("verify --clipper textbook --scene teapot --intrinsics 500,500,320,240,640,480",
         "--eye or --pose");
  expect("verify --clipper textbook --scene teapot --pose 1,0,0,0,0,1,0,0,0,0,1,0,0,0,1,1",
         "last row 0 0 0 1");
  expect("verify --clipper textbook --scene teapot --camera 0", "built-in scene");
}

TEST_CASE("intrinsics: the corners of the image go to the corners of the volume") {
  const Folder folder;
  // 640 x 480 px at f = 320, principal point (319.5, 239.5): x / z of the right side is 1.
  const Result r =
      folder.run("clip --intrinsics 320,320,319.5,239.5,640,480 --near 1 --far inf --scalar double",
                 "0 0 -4  4 0 -4  0 3 -4\n");
  INFO(r.err);
  CHECK(r.out ==
        "triangle,vertex,x,y,z,inv_w\n0,0,0,0,0.5,0.25\n0,1,1,0,0.5,0.25\n0,2,0,1,0.5,0.25\n");
}

TEST_CASE("matrix: scenes seen by one keep their promises and are judged by the matrix") {
  const Folder folder;
  const std::string seen = " --scene teapot --quick --eye 0,2,9 --matrix " + std::string(kRows);
  const Result kept =
      folder.run("verify --sample 100 --clipper barycentric/correctly_rounded" + seen);
  INFO(kept.err);
  CHECK(kept.code == 0);
  CHECK(contains(kept.out, "promise kept on"));
  const Result compared = folder.run(
      "compare --sample 50 --scalar exact --clipper 'view/s*' --clipper textbook" + seen);
  CHECK(compared.code == 2);  // an option is given once
  const Result exact =
      folder.run("compare --sample 50 --scalar exact --clipper '*/s*' --json" + seen);
  INFO(exact.err);
  CHECK(exact.code == 0);
  CHECK(contains(exact.out, "the matrix as given"));
  CHECK(contains(exact.out, "view/sutherland_hodgman"));
  CHECK(contains(folder.run("plan --sample 50" + seen).out, "matrix as given"));
}

TEST_CASE("explain: takes planes, clip distances, depth clamp, primitives and a matrix") {
  const Folder folder;
  const auto explained = [&](const std::string& options, const std::string& input) {
    const Result r = folder.run("explain " + options, input);
    INFO(options << "\n" << r.err);
    CHECK(r.code == 0);
    for (const std::string& line : lines(r.out)) CHECK(line.size() <= 100);
    return r.out;
  };
  CHECK(contains(explained("--perspective 90,1,1,9 --plane 1,0,0,-0.25", kCrossing),
                 "4 vertices, exact 4"));
  CHECK(contains(explained("--perspective 90,1,1,3 --depth-clamp", kCrossing),
                 "4 vertices, exact 4"));
  CHECK(contains(explained("--perspective 90,1,1,9 --half-open", "2 0 -2  3 1 -3  3 -1 -3\n"),
                 "right: open, and no vertex is strictly inside of it"));
  CHECK(contains(explained("--perspective 90,1,1,9 --attributes 1 --clip-distances 1",
                           "0 0 -4 1  2 0 -4 -1  0 2 -4 1\n"),
                 "4 vertices, exact 4"));
  CHECK(
      contains(explained("--primitive segment --matrix " + std::string(kRows), "0 0 -4  8 0 -4\n"),
               "2 vertices, exact 2; outcome: exact"));
  CHECK(contains(
      explained("--primitive polygon --perspective 90,1,1,9", "0 0 -4  8 0 -4  8 2 -4  0 2 -4\n"),
      "4 vertices, exact 4"));
  for (const char* scalar : {"float", "double", "double_double", "exact"}) {
    explained(std::string("--perspective 70,1.3,.1,9 --scalar ") + scalar, kCrossing);
  }
}

TEST_CASE("explain: nothing to draw is said in words where what is visible has no area") {
  const Folder folder;
  const Result r = folder.run("explain --perspective 90,1,1,10", "1 -1 -1  1 1 -1  3 0 -1\n");
  CHECK(
      contains(r.out, "0 vertices, exact 2; outcome: exact: only a line without area is visible"));
}

TEST_CASE("explain: a seen triangle of a scene takes the camera's options") {
  const Folder folder;
  const Result r = folder.run("explain --scene teapot --quick --triangle 7 --eye 0,2,9 --matrix " +
                              std::string(kRows) + " --json");
  INFO(r.err);
  CHECK(r.code == 0);
  CHECK(contains(r.out, "\"outcome\""));
  CHECK(contains(r.out, "\"exact_vertices\""));
}
