// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of the guard band, and that altered rows say otherwise.
#include "experiments/guard_band/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::guard_band;

namespace {

WorkRow work_row(const char* scene, double speedup, double visited) {
  WorkRow row;
  row.scene = scene;
  row.method = Method::band;
  row.band = 16;
  row.visited_ratio = visited;
  row.timing = Timing{};
  row.timing->speedup = MedianInterval{speedup, speedup - 0.1, speedup + 0.1};
  return row;
}

PictureRow picture(Method method, std::int64_t holes) {
  PictureRow row;
  row.method = method;
  if (method == Method::band) row.band = 16;
  row.vertices = "float";
  row.holes_px = holes;
  return row;
}

std::string checked(const std::vector<WorkRow>& work, const std::vector<PictureRow>& pictures) {
  const std::string text = finding(work, pictures);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

}  // namespace

TEST_CASE("guard band: the finding says where it pays, what it costs and that nothing changes") {
  std::vector<WorkRow> work = {work_row("soup", 0.7, 1), work_row("soup_straddling", 1.5, 2.07),
                               work_row("floor", 1, 1.3)};
  std::vector<PictureRow> pictures = {picture(Method::full, 0), picture(Method::band, 0)};
  CHECK(
      checked(work, pictures) ==
      "A guard band of 16 half screens makes clipping faster on straddling triangles, but slower on the game-like mix. The rasteriser pays for it: on straddling triangles it visits 2.07 times the pixels. The pictures cover the same pixels as the exact ones.");
  work[1] = work_row("soup_straddling", 1, 1);
  work[2].visited_ratio = 1;
  pictures[1].holes_px = 5;
  CHECK(
      checked(work, pictures) ==
      "A guard band of 16 half screens makes clipping faster on no scene. The rasteriser visits no more pixels. The pictures cover more wrong pixels than those of full clipping.");
  pictures[0].holes_px = 5;
  CHECK(checked(work, pictures).ends_with("as many wrong pixels as those of full clipping."));
}

TEST_CASE("guard band: without a row of that band the finding says that it was not timed") {
  CHECK(checked({}, {}) == "A guard band of 16 half screens was not timed.");
}
