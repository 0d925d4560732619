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

TEST_CASE("cli: verify does not pass where the promise speaks of no triangle") {
  const Folder folder;
  const auto mesh = folder.file("far.obj", "v 0 0 0\nv 3e38 0 0\nv 0 3e38 0\nf 1 2 3\n");
  const std::string camera =
      " --scene " + mesh.string() + " --eye 0,0,1 --target 0,0,0 --near 0.5 --far 10";
  const Result text =
      folder.run("verify --clipper homogeneous/sutherland_hodgman --scalar float" + camera);
  CHECK(text.code == 5);
  CHECK(contains(text.out, "NOTHING JUDGED"));
  CHECK(contains(
      text.out,
      "outside the promise's domain: 1 triangle; wrong answers among these: 1 (1 missing)"));
  const Result r =
      folder.run("verify --clipper homogeneous/sutherland_hodgman --scalar float --json" + camera);
  CHECK(r.code == 5);
  const auto json = nlohmann::json::parse(r.out);
  CHECK(json["kept"] == false);
  CHECK(json["judged"] == 0);
}

TEST_CASE("cli: verify says how large the backward error is and what is promised") {
  const Folder folder;
  const Result r = folder.run("verify --clipper cvv/near_first --scene teapot --quick --sample 50");
  CHECK(r.code == 0);
  CHECK(contains(r.out, "u M is promised"));
  const Result exact = folder.run(
      "verify --clipper homogeneous/sutherland_hodgman --scalar exact --scene teapot --quick --sample 5");
  CHECK(contains(exact.out, "backward error: none, as promised"));
}
