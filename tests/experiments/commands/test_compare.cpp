// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope compare, as a user runs it.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/contestants/contestant.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace fs = std::filesystem;
using namespace clipscope::experiments;

TEST_CASE("cli: compare tabulates every clipper on a mesh of the user's") {
  const Folder folder;
  const fs::path mesh =
      folder.file("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 2 4 3\n");
  const Result r = folder.run("compare --scene " + mesh.string() + " --quick --json --out " +
                              (folder.path() / "tables").string());
  INFO(r.err);
  REQUIRE(r.code == 0);
  const auto rows = nlohmann::json::parse(r.out)["rows"];
  const auto contestants = std::ranges::count_if(all_contestants(), [](const Contestant& c) {
    return c.contract == Contract::full && c.vertices == 3 &&
           (c.scalar() == "float" || c.scalar() == "double");
  });
  CHECK(static_cast<std::ptrdiff_t>(rows.size()) == contestants);
  for (const auto& row : rows) {
    CHECK(row.contains("max_px"));
    CHECK(row["ns_per_triangle"].get<double>() > 0);
    CHECK(row["timing_refused"].is_null());
  }
  CHECK(fs::exists(folder.path() / "tables" / "compare.csv"));
}

TEST_CASE("cli: a bad mesh is named with its place, exit 3") {
  const Folder folder;
  const fs::path mesh = folder.file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  const Result r = folder.run("compare --quick --scene " + mesh.string());
  CHECK(r.code == 3);
  CHECK(contains(r.err, "bad.obj:4"));
}

TEST_CASE("cli: double and exact scalars are given positions in double, as the file has them") {
  const Folder folder;
  const fs::path mesh = folder.file("roof.obj",
                                    "v 12958095.1 4865499.8 10\nv 12958095.4 4865499.8 10\n"
                                    "v 12958095.4 4865500.1 10\nf 1 2 3\n");
  const std::string camera =
      " --scene " + mesh.string() +
      " --eye 12958095.25,4865499.95,12 --target 12958095.25,4865499.95,10 --up 0,1,0 --near 0.5 --far 10 --json";
  const auto outcomes = [&](const std::string& scalar) {
    const Result r = folder.run(
        "compare --quick --clipper homogeneous/sutherland_hodgman --scalar " + scalar + camera);
    REQUIRE(r.code == 0);
    return nlohmann::json::parse(r.out)["rows"][0];
  };
  // In float the three positions fall together, and there is nothing to see.
  CHECK(outcomes("float")["median_px"].is_null());
  CHECK(outcomes("double")["max_px"].get<double>() < 1e-3);
  const Result r =
      folder.run("explain --clipper homogeneous/sutherland_hodgman --scalar double" + camera);
  CHECK(contains(r.out, "\"exact\""));
}

TEST_CASE("cli: compare in real time says so with the machine, or what to do where it is refused") {
  const Folder folder;
  const Result r = folder.run(
      "compare --realtime --scene soup --quick --sample 20 --scalar float --clipper textbook");
  INFO(r.err);
  if (r.code == 0) {
    CHECK(contains(r.out, "SCHED_"));
    CHECK(contains(r.out, "runs under the clock"));
  } else {
    CHECK(r.code == 2);
    CHECK(contains(r.err, "--realtime"));
    CHECK(contains(r.err, "rtprio"));
  }
}
