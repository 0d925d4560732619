// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can't be merged is refused, with the names of the folders.
#include <SQLiteCpp/SQLiteCpp.h>

#include "tests/experiments/shards/shard_folders.hpp"

namespace {

const std::string kTiny = "sweep --triangles 3000 --clipper textbook";

SQLite::Database store_in(const ShardFolders& folders, const std::string& name) {
  return {(folders.path() / name / "results.sqlite").string(), SQLite::OPEN_READWRITE};
}

}  // namespace

TEST_CASE("merge: a shard that is there twice is refused, and one that is missing") {
  const ShardFolders folders;
  const std::vector<std::string> s = folders.shards(kTiny, 3);
  folders.do_run(kTiny + " --shard 1/3 --out " + folders.at("again"));
  folders.is_refused({s[0], s[1], s[2], folders.at("again")}, 2,
                     {"shard 1/3 is in", "1of3", "again"});
  folders.is_refused({s[0], s[2]}, 2, {"1 of 3 shards are missing: 1", "0of3", "2of3", "--part"});
  folders.is_refused({s[0], s[1], s[2], folders.at("nowhere")}, 3, {"nowhere"});
}

TEST_CASE("merge: other seeds, options, numbers of shards and kinds of work are refused") {
  const ShardFolders folders;
  const std::vector<std::string> s = folders.shards(kTiny, 2);
  const auto refused = [&](const std::string& other, const std::vector<std::string>& texts) {
    folders.do_run(other + " --out " + folders.at("other"));
    folders.is_refused({s[0], folders.at("other")}, 2, texts);
  };
  refused(kTiny + " --seed 2 --shard 1/2", {"0of2", "other", "--seed: 1 there, 2 here"});
  refused("sweep --triangles 3001 --clipper textbook --shard 1/2",
          {"--triangles: 3000 there, 3001 here"});
  refused("sweep --triangles 3000 --clipper cvv/naive --shard 1/2",
          {"--clipper: textbook there, cvv/naive here"});
  refused(kTiny + " --shard 1/4", {"2 shards there, 4 here"});
  refused("hunt --clipper textbook --evaluations 50 --shard 1/2", {"sweep there, hunt here"});
}

TEST_CASE("merge: shards of another build are refused") {
  const ShardFolders folders;
  const std::vector<std::string> s = folders.shards(kTiny, 2);
  const std::string key = GENERATE("program", "commit", "version", "flags");
  store_in(folders, "1of2").exec("UPDATE run SET value = 'another' WHERE key = '" + key + "'");
  folders.is_refused(s, 2,
                     {"0of2", "1of2", key == "program" ? "another build here" : "another here"});
}

TEST_CASE("merge: a shard that is not finished is refused, with the command that finishes it") {
  const ShardFolders folders;
  const std::vector<std::string> s = folders.shards(kTiny, 2);
  store_in(folders, "0of2").exec("UPDATE shards SET done = 0");
  folders.is_refused(s, 2, {"0of2: shard 0/2 is not finished, 0 of 2", "--shard 0/2 --resume"});
}

TEST_CASE("merge: a folder without a shard, and one that would be written over, are refused") {
  const ShardFolders folders;
  const std::vector<std::string> s = folders.shards(kTiny, 1);
  folders.do_run("hunt --clipper textbook --evaluations 50 --out " + folders.at("hunted"));
  folders.is_refused({folders.at("hunted")}, 3, {"hunted: holds no shard"});
  CHECK(folders.run("merge " + s[0] + " " + s[0]).code == 2);
  CHECK(folders.run("merge " + folders.at("sum")).code == 2);
}

TEST_CASE("shard: options that do not go together are refused, by name") {
  const ShardFolders folders;
  const auto refused = [&](const std::string& arguments, const std::string& text) {
    const Result r = folders.run(arguments);
    INFO(arguments << "\n" << r.err);
    CHECK(r.code == 2);
    CHECK(contains(r.err, text));
  };
  const std::string out = " --out " + folders.at("shard");
  refused(kTiny + " --shard 3/3" + out, "--shard: '3/3' given, i/N expected");
  refused(kTiny + " --shard 0/3", "--shard: takes --out DIR");
  refused(kTiny + " --resume", "--resume: takes --out DIR");
  refused("hunt --clipper textbook --seconds 1 --shard 0/2" + out, "take --evaluations N");
  refused("run cost --shard 0/2" + out, "'cost' given; accuracy and hard_cases are spread");
  refused("run --shard 0/2" + out, "name the experiments");
  folders.do_run(kTiny + " --shard 0/2" + out);
  refused(kTiny + " --shard 1/2 --resume" + out, "--shard: 0/2 then, 1/2 now");
  refused(kTiny + " --triangles 99 --shard 0/2 --resume" + out, "triangles");
}
