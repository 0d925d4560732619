// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "experiments/drawcalls/wire.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

DrawCall sample_call() {
  DrawCall call{.name = "strip", .topology = Topology::triangle_strip};
  for (int i = 0; i < 4; ++i) {
    const auto f = static_cast<float>(i);
    call.vertices.push_back({{f, -f, 0.5f * f, 1}, {f, 2, 3, 4}, {-1, f}});
  }
  call.indices = {0, 2, 1, 3};
  call.volume = {.depth = DepthRange::zero_to_one, .depth_clamp = true, .clip_distances = 2};
  call.provoking = ProvokingVertex::first;
  call.viewport = {-3, 4, 64, 16};
  call.quantities.set(bit(Quantity::smooth));
  return call;
}

Pixels sample_pixels() {
  Pixels pixels{2, 3};
  pixels.values[bit(Quantity::covered)] = {0, 1, 1, 0, 0, 1};
  pixels.values[bit(Quantity::hits)] = std::vector<float>(12, 1);
  return pixels;
}

TEST_CASE("wire: what is written is read back", "[drawcalls]") {
  CHECK(draw_call_of(to_bytes(sample_call())) == sample_call());
  DriverInfo info{.api = GraphicsApi::vulkan, .renderer = "one", .subpixel_bits = 8};
  info.quantities.set();
  CHECK(greeting_of(to_bytes(Greeting(info))) == Greeting(info));
  CHECK(greeting_of(to_bytes(Greeting("no EGL"))) == Greeting("no EGL"));
  CHECK(drawn_of(to_bytes(Drawn(sample_pixels()))) == Drawn(sample_pixels()));
  const DrawFailure failure{DrawFailure::Kind::refused, "GL_OUT_OF_MEMORY"};
  CHECK(drawn_of(to_bytes(Drawn(failure))) == Drawn(failure));
}

TEST_CASE("wire: bytes that are cut short or too many are nothing", "[drawcalls]") {
  const std::string call = to_bytes(sample_call()), drawn = to_bytes(Drawn(sample_pixels()));
  for (std::size_t size = 0; size < call.size(); ++size) {
    CHECK_FALSE(draw_call_of(std::span(call).first(size)));
  }
  for (std::size_t size = 0; size < drawn.size(); ++size) {
    CHECK_FALSE(drawn_of(std::span(drawn).first(size)));
  }
  CHECK_FALSE(draw_call_of(call + "x"));
  CHECK_FALSE(drawn_of(drawn + "x"));
}

TEST_CASE("wire: pixels that lack some of their values are nothing", "[drawcalls]") {
  Pixels pixels = sample_pixels();
  pixels.values[bit(Quantity::covered)].pop_back();
  CHECK_FALSE(drawn_of(to_bytes(Drawn(pixels))));
  CHECK_FALSE(drawn_of(to_bytes(Drawn(Pixels{}))));
}

TEST_CASE("wire: any byte changed gives something valid or nothing", "[drawcalls]") {
  const std::string good = to_bytes(sample_call());
  std::size_t refused = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bytes = good;
    bytes[i] = static_cast<char>(0xff);
    const auto call = draw_call_of(bytes);
    if (!call) ++refused;
    if (call) CHECK(static_cast<std::size_t>(call->topology) < names_of(Topology{}).size());
  }
  CHECK(refused > 10);
}

using Vertices = std::vector<std::vector<std::uint32_t>>;

TEST_CASE("draw call: a strip's triangles all face the same way", "[drawcalls]") {
  CHECK(primitives_of(sample_call()) == Vertices{{0, 2, 1}, {1, 2, 3}});
}

TEST_CASE("draw call: a fan turns about its first vertex", "[drawcalls]") {
  DrawCall call = sample_call();
  call.topology = Topology::triangle_fan;
  call.indices.clear();
  CHECK(primitives_of(call) == Vertices{{0, 1, 2}, {0, 2, 3}});
}

// OpenGL 4.6 core, table 13.2, with vertices and primitives counted from 0.
TEST_CASE("draw call: the provoking vertex is that of the specification's table", "[drawcalls]") {
  DrawCall call = sample_call();
  call.indices.clear();
  const auto provoking = [&](Topology topology, ProvokingVertex mode, std::size_t primitive) {
    call.topology = topology;
    call.provoking = mode;
    return provoking_vertex(call, primitive);
  };
  constexpr auto kFirst = ProvokingVertex::first, kLast = ProvokingVertex::last;
  CHECK(provoking(Topology::points, kFirst, 1) == 1);
  CHECK(provoking(Topology::lines, kFirst, 1) == 2);
  CHECK(provoking(Topology::lines, kLast, 1) == 3);
  CHECK(provoking(Topology::line_strip, kFirst, 1) == 1);
  CHECK(provoking(Topology::line_strip, kLast, 1) == 2);
  CHECK(provoking(Topology::triangle_strip, kFirst, 1) == 1);
  CHECK(provoking(Topology::triangle_strip, kLast, 1) == 3);
  CHECK(provoking(Topology::triangle_fan, kFirst, 1) == 2);
  CHECK(provoking(Topology::triangle_fan, kLast, 1) == 3);
}

TEST_CASE("driver: what it can't is said, whatever else it can", "[drawcalls]") {
  DriverInfo info{.max_size = 64, .zero_to_one = true};
  info.quantities.set();
  DrawCall call = sample_call();
  CHECK(inability(info, call) == "has no depth clamp");
  info.depth_clamp = true;
  CHECK(inability(info, call) == "has no clip distances");
  info.max_clip_distances = 8;
  CHECK(inability(info, call).empty());
  call.quantities.set(bit(Quantity::flat));
  CHECK(inability(info, call) == "can't provoke by the first vertex");
  info.provoking_first = true;
  CHECK(inability(info, call).empty());
  call.viewport.width = 65;
  CHECK(inability(info, call) == "has no target or viewport of that size");
}

}  // namespace
}  // namespace clipscope::experiments
