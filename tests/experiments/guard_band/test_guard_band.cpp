// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/measure.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::guard_band;

namespace {

// A view with 90 degrees both ways: x/w = x / -z.
View square_view() {
  View view;
  view.frustum = {.left = -1, .right = 1, .bottom = -1, .top = 1, .near = 1, .far = 100};
  return view;
}

// In front of the eye at z = -2, its right corner at x_ndc = reach.
SceneTriangle reaching(float reach) {
  SceneTriangle t{};
  t[0].position = {-1, -1, -2};
  t[1].position = {2 * reach, 0, -2};
  t[2].position = {-1, 1, -2};
  return t;
}

Work work_on(const SceneTriangle& triangle, const GuardBand& band,
             NdcPolygon<float, kSceneAttributes>& out) {
  return clip_to_band(Projection<float>(square_view().frustum), band, triangle, out);
}

std::vector<SampledView> batch_of(const std::vector<SceneTriangle>& triangles) {
  return {{square_view(), triangles}};
}

}  // namespace

TEST_CASE("guard band: a triangle that stays in the band is passed on as it is") {
  NdcPolygon<float, kSceneAttributes> out;
  CHECK(work_on(reaching(3), {4, 4}, out) == Work::none);
  REQUIRE(out.size() == 3);
  CHECK(out[1].position[0] == 3);
}

TEST_CASE("guard band: its edge belongs to it, and beyond it is cut there") {
  NdcPolygon<float, kSceneAttributes> out;
  CHECK(work_on(reaching(4), {4, 4}, out) == Work::none);
  CHECK(work_on(reaching(std::nextafter(4.0f, 5.0f)), {4, 4}, out) == Work::side_cut);
  CHECK(work_on(reaching(8), {4, 4}, out) == Work::side_cut);
  REQUIRE(out.size() == 4);
  for (const auto& v : out) CHECK(v.position[0] <= 4);
}

TEST_CASE("guard band: x and y have bands of their own") {
  NdcPolygon<float, kSceneAttributes> out;
  CHECK(work_on(reaching(3), {2, 8}, out) == Work::side_cut);
  CHECK(work_on(reaching(3), {8, 1}, out) == Work::none);
}

TEST_CASE("guard band: without sides only near and far cut") {
  SceneTriangle behind = reaching(1);
  behind[1].position = {0, 0, 5};
  NdcPolygon<float, kSceneAttributes> out;
  CHECK(work_on(behind, {kNoSides, kNoSides}, out) == Work::depth_cut);
  CHECK(out.size() == 4);
  CHECK(work_on(reaching(1e6f), {kNoSides, kNoSides}, out) == Work::none);
}

TEST_CASE("guard band: what is outside one side of the screen is rejected, band or not") {
  SceneTriangle beside = reaching(3);
  for (auto& v : beside) v.position[0] += 20;
  NdcPolygon<float, kSceneAttributes> out;
  CHECK(work_on(beside, {64, 64}, out) == Work::rejected);
  CHECK(out.empty());
}

TEST_CASE("guard band: a wider band never cuts more") {
  const auto batches =
      sampled_views(make_builtin_scene("soup_behind", {.seed = 1, .quick = true}), 500);
  std::int64_t last = tally_band(batches, {1, 1}).side_cut;
  CHECK(last > 0);
  for (const double band : {2.0, 4.0, 16.0, 64.0}) {
    const std::int64_t cut = tally_band(batches, {band, band}).side_cut;
    CHECK(cut <= last);
    last = cut;
  }
  CHECK(tally_band(batches, {kNoSides, kNoSides}).side_cut == 0);
}

TEST_CASE("guard band: the tally counts vertices, visited pixels and area by hand") {
  // In NDC: (-0.5, -0.5), (3, 0), (-0.5, 0.5): half of 3.5 x 1 of a 2 x 2 square.
  const Tally band = tally_band(batch_of({reaching(3)}), {4, 4});
  CHECK(band.passed() == 1);
  CHECK(band.vertices == 3);
  CHECK(band.area_px2 == Approx(3.5 / 2 / 4 * 3840 * 2160));
  // Its bounding box within the screen: x from -0.5 to 1, y from -0.5 to 0.5.
  CHECK(band.visited_px == 2880.0 * 1080.0);
  const Tally full = tally_full(batch_of({reaching(3)}));
  CHECK(full.vertices == 4);
  CHECK(full.side_cut == 1);
  CHECK(full.area_px2 < band.area_px2);
}

TEST_CASE("fixed point: the band of 16 integer bits is 32768 px") {
  const FixedPoint format{16};
  CHECK(format.band_px() == 32768);
  CHECK(format.band().x == 32768.0 / 1920);
  CHECK(format.band().y == 32768.0 / 1080);
  // Differences of two 24-bit numbers take 25, their products 50, the difference of two of those
  // 51.
  CHECK(format.edge_function_bits(8) == 51);
}

TEST_CASE("points: near, far and the pixel draw what six planes draw") {
  const auto batches = sampled_views(make_builtin_scene("soup", {.seed = 3, .quick = true}), 500);
  const PointTally tally = tally_points(batches);
  CHECK(tally.points == 1500);
  CHECK(tally.drawn > 0);
  CHECK(tally.kept_near_far > tally.kept_full);
  CHECK(tally.differ == 0);
}

TEST_CASE("guard band: the scissored picture is that of full clipping") {
  const Scene scene = make_builtin_scene("corridor", {.seed = 1, .quick = true});
  const PictureSize size{120, 68};
  const View& view = scene.views.front();
  const FrameBuffer exact = draw_exact(scene, view, size);
  const FrameBuffer full = draw(scene, view, size, {});
  const FrameBuffer band = draw(scene, view, size, {.band = GuardBand{16, 16}});
  const HeatMapCounts counts = compare(band, exact).counts;
  CHECK(counts[PixelFate::hole] + counts[PixelFate::extra] == 0);
  CHECK(unlike_pixels(band, full) == 0);
  CHECK(counts.compared() > 1000);

  FrameBuffer damaged = band;
  damaged.triangle[17] = kNoTriangle;
  CHECK(unlike_pixels(damaged, full) == 1);
}

TEST_CASE("guard band: times come with full clipping beside them") {
  const auto batches = sampled_views(make_builtin_scene("floor", {.seed = 1, .quick = true}), 100);
  const std::array bands = {GuardBand{1, 1}, GuardBand{16, 16}};
  const Times times = time_bands(batches, bands, 3);
  REQUIRE(times.bands.size() == 2);
  CHECK(times.full.is_timed());
  REQUIRE(times.full.speedup);
  CHECK(times.full.speedup->median == 1);
  for (const Timing& band : times.bands) {
    CHECK(band.refused.empty());
    CHECK(band.samples_ns.size() == 3);
    CHECK(band.ns.median > 0);
  }
}
