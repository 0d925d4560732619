// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/rasterizer.hpp"

#include <limits>
#include <random>
#include <vector>

#include "tests/catch.hpp"
#include "tests/experiments/render/shapes.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// How often each pixel is drawn when every polygon gets a buffer of its own.
template <class Polygons>
std::vector<int> times_drawn(const Polygons& polygons, int width, int height) {
  std::vector<int> times(static_cast<std::size_t>(width * height));
  for (const auto& polygon : polygons) {
    FrameBuffer buffer = empty_buffer(width, height);
    draw_polygon(buffer, polygon, 0);
    for (std::size_t i = 0; i < times.size(); ++i) times[i] += buffer.covered(i);
  }
  return times;
}

TEST_CASE("rasterizer: two triangles that share an edge draw each pixel once") {
  const Quad& q = kWholeScreen;
  const int width = GENERATE(1, 7, 16), height = GENERATE(1, 16);
  const std::vector<std::array<ScreenVertex, 3>> triangles = {{q[0], q[1], q[2]},
                                                              {q[0], q[2], q[3]}};
  const std::vector<std::array<ScreenVertex, 3>> clockwise = {{q[0], q[2], q[1]},
                                                              {q[3], q[2], q[0]}};
  const std::vector<int> once(static_cast<std::size_t>(width * height), 1);
  CHECK(times_drawn(triangles, width, height) == once);
  CHECK(times_drawn(clockwise, width, height) == once);
}

TEST_CASE("rasterizer: a mesh with arbitrary inner vertices draws each pixel once") {
  constexpr int kCells = 6;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  std::array<std::array<ScreenVertex, kCells + 1>, kCells + 1> grid;
  for (int i = 0; i <= kCells; ++i) {
    for (int j = 0; j <= kCells; ++j) {
      const bool inner = 0 < i && i < kCells && 0 < j && j < kCells;
      grid[i][j].x = 2 * (i + (inner ? jitter(generator) : 0)) / kCells - 1;
      grid[i][j].y = 2 * (j + (inner ? jitter(generator) : 0)) / kCells - 1;
    }
  }
  std::vector<std::array<ScreenVertex, 3>> triangles;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      triangles.push_back({grid[i][j], grid[i + 1][j], grid[i + 1][j + 1]});
      triangles.push_back({grid[i][j], grid[i + 1][j + 1], grid[i][j + 1]});
    }
  }
  CHECK(times_drawn(triangles, 61, 47) == std::vector<int>(61 * 47, 1));
}

TEST_CASE("rasterizer: centres on a left or top edge are drawn, on a right or bottom edge not") {
  FrameBuffer buffer = empty_buffer(4, 4);
  // From the centre of pixel (0, 0) to the centre of pixel (2, 2).
  draw_polygon(buffer, rectangle(-0.75, -0.25, 0.25, 0.75), 0);
  const std::vector<int> expected = {1, 1, 0, 0,  //
                                     1, 1, 0, 0,  //
                                     0, 0, 0, 0,  //
                                     0, 0, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("pixel " << i);
    CHECK(buffer.covered(i) == (expected[i] == 1));
  }
}

TEST_CASE("rasterizer: attributes are perspective-correct and depth is linear on the screen") {
  // From w = 1, u = 0 at the left to w = 3, u = 1 at the right. Pixel 1 of 4 lies at s = 3/8:
  // u = (s/3) / ((1 - s) + s/3) = (1/8) / (6/8) = 1/6, z = 3/8, 1/w = 6/8.
  const Quad floor = {
      {{-1, -1, 0, 1, {0}}, {1, -1, 1, 1.0 / 3, {1}}, {1, 1, 1, 1.0 / 3, {1}}, {-1, 1, 0, 1, {0}}}};
  FrameBuffer buffer = empty_buffer(4, 1);
  draw_polygon(buffer, floor, 9);
  CHECK(buffer.attributes[1][0] == Approx(1.0 / 6).epsilon(1e-14));
  CHECK(buffer.depth[1] == 0.375f);
  CHECK(buffer.inv_w[1] == Approx(0.75).epsilon(1e-14));
  CHECK(buffer.triangle[1] == 9);
}

TEST_CASE("rasterizer: the nearer pixel stays, and the first of two equally near ones") {
  const auto range =
      GENERATE(DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed);
  FrameBuffer buffer(2, 2, range);
  const double nearer = range == DepthRange::reversed ? 0.75 : 0.25;
  const auto draw = [&](double z, std::uint32_t id) {
    Quad quad = kWholeScreen;
    for (ScreenVertex& v : quad) v.z = z;
    draw_polygon(buffer, quad, id);
  };
  draw(0.5, 1);
  CHECK(buffer.triangle[0] == 1);
  draw(nearer, 2);
  CHECK(buffer.triangle[0] == 2);
  draw(nearer, 3);
  draw(0.5, 4);
  CHECK(buffer.triangle[0] == 2);
  CHECK(buffer.depth[0] == static_cast<float>(nearer));
}

TEST_CASE("rasterizer: counter-clockwise is a front face, clockwise a back face") {
  FrameBuffer front = empty_buffer(2, 2), back = empty_buffer(2, 2);
  draw_polygon(front, kWholeScreen, 0);
  draw_polygon(back, Quad{kWholeScreen[3], kWholeScreen[2], kWholeScreen[1], kWholeScreen[0]}, 0);
  CHECK(front.facing == std::vector<Facing>(4, Facing::front));
  CHECK(back.facing == std::vector<Facing>(4, Facing::back));
}

TEST_CASE("rasterizer: a polygon reaching beyond the screen is drawn up to its border") {
  const double size = GENERATE(1.5, 1e3, 1e9, 1e30, 1e100);
  FrameBuffer buffer = empty_buffer(8, 5);
  draw_polygon(buffer, rectangle(-size, -size, size, size), 0);
  CHECK(covered_pixels(buffer) == 40);
  CHECK(buffer.not_finite == 0);
}

TEST_CASE("rasterizer: triangles with a vertex that is not finite are left out and counted") {
  FrameBuffer half = empty_buffer(4, 4);
  draw_polygon(half, std::span(kWholeScreen).first(3), 0);
  const double value = GENERATE(as<double>{}, kNan, kInfinity, -kInfinity);
  for (const auto member :
       {&ScreenVertex::x, &ScreenVertex::y, &ScreenVertex::z, &ScreenVertex::inv_w}) {
    INFO("value " << value);
    Quad quad = kWholeScreen;
    quad[3].*member = value;
    FrameBuffer buffer = empty_buffer(4, 4);
    draw_polygon(buffer, quad, 0);
    CHECK(buffer.not_finite == 1);
    CHECK(buffer.facing == half.facing);
  }
}

TEST_CASE("rasterizer: a pixel whose 1/w is 0 is drawn and is not finite") {
  Quad quad = kWholeScreen;
  for (ScreenVertex& v : quad) v.inv_w = 0;
  FrameBuffer buffer = empty_buffer(2, 2);
  draw_polygon(buffer, quad, 0);
  CHECK(covered_pixels(buffer) == 4);
  CHECK_FALSE(buffer.finite(0));
}

TEST_CASE("rasterizer: polygons without area draw nothing") {
  FrameBuffer buffer = empty_buffer(8, 8);
  draw_polygon(buffer, {}, 0);
  draw_polygon(buffer, std::span(kWholeScreen).first(2), 0);
  draw_polygon(buffer, Quad{kWholeScreen[0], kWholeScreen[2], kWholeScreen[0], kWholeScreen[2]}, 0);
  CHECK(covered_pixels(buffer) == 0);
  CHECK(buffer.not_finite == 0);
}

TEST_CASE("rasterizer: any bit patterns are survived, and the same calls give the same bits") {
  constexpr std::array<double, 14> kHostile = {
      0.0,  -0.0,   1.0,   -1.0,     0.5,  1e-320,    -1e30,
      1e30, 1e-300, 1e300, -1.7e308, kNan, kInfinity, std::numeric_limits<double>::min()};
  const auto draw_all = [&] {
    FrameBuffer buffer = empty_buffer(5, 3);
    std::mt19937 generator(3);
    const auto any = [&] { return kHostile[generator() % kHostile.size()]; };
    for (std::uint32_t i = 0; i < 20000; ++i) {
      Quad quad;
      for (ScreenVertex& v : quad) v = {any(), any(), any(), any(), {any(), any(), any(), any()}};
      draw_polygon(buffer, quad, i);
    }
    return buffer;
  };
  const FrameBuffer first = draw_all(), second = draw_all();
  CHECK(first.not_finite > 0);
  CHECK(covered_pixels(first) > 0);
  CHECK(first.triangle == second.triangle);
  CHECK(first.facing == second.facing);
}

}  // namespace
}  // namespace clipscope::experiments
