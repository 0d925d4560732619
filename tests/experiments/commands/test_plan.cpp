// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope plan, as a user runs it.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("cli: plan says of each effect whether a scene calls for it, and why") {
  const Folder folder;
  const Result text = folder.run("plan --scene overlay");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "Effects that overlay calls for, by view"));
  CHECK(contains(text.out, "Called for by no view: "));
  const auto tables =
      nlohmann::json::parse(folder.run("plan --scene overlay --scene telephoto --json").out);
  REQUIRE(tables.size() == 2);
  for (const auto& row : tables[0]["rows"]) {
    for (const char* key : {"view", "effect", "called_for", "because"}) CHECK(row.contains(key));
  }
  CHECK(folder.run("plan --scene nowhere").code == 2);
}

TEST_CASE("cli: plan prints a row per effect and a column per view") {
  const Folder folder;
  const Result r = folder.run("plan --scene teapot --quick");
  REQUIRE(r.code == 0);
  CHECK(lines(r.out).size() < 40);
  const std::vector<std::string> all = lines(r.out);
  const auto head =
      std::ranges::find_if(all, [](const std::string& line) { return line.starts_with("effect"); });
  REQUIRE(head != all.end());
  CHECK(contains(*head, "0: outside"));
}
