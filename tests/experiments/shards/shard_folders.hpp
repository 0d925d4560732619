// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shards made and merged by the program, in a folder of the test.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

// Little work: a sixteenth of the small lattice, one clipper in two scalars.
inline const std::string kSmallSweep =
    "sweep --lattice small --quick --clipper homogeneous/sutherland_hodgman --scalar float,double";

struct ShardFolders : Folder {
  std::string at(const std::string& name) const { return quoted((path() / name).string()); }

  // What must succeed; what it prints.
  std::string do_run(const std::string& arguments) const {
    const Result r = run(arguments);
    INFO(arguments << "\n" << r.err);
    REQUIRE(r.code == 0);
    return r.out;
  }

  // All shards of the command, each in a folder of its own; their names, as a shell takes them.
  std::vector<std::string> shards(const std::string& command, int count) const {
    std::vector<std::string> folders;
    for (int i = 0; i < count; ++i) {
      folders.push_back(at(fmt::format("{}of{}", i, count)));
      do_run(fmt::format("{} --shard {}/{} --out {}", command, i, count, folders.back()));
    }
    return folders;
  }

  // The folders merged, in the order given.
  std::string merge(const std::string& out, const std::vector<std::string>& folders,
                    const std::string& options = "") const {
    std::string command = "merge " + at(out) + options;
    for (const std::string& folder : folders) command += " " + folder;
    return do_run(command);
  }

  // That the merge ends with the code and an error which has all of these texts.
  void is_refused(const std::vector<std::string>& folders, int code,
                  const std::vector<std::string>& texts) const {
    std::string command = "merge " + at("refused");
    for (const std::string& folder : folders) command += " " + folder;
    const Result r = run(command);
    INFO(r.err);
    CHECK(r.code == code);
    for (const std::string& text : texts) CHECK(contains(r.err, text));
  }
};
