// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/pixels/judgement.hpp"
#include "experiments/pixels/own_driver.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/pixels/draw_calls.hpp"

namespace clipscope::experiments {
namespace {

// A square of 2 x 2 px around the middle of 8 x 8, as two triangles, w = 1.
DrawCall square() {
  return call_of(Topology::triangle_strip,
                 {vertex_at(-0.25f, -0.25f, 0, 1, 1), vertex_at(0.25f, -0.25f, 0, 1, 1),
                  vertex_at(-0.25f, 0.25f, 0, 1, 1), vertex_at(0.25f, 0.25f, 0, 1, 1)},
                 8);
}

Pixels drawn(const DrawCall& call, const OwnDriverSetup& setup = {}) {
  OwnDriver driver(RasterFault::none, setup);
  return std::get<Pixels>(driver.draw(call));
}

Judgement judged(const DrawCall& call, const Pixels& pixels, const OwnDriverSetup& setup = {}) {
  return judge_pixels(call, pixels, OwnDriver(RasterFault::none, setup).info());
}

float& value(Pixels& pixels, Quantity quantity, int x, int y, std::size_t channel = 0) {
  const auto pixel = static_cast<std::size_t>(y * pixels.width + x);
  return pixels.values[bit(quantity)][pixel * channels(quantity) + channel];
}

// The only violation of the altered pixels.
Violation only(const Judgement& judgement) {
  REQUIRE(judgement.violations.size() == 1);
  return judgement.violations[0];
}

TEST_CASE("judgement: what is right has no violation, and its errors are counted", "[pixels]") {
  const DrawCall call = square();
  const Judgement judgement = judged(call, drawn(call));
  CHECK(judgement.violations.empty());
  CHECK(judgement.apart.empty());
  // The two pixels on the diagonal are open to both triangles, and so are their values.
  CHECK(judgement.undecided == 2);
  CHECK(judgement.errors[bit(Quantity::smooth)].count() == 2 * 4);
  CHECK(judgement.errors[bit(Quantity::smooth)].greatest == 0);
  CHECK(judgement.pixels == 62);
}

TEST_CASE("judgement: a line that OpenGL ES divides by 0 accuses nobody, one in OpenGL does",
          "[pixels]") {
  DrawCall call = call_of(Topology::lines, {vertex_at(0, 0, 0, 1), vertex_at(0, 1, 0, 0)}, 16);
  const auto judged_as = [&](GraphicsApi api) {
    Pixels nothing = drawn(call);
    for (auto& values : nothing.values) std::fill(values.begin(), values.end(), 0.0f);
    DriverInfo info = OwnDriver().info();
    info.api = api;
    return judge_pixels(call, nothing, info);
  };
  CHECK(judged_as(GraphicsApi::webgl).apart == "a line that is divided by 0");
  const Judgement in_opengl = judged_as(GraphicsApi::opengl);
  CHECK(in_opengl.apart.empty());
  CHECK(!in_opengl.violations.empty());
  call.vertices[1].position[2] = 1;  // near and far cut it off before
  CHECK(judged_as(GraphicsApi::webgl).apart.empty());
  CHECK(!judged_as(GraphicsApi::webgl).violations.empty());
}

TEST_CASE("clause: what OpenGL ES has by an extension alone is that one's", "[pixels]") {
  const auto document = [](GraphicsApi api, Quantity quantity) {
    return clause_of(api, Topology::triangles, ViolationKind::not_finite, quantity).document;
  };
  CHECK(document(GraphicsApi::webgl, Quantity::noperspective) ==
        "NV_shader_noperspective_interpolation");
  CHECK(document(GraphicsApi::webgl, Quantity::smooth) == "OpenGL ES 3.2");
  CHECK(document(GraphicsApi::opengl, Quantity::noperspective) == "OpenGL 4.6 core");
}

TEST_CASE("judgement: one wrong number is found at its pixel and channel", "[pixels]") {
  struct Change {
    Quantity quantity;
    std::size_t channel;
    float number;
    ViolationKind kind;
  };
  const auto [quantity, channel, number, kind] =
      GENERATE(Change{Quantity::smooth, 2, std::numeric_limits<float>::quiet_NaN(),
                      ViolationKind::not_finite},
               Change{Quantity::smooth, 3, 3.01f, ViolationKind::outside_hull},
               Change{Quantity::noperspective, 0, -1, ViolationKind::outside_hull},
               Change{Quantity::flat, 1, std::nextafter(1.0f, 2.0f), ViolationKind::flat_value},
               Change{Quantity::frag_coord, 1, 3, ViolationKind::wrong_value},
               Change{Quantity::frag_coord, 3, 0, ViolationKind::outside_hull},
               Change{Quantity::facing, 0, -1, ViolationKind::facing},
               Change{Quantity::primitive_id, 0, 1, ViolationKind::primitive_id},
               Change{Quantity::depth, 0, 0.51f, ViolationKind::outside_hull});
  const DrawCall call = square();
  Pixels pixels = drawn(call);
  value(pixels, quantity, 3, 3, channel) = number;
  const Violation violation = only(judged(call, pixels));
  CHECK(violation.primitive == 0);
  CHECK(violation.quantity == quantity);
  CHECK(violation.kind == kind);
  CHECK(violation.pixels == 1);
  CHECK(violation.worst.x == 3);
  CHECK(violation.worst.y == 3);
  CHECK(violation.worst.channel == channel);
}

TEST_CASE("judgement: a pixel too many and one too few", "[pixels]") {
  const DrawCall call = square();
  Pixels pixels = drawn(call);
  value(pixels, Quantity::hits, 7, 7) = 1;
  CHECK(only(judged(call, pixels)).kind == ViolationKind::extra);
  pixels = drawn(call);
  value(pixels, Quantity::hits, 3, 3) = 0;
  // It is the first triangle's only pixel that is covered for certain.
  CHECK(only(judged(call, pixels)).kind == ViolationKind::primitive_lost);
  pixels = drawn(call);
  value(pixels, Quantity::hits, 3, 4) = 2;  // on the diagonal
  CHECK(only(judged(call, pixels)).kind == ViolationKind::shared_edge);
  value(pixels, Quantity::hits, 3, 4) = 0;
  CHECK(only(judged(call, pixels)).kind == ViolationKind::shared_edge);
}

// A left side 1/32 px off the pixels' centres: within 4 sub-pixel bits, beyond 8.
TEST_CASE("judgement: the margin is the driver's own sub-pixel bits", "[pixels]") {
  DrawCall call = call_of(
      Topology::triangles,
      {vertex_at(-0.3828125f, -1, 0, 1), vertex_at(-0.3828125f, 1, 0, 1), vertex_at(1, 0, 0, 1)},
      8);
  Pixels pixels = drawn(call);
  REQUIRE(value(pixels, Quantity::hits, 2, 4) == 1);
  value(pixels, Quantity::hits, 2, 4) = 0;
  CHECK(only(judged(call, pixels)).kind == ViolationKind::missing);
  CHECK(judged(call, pixels, {GraphicsApi::opengl, 4}).violations.empty());
}

TEST_CASE("judgement: OpenGL ES interpolates flat values, others copy them", "[pixels]") {
  const DrawCall call = square();
  Pixels pixels = drawn(call);
  value(pixels, Quantity::flat, 3, 3, 1) = std::nextafter(1.0f, 2.0f);
  CHECK(judged(call, pixels, {GraphicsApi::webgl, 8}).violations.empty());
  CHECK(judged(call, pixels, {GraphicsApi::vulkan, 8}).violations.size() == 1);
}

TEST_CASE("judgement: of a point beside the volume Vulkan says it, OpenGL leaves it open",
          "[pixels]") {
  DrawCall call = call_of(Topology::points, {vertex_at(1.25f, 0, 0, 1)}, 8);
  call.point_size = 4;
  const Pixels pixels = drawn(call);
  CHECK(judged(call, pixels).violations.empty());
  CHECK(only(judged(call, pixels, {GraphicsApi::vulkan, 8})).kind == ViolationKind::extra);
}

TEST_CASE("judgement: numbers that nothing is promised of are apart", "[pixels]") {
  const auto apart = [](float x, float w) {
    DrawCall call = square();
    call.vertices[3].position[0] = x;
    call.vertices[3].position[3] = w;
    return judged(call, drawn(square())).apart;
  };
  CHECK(apart(0.25f, 1).empty());
  CHECK(apart(0x1p33f, 1) == "numbers beyond 2^32");
  CHECK(apart(0x1p-130f, 1) == "numbers below the normal range");
  CHECK(apart(0.25f, 0x1p-33f) == "divided by w, numbers beyond 2^32");
}

TEST_CASE("judgement: bins of errors in ulp", "[pixels]") {
  UlpErrors errors;
  for (const double ulps : {0.0, 0.5, 0.500001, 1.0, 1.5, 2.0, 1e300}) errors.add(ulps, {});
  CHECK(errors.bins[0] == 2);
  CHECK(errors.bins[1] == 2);
  CHECK(errors.bins[2] == 2);
  CHECK(errors.bins.back() == 1);
  CHECK(errors.greatest == 1e300);
  CHECK(errors.quantile(0.5) == 1);
}

TEST_CASE("clauses: each kind of violation has a sentence in each document", "[pixels]") {
  for (const auto api : {GraphicsApi::opengl, GraphicsApi::vulkan, GraphicsApi::webgl}) {
    for (std::size_t kind = 0; kind < names_of(ViolationKind{}).size(); ++kind) {
      for (std::size_t topology = 0; topology < names_of(Topology{}).size(); ++topology) {
        const Clause clause = clause_of(api, static_cast<Topology>(topology),
                                        static_cast<ViolationKind>(kind), Quantity::covered);
        CHECK_FALSE(clause.document.empty());
        CHECK_FALSE(clause.section.empty());
        CHECK(clause.meaning.ends_with('.'));
      }
    }
  }
  const Clause edge = clause_of(GraphicsApi::webgl, Topology::triangles, ViolationKind::shared_edge,
                                Quantity::hits);
  CHECK(edge.document == "OpenGL ES 3.2");
  CHECK(edge.section == "13.7.1");
  const Clause point =
      clause_of(GraphicsApi::vulkan, Topology::points, ViolationKind::extra, Quantity::covered);
  CHECK(point.section.starts_with("Primitive Clipping"));
}

}  // namespace
}  // namespace clipscope::experiments
