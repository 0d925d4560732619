// SPDX-License-Identifier: GPL-3.0-or-later
//
// Experiments that are spread: their pieces, merged, are the run that was not spread.
#include <filesystem>

#include "tests/experiments/shards/shard_folders.hpp"

namespace {

namespace fs = std::filesystem;

void check_same_tables(const fs::path& a, const fs::path& b) {
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(a)) {
    if (entry.path().extension() != ".csv") continue;
    INFO(entry.path().string());
    CHECK(read(entry.path()) == read(b / entry.path().filename()));
    ++compared;
  }
  CHECK(compared > 0);
}

}  // namespace

TEST_CASE("merge: pieces of experiments from shards are the run that was not spread") {
  const std::string name = GENERATE("accuracy", "hard_cases");
  const ShardFolders folders;
  const std::string run = "run " + name +
                          " --quick --scene teapot --scene floor --scene corridor --scene slivers" +
                          " --sample 40 --clipper homogeneous/sutherland_hodgman --scalar float";
  folders.do_run(run + " --out " + folders.at("whole"));
  const std::vector<std::string> s = folders.shards(run, 3);
  CHECK(!fs::exists(folders.path() / "0of3" / name / (name + ".csv")));
  folders.merge("left", {s[2], s[0]}, " --part");
  const std::string told = folders.merge("merged", {s[1], folders.at("left")});
  CHECK(contains(told, "clipscope run " + name));
  folders.do_run(run + " --resume --out " + folders.at("merged"));
  check_same_tables(folders.path() / "whole" / name, folders.path() / "merged" / name);
  CHECK(folders.run("diff " + folders.at("whole") + " " + folders.at("merged")).code == 0);
}

TEST_CASE("merge: a run that is not spread does not go on in the folder of a shard") {
  const ShardFolders folders;
  const std::string run = "run accuracy --quick --scene teapot --sample 20 --clipper textbook";
  const std::vector<std::string> s = folders.shards(run, 2);
  const Result r = folders.run(run + " --resume --out " + s[0]);
  CHECK(r.code == 2);
  CHECK(contains(r.err, "--shard: 0/2 then, none now"));
}
