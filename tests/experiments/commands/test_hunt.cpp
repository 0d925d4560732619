// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope hunt and promote, as a user runs them.
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

const std::string kSkipsLeft =
    "hunt --clipper seeded/skips_left --without-catalogue --evaluations 3000";

// The command after the "clipscope" of a line such as "echo '...' | clipscope explain ...", and
// what it reads.
struct Replay {
  std::string input, arguments;

  explicit Replay(const std::string& command) {
    const std::string between = "' | clipscope ";
    const std::size_t quote = command.find('\''), end = command.find(between);
    input = command.substr(quote + 1, end - quote - 1) + "\n";
    arguments = command.substr(end + between.size());
  }
};

}  // namespace

TEST_CASE("cli: hunt finds a bug, shrinks it, and says how to see it and how to find it again") {
  const Folder folder;
  const Result r = folder.run(kSkipsLeft + " --measure px,attribute --json");
  REQUIRE(r.code == 0);
  const auto hunts = nlohmann::json::parse(r.out)["hunts"];
  REQUIRE(hunts.size() == 2);
  const auto& hunt = hunts[0];
  CHECK(hunt["clipper"] == "seeded/skips_left");
  CHECK(hunt["measure"] == "px");
  CHECK(hunt["bound"] == "lower");
  CHECK(hunt["evaluations"] == 3000);
  CHECK(hunt["failing"].size() > 0);
  REQUIRE(hunt["worst"].is_object());
  CHECK(hunt["shrunk"]["value"].get<double>() >= hunt["worst"]["value"].get<double>() / 2);
  const std::string command = hunt["command"];
  CHECK(contains(
      command,
      "--clipper seeded/skips_left --scalar float --measure px --seed 1 --evaluations 3000 --without-catalogue"));
  const auto again =
      nlohmann::json::parse(folder.run(command.substr(10) + " --json").out)["hunts"][0];
  CHECK(again["worst"] == hunt["worst"]);
  CHECK(again["shrunk"] == hunt["shrunk"]);
  for (const char* which : {"worst", "shrunk"}) {
    const Replay replay(hunt[which]["replay"].get<std::string>());
    CHECK(folder.run(replay.arguments, replay.input).code == 0);
  }
}

TEST_CASE("cli: hunt adds what it shrunk to a file of cases, which explain reads") {
  const Folder folder;
  const std::string corpus = (folder.path() / "mine.cases").string();
  const Result r = folder.run(kSkipsLeft + " --measure px --corpus-out " + quoted(corpus));
  CHECK(r.code == 0);
  CHECK(contains(r.out, "a lower bound of the worst"));
  CHECK(contains(r.out, "case seeded_skips_left_float_px"));
  const Result explained =
      folder.run("explain --corpus " + quoted(corpus) +
                 " --case mine/seeded_skips_left_float_px --clipper seeded/skips_left");
  CHECK(explained.code == 0);
  CHECK(contains(explained.out, "clipscope hunt"));
}

TEST_CASE("cli: what is stored by a hunt is promoted into a file of cases, once") {
  const Folder folder;
  const std::string out = (folder.path() / "hunted").string();
  const std::string corpus = (folder.path() / "mine.cases").string();
  const std::string hunt = "hunt --clipper homogeneous/sutherland_hodgman --evaluations 4000";
  REQUIRE(folder.run(hunt + " --measure px,crack,containment --out " + quoted(out)).code == 0);
  const Result table = folder.run("table hunt --run " + quoted(out) + " --format csv");
  CHECK(table.code == 0);
  CHECK(contains(table.out, "homogeneous/sutherland_hodgman"));
  const std::string promote = "promote " + quoted(out) + " --corpus-out " + quoted(corpus);
  const Result px = folder.run(promote + " --measure px");
  CHECK(px.code == 0);
  CHECK(contains(px.out, "1 of 1 case added"));
  const Result all = folder.run(promote);
  CHECK(contains(all.out, "3 of 4 cases added"));
  CHECK(contains(folder.run(promote).out, "0 of 4 cases added"));
  CHECK(contains(read(corpus), "homogeneous_sutherland_hodgman_float_crack_neighbour"));
}

TEST_CASE("cli: hunt names what is wrong with its options") {
  const Folder folder;
  const Result nobody = folder.run("hunt --measure px");
  CHECK(nobody.code == 2);
  CHECK(contains(nobody.err, "--clipper"));
  const Result measure = folder.run("hunt --clipper cvv/naive --measure size");
  CHECK(measure.code == 2);
  CHECK(contains(measure.err, "px, ulp, depth, attribute, containment, crack, crash"));
  CHECK(folder.run("hunt --clipper cvv/naive --seconds 1 --evaluations 5").code == 2);
  CHECK(folder.run("promote nowhere --corpus-out x.cases").code == 3);
}
