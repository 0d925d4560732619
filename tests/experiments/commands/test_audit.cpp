// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope audit, as a user runs it.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

// A triangle inside of the volume, and one with a vertex behind the eye.
constexpr const char* kCases = R"(case inside
source by hand
why nothing is cut
primitive triangle
space clip gl
vertex -0.5 -0.5 0 1
vertex 0.5 -0.5 0 1
vertex 0 0.5 0 1

case behind
source by hand
why a vertex is behind the eye
primitive triangle
space clip gl
vertex -0.5 -0.5 0 1
vertex 0.5 -0.5 0 1
vertex 0 3 -2 -1
)";

std::string audit(const Folder& folder, const std::string& driver) {
  return "audit --driver " + driver + " --cases " +
         quoted(folder.file("two.cases", kCases).string());
}

}  // namespace

TEST_CASE("audit: a right driver exits with 0 and says on what") {
  const Folder folder;
  const Result r = folder.run(audit(folder, "own"));
  INFO(r.err << r.out);
  CHECK(r.code == 0);
  CHECK(contains(r.out, "no violation in "));
  for (const std::string& line : lines(r.out)) CHECK(line.size() <= 100);
}

TEST_CASE("audit: a fault exits with 1, and JSON tells it in the fixed form") {
  const Folder folder;
  const Result r = folder.run(audit(folder, "own/noperspective_nan") + " --json");
  INFO(r.err << r.out);
  REQUIRE(r.code == 1);
  const nlohmann::json json = nlohmann::json::parse(r.out);
  CHECK(json["driver"] == "own/noperspective_nan");
  CHECK(json["version"].is_string());
  CHECK(json["cases"].get<int>() > 2);
  bool is_found = false;
  for (const auto& finding : json["findings"]) {
    for (const char* key :
         {"case", "primitive", "quantity", "class", "size", "clause", "pixels", "worst"}) {
      CHECK(finding.contains(key));
    }
    if (finding["class"] != "not_finite" || finding["quantity"] != "noperspective") continue;
    is_found = true;
    CHECK(finding["primitive"] == "triangle");
    CHECK(contains(finding["clause"].get<std::string>(), "OpenGL"));
    CHECK(finding["worst"]["returned"] == "nan");
    CHECK(contains(finding["smallest"]["case"].get<std::string>(), "two/"));
  }
  CHECK(is_found);
}

TEST_CASE("audit: what it writes replays what it found") {
  const Folder folder;
  const std::string out = quoted((folder.path() / "audited").string());
  const Result r = folder.run(audit(folder, "own/noperspective_nan") + " --out " + out);
  INFO(r.err << r.out);
  REQUIRE(r.code == 1);
  for (const std::string& line : lines(r.out)) {
    if (contains(line, "/findings/")) continue;  // paths and commands to copy are not broken
    CHECK(line.size() <= 100);
  }
  std::string replay;
  for (const std::string& line : lines(r.out)) {
    const std::size_t start = line.find("clipscope audit ");
    if (start != std::string::npos && replay.empty()) replay = line.substr(start + 10);
  }
  REQUIRE_FALSE(replay.empty());
  const Result again = folder.run(replay);
  INFO(replay << "\n" << again.err << again.out);
  CHECK(again.code == 1);
  CHECK(contains(again.out, "not_finite"));
}

TEST_CASE("audit: two drivers are compared by diff") {
  const Folder folder;
  for (const char* driver : {"own", "own/noperspective_nan"}) {
    const std::string out = (folder.path() / (driver == std::string("own") ? "a" : "b")).string();
    folder.run(audit(folder, driver) + " --no-shrink --out " + quoted(out));
  }
  const Result r = folder.run("diff " + quoted((folder.path() / "a").string()) + " " +
                              quoted((folder.path() / "b").string()));
  INFO(r.err << r.out);
  CHECK(r.code == 1);
  CHECK(contains(r.out, "audit_findings"));
  CHECK(contains(r.out, "noperspective"));
}

TEST_CASE("audit: JUnit has a failure for each finding") {
  const Folder folder;
  const std::string junit = (folder.path() / "audit.xml").string();
  const Result r =
      folder.run(audit(folder, "own/noperspective_nan") + " --no-shrink --junit " + quoted(junit));
  INFO(r.err << r.out);
  CHECK(r.code == 1);
  const std::string xml = read(junit);
  CHECK(contains(xml, "<failure message=\"OpenGL"));
  CHECK(contains(xml, "own/noperspective_nan.crashed\" name=\"no violation\""));
}

TEST_CASE("audit: the smallest cases go to a file that others can be asked about") {
  const Folder folder;
  const std::string corpus = (folder.path() / "found.cases").string();
  folder.run(audit(folder, "own/noperspective_nan") + " --corpus-out " + quoted(corpus));
  const Result r =
      folder.run("verify --clipper homogeneous/sutherland_hodgman --corpus " + quoted(corpus));
  INFO(r.err << r.out);
  CHECK(r.code == 0);
}

TEST_CASE("audit: a driver that is not there exits with 5 and says why") {
  const Folder folder;
  const Result r = folder.run("audit --icd " + quoted(folder.file("no.json", "{}").string()));
  INFO(r.out);
  CHECK(r.code == 5);
  CHECK_FALSE(r.err.empty());
}

TEST_CASE("audit: names that are none are usage errors") {
  const Folder folder;
  CHECK(folder.run("audit --driver nobody").code == 2);
  CHECK(folder.run("audit --driver own/nothing").code == 2);
  CHECK(folder.run("audit --driver own --icd x.json").code == 2);
}

TEST_CASE("list: drivers that are here, and why the others are not") {
  const Folder folder;
  const Result r = folder.run("list drivers --json");
  INFO(r.err);
  REQUIRE(r.code == 0);
  std::vector<std::string> names;
  for (const auto& driver : nlohmann::json::parse(r.out)) {
    names.push_back(driver["name"]);
    CHECK(driver["api"].is_null() != driver["missing"].is_null());
  }
  for (const char* name : {"llvmpipe", "softpipe", "lavapipe", "swiftshader", "webgl"}) {
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
}
