// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope table, diff, report and paper, as a user asks them about a run.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

// A small run in a folder of that name; its path, quoted.
std::string run_in(const Folder& folder, const std::string& name, const std::string& scalars) {
  const std::string path = quoted((folder.path() / name).string());
  const Result r =
      folder.run("run accuracy --quick --sample 20 --scene corridor --clipper cvv/naive --out " +
                 path + " --scalar " + scalars);
  INFO(r.err);
  REQUIRE(r.code == 0);
  return path;
}

}  // namespace

TEST_CASE("cli: table lists a run's tables and prints each in five formats") {
  const Folder folder;
  const std::string run = " --run " + run_in(folder, "a", "float,double");
  CHECK(contains(folder.run("table" + run).out, "accuracy_worst"));
  const auto rows =
      nlohmann::json::parse(folder.run("table accuracy --format json" + run).out)["rows"];
  CHECK(rows.size() == 2);
  CHECK(contains(folder.run("table accuracy --format csv" + run).out, "cvv/naive,float,"));
  CHECK(
      contains(folder.run("table accuracy --format markdown" + run).out, "| cvv/naive | float |"));
  CHECK(contains(folder.run("table accuracy --format latex" + run).out, "toprule"));
  CHECK(contains(folder.run("table accuracy" + run).out, "cvv/naive"));
  CHECK(folder.run("table --finding accuracy" + run).out.size() > 20);
  const Result none = folder.run("table --finding cost" + run);
  CHECK(none.code == 2);
  CHECK(contains(none.err, "has none of an experiment 'cost'"));
  CHECK(folder.run("table nothing" + run).code == 2);
}

TEST_CASE("cli: diff exits 0 for the same figures and 1 where one moved or is missing") {
  const Folder folder;
  const std::string a = run_in(folder, "a", "float,double"),
                    b = run_in(folder, "b", "float,double");
  const std::string c = run_in(folder, "c", "float");
  const Result same = folder.run("diff " + a + " " + b);
  CHECK(same.code == 0);
  CHECK(contains(same.out, "0 of "));
  const Result other = folder.run("diff --format json " + a + " " + c);
  CHECK(other.code == 1);
  const auto json = nlohmann::json::parse(other.out);
  CHECK(json["moved"].empty());
  REQUIRE(!json["lone"].empty());
  CHECK(json["lone"][0]["run"] == "A");
}

TEST_CASE("cli: report writes the page of a run again, and paper asks for what is missing") {
  const Folder folder;
  const std::string run = " --run " + run_in(folder, "a", "float,double");
  std::filesystem::remove(folder.path() / "a" / "report.html");
  CHECK(folder.run("report" + run).code == 0);
  CHECK(contains(read(folder.path() / "a" / "report.html"), "cvv/naive"));
  CHECK(folder.run("report --run /nowhere").code == 3);
  CHECK(folder.run("paper --run /nowhere").code == 3);
}
