// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clippers of the user's, as a user brings them: --plugin in every command that takes clippers.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

const std::string kPlugin = " --plugin " + quoted(CLIPSCOPE_OWN_PLUGIN);
const std::string kMisbehaving = " --plugin " + quoted(CLIPSCOPE_MISBEHAVING);
constexpr const char* kName = "plugin/sutherland_hodgman";
constexpr const char* kAcrossRight = "0 0 0 1  2 0 0 1  0 1 0 1\n";

// The rows of the table whose clipper has that name.
nlohmann::json rows_of(const Result& r, const std::string& clipper) {
  INFO(r.err);
  REQUIRE(r.code == 0);
  nlohmann::json found = nlohmann::json::array();
  const nlohmann::json table = nlohmann::json::parse(r.out);
  for (const auto& row : table.at("rows")) {
    if (row.at("clipper") == clipper) found.push_back(row);
  }
  return found;
}

}  // namespace

TEST_CASE("plug-in: list shows it beside our clippers") {
  const Folder folder;
  const Result r = folder.run("list clippers" + kPlugin);
  CHECK(r.code == 0);
  CHECK(contains(r.out, "plugin/sutherland_hodgman\n"));
  CHECK(contains(r.out, "homogeneous/sutherland_hodgman as a plug-in"));
  CHECK(contains(r.out, "backward error promised: none"));
}

TEST_CASE("plug-in: clip and explain take it where no clipper is named") {
  const Folder folder;
  const Result ours = folder.run("clip --space clip", kAcrossRight);
  const Result its = folder.run("clip --space clip" + kPlugin, kAcrossRight);
  CHECK(its.err.empty());
  CHECK(its.out == ours.out);
  const Result explained = folder.run("explain --space clip" + kPlugin, kAcrossRight);
  CHECK(explained.code == 0);
  CHECK(contains(explained.out, kName));
  const Result named =
      folder.run("explain --space clip --clipper textbook" + kPlugin, kAcrossRight);
  CHECK(contains(named.out, "textbook"));
}

TEST_CASE("plug-in: compare and sweep have a row for it, whatever --clipper selects") {
  const Folder folder;
  const std::string ours = "homogeneous/sutherland_hodgman";
  const std::string options = " --json --clipper " + ours + kPlugin;
  const Result r =
      folder.run("compare --quick --scene soup --sample 200 --scalar float,double" + options);
  const auto compared = rows_of(r, kName), beside = rows_of(r, ours);
  REQUIRE(compared.size() == 2);
  REQUIRE(beside.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const char* column : {"wrong", "max_px", "max_ulp", "max_attribute"}) {
      CHECK(compared[i].at(column) == beside[i].at(column));
    }
    CHECK(compared[i].at("ns_per_triangle") > 0);
  }
  const auto swept = rows_of(folder.run("sweep --triangles 2000" + options), kName);
  REQUIRE(swept.size() == 1);
  CHECK(swept[0].at("crashed") == 0);
}

TEST_CASE("plug-in: render draws with it") {
  const Folder folder;
  const std::string out = (folder.path() / "picture.exr").string();
  const Result r = folder.run("render --scene floor --quick --size 64,36 --out " + quoted(out) +
                              " --against exact" + kPlugin);
  INFO(r.err);
  CHECK(r.code == 0);
  CHECK(contains(r.out, "holes 0, extra 0"));
}

TEST_CASE("plug-in: run has it in its tables, and says how it came") {
  const Folder folder;
  const std::string out = (folder.path() / "results").string();
  const Result r = folder.run(
      "run accuracy --quick --scene soup --sample 50 --scalar float --clipper textbook --json --out " +
      quoted(out) + kPlugin);
  INFO(r.err);
  CHECK(r.code == 0);
  CHECK(contains(r.out, kName));
  CHECK(contains(read(folder.path() / "results" / "README.md"), "--plugin"));
}

TEST_CASE("plug-in: what crashes on a primitive is an outcome, and a warning of clip") {
  const Folder folder;
  setenv("CLIPSCOPE_MISBEHAVIOUR", "abort", 1);
  const Result r = folder.run("clip --space clip" + kMisbehaving,
                              "0 0 0 1  1 0 0 1  0 1 0 1\n42 0 0 1  1 0 0 1  0 1 0 1\n");
  CHECK(r.code == 0);
  CHECK(lines(r.out).size() == 4);
  CHECK(contains(r.err, "no answer to primitive 1: test/abort was ended by SIGABRT"));
  const Result explained =
      folder.run("explain --space clip" + kMisbehaving, "42 0 0 1  1 0 0 1  0 1 0 1");
  CHECK(explained.code == 0);
  CHECK(contains(explained.out, "was ended by SIGABRT"));
}

TEST_CASE("plug-in: one that can't be asked ends the command with 5 and the reason") {
  const Folder folder;
  const Result missing = folder.run("clip --space clip --plugin ./none.so", kAcrossRight);
  CHECK(missing.code == 5);
  CHECK(contains(missing.err, "--plugin: ./none.so: there is no such file"));
  setenv("CLIPSCOPE_MISBEHAVIOUR", "crash_at_once", 1);
  const Result crash = folder.run("list clippers" + kMisbehaving);
  CHECK(crash.code == 5);
  CHECK(contains(crash.err, "while it is loaded, it was ended by SIGABRT"));
}

TEST_CASE("plug-in: what it does not take is a wrong option") {
  const Folder folder;
  setenv("CLIPSCOPE_MISBEHAVIOUR", "none", 1);
  const Result depth =
      folder.run("clip --space clip --depth reversed" + kMisbehaving, kAcrossRight);
  CHECK(depth.code == 2);
  CHECK(contains(depth.err, "test/none does not take --depth reversed"));
  const Result scalar =
      folder.run("clip --space clip --scalar double" + kMisbehaving, kAcrossRight);
  CHECK(scalar.code == 2);
  CHECK(contains(scalar.err, "test/none does not compute in double"));
  const Result scenes = folder.run("compare --quick --scene soup --depth reversed" + kMisbehaving);
  CHECK(scenes.code == 2);
  CHECK(contains(scenes.err, "does not take what scenes are made of"));
  const Result none = folder.run("verify --scalar float");
  CHECK(none.code == 2);
}
