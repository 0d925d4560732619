// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope plan, as a user runs it.
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("cli: plan says of each effect whether a scene calls for it, and why") {
  const Folder folder;
  const Result text = folder.run("plan --scene overlay");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "Effects that overlay calls for"));
  const auto tables =
      nlohmann::json::parse(folder.run("plan --scene overlay --scene telephoto --json").out);
  REQUIRE(tables.size() == 2);
  for (const auto& row : tables[0]["rows"]) {
    for (const char* key : {"view", "effect", "called_for", "because"}) CHECK(row.contains(key));
  }
  CHECK(folder.run("plan --scene nowhere").code == 2);
}
