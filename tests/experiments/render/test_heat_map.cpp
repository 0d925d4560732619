// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/heat_map.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "tests/catch.hpp"
#include "tests/experiments/render/shapes.hpp"

namespace clipscope::experiments {
namespace {

FrameBuffer drawn(const Quad& quad, int width = 8, int height = 4) {
  FrameBuffer buffer = empty_buffer(width, height);
  draw_polygon(buffer, quad, 0);
  return buffer;
}

Quad with_u_moved(Quad quad, double texels) {
  for (ScreenVertex& v : quad) v.attributes[0] += texels / 1024;
  return quad;
}

TEST_CASE("heat map: a buffer compared with itself is equal where it is covered") {
  const FrameBuffer half = drawn(rectangle(-1, -1, 0, 1));
  const HeatMapCounts counts = compare(half, half).counts;
  CHECK(counts[PixelFate::equal] == 16);
  CHECK(counts[PixelFate::empty] == 16);
  CHECK(counts.compared() == 16);
  CHECK(counts.max_error == 0);
  CHECK(counts.median_error == 0);
  CHECK(counts.share_above_one == 0);
}

TEST_CASE("heat map: what only the truth covers is a hole, what only the tested covers is extra") {
  const FrameBuffer left = drawn(rectangle(-1, -1, 0.5, 1)), right = drawn(rectangle(0, -1, 1, 1));
  const HeatMap map = compare(left, right);
  CHECK(map.counts[PixelFate::extra] == 16);
  CHECK(map.counts[PixelFate::hole] == 8);
  CHECK(map.counts[PixelFate::equal] == 8);
  CHECK(map.image.pixels[0] == fate_colour(PixelFate::extra));
  CHECK(map.image.pixels[7] == fate_colour(PixelFate::hole));
}

TEST_CASE("heat map: a face seen from the wrong side is flipped, whatever its error") {
  const Quad& q = kWholeScreen;
  const FrameBuffer front = drawn(q), back = drawn({q[3], q[2], q[1], q[0]});
  const HeatMapCounts counts = compare(back, front).counts;
  CHECK(counts[PixelFate::flipped] == 32);
  CHECK(counts.compared() == 0);
}

TEST_CASE("heat map: an attribute that is not finite has a category of its own") {
  Quad quad = kWholeScreen;
  for (ScreenVertex& v : quad) v.attributes[1] = std::numeric_limits<double>::quiet_NaN();
  const HeatMapCounts counts = compare(drawn(quad), drawn(kWholeScreen)).counts;
  CHECK(counts[PixelFate::not_finite] == 32);
  CHECK(counts.max_error == 0);
}

TEST_CASE("heat map: the error counts texels of a 1024-texel texture") {
  // The right half is 2 texels off, the left quarter half a texel, the rest is right.
  const Quad right = rectangle(0, -1, 1, 1), left = rectangle(-1, -1, -0.5, 1),
             rest = rectangle(-0.5, -1, 0, 1);
  FrameBuffer truth = empty_buffer(8, 4), tested = truth;
  for (const Quad& quad : {right, left, rest}) draw_polygon(truth, quad, 0);
  draw_polygon(tested, with_u_moved(right, 2), 0);
  draw_polygon(tested, with_u_moved(left, -0.5), 0);
  draw_polygon(tested, rest, 0);
  const HeatMapCounts counts = compare(tested, truth).counts;
  CHECK(counts[PixelFate::error] == 24);
  CHECK(counts[PixelFate::equal] == 8);
  CHECK(counts.max_error == Approx(2).epsilon(1e-12));
  CHECK(counts.median_error == Approx(2).epsilon(1e-12));
  CHECK(counts.share_above_one == 0.5);
}

TEST_CASE("heat map: an error below the scale counts as equal and still enters the median") {
  const HeatMapOptions options{.lowest = 1};
  const double texels = GENERATE(0.5, 2.0);
  const HeatMapCounts counts =
      compare(drawn(with_u_moved(kWholeScreen, texels)), drawn(kWholeScreen), options).counts;
  CHECK(counts[texels < 1 ? PixelFate::equal : PixelFate::error] == 32);
  CHECK(counts.median_error == Approx(texels).epsilon(1e-9));
}

TEST_CASE("heat map: the fates of all pixels add up to the buffer's size") {
  const HeatMapCounts counts = compare(drawn(rectangle(-0.5, -1, 1, 0.5)),
                                       drawn(with_u_moved(rectangle(-1, -0.5, 0.5, 1), 1)))
                                   .counts;
  CHECK(std::accumulate(counts.pixels.begin(), counts.pixels.end(), std::uint64_t{0}) == 32);
}

TEST_CASE("heat map: dilation widens what is drawn, not what is counted") {
  FrameBuffer truth = drawn(kWholeScreen, 9, 9), tested = truth;
  tested.facing[40] = Facing::none;  // the middle pixel
  HeatMapOptions options;
  options.dilate = GENERATE(false, true);
  const HeatMap map = compare(tested, truth, options);
  const auto magenta =
      std::count(map.image.pixels.begin(), map.image.pixels.end(), fate_colour(PixelFate::hole));
  CHECK(map.counts[PixelFate::hole] == 1);
  CHECK(magenta == (options.dilate ? 9 : 1));
}

TEST_CASE("heat map: triangles that could not be drawn are counted") {
  Quad quad = kWholeScreen;
  quad[0].x = std::numeric_limits<double>::infinity();
  const HeatMapCounts counts = compare(drawn(quad), drawn(kWholeScreen)).counts;
  CHECK(counts.triangles_not_drawn == 2);
  CHECK(counts[PixelFate::hole] == 32);
}

}  // namespace
}  // namespace clipscope::experiments
