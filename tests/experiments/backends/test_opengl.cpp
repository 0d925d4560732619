// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "tests/experiments/backends/drivers_for_tests.hpp"

namespace clipscope::experiments {
namespace {

Pixels pixels_of(DriverProcess& driver, const DrawCall& call) {
  const Drawn drawn = driver.draw(call);
  const auto* failure = std::get_if<DrawFailure>(&drawn);
  if (failure) FAIL(failure->reason);
  return std::get<Pixels>(drawn);
}

template <std::size_t n>
std::array<float, n> values_at(const Pixels& pixels, Quantity quantity, int x, int y) {
  std::array<float, n> values{};
  for (std::size_t c = 0; c < n; ++c) values[c] = pixels.at(quantity, x, y, c);
  return values;
}

TEST_CASE("opengl: each quantity of a triangle whose values are all exact is what it should be") {
  const auto* name = GENERATE("llvmpipe", "softpipe", "zink");
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

}  // namespace
}  // namespace clipscope::experiments
