// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <sstream>

#include "experiments/pixels/judgement.hpp"
#include "experiments/pixels/own_driver.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/pixels/draw_calls.hpp"

namespace clipscope::experiments {
namespace {

Judgement judged_by(const DrawCall& call, OwnDriver& driver) {
  const Drawn drawn = driver.draw(call);
  return judge_pixels(call, std::get<Pixels>(drawn), driver.info());
}

std::string told(const DrawCall& call, const Judgement& judgement) {
  std::ostringstream text;
  text.precision(9);
  text << names_of(Topology{})[static_cast<std::size_t>(call.topology)] << " viewport "
       << call.viewport.x << ' ' << call.viewport.y << ' ' << call.viewport.width << ' '
       << call.viewport.height << " depth " << static_cast<int>(call.volume.depth) << " clamp "
       << static_cast<bool>(call.volume.depth_clamp) << " distances " << call.volume.clip_distances
       << " size " << call.point_size << '\n';
  for (const DrawVertex& v : call.vertices) {
    for (const float c : v.position) text << c << ' ';
    text << "| ";
    for (const float c : v.varying) text << c << ' ';
    text << "| ";
    for (int c = 0; c < call.volume.clip_distances; ++c) {
      text << v.clip_distances[static_cast<std::size_t>(c)] << ' ';
    }
    text << '\n';
  }
  for (const Violation& v : judgement.violations) {
    text << "primitive " << v.primitive << ' '
         << names_of(Quantity{})[static_cast<std::size_t>(v.quantity)] << ' '
         << names_of(ViolationKind{})[static_cast<std::size_t>(v.kind)] << " pixels " << v.pixels
         << " at " << v.worst.x << ' ' << v.worst.y << " channel " << v.worst.channel << " exact "
         << v.worst.exact << " returned " << v.worst.returned << " size " << v.size << '\n';
  }
  return text.str();
}

using Maker = DrawCall (*)(std::mt19937&);

void check_clean(Maker maker, int calls, const OwnDriverSetup& setup) {
  OwnDriver driver(RasterFault::none, setup);
  std::mt19937 random(1);
  std::uint64_t pixels = 0;
  for (int i = 0; i < calls; ++i) {
    const DrawCall call = maker(random);
    const Judgement judgement = judged_by(call, driver);
    INFO(told(call, judgement));
    CHECK(judgement.violations.empty());
    pixels += judgement.pixels;
  }
  CHECK(pixels > static_cast<std::uint64_t>(calls) * 500);
}

TEST_CASE("own driver: a right rasteriser is accused of nothing", "[pixels]") {
  const GraphicsApi api = GENERATE(GraphicsApi::opengl, GraphicsApi::vulkan);
  const int bits = GENERATE(8, 4, 0);
  const OwnDriverSetup setup{api, bits};
  check_clean(lattice_call, 2000, setup);
  check_clean(random_call, 1000, setup);
  check_clean(far_call, 1000, setup);
  check_clean(scaled_call, 1000, setup);
}

// What a fault is shown by: few draw calls, and what the judge has to say of them.
struct FaultCase {
  RasterFault fault;
  ViolationKind kind;
  Quantity quantity;
  DrawCall call;
};

// All inside of the volume, w from 1 to 2.
std::vector<DrawVertex> inside_triangle() {
  return {vertex_at(-0.75f, -0.75f, 0.25f, 1, 0), vertex_at(1.5f, -1.25f, 0.5f, 2, 1),
          vertex_at(-0.5f, 0.75f, 0.75f, 1, 4)};
}

// One corner before the near plane, none behind the eye.
std::vector<DrawVertex> near_triangle() {
  return {vertex_at(-0.5f, -0.5f, 0, 1, 0), vertex_at(0.5f, -0.5f, 0, 1, 1),
          vertex_at(0, 1, -3, 2, 4)};
}

// One corner behind the eye.
std::vector<DrawVertex> behind_triangle() {
  return {vertex_at(-0.5f, -0.5f, 0, 1, 0), vertex_at(0.5f, -0.5f, 0, 1, 1),
          vertex_at(0, 1.5f, -3, -1, 4)};
}

// One depth beyond each plane.
DrawCall clamped_call() {
  DrawCall call = call_of(Topology::triangles, {vertex_at(-1, -1, -2, 1), vertex_at(1, -1, 2, 1),
                                                vertex_at(0, 1, 3, 1)});
  call.volume.depth_clamp = true;
  return call;
}

DrawCall clip_distance_call() {
  DrawCall call = call_of(Topology::triangles, inside_triangle());
  call.volume.clip_distances = 2;
  for (DrawVertex& v : call.vertices) v.clip_distances = {1, v.position[0]};
  return call;
}

DrawCall triangle_call(std::vector<DrawVertex> vertices, int size = 32) {
  return call_of(Topology::triangles, std::move(vertices), size);
}

// Two triangles of a square whose diagonal goes through centres of pixels.
DrawCall square_call() {
  DrawCall call = call_of(Topology::triangle_strip,
                          {vertex_at(-0.5f, -0.5f, 0, 1, 0), vertex_at(0.5f, -0.5f, 0, 1, 1),
                           vertex_at(-0.5f, 0.5f, 0, 1, 2), vertex_at(0.5f, 0.5f, 0, 1, 3)});
  return call;
}

// A line from the lower left.
DrawCall line_call(const DrawVertex& end) {
  return call_of(Topology::lines, {vertex_at(-0.8f, -0.7f, 0, 1), end});
}

DrawCall point_call() {
  DrawCall call = call_of(Topology::points, {vertex_at(0, -0.4f, 0, 1)});
  call.point_size = 5;
  return call;
}

std::vector<FaultCase> fault_cases() {
  using F = RasterFault;
  using K = ViolationKind;
  using Q = Quantity;
  const std::vector<DrawVertex> collinear = {
      vertex_at(-0.5f, -0.5f, 0, 1), vertex_at(0, 0, 0, 1, 1), vertex_at(0.5f, 0.5f, 0, 1, 2)};
  const std::vector<DrawVertex> far = {vertex_at(-1, -1, 0, 1), vertex_at(100, -1, 0, 1, 1),
                                       vertex_at(-1, 100, 0, 1, 2)};
  const std::vector<DrawVertex> farther = {vertex_at(-1, -1, 0, 1), vertex_at(1000, -1, 0, 1, 1),
                                           vertex_at(-1, 1000, 0, 1, 2)};
  const std::vector<DrawVertex> off_grid = {vertex_at(-0.99f, -0.97f, 0, 1),
                                            vertex_at(0.97f, -0.93f, 0, 1, 1),
                                            vertex_at(-0.91f, 0.94f, 0, 1, 2)};
  return {
      {F::noperspective_nan, K::not_finite, Q::noperspective, triangle_call(near_triangle())},
      {F::smooth_affine, K::wrong_value, Q::smooth, triangle_call(inside_triangle())},
      {F::row_missing, K::missing, Q::covered, triangle_call(inside_triangle())},
      {F::near_unclipped, K::extra, Q::covered, triangle_call(behind_triangle())},
      {F::far_vertex_dropped, K::primitive_lost, Q::covered, triangle_call(far)},
      {F::edges_drawn_twice, K::shared_edge, Q::hits, square_call()},
      {F::edges_never_drawn, K::shared_edge, Q::hits, square_call()},
      {F::flat_of_other_vertex, K::flat_value, Q::flat, triangle_call(inside_triangle())},
      {F::facing_of_clipped, K::facing, Q::facing, triangle_call(near_triangle())},
      {F::facing_of_clipped, K::facing, Q::hits, triangle_call(near_triangle())},
      {F::w_not_reciprocal, K::outside_hull, Q::frag_coord, triangle_call(inside_triangle())},
      {F::depth_unclamped, K::outside_hull, Q::depth, clamped_call()},
      {F::clip_distance_ignored, K::extra, Q::covered, clip_distance_call()},
      {F::absolute_w, K::extra, Q::covered, triangle_call(behind_triangle())},
      {F::guard_band_wraps, K::primitive_lost, Q::covered, triangle_call(farther)},
      {F::fewer_bits, K::missing, Q::covered, triangle_call(off_grid)},
      {F::primitive_id_off, K::primitive_id, Q::primitive_id, square_call()},
      {F::zero_area_drawn, K::zero_area, Q::covered, triangle_call(collinear)},
      {F::near_unclipped, K::extra, Q::covered, line_call(vertex_at(1, 1, -3, 2))},
      {F::far_vertex_dropped, K::primitive_lost, Q::covered, line_call(vertex_at(100, 90, 0, 1))},
      {F::absolute_w, K::extra, Q::covered, line_call(vertex_at(1, 1, -3, -1))},
      {F::smooth_affine, K::wrong_value, Q::smooth, line_call(vertex_at(7, 7, 0, 8, 4))},
      {F::row_missing, K::missing, Q::covered, point_call()},
      {F::flat_of_other_vertex, K::flat_value, Q::flat, line_call(vertex_at(1, 1, 0, 1, 4))},
      {F::extrapolated, K::outside_hull, Q::smooth, triangle_call(inside_triangle())},
  };
}

bool has(const Judgement& judgement, ViolationKind kind, Quantity quantity) {
  return std::any_of(judgement.violations.begin(), judgement.violations.end(),
                     [&](const Violation& v) { return v.kind == kind && v.quantity == quantity; });
}

TEST_CASE("own driver: each seeded fault is found, and is not there without it", "[pixels]") {
  std::set<RasterFault> shown;
  for (const FaultCase& given : fault_cases()) {
    OwnDriver right, wrong(given.fault);
    const Judgement clean = judged_by(given.call, right), found = judged_by(given.call, wrong);
    INFO(wrong.info().version << '\n' << told(given.call, clean) << told(given.call, found));
    CHECK(clean.violations.empty());
    CHECK(has(found, given.kind, given.quantity));
    shown.insert(given.fault);
  }
  CHECK(shown.size() + 1 == names_of(RasterFault{}).size());
}

}  // namespace
}  // namespace clipscope::experiments
