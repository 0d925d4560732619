// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope list, as a user runs it; and that experiments/README.md says the same.
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

// "name: question" of the rows `| [name/](name/README.md) | question |`.
std::vector<std::string> questions_of_readme() {
  static const std::regex kRow(R"(\| \[(\w+)/\]\(\1/README\.md\) \| (.+) \|)");
  std::vector<std::string> questions;
  for (const std::string& line : lines(read(CLIPSCOPE_SOURCE_DIR "/experiments/README.md"))) {
    std::smatch row;
    if (std::regex_match(line, row, kRow)) questions.push_back(row.str(1) + ": " + row.str(2));
  }
  return questions;
}

}  // namespace

TEST_CASE("list: experiments and their questions are those of experiments/README.md") {
  const Folder folder;
  std::vector<std::string> questions;
  for (const auto& e : nlohmann::json::parse(folder.run("list experiments --json").out)) {
    questions.push_back(e["name"].get<std::string>() + ": " + e["question"].get<std::string>());
  }
  CHECK(questions.size() >= 17);
  CHECK(questions == questions_of_readme());
}

TEST_CASE("list: clippers of every primitive, with what their promises hold to the bit") {
  const Folder folder;
  std::set<std::string> primitives;
  for (const auto& clipper : nlohmann::json::parse(folder.run("list clippers --json").out)) {
    for (const char* key : {"name", "primitive", "space_inputs", "summary", "promise", "source"}) {
      CHECK(clipper.contains(key));
    }
    primitives.insert(clipper["primitive"]);
    if (clipper["name"] == "homogeneous/liang_barsky") {
      CHECK(contains(clipper["promise"], "; to the bit: total, watertight, rotation, scale"));
    }
  }
  CHECK(primitives == std::set<std::string>{"point", "polygon", "segment", "triangle"});
  CHECK(contains(folder.run("list clippers").out, "point/pop_free\n    primitive: point\n"));
}

TEST_CASE("list: scalars, and the scenes that can be run by their names") {
  const Folder folder;
  const auto scalars = nlohmann::json::parse(folder.run("list scalars --json").out);
  CHECK(scalars[0]["name"] == "float");
  CHECK(scalars[0]["precision_bits"] == 24);
  CHECK(scalars[3]["name"] == "exact");
  CHECK(scalars[3]["precision_bits"].is_null());
  for (const auto& scene : nlohmann::json::parse(folder.run("list scenes --json").out)) {
    INFO(scene["name"]);
    CHECK(folder
              .run("verify --clipper whole/all_outside --quick --sample 1 --scene " +
                   scene["name"].get<std::string>())
              .code == 0);
  }
  CHECK(folder.run("list nothing").code == 2);
}
