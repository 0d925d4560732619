// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program as a user runs it: exit codes, formats, messages.
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/catch.hpp"

namespace {

namespace fs = std::filesystem;

struct Result {
  int code = -1;
  std::string out, err;
};

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// For the shell: the tree may lie in a folder with blanks in its name.
std::string quoted(const std::string& path) { return "'" + path + "'"; }

// A folder for one test case.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("clipscope-cli-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path file(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

  Result run(const std::string& arguments, const std::string& input = "") const {
    const fs::path in = file("in", input), out = path_ / "out", err = path_ / "err";
    const std::string command = quoted(CLIPSCOPE_PROGRAM_PATH) + " " + arguments + " <" +
                                quoted(in.string()) + " >" + quoted(out.string()) + " 2>" +
                                quoted(err.string());
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
  }

 private:
  fs::path path_;
};

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

constexpr const char* kHalfOutside = "0 0 -2  3 0 -2  0 1 -2\n";

}  // namespace

TEST_CASE("cli: clip writes a row per vertex") {
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

TEST_CASE("cli: clip numbers triangles in input order and skips those without output") {
  const Folder folder;
  const Result r = folder.run("clip --space clip --attributes 1",
                              "# nothing of this one\n5 0 0 1 0, 6 0 0 1 0, 5 1 0 1 0\n\n"
                              "0,0,0,1,7 0.5,0,0,1,8 0,0.5,0,1,9 # inside\n");
  REQUIRE(r.code == 0);
  CHECK(lines(r.out) == std::vector<std::string>{"triangle,vertex,x,y,z,inv_w,a0", "1,0,0,0,0,1,7",
                                                 "1,1,0.5,0,0,1,8", "1,2,0,0.5,0,1,9"});
}

TEST_CASE("cli: clip reads and writes hex floats without losing a bit") {
  const Folder folder;
  const std::string third = "0x1.555556p-2";
  const Result r =
      folder.run("clip --space clip --hex", third + " 0 0 1  0x1p-1 0 0 1  0 0x1p-1 0 1\n");
  REQUIRE(r.code == 0);
  CHECK(contains(r.out, "0,0," + third + ",0x0p+0,0x0p+0,0x1p+0"));
}

TEST_CASE("cli: every clipper and scalar clips") {
  const Folder folder;
  const auto clippers = nlohmann::json::parse(folder.run("list clippers --json").out);
  const auto scalars = nlohmann::json::parse(folder.run("list scalars --json").out);
  REQUIRE(clippers.size() >= 8);
  REQUIRE(scalars.size() == 5);
  for (const auto& clipper : clippers) {
    for (const auto& scalar : scalars) {
      const std::string options = "clip --space view --ortho -1,1,-1,1,1,10 --clipper " +
                                  clipper["name"].get<std::string>() + " --scalar " +
                                  scalar["name"].get<std::string>();
      const Result r = folder.run(options, "0 0 -2  0.5 0 -2  0 0.5 -2\n");
      INFO(options);
      CHECK(r.code == 0);
      CHECK(lines(r.out).size() == 4);
    }
  }
}

TEST_CASE("cli: depth conventions and projections reach the clipper") {
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

TEST_CASE("cli: a malformed line is named with its number, exit 3, and nothing is written") {
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

TEST_CASE("cli: wrong options and names are usage errors, exit 2") {
  const Folder folder;
  const auto expect = [&](const std::string& arguments, const std::string& message) {
    const Result r = folder.run(arguments, kHalfOutside);
    INFO(arguments << "\n" << r.err);
    CHECK(r.code == 2);
    CHECK(contains(r.err, message));
  };
  expect("", "subcommand");
  expect("frobnicate", "frobnicate");
  expect("clip --space view", "--perspective");
  expect("clip --space clip --perspective 90,1,1,10", "--space view");
  expect("clip --space view --perspective 90,1,10,1", "near < far");
  expect("clip --space view --perspective 190,1,1,10", "FOVY");
  expect("clip --space clip --clipper view/sutherland_hodgman", "not applicable");
  expect("clip --space clip --clipper nobody", "homogeneous/sutherland_hodgman");
  expect("clip --space clip --scalar half", "double_double");
  expect("clip --space clip --attributes 33", "--attributes");
  expect("verify --clipper 'cvv/*'", "several");
  expect("run nothing", "no experiment is called 'nothing'");
  expect("render --scene teapot --clipper textbook --out picture.gif", "--out");
  expect("compare --scene nowhere", "nowhere");
}

TEST_CASE("cli: help teaches and version tells") {
  const Folder folder;
  for (const char* command :
       {"", "run", "compare", "verify", "clip", "explain", "render", "list"}) {
    const Result r = folder.run(std::string(command) + " --help");
    CHECK(r.code == 0);
    CHECK(r.out.size() > 200);
  }
  CHECK(contains(folder.run("--version").out, "clipscope 0."));
}

TEST_CASE("cli: verify exits 0 where the promise holds and prints JSON") {
  const Folder folder;
  const Result r = folder.run(
      "verify --clipper cvv/near_first --scalar float --scene teapot --quick --sample 50 --json");
  REQUIRE(r.code == 0);
  const auto json = nlohmann::json::parse(r.out);
  CHECK(json["kept"] == true);
  CHECK(json["triangles"].get<int>() > 0);
  CHECK(json["largest_backward_error_ulp"].get<double>() < 93);
}

TEST_CASE("cli: compare tabulates every clipper on a mesh of the user's") {
  const Folder folder;
  const fs::path mesh =
      folder.file("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 2 4 3\n");
  const Result r = folder.run("compare --scene " + mesh.string() + " --quick --json --out " +
                              (folder.path() / "tables").string());
  INFO(r.err);
  REQUIRE(r.code == 0);
  const auto rows = nlohmann::json::parse(r.out)["rows"];
  CHECK(rows.size() == 16);
  for (const auto& row : rows) {
    CHECK(row.contains("max_px"));
    CHECK(row["ns_per_triangle"].get<double>() > 0);
  }
  CHECK(fs::exists(folder.path() / "tables" / "compare.csv"));
}

TEST_CASE("cli: a bad mesh is named with its place, exit 3") {
  const Folder folder;
  const fs::path mesh = folder.file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  const Result r = folder.run("compare --quick --scene " + mesh.string());
  CHECK(r.code == 3);
  CHECK(contains(r.err, "bad.obj:4"));
}

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

TEST_CASE("cli: render writes PNG and EXR, and says where it can't") {
  const Folder folder;
  for (const char* name : {"a.png", "a.exr"}) {
    const Result r = folder.run(
        "render --scene corridor --clipper cvv/naive --against exact --size 160,90 --out " +
        (folder.path() / name).string());
    INFO(r.err);
    CHECK(r.code == 0);
    CHECK(fs::file_size(folder.path() / name) > 1000);
    CHECK(contains(r.out, "holes"));
  }
  CHECK(
      folder
          .run(
              "render --scene corridor --clipper textbook --size 64,64 --out /no/such/folder/a.png")
          .code == 4);
}

TEST_CASE("cli: run writes tables in three formats and pictures, and can be told where") {
  const Folder folder;
  const fs::path out = folder.path() / "results";
  const Result r = folder.run(
      "run accuracy pictures --quick --sample 20 --scene corridor --scalar float --out " +
      out.string());
  INFO(r.err);
  REQUIRE(r.code == 0);
  for (const char* name : {"accuracy.md", "accuracy.csv", "accuracy.tex", "pictures.csv",
                           "corridor-cvv-naive.png", "corridor-cvv-naive.exr"}) {
    INFO(name);
    CHECK(fs::exists(out / name));
  }
  CHECK(lines(read(out / "accuracy.csv")).size() == 9);
  CHECK(folder.run("run cost --quick --out /proc/no").code == 4);
}

TEST_CASE("cli: the same seed gives the same accuracy table") {
  const Folder folder;
  const std::string arguments =
      "run accuracy --quick --sample 20 --scene soup --seed 5 --json --out " +
      (folder.path() / "r").string();
  const Result a = folder.run(arguments);
  const Result b = folder.run(arguments);
  REQUIRE(a.code == 0);
  CHECK(a.out == b.out);
}
