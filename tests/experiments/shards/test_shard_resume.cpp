// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shards that are killed and go on.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/experiments/shards/shard_folders.hpp"

namespace {

namespace fs = std::filesystem;

// Units that are done, of a store that another process writes; 0 before there is one.
int done_in(const fs::path& folder) {
  try {
    SQLite::Database database((folder / "results.sqlite").string());
    database.setBusyTimeout(10000);
    return database.execAndGet("SELECT max(done) FROM shards").getInt();
  } catch (const SQLite::Exception&) {
    return 0;
  }
}

// Starts the program and kills it once more than `least` units are done; how many are.
int done_when_killed(const std::string& arguments, const fs::path& folder, int least) {
  const pid_t child = fork();
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    const std::string command = "exec " + quoted(CLIPSCOPE_PROGRAM_PATH) + " " + arguments;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  int status = 0, done = 0;
  while (done <= least && waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    done = done_in(folder);
  }
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return done_in(folder);
}

}  // namespace

TEST_CASE("shard: killed and resumed it loses one piece at most, and gives the same table") {
  constexpr int kPiece = 64;  // chunks
  const ShardFolders folders;
  const std::string whole = folders.do_run(kSmallSweep);
  const fs::path killed = folders.path() / "killed";
  const std::string shard = kSmallSweep + " --shard 1/2 --resume --out " + folders.at("killed");
  int done = 0;
  for (int kills = 0; kills < 4; ++kills) {
    const int now = done_when_killed(shard, killed, done);
    CHECK(now > done);  // what was done before stays
    CHECK((now % kPiece == 0 || kills > 0));
    done = now;
  }
  folders.do_run(shard);
  folders.do_run(kSmallSweep + " --shard 0/2 --out " + folders.at("other"));
  CHECK(folders.merge("merged", {folders.at("killed"), folders.at("other")}) == whole);
}

TEST_CASE("shard: what is stored is not computed again") {
  const ShardFolders folders;
  const fs::path killed = folders.path() / "killed";
  const std::string command = kSmallSweep + " --resume --out " + folders.at("killed");
  REQUIRE(done_when_killed(command, killed, 0) > 0);
  SQLite::Database((killed / "results.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE lattice_small SET failures = failures + 1000000000 WHERE scalar = 'float'");
  CHECK(contains(folders.do_run(command + " --json"), "\"failures\": 10000"));
  CHECK(contains(folders.do_run(command + " --json"), "\"failures\": 10000"));  // finished already
}

TEST_CASE("shard: hunts that were killed go on with the next hunt") {
  const ShardFolders folders;
  const std::string hunts = "hunt --clipper textbook --evaluations 20000 --hunts 4";
  const std::string whole = folders.do_run(hunts + " --out " + folders.at("whole"));
  const std::string again = hunts + " --resume --out " + folders.at("killed");
  CHECK(done_when_killed(again, folders.path() / "killed", 1) >= 2);
  CHECK(folders.do_run(again) == whole);
}
