// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope camera, as a user runs it.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("camera: a frustum, intrinsics and a matrix of the same camera mean the same") {
  const Folder folder;
  const auto meaning = [&](const std::string& options) {
    const Result r = folder.run("camera --json " + options);
    INFO(options << "\n" << r.err);
    REQUIRE(r.code == 0);
    return nlohmann::json::parse(r.out);
  };
  for (const char* options :
       {"--perspective 90,1,1,inf", "--frustum=-1,1,-1,1,1,inf",
        "--intrinsics 320,320,319.5,319.5,640,640 --near 1 --far inf",
        "--matrix 1,0,0,0,0,1,0,0,0,0,-1,-2,0,0,-1,0",
        "--matrix-order column --matrix 1,0,0,0,0,1,0,0,0,0,-1,-1,0,0,-2,0"}) {
    const nlohmann::json json = meaning(options);
    INFO(options);
    CHECK(json["kind"] == "perspective");
    CHECK(json["depth"] == "gl");
    CHECK(json["horizontal_degrees"].get<double>() == Approx(90));
    CHECK(json["conventions"]["gl"]["near"]["value"].get<double>() == Approx(1));
    CHECK(json["conventions"]["gl"]["far"]["value"] == "inf");
    CHECK(json["right_handed_if_y_up"] == true);
  }
}

TEST_CASE("camera: says in words what is lost, and draws the volume") {
  const Folder folder;
  const auto svg = folder.path() / "a.svg";
  const Result r = folder.run("camera --perspective 60,1.5,0.001,100000 --picture " + svg.string());
  INFO(r.err);
  CHECK(r.code == 0);
  for (const char* part :
       {"perspective", "right-handed", "one entry off", "at infinity", "24 bits"}) {
    CHECK(contains(r.out, part));
  }
  CHECK(contains(read(svg), "<title>A perspective frustum"));
  const Result flat = folder.run("camera --matrix 1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1");
  CHECK(flat.code == 0);
  CHECK(contains(flat.out, "singular"));
  CHECK(contains(flat.out, "The direction (0, 0, 1) goes to (0, 0, 0, 0)"));
}

TEST_CASE("camera: a camera of a glTF file is found by name or number") {
  const Folder folder;
  const std::string file =
      folder
          .file("a.gltf",
                R"({"asset":{"version":"2.0"},"nodes":[{"camera":0,"name":"front"}],
  "cameras":[{"type":"perspective","perspective":{"yfov":1.0,"aspectRatio":2,"znear":0.5}}]})")
          .string();
  for (const char* name : {"", " --camera 0", " --camera front"}) {
    const Result r = folder.run("camera --json " + quoted(file) + name);
    INFO(name << r.err);
    REQUIRE(r.code == 0);
    const auto json = nlohmann::json::parse(r.out);
    CHECK(json["vertical_degrees"].get<double>() == Approx(57.29578));
    CHECK(json["aspect"].get<double>() == Approx(2));
  }
  const Result unknown = folder.run("camera " + quoted(file) + " --camera back");
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "0 (front)"));
}

TEST_CASE("camera: what is wrong is named") {
  const Folder folder;
  const auto expect = [&](const std::string& arguments, int code, const std::string& message) {
    const Result r = folder.run("camera " + arguments);
    INFO(arguments << "\n" << r.out << r.err);
    CHECK(r.code == code);
    CHECK(contains(r.err, message));
  };
  expect("", 2, "none is given");
  expect("--perspective 90,1,1,9 --ortho 0,1,0,1,0,1", 2, "--perspective and --ortho");
  expect("--matrix 1,2", 2, "2 numbers; 16 numbers expected");
  expect("--frustum 1,-1,0,1,1,2", 2, "encloses no volume");
  expect("--perspective 90,1,1,9 --picture a.gif", 2, ".svg, .pdf or .png");
  expect("/no/such.gltf", 3, "/no/such.gltf");
}
