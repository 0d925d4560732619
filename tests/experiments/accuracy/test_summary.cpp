// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of accuracy, and that altered rows say otherwise.
#include "experiments/accuracy/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::accuracy {
namespace {

Row row(const char* scene, const char* clipper, const char* scalar, double max_px) {
  Row r;
  r.scene = scene;
  r.clipper = clipper;
  r.scalar = scalar;
  r.figures.px = Spread{.median = 0, .max = max_px};
  return r;
}

std::vector<Row> measured() {
  return {row("teapot", "view/sutherland_hodgman", "float", 0.01),
          row("teapot", "homogeneous/sutherland_hodgman", "float", 0.02),
          row("slivers", "view/sutherland_hodgman", "float", 667),
          row("slivers", "homogeneous/sutherland_hodgman", "float", 1457),
          row("slivers", "homogeneous/sutherland_hodgman", "double", 1e-6)};
}

std::string checked(const std::vector<Row>& rows) {
  const std::string text = finding(rows);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

TEST_CASE(
    "accuracy: the finding says whether float is seen to be off, where, and what double does") {
  std::vector<Row> rows = measured();
  CHECK(
      checked(rows) ==
      "Float clipping can be seen to be off where the vertices are the right ones: the largest error is 667 px for view space and 1457 px for clip space. It depends on the triangles: the worst are on slivers, and on one of two scenes no error reaches a pixel. In double no error can be seen on any scene.");
  rows[3].figures.px->max = 0.5;
  rows[4].figures.px->max = 2;
  CHECK(
      checked(rows) ==
      "Float clipping can be seen to be off, but not in every space, where the vertices are the right ones: the largest error is 0.500 px for clip space and 667 px for view space. It depends on the triangles: the worst are on slivers, and on one of two scenes no error reaches a pixel. In double, too, errors can be seen.");
  rows[2].figures.px->max = 0.5;
  CHECK(checked(rows).starts_with("Float clipping can't be seen to be off"));
}

TEST_CASE("accuracy: scenes where nothing had the right vertices are no answer") {
  std::vector<Row> rows = {row("teapot", "view/sutherland_hodgman", "float", 1)};
  rows[0].figures.px.reset();
  CHECK(checked(rows).starts_with("Nothing was judged"));
  CHECK(error_plot(rows).series.empty());
}

}  // namespace
}  // namespace clipscope::experiments::accuracy
