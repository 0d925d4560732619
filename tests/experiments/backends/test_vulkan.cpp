// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <functional>
#include <variant>
#include <vector>

#include "tests/experiments/backends/drivers_for_tests.hpp"

namespace clipscope::experiments {
namespace {

// Runs a test on each Vulkan driver that is here.
void on_vulkan_drivers(const std::function<void(DriverProcess&)>& test) {
  for (const char* name : {"lavapipe", "swiftshader"}) {
    INFO("on " << name);
    if (const auto driver = driver_for_test(name)) test(*driver);
  }
}

// half_square with the depth range of Vulkan and the depths of its corners.
DrawCall slope(int size, float z0, float z1, float z2) {
  DrawCall call = half_square(size);
  call.volume.depth = DepthRange::zero_to_one;
  call.vertices[0].position[2] = z0;
  call.vertices[1].position[2] = z1;
  call.vertices[2].position[2] = z2;
  call.quantities.set(bit(Quantity::depth)).set(bit(Quantity::frag_coord));
  return call;
}

// Two triangles that are all of the target, as a strip or a fan; varying x numbers the vertices.
DrawCall square(int size, Topology topology) {
  DrawCall call = half_square(size);
  call.topology = topology;
  call.vertices = {{{-1, -1}}, {{1, -1}}, {{-1, 1}}, {{1, 1}}};
  if (topology == Topology::triangle_fan) std::swap(call.vertices[2], call.vertices[3]);
  for (std::size_t i = 0; i < 4; ++i) {
    call.vertices[i].position[3] = 1;
    call.vertices[i].varying[0] = static_cast<float>(i);
  }
  return call;
}

std::ptrdiff_t count(const Pixels& pixels, Quantity quantity, float value) {
  const std::vector<float>& values = pixels.of(quantity);
  std::ptrdiff_t found = 0;
  for (std::size_t i = 0; i < values.size(); i += channels(quantity)) found += values[i] == value;
  return found;
}

TEST_CASE("vulkan: depth is z / w from 0 to 1, and half of 1 + z / w from -1 to 1") {
  on_vulkan_drivers([](DriverProcess& driver) {
    DrawCall call = slope(8, 0, 0.5f, 1);
    for (const auto range : {DepthRange::zero_to_one, DepthRange::minus_one_to_one}) {
      call.volume.depth = range;
      const Pixels pixels = pixels_of(driver, call);
      for (int i = 0; i < 28; ++i) {
        const int x = i % 4, y = i / 8;
        CAPTURE(x, y, range == DepthRange::zero_to_one);
        const float z_ndc =
            (static_cast<float>(x) + 0.5f) / 16 + (static_cast<float>(y) + 0.5f) / 8;
        const float z = range == DepthRange::zero_to_one ? z_ndc : (1 + z_ndc) / 2;
        CHECK(pixels.at(Quantity::depth, x, y) == z);
        CHECK(pixels.at(Quantity::frag_coord, x, y, 2) == z);
      }
    }
  });
}

TEST_CASE("vulkan: what is beyond the far plane is drawn at its depth with depth clamp alone") {
  on_vulkan_drivers([](DriverProcess& driver) {
    DrawCall call = slope(8, 0, 2, 0);  // z / w = 1 at x = 4 px
    const Pixels clipped = pixels_of(driver, call);
    call.volume.depth_clamp = true;
    const Pixels clamped = pixels_of(driver, call);
    CHECK(clipped.at(Quantity::covered, 3, 0) == 1);
    CHECK(clipped.at(Quantity::covered, 4, 0) == 0);
    CHECK(clipped.at(Quantity::depth, 4, 0) == kNoDepth);
    CHECK(clamped.at(Quantity::depth, 3, 0) == 0.875f);
    CHECK(clamped.at(Quantity::depth, 4, 0) == 1);
  });
}

TEST_CASE("vulkan: flat values are those of the provoking vertex, first or last") {
  on_vulkan_drivers([](DriverProcess& driver) {
    for (const auto topology : {Topology::triangle_strip, Topology::triangle_fan}) {
      for (const auto mode : {ProvokingVertex::first, ProvokingVertex::last}) {
        DrawCall call = square(8, topology);
        call.provoking = mode;
        call.quantities.set(bit(Quantity::flat));
        const Pixels pixels = pixels_of(driver, call);
        CAPTURE(names_of(topology)[static_cast<std::size_t>(topology)]);
        CAPTURE(mode == ProvokingVertex::last);
        const auto first = static_cast<float>(provoking_vertex(call, 0));
        const auto second = static_cast<float>(provoking_vertex(call, 1));
        CHECK(count(pixels, Quantity::hits, 1) == 64);
        CHECK(count(pixels, Quantity::flat, first) >= 28);
        CHECK(count(pixels, Quantity::flat, second) >= 28);
      }
    }
  });
}

TEST_CASE("vulkan: clip distances clip, and the fragment shader reads them") {
  on_vulkan_drivers([](DriverProcess& driver) {
    for (int number = 0; number < kMaxClipDistances; ++number) {
      CAPTURE(number);
      DrawCall call = half_square(8);
      call.volume.clip_distances = number + 1;
      call.quantities.set(bit(Quantity::clip_distances));
      for (std::size_t i = 0; i < 3; ++i) {
        call.vertices[i].clip_distances = {1, 1, 1, 1, 1, 1, 1, 1};
        call.vertices[i].clip_distances[static_cast<std::size_t>(number)] = i == 1 ? -1 : 1;
      }
      const Pixels pixels = pixels_of(driver, call);  // the distance is 0 at x = 4 px
      CHECK(pixels.at(Quantity::covered, 3, 0) == 1);
      CHECK(pixels.at(Quantity::covered, 4, 0) == 0);
      for (int i = 0; i < kMaxClipDistances; ++i) {
        const float expected = i == number ? 0.125f : i < number ? 1 : 0;
        CHECK(pixels.at(Quantity::clip_distances, 3, 0, static_cast<std::size_t>(i)) == expected);
      }
    }
  });
}

TEST_CASE("vulkan: points and lines have the pixels whose centres they cover") {
  on_vulkan_drivers([](DriverProcess& driver) {
    DrawCall call = half_square(8);
    call.topology = Topology::points;
    call.point_size = 4;
    call.vertices = {{{0, 0, 0, 1}}};
    const Pixels point = pixels_of(driver, call);
    CHECK(count(point, Quantity::covered, 1) == 16);
    CHECK(point.at(Quantity::covered, 2, 2) + point.at(Quantity::covered, 5, 5) == 2);
    call.topology = Topology::lines;
    call.vertices = {{{-1, -0.125f, 0, 1}}, {{1, -0.125f, 0, 1}}};  // centres of row 3
    call.quantities.set(bit(Quantity::facing));
    const Pixels line = pixels_of(driver, call);
    CHECK(count(line, Quantity::covered, 1) == 8);
    CHECK(line.at(Quantity::covered, 0, 3) + line.at(Quantity::covered, 7, 3) == 2);
    CHECK(count(line, Quantity::facing, 1) == 8);
  });
}

TEST_CASE("vulkan: a triangle that turns the other way is back-facing") {
  on_vulkan_drivers([](DriverProcess& driver) {
    DrawCall call = half_square(8);
    call.quantities.set(bit(Quantity::facing));
    CHECK(pixels_of(driver, call).at(Quantity::facing, 0, 0) == 1);
    call.indices = {0, 2, 1};
    const Pixels pixels = pixels_of(driver, call);
    CHECK(pixels.at(Quantity::facing, 0, 0) == -1);
    CHECK(values_at<2>(pixels, Quantity::hits, 0, 0) == std::array<float, 2>{1, 0});
  });
}

TEST_CASE("vulkan: hits count each fragment, and later primitives are above earlier ones") {
  on_vulkan_drivers([](DriverProcess& driver) {
    DrawCall call = half_square(8);
    call.indices = {0, 1, 2, 0, 2, 1, 0, 1, 2};
    const bool tells_id = driver.info().quantities[bit(Quantity::primitive_id)];
    call.quantities.set(bit(Quantity::primitive_id), tells_id);
    const Pixels pixels = pixels_of(driver, call);
    CHECK(values_at<2>(pixels, Quantity::hits, 0, 0) == std::array<float, 2>{3, 2});
    if (tells_id) CHECK(pixels.at(Quantity::primitive_id, 0, 0) == 2);
    if (tells_id) CHECK(pixels.at(Quantity::primitive_id, 7, 7) == -1);
  });
}

TEST_CASE("vulkan: a viewport may reach beyond the target, but not beyond the driver's bounds") {
  on_vulkan_drivers([](DriverProcess& driver) {
    DrawCall call = half_square(8);
    call.viewport = {-8, 0, 16, 8};
    call.quantities.set(bit(Quantity::smooth));
    const Pixels pixels = pixels_of(driver, call);
    CHECK(values_at<4>(pixels, Quantity::smooth, 2, 1) ==
          std::array<float, 4>{10.5f / 16, 1.5f / 8, 0, 1});
    CHECK(pixels.at(Quantity::covered, 7, 1) == 0);
    call.viewport.x = -1'000'000;
    const Drawn drawn = driver.draw(call);
    REQUIRE(std::holds_alternative<DrawFailure>(drawn));
    CHECK(std::get<DrawFailure>(drawn).kind == DrawFailure::Kind::unable);
  });
}

TEST_CASE("vulkan: no vertices are no pixels") {
  on_vulkan_drivers([](DriverProcess& driver) {
    DrawCall call = half_square(8);
    call.vertices.clear();
    CHECK(count(pixels_of(driver, call), Quantity::hits, 0) == 64);
  });
}

}  // namespace
}  // namespace clipscope::experiments
