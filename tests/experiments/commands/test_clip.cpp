// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope clip, as a user runs it. Answers are checked by hand.
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

using Lines = std::vector<std::string>;

constexpr const char* kHalfOutside = "0 0 -2  3 0 -2  0 1 -2\n";

// What `clip` writes without the head.
Lines rows_of(const Folder& folder, const std::string& options, const std::string& input) {
  const Result r = folder.run("clip " + options, input);
  INFO(options << "\n" << r.err);
  REQUIRE(r.code == 0);
  Lines rows = lines(r.out);
  REQUIRE(!rows.empty());
  rows.erase(rows.begin());
  return rows;
}

std::vector<double> numbers_of(const std::string& row) {
  std::vector<double> numbers;
  std::istringstream stream(row);
  for (std::string word; std::getline(stream, word, ',');) numbers.push_back(std::stod(word));
  return numbers;
}

// Twice the area of each part of the only polygon: its rows are polygon,part,vertex,x,y,...
std::vector<double> twice_areas(const Lines& rows) {
  std::vector<std::vector<std::vector<double>>> parts;
  for (const std::string& row : rows) {
    const auto numbers = numbers_of(row);
    parts.resize(static_cast<std::size_t>(numbers.at(1)) + 1);
    parts.back().push_back(numbers);
  }
  std::vector<double> areas;
  for (const auto& part : parts) {
    double& area = areas.emplace_back(0);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const auto &p = part[i], &q = part[(i + 1) % part.size()];
      area += p[3] * q[4] - p[4] * q[3];
    }
  }
  return areas;
}

std::size_t vertices_of(const std::string& primitive) {
  return primitive == "point" ? 1 : primitive == "segment" ? 2 : primitive == "triangle" ? 3 : 4;
}

// One in view space, inside.
std::string primitive_input(const std::string& primitive) {
  const Lines square = {"-0.5 -0.5 -2 ", "0.5 -0.5 -2 ", "0.5 0.5 -2 ", "-0.5 0.5 -2 "};
  std::string line;
  for (std::size_t i = 0; i < vertices_of(primitive); ++i) line += square[i];
  return line + "\n";
}

// A dart: (0, -0.25) is reflex, and the one way to cut it is from there to (0, 0.5).
constexpr const char* kDart = "-0.5 -0.5 0 1  0 -0.25 0 1  0.5 -0.5 0 1  0 0.5 0 1\n";
constexpr const char* kSquare = "-0.5 -0.5 0 1  0.5 -0.5 0 1  0.5 0.5 0 1  -0.5 0.5 0 1\n";
constexpr const char* kBowTie = "-0.5 -0.5 0 1  0.5 0.5 0 1  0.5 -0.5 0 1  -0.5 0.25 0 1\n";

}  // namespace

TEST_CASE("clip: writes a row per vertex") {
  const Folder folder;
  const Result r =
      folder.run("clip --space view --perspective 90,1,1,10 --clipper textbook", kHalfOutside);
  REQUIRE(r.code == 0);
  const auto rows = lines(r.out);
  REQUIRE(rows.size() == 5);
  CHECK(rows[0] == "triangle,vertex,x,y,z,inv_w");
  CHECK(rows[1].starts_with("0,0,0,0,"));
  CHECK(rows[2].starts_with("0,1,1,0,"));
}

TEST_CASE("clip: numbers triangles in input order and skips those without output") {
  const Folder folder;
  const Result r = folder.run("clip --space clip --attributes 1",
                              "# nothing of this one\n5 0 0 1 0, 6 0 0 1 0, 5 1 0 1 0\n\n"
                              "0,0,0,1,7 0.5,0,0,1,8 0,0.5,0,1,9 # inside\n");
  REQUIRE(r.code == 0);
  CHECK(lines(r.out) == std::vector<std::string>{"triangle,vertex,x,y,z,inv_w,a0", "1,0,0,0,0,1,7",
                                                 "1,1,0.5,0,0,1,8", "1,2,0,0.5,0,1,9"});
}

TEST_CASE("clip: an exact answer is written as the nearest double, and whole as a fraction") {
  const Folder folder;
  const std::string tenths = "1 0 0 10  0 1 0 10  0 0 1 10\n";
  const std::string exact = "--space clip --scalar exact";
  CHECK(rows_of(folder, exact, tenths).at(0) == "0,0,0.1,0,0,0.1");
  CHECK(rows_of(folder, exact + " --hex", tenths).at(1) ==
        "0,1,0x0p+0,0x1.999999999999ap-4,0x0p+0,0x1.999999999999ap-4");
  CHECK(rows_of(folder, exact + " --fraction", tenths).at(2) == "0,2,0,0,1/10,1/10");
  CHECK(rows_of(folder, "--space clip --scalar double --fraction", "-1 0 0 4  0 1 0 2  0 0 1 2\n")
            .at(0) == "0,0,-1/4,0,0,1/4");
  const Result both = folder.run("clip --space clip --hex --fraction", tenths);
  CHECK(both.code == 2);
  CHECK_THAT(both.err, Catch::Matchers::Contains("--fraction"));
}

TEST_CASE("clip: reads and writes hex floats without losing a bit") {
  const Folder folder;
  const std::string third = "0x1.555556p-2";
  const Result r =
      folder.run("clip --space clip --hex", third + " 0 0 1  0x1p-1 0 0 1  0 0x1p-1 0 1\n");
  REQUIRE(r.code == 0);
  CHECK(contains(r.out, "0,0," + third + ",0x0p+0,0x0p+0,0x1p+0"));
}

TEST_CASE("clip: depth conventions and projections reach the clipper") {
  const Folder folder;
  const auto z_of = [&](const std::string& options) {
    const Result r =
        folder.run("clip --space view --scalar double " + options, "0 0 -1  0.5 0 -1  0 0.5 -1\n");
    REQUIRE(r.code == 0);
    return lines(r.out).at(1);
  };
  CHECK(z_of("--frustum -1,1,-1,1,1,10 --depth gl") == "0,0,0,0,-1,1");
  CHECK(z_of("--frustum -1,1,-1,1,1,10 --depth zero_to_one") == "0,0,0,0,0,1");
  CHECK(z_of("--frustum -1,1,-1,1,1,inf --depth reversed") == "0,0,0,0,1,1");
  CHECK(z_of("--ortho -1,1,-1,1,1,10 --depth reversed") == "0,0,0,0,1,1");
}

TEST_CASE("clip: an oblique view is cut where its sheared sides are") {
  // At z = -2 the sides bound x - 1, so x from 0 to 2.
  const Folder folder;
  const std::string options = "--scalar exact --fraction --ortho -1,1,-1,1,1,3 ";
  const std::string input = "1 0 -2  3 0 -2  1 0.5 -2\n";
  CHECK(rows_of(folder, options + "--shear 0.5,0", input) ==
        Lines{"0,0,0,0,0,1", "0,1,1,0,0,1", "0,2,1,1/4,0,1", "0,3,0,1/2,0,1"});
  for (const char* wrong : {"--frustum -1,1,-1,1,1,3 --shear 0.5,0", "--space clip --shear 0.5,0",
                            "--ortho -1,1,-1,1,1,3 --shear 0.5,nan"}) {
    const Result r = folder.run(std::string("clip ") + wrong, input);
    CHECK(r.code == 2);
    CHECK_THAT(r.err, Catch::Contains("--shear"));
  }
}

TEST_CASE("clip: a malformed line is named with its number, exit 3, and nothing is written") {
  const Folder folder;
  const auto expect = [&](const std::string& input, const std::string& message) {
    const Result r = folder.run("clip --space view --perspective 90,1,1,10", input);
    INFO(r.err);
    CHECK(r.code == 3);
    CHECK(r.out.empty());
    CHECK(contains(r.err, message));
  };
  expect(std::string(kHalfOutside) + "1 2 3\n", "standard input:2: found 3 numbers");
  expect("0 0 -2  3 0 -2  0 one -2\n", "standard input:1: 'one' is not a number");
  expect("0 0 -2  3 0 -2  0 nan -2\n", "'nan' is not finite");
  expect("0 0 -2  3 0 -2  0 1e39 -2\n", "'1e39' is not finite as a float");
  const Result missing = folder.run("clip --space view --perspective 90,1,1,10 /no/such/file");
  CHECK(missing.code == 3);
  CHECK(contains(missing.err, "/no/such/file"));
}

TEST_CASE("clip: every clipper clips, and every primitive in every scalar") {
  const Folder folder;
  const auto check = [&](const std::string& primitive, const std::string& options) {
    const std::size_t rows =
        rows_of(folder, "--ortho -1,1,-1,1,1,10 --primitive " + primitive + options,
                primitive_input(primitive))
            .size();
    INFO(primitive << options);
    CHECK(rows == vertices_of(primitive));
  };
  const auto clippers = nlohmann::json::parse(folder.run("list clippers --json").out);
  REQUIRE(clippers.size() >= 34);
  for (const auto& clipper : clippers) {
    check(clipper["primitive"], " --clipper " + clipper["name"].get<std::string>());
  }
  const auto scalars = nlohmann::json::parse(folder.run("list scalars --json").out);
  REQUIRE(scalars.size() == 5);
  for (const auto& scalar : scalars) {
    for (const char* primitive : {"point", "segment", "triangle", "polygon"}) {
      check(primitive, " --scalar " + scalar["name"].get<std::string>());
    }
  }
}

TEST_CASE("clip: a clipper takes the volume's options unless its promise says that it does not") {
  const Folder folder;
  const auto clippers = nlohmann::json::parse(folder.run("list clippers --json").out);
  std::set<bool> met;
  for (const auto& clipper : clippers) {
    const std::string primitive = clipper["primitive"], promise = clipper["promise"];
    const auto check = [&](const std::string& option, const std::string& name) {
      const Result r =
          folder.run("clip --ortho -1,1,-1,1,1,10 --primitive " + primitive + " --clipper " +
                         clipper["name"].get<std::string>() + " " + option,
                     primitive_input(primitive));
      const std::string refused = "; does not take ";
      const bool takes =
          !contains(promise, refused) || !contains(promise.substr(promise.find(refused)), name);
      INFO(clipper["name"] << " " << option << "\n" << r.err);
      CHECK(r.code == (takes ? 0 : 2));
      CHECK(contains(r.err, takes ? "" : "does not take"));
      met.insert(takes);
    };
    check("--depth-clamp", "depth clamp");
    check("--plane 1,0,0,3", "clip distances");
    check("--half-open", "open sides");
  }
  CHECK(met.size() == 2);
}

TEST_CASE("clip: a segment keeps its order and its attributes stay linear") {
  const Folder folder;
  const Result r =
      folder.run("clip --primitive segment --space clip --attributes 1",
                 "-2 0 0 1 0  2 0 0 1 4\n5 0 0 1 0  6 0 0 1 0\n2 0 0 1 4  0 0 0 1 2\n");
  REQUIRE(r.code == 0);
  CHECK(lines(r.out) == Lines{"segment,vertex,x,y,z,inv_w,a0", "0,0,-1,0,0,1,1", "0,1,1,0,0,1,3",
                              "2,0,1,0,0,1,3", "2,1,0,0,0,1,2"});
}

TEST_CASE("clip: a point is there or not") {
  const Folder folder;
  const Result r = folder.run("clip --primitive point --ortho -2,2,-2,2,1,3",
                              "1 1 -2\n3 0 -2 # outside\n-2 2 -2\n");
  REQUIRE(r.code == 0);
  CHECK(lines(r.out) == Lines{"point,vertex,x,y,z,inv_w", "0,0,0.5,0.5,0,1", "2,0,-1,1,0,1"});
}

TEST_CASE("clip: a large point stays for pop_free while its square is in sight") {
  const Folder folder;
  // 1.125 in NDC: an eighth of 1 outside is 16 of the 256 pixels, half of a square of 32.
  const auto kept = [&](const std::string& options) {
    return rows_of(folder, "--primitive point --space clip " + options, "1.125 0 0 1\n").size();
  };
  CHECK(kept("--clipper pop_free --point-size 32 --viewport 256x256") == 1);
  CHECK(kept("--clipper pop_free --point-size 31.5 --viewport 256x256") == 0);
  CHECK(kept("--clipper pop_free --point-size 32 --viewport 257x8 --scalar exact") == 0);
  CHECK(kept("--clipper pop_free --point-size 32 --viewport 256x8 --scalar exact") == 1);
  CHECK(kept("--clipper pop_free") == 0);
  CHECK(kept("--clipper pop --point-size 32 --viewport 256x256") == 0);
  CHECK(kept("--point-size 32 --viewport 256x256") == 0);
}

TEST_CASE("clip: a convex polygon of any size is one part") {
  const Folder folder;
  const Result r = folder.run("clip --primitive polygon --space clip --attributes 1",
                              "0 -0.5 0 1 0  2 -0.5 0 1 2  2 0 0 1 2  2 0.5 0 1 2  0 0.5 0 1 0\n");
  REQUIRE(r.code == 0);
  CHECK(lines(r.out) == Lines{"polygon,part,vertex,x,y,z,inv_w,a0", "0,0,0,0,-0.5,0,1,0",
                              "0,0,1,1,-0.5,0,1,1", "0,0,2,1,0.5,0,1,1", "0,0,3,0,0.5,0,1,0"});
}

TEST_CASE("clip: a concave polygon is cut into triangles first") {
  const Folder folder;
  const auto areas = [&](const std::string& options) {
    return twice_areas(rows_of(folder, "--primitive polygon --space clip " + options, kDart));
  };
  // Each half has half of width 0.5 times height 0.75.
  CHECK(areas("") == std::vector<double>{0.375, 0.375});
  CHECK(areas("--clipper textbook") == std::vector<double>{0.375, 0.375});
  // x >= 0 leaves one half.
  CHECK(areas("--plane 1,0,0,0").back() == 0.375);
  CHECK(rows_of(folder, "--primitive polygon --space clip --plane 1,0,0,0", kDart).size() == 3);
  // Below y = -0.25 each half keeps a triangle of width 0.375 and height 0.25.
  CHECK(areas("--plane 0,-1,0,-0.25") == std::vector<double>{0.09375, 0.09375});
}

TEST_CASE("clip: a clipper of triangles gets every polygon in triangles") {
  const Folder folder;
  const auto areas = [&](const std::string& options) {
    return twice_areas(rows_of(folder, "--primitive polygon --space clip " + options, kSquare));
  };
  CHECK(areas("") == std::vector<double>{2});
  CHECK(areas("--clipper homogeneous/polygon") == std::vector<double>{2});
  CHECK(areas("--clipper homogeneous/pipeline") == std::vector<double>{1, 1});
}

TEST_CASE("clip: a polygon that is not flat is clipped as triangles, and a note says so") {
  const Folder folder;
  const std::string fold = "-3 -3 -2  3 -3 -2  3 3 -4  -3 3 -2\n";
  const Result r = folder.run("clip --primitive polygon --perspective 90,1,1,3", fold);
  CHECK(r.code == 0);
  CHECK(contains(r.err, "1 polygon is not flat"));
  CHECK(contains(r.err, "standard input:1, where vertex"));
  CHECK(contains(r.out, "0,1,0,"));
  // The triangles are those of a clipper of triangles.
  const Result triangles = folder.run(
      "clip --primitive polygon --clipper homogeneous/sutherland_hodgman --perspective 90,1,1,3",
      fold);
  CHECK(triangles.out == r.out);
  CHECK(triangles.err == r.err);
  CHECK(folder.run("clip --primitive polygon --space clip", kSquare).err.empty());
}

TEST_CASE("clip: a closed ring is the polygon that it goes around") {
  const Folder folder;
  const std::string open = "0 0 0 1 5  .5 0 0 1 6  .5 .5 0 1 7";
  const auto rows = [&](const std::string& input) {
    return rows_of(folder, "--primitive polygon --space clip --attributes 1", input);
  };
  CHECK(rows(open + "  0 0 0 1 5\n") == rows(open + "\n"));
  const Result other =
      folder.run("clip --primitive polygon --space clip --attributes 1", open + "  0 0 0 1 8\n");
  CHECK(other.code == 3);
  CHECK(contains(other.err,
                 "standard input:1: vertices 0 and 3 (counted from 0) are the same point"));
}

TEST_CASE("clip: polygons of view space may start in view space") {
  const Folder folder;
  const Lines rows =
      rows_of(folder, "--primitive polygon --ortho -1,1,-1,1,1,3 --clipper view/sutherland_hodgman",
              "-0.5 -0.5 -2  0 -0.25 -2  0.5 -0.5 -2  0 0.5 -2\n");
  CHECK(twice_areas(rows) == std::vector<double>{0.375, 0.375});
}

TEST_CASE("clip: a scissor rectangle cuts at its pixels, in clip space and in view space") {
  const Folder folder;
  // Of x from -1 to 1 on 640 pixels, 160 to 480 are -1/2 to 1/2.
  const std::string scissor = "--primitive segment --viewport 640x480 --scissor 160,0,320,480 ";
  const Lines half = {"0,0,-0.5,0,0,0.25", "0,1,0.5,0,0,0.25"};
  CHECK(rows_of(folder, "--space clip " + scissor, "-4 0 0 4  4 0 0 4\n") == half);
  CHECK(rows_of(folder, "--frustum -1,1,-1,1,1,inf --depth zero_to_one --scalar exact " + scissor,
                "-4 0 -4  4 0 -4\n") == Lines{"0,0,-0.5,0,0.75,0.25", "0,1,0.5,0,0.75,0.25"});
  CHECK(rows_of(folder, "--ortho 0,4,-1,1,1,3 " + scissor, "0 0 -2  4 0 -2\n") ==
        Lines{"0,0,-0.5,0,0,1", "0,1,0.5,0,0,1"});
  CHECK(rows_of(folder, "--matrix 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,4 " + scissor, "-4 0 0  4 0 0\n") ==
        half);
  // y goes upwards: the lower quarter.
  CHECK(rows_of(folder, "--space clip --primitive segment --viewport 640x480 --scissor 0,0,640,120",
                "0 -1 0 1  0 1 0 1\n") == Lines{"0,0,0,-1,0,1", "0,1,0,-0.5,0,1"});
}

TEST_CASE("clip: flat attributes are those of the provoking vertex, at every vertex, to the bit") {
  const Folder folder;
  const auto flat_of = [&](const std::string& options, const std::string& input) {
    std::set<std::string> values;
    for (const std::string& row :
         rows_of(folder, "--space clip --attributes 2 " + options, input)) {
      values.insert(row.substr(row.rfind(',') + 1));
    }
    return values;
  };
  const std::string triangle = "0 0 0 1 0 0.1  3 0 0 1 1 0.2  0 3 0 1 2 16777215\n";
  const std::string all = "--clipper 'distance_matrix' --flat 1";
  CHECK(flat_of("--flat 1", triangle) == std::set<std::string>{"0.1"});
  CHECK(flat_of(all + " --provoking last", triangle) == std::set<std::string>{"16777215"});
  CHECK(flat_of("--provoking first", triangle).size() > 2);
  // The parts of a concave polygon have that of the polygon.
  const std::string dart = "0 0 0 1 0 7  1 -1 0 1 0 6  0 1 0 1 0 5  -1 -1 0 1 0 4\n";
  CHECK(flat_of("--primitive polygon --flat 1", dart) == std::set<std::string>{"7"});
  const Result r = folder.run("clip --space clip --attributes 2 --flat 3", triangle);
  CHECK(r.code == 2);
  CHECK(contains(r.err, "--flat: 3 asked for"));
}

TEST_CASE("clip: depth is clamped at both planes or at one") {
  const Folder folder;
  const auto depths = [&](const std::string& option) {
    std::vector<double> z;
    for (const std::string& row :
         rows_of(folder, "--space clip --primitive segment " + option, "0 0 -3 1  0 0 3 1\n")) {
      z.push_back(numbers_of(row).at(4));
    }
    return z;
  };
  CHECK(depths("") == std::vector<double>{-1, 1});
  CHECK(depths("--depth-clamp") == std::vector<double>{-3, 3});
  CHECK(depths("--depth-clamp=both") == std::vector<double>{-3, 3});
  CHECK(depths("--depth-clamp=near") == std::vector<double>{-3, 1});
  CHECK(depths("--depth-clamp=far") == std::vector<double>{-1, 3});
  CHECK(folder.run("clip --space clip --depth-clamp=side", "").code == 2);
}

// The borders x = w and y = w of a tile are x = -w and y = -w of its neighbours.
TEST_CASE("clip: half-open tiles answer a point in their border once") {
  const Folder folder;
  const auto kept = [&](const std::string& option) {
    return rows_of(folder, "--primitive point --space clip " + option,
                   "1 0 0 1\n-1 0 0 1\n0 1 0 1\n0 -1 0 1\n");
  };
  CHECK(kept("").size() == 4);
  CHECK(kept("--half-open") == Lines{"1,0,-1,0,0,1", "2,0,0,1,0,1"});
  CHECK(kept("--half-open=top-left") == kept("--half-open"));
  CHECK(kept("--half-open=right,top") == Lines{"1,0,-1,0,0,1", "3,0,0,-1,0,1"});
  CHECK(kept("--half-open=left,right,bottom,top").empty());
  const Result r = folder.run("clip --space clip --half-open=near", "");
  CHECK(r.code == 2);
  CHECK(contains(r.err, "'near' given, some of left, right, bottom and top expected"));
}

TEST_CASE("clip: a user plane cuts in the space of the input") {
  const Folder folder;
  // View space, x >= 0 of the triangle beneath the diagonal of a square.
  CHECK(rows_of(folder, "--ortho -1,1,-1,1,1,3 --plane 1,0,0,0",
                "-0.5 -0.5 -2  0.5 -0.5 -2  0.5 0.5 -2\n") ==
        Lines{"0,0,0,0,0,1", "0,1,0,-0.5,0,1", "0,2,0.5,-0.5,0,1", "0,3,0.5,0.5,0,1"});
  // View space, x >= 1: half of the width, the frustum being 2 wide to each side.
  CHECK(rows_of(folder, "--primitive segment --ortho -2,2,-2,2,1,3 --plane 1,0,0,-1",
                "0 0 -2  2 0 -2\n") == Lines{"0,0,0.5,0,0,1", "0,1,1,0,0,1"});
  // Clip space, x >= w / 2 with w = 2.
  CHECK(rows_of(folder, "--primitive segment --space clip --plane 1,0,0,-0.5",
                "0 0 0 2  2 0 0 2\n") == Lines{"0,0,0.5,0,0,0.5", "0,1,1,0,0,0.5"});
}

TEST_CASE("clip: --plane may be given again, in every scalar") {
  const Folder folder;
  for (const char* scalar : {"float", "double", "double_double", "exact", "counting"}) {
    INFO(scalar);
    const std::string options =
        "--primitive segment --space clip --hex --plane 1,0,0,0.5 --plane -1,0,0,0.5 --scalar ";
    const Lines rows = rows_of(folder, options + scalar, "-2 0 0 1  2 0 0 1\n");
    CHECK(rows == Lines{"0,0,-0x1p-1,0x0p+0,0x0p+0,0x1p+0", "0,1,0x1p-1,0x0p+0,0x0p+0,0x1p+0"});
  }
}

TEST_CASE("clip: a clipper of many triangles at once is cut by planes and clip distances, too") {
  const Folder folder;
  const std::string options =
      "--ortho -1,1,-1,1,1,3 --attributes 1 --clip-distances 1 --plane 1,0,0,0";
  const std::string input = "-0.5 -0.5 -2 1  0.5 -0.5 -2 1  0.5 0.5 -2 -1\n";
  const Lines rows = rows_of(folder, options, input);
  CHECK(rows ==
        Lines{"0,0,0,0,0,1,0", "0,1,0,-0.5,0,1,1", "0,2,0.5,-0.5,0,1,1", "0,3,0.5,0,0,1,0"});
  CHECK(rows_of(folder, options + " --clipper homogeneous/batch", input) == rows);
}

TEST_CASE("clip: double-double is written to 32 digits") {
  const Folder folder;
  const Lines rows =
      rows_of(folder, "--primitive point --space clip --scalar double_double", "1 0 0 3\n");
  const std::string third = "3.33333333333333333333333333333332e-01",
                    zero = "0.00000000000000000000000000000000e+00";
  CHECK(rows == Lines{"0,0," + third + "," + zero + "," + zero + "," + third});
}

TEST_CASE("clip: however many primitives there are, each keeps its number") {
  const Folder folder;
  std::string input;
  for (int i = 0; i < 3000; ++i) input += i % 2 == 0 ? "0 0 0 1\n" : "2 0 0 1\n";
  const Lines rows = rows_of(folder, "--primitive point --space clip", input);
  REQUIRE(rows.size() == 1500);
  CHECK(rows.front() == "0,0,0,0,0,1");
  CHECK(rows[700] == "1400,0,0,0,0,1");
  CHECK(rows.back() == "2998,0,0,0,0,1");
}

TEST_CASE("clip: the first attributes are clip distances, and stay; those of planes do not") {
  const Folder folder;
  const std::string input = "0 0 0 1 1 5  0.5 0 0 1 -1 5  0 0.5 0 1 1 9\n";
  const Lines cut = {"0,0,0,0,0,1,1,5", "0,1,0.25,0,0,1,0,5", "0,2,0.25,0.25,0,1,0,7",
                     "0,3,0,0.5,0,1,1,9"};
  CHECK(rows_of(folder, "--space clip --attributes 2 --clip-distances 1", input) == cut);
  CHECK(rows_of(folder, "--space clip --attributes 2 --plane -1,0,0,0.75 --clip-distances 1",
                input) == cut);
  CHECK(rows_of(folder, "--space clip --attributes 2", input).size() == 3);
  CHECK(rows_of(folder, "--primitive point --space clip --attributes 1 --clip-distances 1",
                "0 0 0 1 -0.5\n0 0 0 1 0\n") == Lines{"1,0,0,0,0,1,0"});
}

TEST_CASE("clip: with depth clamp near and far do not cut") {
  const Folder folder;
  const std::string input = "0 0 -2 1  0.5 0 2 1\n";
  const std::string options = "--primitive segment --space clip";
  CHECK(rows_of(folder, options, input) == Lines{"0,0,0.125,0,-1,1", "0,1,0.375,0,1,1"});
  CHECK(rows_of(folder, options + " --depth-clamp", input) ==
        Lines{"0,0,0,0,-2,1", "0,1,0.5,0,2,1"});
}

TEST_CASE("clip: a line with the wrong count of numbers is named, with the count expected") {
  const Folder folder;
  const auto expect = [&](const std::string& options, const std::string& input,
                          const std::string& message) {
    const Result r = folder.run("clip --space clip --primitive " + options, input);
    INFO(r.err);
    CHECK(r.code == 3);
    CHECK(r.out.empty());
    CHECK(contains(r.err, message));
  };
  expect("point", "0 0 0 1\n0 0 0\n",
         "standard input:2: found 3 numbers; a point in clip space takes 4: 1 vertex of 4");
  expect("segment --attributes 1", "0 0 0 1  1 0 0 1\n",
         "found 8 numbers; a segment in clip space takes 10: 2 vertices of 4 coordinates and 1");
  const std::string polygon = "a polygon in clip space takes a multiple of 4 from 12: 3 or more";
  expect("polygon", "0 0 0 1  1 0 0 1  1 1 0 1  5\n", "found 13 numbers; " + polygon);
  expect("polygon", "0 0 0 1  1 0 0 1\n", "found 8 numbers; " + polygon);
  expect("polygon", kSquare + std::string(kBowTie), "standard input:2: edges of the polygon cross");
  expect("polygon --clipper textbook", kBowTie, "standard input:1: edges of the polygon cross");
  expect("polygon", "0 0 0 1  1 0 0 1  2 0 0 1\n", "standard input:1: the polygon has no area");
}

TEST_CASE("clip: wrong options and names are usage errors, exit 2") {
  const Folder folder;
  const auto expect = [&](const std::string& arguments, const std::string& message) {
    const Result r = folder.run(arguments, kHalfOutside);
    INFO(arguments << "\n" << r.err);
    CHECK(r.code == 2);
    CHECK(r.out.empty());
    CHECK(contains(r.err, message));
  };
  expect("clip --space view", "--perspective");
  expect("clip --space clip --perspective 90,1,1,10", "--space view");
  expect("clip --space view --perspective 90,1,10,1", "near < far");
  expect("clip --space view --perspective 190,1,1,10", "FOVY");
  expect("clip --space clip --clipper view/sutherland_hodgman", "not applicable");
  expect("clip --space clip --clipper nobody", "homogeneous/sutherland_hodgman");
  expect("clip --space clip --scalar half", "double_double");
  expect("clip --space clip --attributes 33", "--attributes");
  expect("clip --ortho -1,1,-1,1,1,9 --clipper view/unit_normals --scalar exact",
         "view/unit_normals needs an operation that exact does not have");
  expect("clip --space clip --primitive line", "--primitive");
  expect("clip --space clip --primitive segment --clipper textbook",
         "no clipper of segments matches 'textbook'; there are: view/cyrus_beck");
  expect("clip --space clip --primitive point --clipper textbook", "point/pop, point/pop_free");
  expect("clip --space clip --clipper point/pop", "no clipper of triangles matches 'point/pop'");
  expect("clip --space clip --primitive polygon --clipper point/pop",
         "of polygons there is homogeneous/polygon");
  expect("clip --space clip --primitive polygon --clipper view/sutherland_hodgman",
         "not applicable");
  expect("clip --space clip --primitive polygon --scalar half", "no scalar is called 'half'");
  expect("clip --space clip --primitive segment --clipper view/cyrus_beck", "not applicable");
  expect("clip --space clip --clip-distances 1", "--attributes gives 0");
  expect("clip --space clip --attributes 9 --clip-distances 9", "--clip-distances");
  expect("clip --space clip --attributes 8 --clip-distances 8 --plane 1,0,0,1",
         "planes (1) and clip distances (8) are more than 8");
  expect("clip --space clip --attributes 32 --plane 1,0,0,1", "attributes (32) are more than 32");
  expect("clip --space clip --plane 1,0,0", "A,B,C,D");
  expect("clip --space clip --plane 1,0,0,nan", "--plane");
  expect("clip --space clip --plane 1,0,0,1e39", "not finite in float");
  expect("clip --ortho -1,1,-1,1,1,10 --depth-clamp --clipper cvv/near_first",
         "cvv/near_first does not take --depth-clamp");
  expect("clip --space clip --primitive point --point-size 3", "--viewport");
  expect("clip --space clip --primitive point --viewport 64x64", "--point-size");
  expect("clip --space clip --scissor 0,0,8,8", "--viewport");
  expect("clip --space clip --scissor 0,0,8,0 --viewport 8x8", "--scissor");
  expect("clip --space clip --primitive point --point-size 3 --viewport 64", "WxH");
  expect("clip --space clip --primitive point --point-size 3 --viewport 64x0", "WxH");
  expect("clip --space clip --primitive point --point-size -3 --viewport 6x6", "--point-size");
  expect("clip --space clip --primitive point --point-size inf --viewport 6x6 --scalar exact",
         "--point-size");
  expect("clip --space clip --point-size 3 --viewport 64x64", "--primitive point");
}

TEST_CASE("clip: text may begin with a byte order mark and end its lines as it likes") {
  const std::string arguments = "clip --space clip --primitive segment";
  const Folder folder;
  const Result plain = folder.run(arguments, "-2 0 0 1  2 0 0 1\n0 0 0 1  1 0 0 1\n");
  REQUIRE(plain.code == 0);
  for (const char* text :
       {"\xEF\xBB\xBF-2 0 0 1  2 0 0 1\n0 0 0 1  1 0 0 1\n",
        "-2 0 0 1  2 0 0 1\r0 0 0 1  1 0 0 1\r", "-2 0 0 1  2 0 0 1\r\n0 0 0 1  1 0 0 1\r\n"}) {
    CHECK(folder.run(arguments, text).out == plain.out);
  }
}

TEST_CASE("clip: what can't be seen in a text is named") {
  const Folder folder;
  const auto refusal = [&](const std::string& text) {
    const Result r = folder.run("clip --space clip --primitive point", text);
    CHECK(r.code == 3);
    return r.err;
  };
  CHECK(contains(refusal("0 0 0 1\xC2\xA0\n"), "'1<U+00A0 no-break space>' is not a number"));
  CHECK(contains(refusal("\xE2\x88\x92.5 0 0 1\n"), "'<U+2212 minus sign>.5' is not a number"));
  CHECK(contains(refusal(std::string("\xFF\xFE-\0", 4)),
                 "standard input: the text is UTF-16 (little-endian); UTF-8 or ASCII expected"));
}
