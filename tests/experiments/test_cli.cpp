// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program as a user runs it: exit codes, formats, messages.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/contestants/contestant.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/program.hpp"

namespace {

namespace fs = std::filesystem;
using clipscope::experiments::contestants;

constexpr const char* kHalfOutside = "0 0 -2  3 0 -2  0 1 -2\n";

}  // namespace

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
  CHECK(rows.size() == clipscope::experiments::contestants<float>().size() +
                           clipscope::experiments::contestants<double>().size());
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
  CHECK(lines(read(out / "accuracy.csv")).size() == contestants<float>().size() + 1);
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
