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
  CHECK(text.code == 6);
  CHECK(contains(text.out, "NOTHING JUDGED"));
  CHECK(contains(
      text.out,
      "outside the promise's domain: 1 triangle; wrong answers among these: 1 (1 missing)"));
  const Result r =
      folder.run("verify --clipper homogeneous/sutherland_hodgman --scalar float --json" + camera);
  CHECK(r.code == 6);
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

TEST_CASE("cli: verify prints promise, held and the first counterexample, and replays it") {
  const Folder folder;
  const Result r = folder.run(
      "verify --clipper textbook --promise watertight,total --space clip --triangles 2000");
  CHECK(r.code == 1);
  CHECK(contains(r.out, "textbook float: BROKEN on "));
  CHECK(contains(r.out, "promise            held?           first counterexample"));
  CHECK(contains(r.out, "total              yes"));
  CHECK(contains(r.out, "watertight         no, on "));
  for (const std::string& line : lines(r.out)) {
    CHECK((line.size() <= 100 || contains(line, "echo")));
  }
  const std::string command = lines(r.out).back();
  const auto pipe = command.find(" | clipscope verify ");
  REQUIRE(pipe != std::string::npos);
  const std::string triangle =
      command.substr(command.find('\'') + 1, pipe - command.find('\'') - 2);
  const Result again = folder.run(command.substr(pipe + 13), triangle);
  INFO(command << again.err);
  CHECK(again.code == 1);
  CHECK(contains(again.out, "BROKEN on 1 triangle; judged: 1"));
}

TEST_CASE("cli: verify replays a hard case by its name") {
  const Folder folder;
  const std::string command = "verify --clipper textbook --promise watertight --catalogue";
  const auto json = nlohmann::json::parse(folder.run(command + " --json").out);
  const auto& counterexample = json["promises"][0]["counterexample"];
  const std::string replay = counterexample["replay"];
  REQUIRE(replay.starts_with("clipscope verify --clipper textbook --scalar float"));
  const Result again = folder.run(replay.substr(10) + " --json");
  CHECK(again.code == 1);
  const auto found = nlohmann::json::parse(again.out)["promises"][0]["counterexample"];
  CHECK(found["case"] == counterexample["case"]);
  CHECK(found["hex"] == counterexample["hex"]);
  const Result unknown = folder.run(command + " --case no/such");
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "there is no triangle 'no/such'"));
}

TEST_CASE("cli: verify's JSON has the fixed form") {
  const Folder folder;
  const Result r = folder.run(
      "verify --clipper textbook --promise total,watertight,steady --triangles 500 --json");
  CHECK(r.code == 1);
  const auto json = nlohmann::json::parse(r.out);
  CHECK(json["judged"].get<int>() > 0);
  CHECK(json["outside_domain"] == 0);
  REQUIRE(json["promises"].size() == 3);
  CHECK(json["promises"][0]["name"] == "total");
  CHECK(json["promises"][0]["held"] == true);
  CHECK(json["promises"][0]["counterexample"].is_null());
  CHECK(json["promises"][1]["name"] == "watertight");
  CHECK(json["promises"][1]["held"] == false);
  for (const char* key : {"case", "hex", "replay", "reason"}) {
    CHECK(json["promises"][1]["counterexample"][key].is_string());
  }
  CHECK(json["holds"] == std::vector<std::string>{"total", "steady"});
  CHECK(json["shrunk"].is_string());
  CHECK(contains(json["shrunk_case"], "case textbook_float_watertight"));
  CHECK(contains(json["shrunk_replay"], "| clipscope verify --clipper textbook"));
  CHECK(
      nlohmann::json::parse(
          folder
              .run(
                  "verify --clipper textbook --promise total,watertight --triangles 500 --json --no-shrink")
              .out)["shrunk"]
          .is_null());
}

TEST_CASE("cli: a promise that is asked for by name and judged on nothing is no pass") {
  const Folder folder;
  const auto mesh = folder.file("far.obj", "v 0 0 0\nv 3e38 0 0\nv 0 3e38 0\nf 1 2 3\n");
  const std::string scene =
      " --scene " + mesh.string() + " --eye 0,0,1 --target 0,0,0 --near 0.5 --far 10";
  const Result r = folder.run("verify --clipper textbook --promise scale" + scene);
  CHECK(r.code == 6);
  CHECK(contains(r.out, "not judged"));
  CHECK(folder.run("verify --clipper textbook --promise total" + scene).code == 0);
}

TEST_CASE("cli: verify takes triangles of one space alone, and by text") {
  const Folder folder;
  const auto judged = [&](const std::string& options) {
    const Result r =
        folder.run("verify --clipper homogeneous/sutherland_hodgman --json " + options);
    INFO(r.err);
    REQUIRE(r.code == 0);
    return nlohmann::json::parse(r.out)["triangles"].get<int>();
  };
  CHECK(judged("--catalogue --space view") + judged("--catalogue --space clip") ==
        judged("--catalogue"));
  CHECK(judged("--triangles 300 --space clip") == 300);
  CHECK(judged("--scene teapot --quick --sample 20 --space clip") > 0);
  const Result missing = folder.run("verify --clipper textbook --input -", "0 0 -4 8 0 -4 0 2 -4");
  CHECK(missing.code == 2);
  CHECK(contains(missing.err, "take one of --frustum, --ortho and --matrix"));
  const Result bad = folder.run("verify --clipper textbook --space clip --input -", "1 2 3\n");
  CHECK(bad.code == 3);
  CHECK(contains(bad.err, "standard input:1"));
}

TEST_CASE("cli: verify needs a clipper, and promises that there are") {
  const Folder folder;
  CHECK(folder.run("verify --catalogue").code == 2);
  const Result r = folder.run("verify --clipper textbook --promise watertite");
  CHECK(r.code == 2);
  CHECK(contains(r.err + r.out, "watertite"));
}

TEST_CASE("cli: --junit writes a test case per source and promise, with the replay in failures") {
  const Folder folder;
  const std::string file = (folder.path() / "verify.xml").string();
  const Result r = folder.run(
      "verify --clipper textbook --promise total,watertight --triangles 500 --junit " + file);
  CHECK(r.code == 1);
  const std::string xml = read(file);
  CHECK(xml.starts_with(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"2\" failures=\"1\""));
  CHECK(contains(xml, "<testcase classname=\"textbook float.random triangles\" name=\"total\"/>"));
  CHECK(contains(xml, "name=\"watertight\">\n      <failure message=\"random triangle "));
  CHECK(contains(xml, "| clipscope verify --clipper textbook --scalar float --promise watertight"));
}

TEST_CASE("cli: --junit fails where nothing was judged") {
  const Folder folder;
  const auto mesh = folder.file("a<b&\"c.obj", "v 0 0 0\nv 3e38 0 0\nv 0 3e38 0\nf 1 2 3\n");
  const std::string file = (folder.path() / "verify.xml").string();
  const Result r = folder.run("verify --clipper homogeneous/sutherland_hodgman --scene " +
                              quoted(mesh.string()) +
                              " --eye 0,0,1 --target 0,0,0 --near 0.5 --far 10 --junit " + file);
  CHECK(r.code == 6);
  const std::string xml = read(file);
  CHECK(contains(xml, "a&lt;b&amp;&quot;c.obj\" name=\"contained\">\n      <skipped message="));
  CHECK(contains(xml, "<failure message=\"no triangle was judged\">"));
  CHECK(std::system(("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' " + file)
                        .c_str()) == 0);
}

TEST_CASE("cli: verify adds the smallest counterexample to a corpus that breaks again") {
  const Folder folder;
  const std::string corpus = (folder.path() / "mine.cases").string();
  const std::string command = "verify --clipper textbook --promise watertight ";
  CHECK(folder.run(command + "--space clip --triangles 500 --corpus-out " + corpus).code == 1);
  CHECK(contains(read(corpus), "case textbook_float_watertight\n"));
  const Result again =
      folder.run(command + "--corpus " + corpus + " --case mine/textbook_float_watertight --json");
  INFO(again.err);
  CHECK(again.code == 1);
  const auto found = nlohmann::json::parse(again.out)["promises"][0]["counterexample"];
  CHECK(found["case"].get<std::string>().starts_with("mine/textbook_float_watertight"));
}
