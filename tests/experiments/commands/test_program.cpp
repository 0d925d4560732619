// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program as a user runs it: help, and what is wrong with a command line.
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("cli: wrong options and names are usage errors, exit 2") {
  const Folder folder;
  const auto expect = [&](const std::string& arguments, const std::string& message) {
    const Result r = folder.run(arguments, "0 0 -2  3 0 -2  0 1 -2\n");
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
       {"", "run", "report", "table", "diff", "compare", "verify", "clip", "explain", "bounds",
        "camera", "render", "plan", "sweep", "paper", "list"}) {
    const Result r = folder.run(std::string(command) + " --help");
    INFO(command);
    CHECK(r.code == 0);
    CHECK(r.out.size() > 200);
    for (const std::string& line : lines(r.out)) {
      INFO(line);
      CHECK(line.size() <= 100);
    }
    CHECK(contains(folder.run("--help").out, std::string("  ") + command));
  }
  CHECK(contains(folder.run("--version").out, "clipscope 0."));
}
