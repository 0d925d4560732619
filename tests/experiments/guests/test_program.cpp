// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/program.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

// Divides, and cuts nothing: right about what is inside. The actions come first, of each line.
std::string divider(const std::string& actions = "") {
  return "awk '" + actions +
         R"({ for (v = 0; v < 3; v++) {
    w = $(4 * v + 4)
    printf "%d,%d,%.9g,%.9g,%.9g,%.9g\n", NR - 1, v, $(4*v+1) / w, $(4*v+2) / w, $(4*v+3) / w, 1 / w
  } }')";
}

const Contestant& added(ProgramOptions options, const Format& format = kFormat<float>) {
  const std::string_view name = add_program(options);
  const auto all = all_contestants();
  return *std::ranges::find_if(
      all, [&](const Contestant& c) { return c.clipper == name && c.format == &format; });
}

// Triangles in clip space, all inside; the first number of each is its number over 1024.
std::vector<double> triangles_inside(std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) / 1024;
    for (const double n : {x, 0., 0., 1., 0.5, 0., 0., 1., 0., 0.5, 0., 1.}) numbers.push_back(n);
  }
  return numbers;
}

Batch clip_space(const std::vector<double>& numbers) {
  Batch batch{.space = Space::clip};
  batch.numbers = std::span<const double>(numbers);
  return batch;
}

TEST_CASE("program: it is a contestant in float and double, with no promise, and not timed") {
  const Contestant& contestant = added({.command = divider(), .name = "divider"});
  CHECK(contestant.is_guest);
  CHECK(contestant.untimed == "a program is judged, not timed");
  const std::vector<double> numbers = triangles_inside(5000);  // more than one start
  const Batch batch = clip_space(numbers);
  CHECK(contestant.takes(batch));
  const Answers answers = clip(contestant, batch);
  REQUIRE(answers.size() == 5000);
  CHECK(answers[4999].size() == 3);
  CHECK(answers[1000][0][0].value == 1000.0 / 1024);
}

TEST_CASE("program: several threads ask at once") {
  const Contestant& contestant = added({.command = divider(), .name = "threads"});
  const std::vector<double> numbers = triangles_inside(50);
  std::vector<std::size_t> sizes(8);
  tbb::parallel_for(std::size_t{0}, sizes.size(), [&](std::size_t i) {
    sizes[i] = clip(contestant, clip_space(numbers))[49].size();
  });
  CHECK(sizes == std::vector<std::size_t>(8, 3));
}

// How it fails on triangle 2 of 8, whose first vertex alone is at x = 2/1024.
Failure failure_on_one(const std::string& name, const std::string& actions, double seconds = 10) {
  const std::vector<double> numbers = triangles_inside(8);
  const Contestant& contestant = added({.command = divider("$1 == 0.001953125 {" + actions + "}"),
                                        .name = name,
                                        .seconds = seconds});
  const Answers answers = clip(contestant, clip_space(numbers));
  for (std::size_t i = 0; i < 8; ++i) REQUIRE((answers[i].failure() != nullptr) == (i == 2));
  return *answers[2].failure();
}

TEST_CASE(
    "program: what it crashes on is found, with its last words, and the others are answered") {
  const Failure f = failure_on_one("exits", R"(print "no way" > "/dev/stderr"; exit 7)");
  CHECK(f.kind == Failure::Kind::crashed);
  CHECK(f.reason == "ends with exit code 7 (standard error: no way)");
}

TEST_CASE("program: what it does not end on is found") {
  const Failure f = failure_on_one("loops", "while (1) continue", 1);
  CHECK(f.kind == Failure::Kind::timed_out);
  CHECK(f.reason == "does not end within 1 s");
}

TEST_CASE("program: what it writes no answer to is found") {
  const Failure junk = failure_on_one("writes junk", R"(print "junk")");
  CHECK(junk.kind == Failure::Kind::malformed);
  CHECK_THAT(junk.reason, Catch::StartsWith("writes 'junk' in line 1: expected a row of"));
  const Failure flood = failure_on_one("floods", R"(while (1) print "0,0,0,0,0,1")");
  CHECK(flood.kind == Failure::Kind::malformed);
  CHECK_THAT(flood.reason, Catch::StartsWith("writes more than"));
}

TEST_CASE("program: a wrong row is blamed on its triangle, and nothing is asked again") {
  const Failure f = failure_on_one("out of order", R"(print NR - 1 ",1,0,0,0,1"; next)");
  CHECK(f.kind == Failure::Kind::malformed);
  CHECK_THAT(f.reason,
             Catch::StartsWith("writes '2,1,0,0,0,1' in line 7: "));  // of all, not of it alone
}

TEST_CASE("program: a failure is judged as what it is") {
  const Contestant& contestant =
      added({.command = divider("$1 == 0 && NR == 1 && $5 == 0.5 {exit 9}"), .name = "judged"});
  const std::vector<double> numbers = triangles_inside(1);
  const Batch batch = clip_space(numbers);
  const TruthPolygon truth = truth_polygons(reference::truth_of(batch), batch)[0];
  CHECK(compare(clip(contestant, batch)[0], truth).outcome == Outcome::crashed);
}

TEST_CASE("program: what does not run can't be asked") {
  const auto message = [](const std::string& command) {
    try {
      add_program({.command = command, .name = "broken", .seconds = 1});
    } catch (const GuestError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(message("./there-is-no-such-program"), Catch::Contains("exit code 127"));
  CHECK_THAT(message("cat /nowhere/mine.py"), Catch::Contains("No such file"));
  CHECK_THAT(message("sleep 100"), Catch::Contains("does not end within 1 s"));
  CHECK_THAT(message(""), Catch::Contains("command line"));
  CHECK_NOTHROW(add_program({.command = "true", .name = "true"}));
  CHECK_THROWS_AS(add_program({.command = "true", .name = "true"}), GuestError);
}

TEST_CASE("program: view space reaches it projected, in its scalar, unless it takes view space") {
  const std::vector<double> view = {0, 0, -2, 0.1, 0, -2, 0, 0.1, -2};
  Batch batch{.space = Space::view};
  batch.numbers = std::span<const double>(view);
  batch.frustum = {.near = 1, .far = 3};
  const std::string echo = R"(awk '{ print "0,0," $1 "," $2 "," $3 ",1" }')";  // its first numbers
  const Contestant& in_clip = added({.command = echo, .name = "sees clip space"});
  CHECK(clip(in_clip, batch)[0][0][2].value == 1);
  const Contestant& in_view =
      added({.command = echo, .name = "sees view space", .space = Space::view});
  CHECK(clip(in_view, batch)[0][0][2].value == -2);
  CHECK_FALSE(in_view.takes(clip_space(triangles_inside(1))));
  batch.matrix = MatrixRows<double>{};
  CHECK(in_clip.takes(batch));
  CHECK_FALSE(in_view.takes(batch));
}

TEST_CASE("program: the environment tells what is asked") {
  const std::string echo =
      R"(env | grep ^CLIPSCOPE_ | sort >&2; exit $CLIPSCOPE_ATTRIBUTES)";  // 0 where it is tried
  ProgramOptions options{.command = echo, .name = "told"};
  set_takes({"view", "zero_to_one", "attributes=3", "clip-distances", "depth-clamp", "hex"},
            options);
  CHECK(options.most_attributes == 8);
  const Contestant& contestant = added(options, kFormat<double>);
  std::vector<double> numbers(3 * 6, 0.5);
  Batch batch{.space = Space::view, .attributes = 3};
  batch.numbers = std::span<const double>(numbers);
  batch.frustum = {.near = 1, .far = 4, .depth = DepthRange::zero_to_one};
  batch.volume = {.depth = DepthRange::zero_to_one, .depth_clamp = kClampFar, .clip_distances = 2};
  REQUIRE(contestant.takes(batch));
  const Answers answers = clip(contestant, batch);
  // What of it ends up in a message is the last lines.
  CHECK_THAT(answers[0].failure()->reason,
             Catch::Contains("CLIPSCOPE_SHEAR=0x0p+0,0x0p+0 | CLIPSCOPE_SPACE=view"));
}

TEST_CASE("program: it is asked for nothing that it does not take") {
  const std::vector<double> numbers(12, 0.5);
  const auto takes = [&](const ProgramOptions& options, const ClipVolume& volume) {
    static int number = 0;
    ProgramOptions named = options;
    named.command = "true";
    named.name = "takes" + std::to_string(++number);
    Batch batch = clip_space(numbers);
    batch.volume = volume;
    return added(named).takes(batch);
  };
  CHECK(takes({}, {}));
  CHECK_FALSE(takes({}, {.depth = DepthRange::reversed}));
  CHECK_FALSE(takes({}, {.depth_clamp = true}));
  CHECK_FALSE(takes({}, {.open_sides = true}));
  ProgramOptions wide;
  set_takes({"gl", "reversed", "depth-clamp", "half-open"}, wide);
  CHECK(takes(wide, {.depth = DepthRange::reversed, .depth_clamp = true, .open_sides = true}));
  CHECK_FALSE(takes(wide, {.depth = DepthRange::zero_to_one}));
}

TEST_CASE("program: of more attributes than it takes it gets and answers the first ones") {
  ProgramOptions options{.command = R"(awk '{ print "0,0,0,0,0,1," $5 }')",
                         .name = "one attribute",
                         .most_attributes = 1};
  const Contestant& contestant = added(options);
  std::vector<double> numbers(18, 7);
  Batch batch{.space = Space::clip, .attributes = 2};
  batch.numbers = std::span<const double>(numbers);
  REQUIRE(contestant.takes(batch));
  const Answers answers = clip(contestant, batch);
  CHECK(answers.stride() == 5);
  REQUIRE(answers[0].failure() == nullptr);
  CHECK(answers[0][0].attribute(0).value == 7);
}

TEST_CASE("program: a list of what it takes is read word by word, and a wrong word is named") {
  ProgramOptions options;
  set_takes({"segments", "points", "segments", "attributes"}, options);
  CHECK(options.primitives == std::vector{Primitive::segment, Primitive::point});
  CHECK(options.most_attributes == 32);
  for (const char* word : {"attributes=33", "attributes=", "attributesx", "triangle", ""}) {
    CHECK_THROWS_AS(set_takes({word}, options), UsageError);
  }
}

TEST_CASE("program: its name is the stem of its file") {
  CHECK(program_name("./build/mine --fast") == "mine");
  CHECK(program_name("python3 no_such_file.py") == "python3");
  CHECK(program_name("sh " CLIPSCOPE_SOURCE_DIR "/tests/run -x") == "run");
  CHECK(program_name("sh '" CLIPSCOPE_SOURCE_DIR "/tests/run' \"a b\"") == "run");
  CHECK(program_name("'/a folder/my clipper' x") == "my clipper");
  CHECK(program_name("").empty());
}

}  // namespace
}  // namespace clipscope::experiments
