// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the program as a user does: a folder for files, its exit code and what it writes.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/machine/temporary_folder.hpp"

struct Result {
  int code = -1;
  std::string out, err;
};

inline std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// For the shell: the tree may lie in a folder with blanks in its name.
inline std::string quoted(const std::string& path) { return "'" + path + "'"; }

// A folder for one test case.
struct Folder : clipscope::experiments::TemporaryFolder {
  std::filesystem::path file(const std::string& name, const std::string& content) const {
    std::ofstream(path() / name, std::ios::binary) << content;
    return path() / name;
  }
  Result run(const std::string& arguments, const std::string& input = "") const {
    const std::filesystem::path in = file("in", input), out = path() / "out", err = path() / "err";
    const std::string command = quoted(CLIPSCOPE_PROGRAM_PATH) + " " + arguments + " <" +
                                quoted(in.string()) + " >" + quoted(out.string()) + " 2>" +
                                quoted(err.string());
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
  }

 private:
  std::filesystem::path path_;
};

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
