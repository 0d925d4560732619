// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "experiments/guests/process.hpp"
#include "experiments/machine/files.hpp"
#include "tests/experiments/reproductions/amber_grammar.hpp"
#include "tests/experiments/reproductions/cases.hpp"

namespace clipscope::experiments {
namespace {

// What glslangValidator says against it; empty if it compiles.
std::string faults_of(const AmberShader& shader) {
  const std::string command = "glslangValidator --quiet -V --stdin -S " +
                              std::string(shader.stage == "vertex" ? "vert" : "frag") +
                              " -o /dev/null";
  const ProcessResult run = run_process(command, shader.source, {}, "CLIPSCOPE", {.seconds = 60});
  return run.succeeded() ? "" : run.output + run.errors;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

TEST_CASE("amber: each script is one by its grammar, and its shaders compile") {
  const bool compiles = is_there_or_not_required("glslangValidator", "CLIPSCOPE_REQUIRE_GLSLANG");
  int scripts = 0;
  for (const Claim& claim : right_claims()) {
    const std::string text = text_of(claim, ".amber");
    if (text.empty()) continue;
    ++scripts;
    CAPTURE(claim.name, text);
    const AmberScript script = read_amber(text);
    CHECK(script.error == "");
    CHECK(script.runs ==
          (claim.wrong.quantity == Quantity::depth && claim.wrong.kind == ViolationKind::wrong_value
               ? 3
               : 1));
    CHECK(script.expectations == 1);
    for (const AmberShader& shader : script.shaders) {
      if (compiles) CHECK(faults_of(shader) == "");
    }
  }
  CHECK(scripts + 1 == static_cast<int>(right_claims().size()));  // all but "flat"
}

TEST_CASE("amber: the grammar refuses what is none") {
  const std::string text = text_of(right_claims().front(), ".amber");
  REQUIRE(read_amber(text).error == "");
  const auto [what, by, error] = GENERATE(table<std::string, std::string, std::string>(
      {{"#!amber", "# amber", "#!amber"},
       {"0.0 0.0 0.5 1.0", "0.0 0.0 0.5", "components are missing"},
       {"0.0 0.0 0.5 1.0", "0 0.0 0.5 1.0", "no number: 0"},
       {"ATTACH vertex_shader", "ATTACH another", "no shader another"},
       {"COUNT 4", "COUNT 3", "another count"},
       {"EXPECT target", "EXPECT picture", "EXPECT"},
       {"0 255 0 255\n", "0 256 0 255\n", "no component"},
       {"TRIANGLE_STRIP", "TRIANGLES", "DRAW_ARRAY"}}));
  CAPTURE(what, by);
  CHECK(read_amber(replaced(text, what, by)).error.find(error) != std::string::npos);
}

TEST_CASE("amber: what Vulkan by itself can't say has no script") {
  for (const Claim& claim : right_claims()) {
    if (claim.name == "flat") CHECK(text_of(claim, ".amber").empty());  // of the last vertex
  }
  Claim claim = right_claims().front();
  claim.call.vertices[0].position = {0, 0, 1, 1 + 0x1p-23f};  // (z + w) / 2 has a bit more
  CHECK(text_of(claim, ".amber").empty());
  CHECK(!text_of(claim, ".shader_test").empty());
}

}  // namespace
}  // namespace clipscope::experiments
