// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope run, as a user runs it.
#include <algorithm>
#include <filesystem>

#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace fs = std::filesystem;

TEST_CASE("cli: run writes tables in three formats and pictures, in a folder for each experiment") {
  const Folder folder;
  const fs::path out = folder.path() / "results";
  const Result r = folder.run(
      "run accuracy pictures --quick --sample 20 --scene corridor --scalar float --out " +
      out.string());
  INFO(r.err);
  REQUIRE(r.code == 0);
  for (const char* name : {"accuracy/accuracy.md", "accuracy/accuracy.csv", "accuracy/accuracy.tex",
                           "pictures/pictures.csv", "pictures/corridor-cvv-naive.png",
                           "pictures/corridor-cvv-naive.exr"}) {
    INFO(name);
    CHECK(fs::exists(out / name));
  }
  CHECK(lines(read(out / "accuracy" / "accuracy.csv")).size() ==
        clipscope::experiments::clipper_names().size() + 1);
  std::vector<std::string> names;  // at the top
  for (const auto& entry : fs::directory_iterator(out)) {
    names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  CHECK(names == std::vector<std::string>{"README.md", "accuracy", "pictures", "report.html",
                                          "results.sqlite"});
  const std::string readme = read(out / "README.md");
  CHECK(contains(readme, "[accuracy](accuracy/accuracy.md), [accuracy_worst]"));
  CHECK(contains(readme, "files](pictures/)"));
  CHECK(folder.run("run cost --quick --out /proc/no").code == 4);
}

TEST_CASE("cli: run prints each finding and where its tables are, the tables only when asked") {
  const Folder folder;
  const std::string run =
      "run plane_order --quick --sample 20 --scene teapot --scalar float --out " +
      (folder.path() / "results").string();
  const Result brief = folder.run(run);
  REQUIRE(brief.code == 0);
  CHECK(contains(brief.out, "plane_order.{md,csv,tex}"));
  CHECK(contains(brief.out, "report.html"));
  CHECK(lines(brief.out).size() < 20);
  for (const std::string& line : lines(brief.out)) CHECK(line.size() <= 100);
  const Result full = folder.run(run + " --tables");
  CHECK(lines(full.out).size() > lines(brief.out).size() + 20);
}

TEST_CASE("cli: a run warns once of a mesh that float bends, however often it is loaded") {
  const Folder folder;
  const std::string mesh =
      folder.file("far.obj", "v 12958095.12 0 0\nv 12958095.52 0 0\nv 12958095.12 9 0\nf 1 2 3\n");
  const Result r =
      folder.run("run accuracy plane_order --quick --sample 20 --scalar float --scene " +
                 quoted(mesh) + " --out " + (folder.path() / "results").string());
  INFO(r.err);
  REQUIRE(r.code == 0);
  const std::vector<std::string> told = lines(r.err);
  CHECK(std::ranges::count_if(told, [](const std::string& line) {
          return contains(line, "clipscope: warning: ");
        }) == 1);
}

TEST_CASE("cli: the same seed gives the same accuracy table") {
  const Folder folder;
  const std::string arguments =
      "run accuracy --quick --sample 20 --scene soup --seed 5 --json --out " +
      (folder.path() / "r").string();
  const Result a = folder.run(arguments);
  const Result b = folder.run(arguments);
  REQUIRE(a.code == 0);
  CHECK(a.out == b.out);
}
