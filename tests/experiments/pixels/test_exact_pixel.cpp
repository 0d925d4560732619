// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/pixels/exact_pixel.hpp"
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/pixels/draw_calls.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;
using Point = std::array<Rational, 2>;

constexpr std::array<std::uint32_t, 3> kTriangle = {0, 1, 2};

// The exact polygon of a draw call's triangle. What is linear in clip space is an attribute: after
// the clip distances the varying's first value, and that times w.
struct Polygon {
  std::vector<Point> ndc;
  // By vertex: z, 1/w, a/w and (a w)/w: linear in the window.
  std::vector<std::array<Rational, 4>> linear;
};

Polygon polygon_of(const DrawCall& call) {
  const auto first = static_cast<std::size_t>(call.volume.clip_distances);
  std::vector<reference::InputVertex> input(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const DrawVertex& v = call.vertices[i];
    std::copy(v.position.begin(), v.position.end(), input[i].position.begin());
    for (std::size_t c = 0; c < first; ++c) input[i].attributes[c] = v.clip_distances[c];
    input[i].attributes[first] = v.varying[0];
    input[i].attributes[first + 1] = static_cast<double>(v.varying[0]) * v.position[3];
  }
  const auto exact =
      reference::clip(reference::Truth::of_clip(call.volume), input, static_cast<int>(first) + 2);
  Polygon polygon;
  for (const reference::ExactVertex& vertex : exact.vertices) {
    const reference::RationalVertex v = reference::vertex_set({exact.verdict, {vertex}})[0];
    polygon.ndc.push_back({v.x, v.y});
    polygon.linear.push_back(
        {v.z, v.inv_w, v.attributes[first] * v.inv_w, v.attributes[first + 1] * v.inv_w});
  }
  return polygon;
}

Rational area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

Point centre(const DrawCall& call, int x, int y) {
  const Viewport& port = call.viewport;
  return {Rational(2 * (x - port.x) + 1) / port.width - 1,
          Rational(2 * (y - port.y) + 1) / port.height - 1};
}

bool contains(const Polygon& polygon, const Point& p) {
  bool has_left = false, has_right = false;
  for (std::size_t i = 0; i < polygon.ndc.size(); ++i) {
    const int side = sgn(area(polygon.ndc[i], polygon.ndc[(i + 1) % polygon.ndc.size()], p));
    has_left = has_left || side > 0;
    has_right = has_right || side < 0;
  }
  return !(has_left && has_right);
}

// The plane through three vertices that are not on a line, at p.
std::array<Rational, 4> interpolated(const Polygon& polygon, const Point& p) {
  for (std::size_t i = 1; i + 1 < polygon.ndc.size(); ++i) {
    const Point &a = polygon.ndc[0], &b = polygon.ndc[i], &c = polygon.ndc[i + 1];
    const Rational whole = area(a, b, c);
    if (whole == 0) continue;
    std::array<Rational, 4> r;
    for (std::size_t k = 0; k < r.size(); ++k) {
      r[k] = (area(p, b, c) * polygon.linear[0][k] + area(p, c, a) * polygon.linear[i][k] +
              area(p, a, b) * polygon.linear[i + 1][k]) /
             whole;
    }
    return r;
  }
  return {};
}

bool has_area(const Polygon& polygon) {
  for (std::size_t i = 1; i + 1 < polygon.ndc.size(); ++i) {
    if (area(polygon.ndc[0], polygon.ndc[i], polygon.ndc[i + 1]) != 0) return true;
  }
  return false;
}

// Coverage of all pixels, and the values of those that are covered. Returns how many those are.
int check_against_reference(const DrawCall& call) {
  const ExactPrimitive primitive(call, kTriangle);
  const Polygon polygon = polygon_of(call);
  if (primitive.orientation() == 0) {
    CHECK_FALSE(has_area(polygon));
    return 0;
  }
  std::array<Interpolant, 4> exact;  // smooth, noperspective, z/w, 1/w
  for (std::size_t i = 0; i < 3; ++i) {
    const DrawVertex& v = call.vertices[i];
    exact[0].of_vertices[i] = v.varying[0];
    exact[1].of_vertices[i] = static_cast<double>(v.varying[0]) * v.position[3];
    exact[2].of_vertices[i] = v.position[2];
    exact[3].of_vertices[i] = 1;
  }
  exact[0].is_perspective = true;
  int covered = 0;
  for (int y = 0; y < call.height; ++y) {
    for (int x = 0; x < call.width; ++x) {
      const bool is_covered = covers(call, kTriangle, primitive, x, y);
      // A polygon that touches nothing but a line has no inside to compare.
      if (has_area(polygon)) CHECK(is_covered == contains(polygon, centre(call, x, y)));
      if (!is_covered || !has_area(polygon)) continue;
      ++covered;
      const auto [z, inv_w, smooth_w, straight] = interpolated(polygon, centre(call, x, y));
      CHECK(primitive.value(exact[0], x, y) == smooth_w / inv_w);
      CHECK(primitive.value(exact[1], x, y) == straight);
      CHECK(primitive.value(exact[2], x, y) == z);
      CHECK(primitive.value(exact[3], x, y) == inv_w);
      const PixelWeights at = primitive.weights(x, y);
      for (const Interpolant& each : exact) {
        const Enclosed filtered = enclosed(each, at);
        const Rational error = primitive.value(each, x, y) - Rational(filtered.value);
        CHECK(abs(error) <= Rational(filtered.bound));
      }
    }
  }
  return covered;
}

DrawCall call_of_case(const HardCase& hard_case) {
  const reference::Truth truth = truth_of(hard_case);
  std::vector<DrawVertex> vertices;
  for (const reference::InputVertex& given : hard_case.vertices) {
    DrawVertex v;
    const auto exact = truth.clip_position(given);
    for (std::size_t c = 0; c < 4; ++c) v.position[c] = reference::round_to<float>(exact[c]);
    for (std::size_t c = 0; c < 8; ++c) {
      v.clip_distances[c] = static_cast<float>(given.attributes[c]);
    }
    v.varying[0] = static_cast<float>(given.attributes[0]);
    vertices.push_back(v);
  }
  DrawCall call = call_of(Topology::triangles, std::move(vertices), 6);
  call.volume = hard_case.volume;
  call.volume.open_sides = {};
  return call;
}

TEST_CASE("exact pixel: equal to the exact polygon on the whole catalogue", "[pixels]") {
  int cases = 0, covered = 0;
  for (const HardCase& hard_case : builtin_catalogue()) {
    const bool is_drawn = hard_case.primitive == Primitive::triangle &&
                          hard_case.volume.depth != DepthRange::reversed &&
                          hard_case.volume.depth_clamp.near == hard_case.volume.depth_clamp.far;
    if (!is_drawn) continue;
    INFO(hard_case.name);
    covered += check_against_reference(call_of_case(hard_case));
    ++cases;
  }
  CHECK(cases > 150);
  CHECK(covered > 1000);
}

TEST_CASE("exact pixel: equal to the exact polygon on draw calls of any size", "[pixels]") {
  using Maker = DrawCall (*)(std::mt19937&);
  const Maker maker =
      GENERATE(Maker{lattice_call}, Maker{far_call}, Maker{scaled_call}, Maker{random_call});
  std::mt19937 random(3);
  int covered = 0;
  for (int i = 0; i < 400; ++i) {
    DrawCall call = maker(random);
    call.topology = Topology::triangles;
    call.width = call.height = 5;
    call.viewport = {call.viewport.x / 4, call.viewport.y / 4, 7, 6};
    covered += check_against_reference(call);
  }
  CHECK(covered > 200);
}

// Of (0,0,.5,1) (4,0,.5,1) (0,4,1,2), drawn on 4 x 4: pixel (2, 3) has its centre at x_ndc = 1/4
// and y_ndc = 3/4. There 1 = l0 + l1 + 2 l2 (w), 1/4 = 4 l1, 3/4 = 4 l2, so l = (9/16, 1/16, 3/16).
TEST_CASE("exact pixel: the values of a triangle found by hand", "[pixels]") {
  DrawCall call = call_of(
      Topology::triangles,
      {vertex_at(0, 0, 0.5f, 1, 0), vertex_at(4, 0, 0.5f, 1, 1), vertex_at(0, 4, 1, 2, 4)}, 4);
  const ExactPrimitive primitive(call, kTriangle);
  CHECK(primitive.orientation() == 1);
  const Interpolant smooth{{0, 1, 4}, true}, straight{{0, 1, 8}, false}, inv_w{{1, 1, 1}, false};
  CHECK(primitive.value(smooth, 2, 3) == 1);
  CHECK(primitive.value(straight, 2, 3) == Rational(25, 16));
  CHECK(primitive.value(inv_w, 2, 3) == Rational(13, 16));
}

// From (-1, 0) at w = 1 to (1, 0) at w = 2, 4 x 4: pixel (2, 0) projects to x_ndc = 1/4. In the
// window the ends are at -1 and 1/2, so that t = 5/6.
TEST_CASE("exact pixel: the values of a line found by hand", "[pixels]") {
  DrawCall call =
      call_of(Topology::lines, {vertex_at(-1, 0, 0, 1, 0), vertex_at(1, 0, 0, 2, 1)}, 4);
  const std::array<std::uint32_t, 2> line = {0, 1};
  const ExactPrimitive primitive(call, line);
  const Interpolant smooth{{0, 1}, true}, straight{{0, 2}, false}, inv_w{{1, 1}, false};
  CHECK(primitive.value(straight, 2, 0) == Rational(5, 6));
  CHECK(primitive.value(inv_w, 2, 0) == Rational(1, 6) + Rational(5, 12));
  CHECK(primitive.value(smooth, 2, 0) == Rational(5, 7));
}

}  // namespace
}  // namespace clipscope::experiments
