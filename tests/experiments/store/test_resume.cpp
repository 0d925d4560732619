// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program interrupted, resumed, and out of room: its tables are those of a run without all
// that.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

namespace fs = std::filesystem;

// Without timings, and of three cells.
const std::string kRun =
    "run accuracy --quick --scene teapot --scene floor --scene corridor --scalar float,double --sample 60 ";

// A run in its own process, which can be killed.
pid_t start(const std::string& arguments) {
  const pid_t child = fork();
  if (child != 0) return child;
  const int null = open("/dev/null", O_WRONLY);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  const std::string command = "exec " + quoted(CLIPSCOPE_PROGRAM_PATH) + " " + arguments;
  execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
  _exit(127);
}

// Kills it after so long; true if it was still running.
bool kill_after(pid_t child, std::chrono::microseconds delay) {
  std::this_thread::sleep_for(delay);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

std::string out(const fs::path& folder) { return "--out " + quoted(folder.string()); }

int cells_in(const fs::path& folder) {
  SQLite::Database database((folder / "results.sqlite").string());
  return database.execAndGet("SELECT count(*) FROM cell").getInt();
}

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void check_same_tables(const fs::path& a, const fs::path& b) {
  for (const char* name : {"accuracy.csv", "accuracy_worst.csv", "accuracy.md", "accuracy.tex"}) {
    INFO(name);
    REQUIRE(fs::exists(a / "accuracy" / name));
    CHECK(read(a / "accuracy" / name) == read(b / "accuracy" / name));
  }
}

}  // namespace

TEST_CASE("resume: a run killed at random moments ends in the tables of one that was not") {
  const Folder folder;
  const fs::path whole = folder.path() / "whole", killed = folder.path() / "killed";
  Result r;
  const double length = seconds([&] { r = folder.run(kRun + out(whole)); });
  INFO(r.err);
  REQUIRE(r.code == 0);
  std::mt19937 random(GENERATE(1u, 2u));
  int kills = 0;
  for (int i = 0; i < 8; ++i) {
    std::uniform_real_distribution<double> moment(0, 0.6 * length);
    const auto delay = std::chrono::microseconds(static_cast<long>(1e6 * moment(random)));
    kills += kill_after(start(kRun + out(killed) + " --resume"), delay);
  }
  CHECK(kills > 0);
  r = folder.run(kRun + out(killed) + " --resume");
  INFO(r.err);
  REQUIRE(r.code == 0);
  CHECK(cells_in(killed) == 3);
  check_same_tables(whole, killed);
  CHECK(
      folder.run("diff --table accuracy " + quoted(whole.string()) + " " + quoted(killed.string()))
          .code == 0);
}

TEST_CASE("resume: a run killed in its first transaction has left nothing, and is begun anew") {
  const Folder folder;
  const fs::path results = folder.path() / "results";
  fs::create_directories(results);
  // Pages without a table: what SQLite makes of such a file when it undoes the transaction.
  SQLite::Database((results / "results.sqlite").string(),
                   SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE t(x); DROP TABLE t");
  REQUIRE(fs::file_size(results / "results.sqlite") > 0);
  const Result r = folder.run(kRun + out(results) + (GENERATE(false, true) ? " --resume" : ""));
  INFO(r.err);
  REQUIRE(r.code == 0);
  CHECK(cells_in(results) == 3);
}

TEST_CASE("resume: what is stored is not computed again") {
  const Folder folder;
  const fs::path results = folder.path() / "results";
  REQUIRE(folder.run(kRun + out(results)).code == 0);
  SQLite::Database((results / "results.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE accuracy SET max_px = 12345.5 WHERE row_number = 0");
  const Result r = folder.run(kRun + out(results) + " --resume");
  INFO(r.err);
  REQUIRE(r.code == 0);
  CHECK(contains(read(results / "accuracy" / "accuracy.csv"), "12345.5"));
  CHECK(contains(folder.run("table accuracy --format csv --run " + quoted(results.string())).out,
                 "12345.5"));
}

TEST_CASE("resume: other options, another program are refused by name, exit 2") {
  const Folder folder;
  const fs::path results = folder.path() / "results";
  const std::string base = "run accuracy --quick --scene teapot --sample 5 --scalar float ";
  REQUIRE(folder.run(base + "--seed 3 " + out(results)).code == 0);
  const auto refused = [&](const std::string& options, const std::string& reason) {
    const Result r = folder.run(base + options + " --resume " + out(results));
    INFO(options << "\n" << r.err);
    CHECK(r.code == 2);
    CHECK(contains(r.err, reason));
  };
  refused("--seed 4", "--seed: 3 then, 4 now");
  refused("--seed 3 --clipper textbook", "--clipper: * then, textbook now");
  refused("--seed 3 --scene floor", "--scene: teapot then, teapot,floor now");
  refused("--seed 3 --near 0.5", "--near: none then, 0.5 now");
  CHECK(folder.run(base + "--seed 3 --threads 1 --resume " + out(results)).code == 0);
  SQLite::Database((results / "results.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE run SET value = 'elsewhere' WHERE key = 'commit'");
  refused("--seed 3", "commit: elsewhere then");
}

TEST_CASE("resume: a run without it keeps the results that are there") {
  const Folder folder;
  const fs::path results = folder.path() / "results";
  const std::string base = "run accuracy --quick --scene teapot --sample 5 --scalar float ";
  REQUIRE(folder.run(base + out(results)).code == 0);
  const Result r = folder.run(base + "--seed 2 " + out(results));
  REQUIRE(r.code == 0);
  CHECK(contains(r.err, "are kept as"));
  int stores = 0;
  for (const auto& entry : fs::directory_iterator(results)) {
    stores += entry.path().extension() == ".sqlite";
  }
  CHECK(stores == 2);
}

TEST_CASE("run: the tables do not depend on the number of threads") {
  const Folder folder;
  for (const char* threads : {"1", "2"}) {
    REQUIRE(folder.run(kRun + "--threads " + threads + " " + out(folder.path() / threads)).code ==
            0);
  }
  check_same_tables(folder.path() / "1", folder.path() / "2");
  CHECK(folder.run(kRun + "--threads 0").code == 2);
}

TEST_CASE("run: a file that may not grow is an error with path and reason, exit 4") {
  const Folder folder;
  const fs::path results = folder.path() / "results";
  REQUIRE(folder.run(kRun + out(results)).code == 0);
  const auto before = read(results / "accuracy" / "accuracy.csv");
  // hard_cases needs some megabytes; what accuracy has left fits.
  const auto kilobytes = fs::file_size(results / "results.sqlite") / 1024 + 16;
  const fs::path err = folder.path() / "limited";
  const std::string limited = "bash -c \"ulimit -f " + std::to_string(kilobytes) + "; exec '" +
                              CLIPSCOPE_PROGRAM_PATH + "' run accuracy hard_cases " +
                              kRun.substr(13) + "--resume " + out(results) + "\" >/dev/null 2>" +
                              quoted(err.string());
  const int status = std::system(limited.c_str());
  INFO(read(err));
  CHECK(WEXITSTATUS(status) == 4);
  CHECK(contains(read(err), results.string()));
  CHECK(contains(read(err), "File too large"));
  CHECK(folder.run("table accuracy --format csv --run " + quoted(results.string())).out == before);
}

TEST_CASE("run: a folder that takes no files is an error, exit 4") {
  const Folder folder;
  const Result r = folder.run("run accuracy --quick --scene teapot --out /proc/clipscope");
  CHECK(r.code == 4);
  CHECK(contains(r.err, "/proc/clipscope"));
}

TEST_CASE("run: a second process in the same folder is told so, exit 4") {
  const Folder folder;
  const fs::path results = folder.path() / "results";
  const pid_t first = start("run hard_cases " + out(results));
  while (!fs::exists(results / "results.sqlite")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const Result r = folder.run(kRun + out(results));
  CHECK(kill_after(first, std::chrono::microseconds(0)));
  CHECK(r.code == 4);
  CHECK(contains(r.err, "another clipscope"));
}

TEST_CASE("diff: a figure altered in the store is found, exit 1; other runs are compared by name") {
  const Folder folder;
  const fs::path a = folder.path() / "a", b = folder.path() / "b";
  REQUIRE(folder.run(kRun + out(a)).code == 0);
  fs::copy(a, b, fs::copy_options::recursive);
  const std::string diff = "diff " + quoted(a.string()) + " " + quoted(b.string());
  CHECK(folder.run(diff).code == 0);
  SQLite::Database((b / "results.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec(
          "UPDATE accuracy SET max_px = 77.25 WHERE scene = 'floor' AND clipper = 'textbook' AND scalar = 'double'; UPDATE run SET value = 'another' WHERE key = 'machine'");
  const Result r = folder.run(diff);
  INFO(r.out);
  CHECK(r.code == 1);
  for (const char* part : {"floor, textbook, double", "max_px", "77.2", "another"}) {
    CHECK(contains(r.out, part));
  }
  CHECK(folder.run(diff + " --table accuracy_worst").code == 0);
  CHECK(folder.run(diff + " --table nothing").code == 2);
  CHECK(folder.run("diff " + quoted(a.string()) + " /nowhere").code == 3);
}

TEST_CASE("table: lists the tables and prints one in each format") {
  const Folder folder;
  const fs::path results = folder.path() / "results";
  REQUIRE(folder.run(kRun + out(results)).code == 0);
  const std::string run = " --run " + quoted(results.string());
  CHECK(contains(folder.run("table" + run).out, "accuracy_worst"));
  for (const auto& [format, file] :
       {std::pair{"csv", "accuracy.csv"}, std::pair{"markdown", "accuracy.md"},
        std::pair{"latex", "accuracy.tex"}}) {
    CHECK(folder.run(std::string("table accuracy --format ") + format + run).out ==
          read(results / "accuracy" / file));
  }
  CHECK(contains(folder.run("table nothing" + run).err, "accuracy_worst"));
  CHECK(folder.run("table --run /nowhere").code == 3);
}
