// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope merge, as a user runs it: the sum of shards is the whole.
#include <algorithm>
#include <filesystem>

#include "experiments/hunt/rows.hpp"
#include "experiments/survey/lattice_sweep.hpp"
#include "tests/experiments/shards/shard_folders.hpp"

using namespace clipscope::experiments;

TEST_CASE("merge: 1, 3 and 16 shards in any order give the same table to the byte") {
  const ShardFolders folders;
  const std::string whole = folders.do_run(kSmallSweep);
  CHECK(contains(whole, "homogeneous/sutherland_hodgman"));
  CHECK(folders.do_run(kSmallSweep + " --shard 0/1 --out " + folders.at("stored")) == whole);
  for (const int count : {1, 3, 16}) {
    INFO(count << " shards");
    std::vector<std::string> shards = folders.shards(kSmallSweep, count);
    std::rotate(shards.begin(), shards.begin() + count / 2, shards.end());
    CHECK(folders.merge("merged", shards) == whole);
    for (const char* file : {"lattice_small.csv", "lattice_small.md", "lattice_small.tex"}) {
      const std::string text = read(folders.path() / "merged" / file);
      CHECK(!text.empty());
      CHECK(text == read(folders.path() / "stored" / file));
    }
    CHECK(folders.do_run("table lattice_small --run " + folders.at("merged") + " --format csv") ==
          folders.do_run("table lattice_small --run " + folders.at("stored") + " --format csv"));
  }
}

TEST_CASE("merge: merged folders are merged again, as a tree") {
  const ShardFolders folders;
  const std::vector<std::string> s = folders.shards(kSmallSweep, 5);
  const std::string flat = folders.merge("flat", s);
  CHECK(contains(folders.merge("left", {s[3], s[0]}, " --part"), "some of 5 shards"));
  folders.merge("right", {s[4], s[1]}, " --part");
  CHECK(folders.merge("tree", {folders.at("right"), s[2], folders.at("left")}) == flat);
}

TEST_CASE("merge: random triangles of both spaces, with a shard that has nothing to do") {
  const ShardFolders folders;
  const std::string sweep = "sweep --triangles 7000 --seed 3 --clipper '*/sutherland_hodgman'";
  const std::string whole = folders.do_run(sweep);
  CHECK(contains(whole, "view/sutherland_hodgman"));
  CHECK(folders.merge("merged", folders.shards(sweep, 3)) == whole);
}

TEST_CASE("merge: of equal errors the one in the lowest chunk stays, whichever comes first") {
  Tally low, high;
  low.max_px = high.max_px = 2;
  low.worst = "low";
  low.worst_chunk = 3;
  high.worst = "high";
  high.worst_chunk = 10;
  Tally a = low, b = high;
  a += high;
  b += low;
  CHECK(a.worst == "low");
  CHECK(b.worst == "low");
  high.max_px = 2.5;
  b = low;
  b += high;
  CHECK(b.worst == "high");
}

TEST_CASE("merge: hunts of many seeds are the same from any number of shards") {
  const ShardFolders folders;
  const std::string hunts =
      "hunt --clipper cvv/near_first --measure px,containment --evaluations 600 --hunts 3";
  const std::string whole = folders.do_run(hunts + " --out " + folders.at("whole"));
  CHECK(contains(whole, "containment"));
  CHECK(folders.merge("three", folders.shards(hunts, 3)) == whole);
  CHECK(folders.merge("two", folders.shards(hunts, 2)) == whole);
  CHECK(read(folders.path() / "three/hunt.csv") == read(folders.path() / "two/hunt.csv"));
  const std::string corpus = folders.at("worst.cases");
  folders.do_run("promote " + folders.at("three") + " --corpus-out " + corpus);
  CHECK(contains(read(folders.path() / "worst.cases"), "cvv_near_first_float_px"));
}

TEST_CASE("merge: of hunts that found equally much the one of the lower seed stays") {
  hunt::HuntRow none;
  none.clipper = "a";
  none.scalar = "float";
  none.measure = "px";
  none.hunts = 0;
  hunt::HuntRow first = none, second = none;
  first.hunts = second.hunts = 1;
  first.worst = second.worst = 4;
  first.seed = 1;
  second.seed = 2;
  first.replay = "first";
  second.replay = "second";
  first.failing = "extra";
  second.failing = "missing";
  hunt::HuntRow sum = none;
  sum += second;
  sum += first;
  CHECK(sum.replay == "first");
  CHECK(sum.hunts == 2);
  CHECK(sum.failing == "missing, extra");
}
