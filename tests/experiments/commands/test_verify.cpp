// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope verify, as a user runs it.
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("cli: verify exits 0 where the promise holds and prints JSON") {
  const Folder folder;
  const Result r = folder.run(
      "verify --clipper cvv/near_first --scalar float --scene teapot --quick --sample 50 --json");
  REQUIRE(r.code == 0);
  const auto json = nlohmann::json::parse(r.out);
  CHECK(json["kept"] == true);
  CHECK(json["triangles"].get<int>() > 0);
  CHECK(json["largest_backward_error_ulp"].get<double>() < 93);
}
