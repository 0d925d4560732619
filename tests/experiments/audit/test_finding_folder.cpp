// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "experiments/audit/draw_cases.hpp"
#include "experiments/audit/draw_text.hpp"
#include "experiments/audit/finding_folder.hpp"
#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/audit/sample_calls.hpp"

namespace clipscope::experiments {
namespace {

// One finding: NaN of the triangle that is clipped.
Audit audit_with_nan(DriverPool& drivers) {
  return audit_driver("own/noperspective_nan", drivers, std::vector{behind_call("behind")},
                      {.shrinks = false});
}

TEST_CASE("finding folder: it holds a picture, a case, reproductions and what they are",
          "[audit]") {
  const TemporaryFolder scratch;
  const DriverSource source = driver_source("own/noperspective_nan");
  DriverPool drivers(source.make);
  const Audit audit = audit_with_nan(drivers);
  REQUIRE(audit.findings.size() == 1);
  const auto folder = write_finding(scratch.path(), source, drivers, audit, audit.findings.front());
  CHECK(folder.filename() == "noperspective_not_finite_triangle_behind_the_eye");
  CHECK(std::filesystem::exists(folder / kPictureFile));
  const std::string readme = read_bytes(folder / "README.md");
  CHECK_THAT(readme, Catch::Contains("clipscope audit --driver own/noperspective_nan --cases"));
  CHECK_THAT(readme, Catch::Contains("picture.png"));
  int shader_tests = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".shader_test") ++shader_tests;
  }
  CHECK(shader_tests == 1);
  const std::vector<HardCase> cases = load_catalogue(folder / kCasesFile);
  REQUIRE(cases.size() == 1);
  CHECK(cases[0].vertices[2].position == std::array<double, 4>{0, 3, -2, -1});
  // Written anew, it has the same case, and no second one.
  write_finding(scratch.path(), source, drivers, audit, audit.findings.front());
  CHECK(load_catalogue(folder / kCasesFile).size() == 1);
}

TEST_CASE("draw cases: clip distances and volume are those of the draw call", "[audit]") {
  DriverPool drivers(own_driver(RasterFault::noperspective_nan));
  DrawCall call = behind_call("behind");
  set_clip_distances(call, 2);
  for (DrawVertex& vertex : call.vertices) vertex.clip_distances = {1, 2};
  const Audit audit = audit_driver("own", drivers, std::vector{call}, {.shrinks = false});
  REQUIRE_FALSE(audit.findings.empty());
  const std::vector<HardCase> cases = cases_of(audit, audit.findings.front());
  REQUIRE(cases.size() == 1);
  CHECK(cases[0].volume == call.volume);
  CHECK(cases[0].vertices[1].attributes[0] == 1);
  CHECK(cases[0].vertices[1].attributes[1] == 2);
}

TEST_CASE("draw text: it names what is unusual and nothing else", "[audit]") {
  DrawCall call = inside_call("");
  CHECK(draw_text(call) == "triangles (-0.5,-0.5,0,1) (0.5,-0.5,0,1) (0,0.5,0,1), 32 x 32 px");
  call.volume.depth = DepthRange::zero_to_one;
  call.volume.depth_clamp = true;
  call.indices = {2, 1, 0};
  call.viewport.x = -3;
  CHECK(
      draw_text(call, 1) ==
      "triangles (-0.5,-0.5,0,1) and 2 more vertices, 3 indices, depth 0 to 1, depth clamp, 32 x 32 px, viewport 32 x 32 at (-3, 0)");
}

}  // namespace
}  // namespace clipscope::experiments
