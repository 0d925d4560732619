// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope bounds, as a user runs it. Answers are checked by hand.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

constexpr const char* kUnitBounds = "bounds --frustum -1,1,-1,1,1,10 ";

// The rows of the table as JSON objects.
nlohmann::json bounds_rows(const Folder& folder, const std::string& options,
                           const std::string& input = "") {
  const Result r = folder.run(options + " --json", input);
  INFO(options << "\n" << r.err);
  REQUIRE(r.code == 0);
  return nlohmann::json::parse(r.out).at("rows");
}

}  // namespace

TEST_CASE("bounds: every kind of solid from standard input, and comments") {
  const Folder folder;
  const auto rows = bounds_rows(folder, kUnitBounds,
                                "# around the view\nbox -1 -1 -4 1 1 -2\nsphere 13,0,-14,0x1.3p2\n"
                                "obb 0 0 4  1 0 0  0 1 0  0 0 1\npoints 2 0 1 12 0 -9\n");
  REQUIRE(rows.size() == 6);
  CHECK(rows[0]["solid"] == "standard input:2");
  CHECK(rows[0]["by_planes"] == "accepted");
  CHECK(rows[0]["exact"] == "accepted");
  CHECK(rows[1]["by_planes"] == "look closer");
  CHECK(rows[1]["by_axes"] == "rejected");
  CHECK(rows[1]["needless"] == "planes");
  CHECK(rows[2]["by_planes"] == "rejected");
  CHECK(rows[3]["bound"] == "axis box");
  CHECK(rows[3]["exact"] == "look closer");
  CHECK(rows[3]["content"] == "rejected");
}

TEST_CASE("bounds: a matrix answers as the frustum that it is of") {
  const Folder folder;
  const std::string solids = "box 10.5 -5 -25 30 5 -5\nsphere 0 0 -5 1\nsphere 13 0 -14 4.9\n";
  const auto by_frustum = bounds_rows(folder, kUnitBounds, solids);
  const auto by_matrix =
      bounds_rows(folder, "bounds --matrix 9,0,0,0,0,9,0,0,0,0,-11,-20,0,0,-9,0", solids);
  CHECK(by_frustum == by_matrix);
}

TEST_CASE("bounds: screen rectangles in NDC and px, cut by the near plane, beside the exact ones") {
  const Folder folder;
  const auto rows = bounds_rows(folder, std::string(kUnitBounds) + "--viewport 640x480",
                                "sphere 0 0 0 2\nbox -1 0 -4 1 .5 4\n");
  REQUIRE(rows.size() == 16);
  CHECK(rows[0]["x_to"] == "inf");
  CHECK(rows[2]["part"] == "beyond near");
  CHECK(std::stod(rows[2]["x_to"].get<std::string>()) == Approx(std::sqrt(3.0)));
  CHECK(rows[5]["unit"] == "px");
  CHECK(rows[5]["x_to"] == "640");
  CHECK(rows[8]["part"] == "w > 0, exact");
  CHECK(rows[12]["part"] == "beyond near, exact");
  // The near plane of the float matrix is not quite at 1.
  CHECK(std::stod(rows[12]["x_to"].get<std::string>()) == Approx(1).epsilon(1e-6));
  CHECK(rows[12]["y_from"] == "0");
}

TEST_CASE("bounds: a mesh is bounded as its views see it, or as it is by a projection") {
  const Folder folder;
  const auto rows = bounds_rows(folder, "bounds --scene teapot --quick");
  REQUIRE(rows.size() > 3);
  CHECK(rows.size() % 3 == 0);
  for (const auto& row : rows) {
    // What exact arithmetic settles of a bound is true of what it bounds.
    if (row["exact"] != "look closer") CHECK(row["content"] == row["exact"]);
    for (const char* test : {"by_planes", "by_axes"}) {
      if (row[test] != "look closer") CHECK(row[test] == row["exact"]);
    }
  }
  const auto mesh = folder.file("m.obj", "v 0 0 -2\nv .5 0 -2\nv 0 .5 -3\nf 1 2 3\n");
  const auto as_it_is = bounds_rows(folder, kUnitBounds + ("--scene " + quoted(mesh.string())));
  REQUIRE(as_it_is.size() == 3);
  CHECK(as_it_is[0]["content"] == "accepted");
}

TEST_CASE("bounds: bad input is named") {
  const Folder folder;
  const auto fails = [&](const std::string& options, const std::string& input, int code,
                         const std::string& message) {
    const Result r = folder.run(options, input);
    INFO(options << "\n" << r.err);
    CHECK(r.code == code);
    CHECK(contains(r.err, message));
  };
  fails(kUnitBounds, "box 1 2 3\n", 3, "standard input:1: 3 numbers given; expected box X0 Y0 Z0");
  fails(kUnitBounds, "\nball 1 2 3\n", 3, "standard input:2: 'ball' given");
  fails(kUnitBounds, "sphere 0 0 nan 1\n", 3, "'nan' is not finite");
  fails(kUnitBounds, "# nothing\n", 3, "there is no solid in it");
  fails("bounds", "sphere 0 0 0 1\n", 2, "--perspective");
  fails("bounds --matrix 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,0", "sphere 0 0 0 1\n", 2, "singular");
  fails(std::string(kUnitBounds) + "--scene teapot in.txt", "", 2, "--scene");
  fails(std::string(kUnitBounds) + "--viewport 640", "sphere 0 0 0 1\n", 2, "WxH");
}

TEST_CASE("bounds: the table fits 100 columns") {
  const Folder folder;
  for (const char* options : {"", "--viewport 640x480"}) {
    const Result r = folder.run(kUnitBounds + std::string(options),
                                "box -1 0 -4 1 .5 4\nsphere 0.1 0.2 -3.3 1.7\npoints 1 2 3\n");
    REQUIRE(r.code == 0);
    for (const std::string& line : lines(r.out)) {
      INFO(line);
      CHECK(line.size() <= 100);
    }
  }
}

TEST_CASE("bounds: the experiment of the same name is still run") {
  const Folder folder;
  const Result r = folder.run("run bounds --quick --scene teapot --sample 50 --out " +
                              quoted((folder.path() / "results").string()));
  INFO(r.err);
  CHECK(r.code == 0);
  CHECK(std::filesystem::exists(folder.path() / "results" / "bounds" / "bounds.csv"));
}
