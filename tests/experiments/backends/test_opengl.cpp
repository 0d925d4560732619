// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <numeric>
#include <vector>

#include "tests/experiments/backends/drivers_for_tests.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("drivers: each quantity of a triangle whose values are all exact is what it should be") {
  const auto* name = GENERATE("llvmpipe", "softpipe", "zink", "lavapipe", "swiftshader");
  const auto driver = driver_for_test(name);
  if (!driver) return;
  DrawCall call = half_square(8);
  call.quantities.set().reset(bit(Quantity::primitive_id));
  call.volume.clip_distances = 1;
  for (DrawVertex& vertex : call.vertices) vertex.clip_distances[0] = 1;
  const Pixels pixels = pixels_of(*driver, call);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      CAPTURE(name, x, y);
      if (x + y == 7) continue;  // on the edge
      const bool is_in = x + y < 7;
      CHECK(pixels.at(Quantity::covered, x, y) == (is_in ? 1 : 0));
      const float hits = is_in ? 1 : 0;
      CHECK(values_at<2>(pixels, Quantity::hits, x, y) == std::array{hits, hits});
      CHECK(pixels.at(Quantity::depth, x, y) == 0.5f);
      if (!is_in) continue;
      const float x_px = static_cast<float>(x) + 0.5f, y_px = static_cast<float>(y) + 0.5f;
      const std::array<float, 4> varying = {x_px / 8, y_px / 8, 0, 1};
      CHECK(values_at<4>(pixels, Quantity::smooth, x, y) == varying);
      CHECK(values_at<4>(pixels, Quantity::noperspective, x, y) == varying);
      CHECK(values_at<4>(pixels, Quantity::flat, x, y) == call.vertices[2].varying);
      CHECK(values_at<4>(pixels, Quantity::frag_coord, x, y) ==
            std::array<float, 4>{x_px, y_px, 0.5f, 1});
      CHECK(pixels.at(Quantity::facing, x, y) == 1);
      CHECK(pixels.at(Quantity::clip_distances, x, y) == 1);
    }
  }
}

// The driver, and on it: what a draw call changes about the half square.
using Change = std::function<void(DrawCall&)>;
Pixels changed(DriverProcess& driver, Quantities quantities, const Change& change) {
  DrawCall call = half_square(8);
  call.quantities = quantities;
  change(call);
  return pixels_of(driver, call);
}

Quantities only(Quantity quantity) { return Quantities().set(bit(quantity)); }

TEST_CASE("opengl: depth follows the volume's range") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const auto to_a_quarter = [](DrawCall& call) {
    for (DrawVertex& vertex : call.vertices) vertex.position[2] = 0.25f;
  };
  const auto from_zero = [&](DrawCall& call) {
    to_a_quarter(call);
    call.volume.depth = DepthRange::zero_to_one;
  };
  CHECK(changed(*driver, only(Quantity::depth), to_a_quarter).at(Quantity::depth, 1, 1) == 0.625f);
  CHECK(changed(*driver, only(Quantity::depth), from_zero).at(Quantity::depth, 1, 1) == 0.25f);
}

TEST_CASE("opengl: what lies beyond the far plane is clipped, or clamped") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const auto beyond = [](DrawCall& call) {
    for (DrawVertex& vertex : call.vertices) vertex.position[2] = 2;
  };
  const auto clamped = [&](DrawCall& call) {
    beyond(call);
    call.volume.depth_clamp = true;
  };
  const Pixels none = changed(*driver, only(Quantity::depth), beyond);
  CHECK(none.at(Quantity::covered, 1, 1) == 0);
  CHECK(none.at(Quantity::depth, 1, 1) == kNoDepth);
  const Pixels some = changed(*driver, only(Quantity::depth), clamped);
  CHECK(some.at(Quantity::covered, 1, 1) == 1);
  CHECK(some.at(Quantity::depth, 1, 1) == 1);
}

TEST_CASE("opengl: a clip distance takes away where it is negative, and no call after its own") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const int last = GENERATE(0, 4, 7);
  const auto left_half = [last](DrawCall& call) {
    call.volume.clip_distances = last + 1;
    for (DrawVertex& vertex : call.vertices) {
      vertex.clip_distances.fill(1);
      vertex.clip_distances[static_cast<std::size_t>(last)] = -vertex.position[0];
    }
  };
  const Pixels cut = changed(*driver, only(Quantity::clip_distances), left_half);
  CHECK(cut.at(Quantity::covered, 3, 0) == 1);
  CHECK(cut.at(Quantity::covered, 4, 0) == 0);
  CHECK(cut.at(Quantity::clip_distances, 2, 0, static_cast<std::size_t>(last)) == 0.375f);
  CHECK(cut.at(Quantity::clip_distances, 2, 0, 6) == (last > 6 ? 1 : last == 6 ? 0.375f : 0));
  CHECK(changed(*driver, {}, [](DrawCall&) {}).at(Quantity::covered, 4, 0) == 1);
}

TEST_CASE("opengl: flat values are those of the provoking vertex, first or last") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const auto topology = GENERATE(Topology::triangles, Topology::line_strip, Topology::triangle_fan);
  const auto provoking = GENERATE(ProvokingVertex::first, ProvokingVertex::last);
  DrawCall call = half_square(8);
  call.topology = topology;
  call.provoking = provoking;
  call.quantities = only(Quantity::flat);
  // The first line of the strip goes along row 0.
  for (DrawVertex& vertex : call.vertices) vertex.position[1] += 0.125f;
  CHECK(values_at<4>(pixels_of(*driver, call), Quantity::flat, 3, 0) ==
        call.vertices[provoking_vertex(call, 0)].varying);
}

TEST_CASE("opengl: a viewport may reach beyond the target on all sides") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const auto shifted = [](DrawCall& call) { call.viewport = {-4, -4, 16, 16}; };
  const Pixels pixels = changed(*driver, only(Quantity::smooth), shifted);
  CHECK(pixels.at(Quantity::covered, 7, 7) == 0);
  CHECK(pixels.at(Quantity::covered, 0, 6) == 1);
  CHECK(values_at<4>(pixels, Quantity::smooth, 0, 6) ==
        std::array<float, 4>{4.5f / 16, 10.5f / 16, 0, 1});
}

TEST_CASE("opengl: which side of a triangle one sees, and how often a pixel is hit, are counted") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const auto both_sides = [](DrawCall& call) { call.indices = {0, 1, 2, 0, 2, 1}; };
  const Pixels pixels = changed(*driver, only(Quantity::facing), both_sides);
  CHECK(values_at<2>(pixels, Quantity::hits, 1, 1) == std::array<float, 2>{2, 1});
  CHECK(pixels.at(Quantity::facing, 1, 1) == -1);
}

TEST_CASE("opengl: a point covers as many pixels as its size has") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const auto points = [](DrawCall& call) {
    call.topology = Topology::points;
    call.vertices.resize(1);
    call.vertices[0].position = {0, 0, 0, 1};
    call.point_size = 4;
  };
  const Pixels pixels = changed(*driver, {}, points);
  const std::vector<float>& covered = pixels.of(Quantity::covered);
  CHECK(std::accumulate(covered.begin(), covered.end(), 0.0f) == 16);
  CHECK(pixels.at(Quantity::covered, 2, 2) == 1);
  CHECK(pixels.at(Quantity::covered, 5, 5) == 1);
}

// softpipe of Mesa 22.3 draws nothing of a shader that reads gl_PrimitiveID.
TEST_CASE("opengl: what gl_PrimitiveID does to its pass, it does to no other quantity") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  const Quantities others = Quantities().set().reset(bit(Quantity::primitive_id));
  const Pixels without = changed(*driver, others, [](DrawCall&) {});
  Pixels with = changed(*driver, Quantities().set(), [](DrawCall&) {});
  with.values[bit(Quantity::primitive_id)].clear();
  CHECK(with == without);
}

TEST_CASE("opengl: an error of the API is told by its name, and the next call is served") {
  const auto driver = driver_for_test(GENERATE("llvmpipe", "softpipe", "zink"));
  if (!driver) return;
  DrawCall call = half_square(8);
  call.viewport.width = -1;
  CHECK(driver->draw(call) ==
        Drawn(DrawFailure{DrawFailure::Kind::refused, "GL_INVALID_VALUE in setting the state"}));
  CHECK(pixels_of(*driver, half_square(8)).at(Quantity::covered, 1, 1) == 1);
}

}  // namespace
}  // namespace clipscope::experiments
