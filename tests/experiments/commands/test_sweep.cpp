// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope sweep, as a user runs it.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("cli: sweep finds the same errors of a seed's triangles again") {
  const Folder folder;
  const std::string tables = (folder.path() / "tables").string();
  const std::string arguments = "sweep --triangles 3000 --seed 4 --clipper cvv/near_first --json";
  const Result r = folder.run(arguments + " --out " + tables);
  REQUIRE(r.code == 0);
  const auto rows = nlohmann::json::parse(r.out)["rows"];
  REQUIRE(rows.size() == 1);
  CHECK(rows[0]["clipper"] == "cvv/near_first");
  CHECK(rows[0]["triangles"] > 1000);
  CHECK(folder.run(arguments).out == r.out);
  CHECK(std::filesystem::exists(tables + "/sweep.csv"));
  CHECK(folder.run("sweep --lattice huge").code == 2);
}
