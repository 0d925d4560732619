// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program of the user's as a clipper of the commands.
#include <string>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

namespace {

const std::string kTriangle = "0 0 0 1  0.5 0 0 1  0 0.5 0 1\n";

// Divides, and cuts nothing. Attributes are left out.
std::string divider_in(const Folder& folder, const std::string& name) {
  const auto script = folder.file(name, R"(awk '{ for (v = 0; v < 3; v++) {
    w = $(4 * v + 4)
    printf "%d,%d,%.9g,%.9g,%.9g,%.9g\n", NR - 1, v, $(4*v+1) / w, $(4*v+2) / w, $(4*v+3) / w, 1 / w
  } }'
)");
  return "--program \"sh " + quoted(script.string()) + "\"";
}

TEST_CASE("cli: a program clips, is explained and compared under the name of its file") {
  const Folder folder;
  const std::string program = divider_in(folder, "my_divider.sh");
  const Result clip = folder.run("clip --space clip " + program, kTriangle);
  CHECK(clip.code == 0);
  CHECK(clip.out == "triangle,vertex,x,y,z,inv_w\n0,0,0,0,0,1\n0,1,0.5,0,0,1\n0,2,0,0.5,0,1\n");
  const Result explain = folder.run("explain --space clip " + program, kTriangle);
  CHECK(contains(explain.out, "Answer of my_divider in float"));
  const Result compare = folder.run(
      "compare --quick --scene teapot --sample 50 --clipper textbook --scalar float --json " +
      program);
  CHECK(compare.code == 0);
  CHECK(contains(compare.out, "a program is judged, not timed"));
}

TEST_CASE("cli: a program has the name given, and a list of what it takes") {
  const Folder folder;
  const std::string program = divider_in(folder, "mine.sh") + " --name Mine --takes zero_to_one";
  CHECK(folder.run("clip --space clip --depth zero_to_one " + program, kTriangle).code == 0);
  const Result other = folder.run("clip --space clip " + program, kTriangle);
  CHECK(other.code == 2);
  const Result wrong = folder.run("clip --space clip " + program + ",triangle", kTriangle);
  CHECK(wrong.code == 2);
  CHECK(contains(wrong.err, "--takes: 'triangle' given"));
  CHECK(folder.run("list clippers " + program + " " + program).code == 2);
}

TEST_CASE("cli: a program that does not start is exit code 5, one that fails says on what") {
  const Folder folder;
  const Result none = folder.run("clip --space clip --program ./no_such_program", kTriangle);
  CHECK(none.code == 5);
  CHECK(contains(none.err, "--program './no_such_program': it can't be asked"));
  const auto script =
      folder.file("fails.sh", "grep -q '^9' && { echo nine >&2; exit 3; } || true\n");
  const Result fails =
      folder.run("clip --space clip --program \"sh " + quoted(script.string()) + "\"",
                 kTriangle + "9 0 0 1  0.5 0 0 1  0 0.5 0 1\n");
  CHECK(contains(fails.err, "no answer to primitive 1: fails ends with exit code 3"));
  CHECK(contains(fails.err, "(standard error: nine)"));
}

}  // namespace
