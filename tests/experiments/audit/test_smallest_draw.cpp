// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "experiments/audit/draw_simpler.hpp"
#include "experiments/audit/smallest_draw.hpp"
#include "experiments/pixels/judgement.hpp"
#include "experiments/pixels/own_driver.hpp"
#include "experiments/workloads/lattice_draws.hpp"
#include "experiments/workloads/plain_call.hpp"
#include "experiments/workloads/random_draws.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/workloads/drivers.hpp"

namespace clipscope::experiments {
namespace {

using Predicate = std::function<bool(const DrawCall&)>;

// Some triangle has a vertex behind the eye and one in front of it, and noperspective values are
// asked for.
bool crosses_the_eye_plane(const DrawCall& call) {
  if (!call.quantities[bit(Quantity::noperspective)]) return false;
  return std::ranges::any_of(primitives_of(call), [&](const std::vector<std::uint32_t>& p) {
    const auto w = [&](std::uint32_t v) { return call.vertices[v].position[3]; };
    return p.size() == 3 && std::ranges::any_of(p, [&](auto v) { return w(v) < 0; }) &&
           std::ranges::any_of(p, [&](auto v) { return w(v) > 0; });
  });
}

// A driver wrong for vertices far from the volume, in a viewport that reaches beyond the target.
bool is_far_in_a_large_viewport(const DrawCall& call) {
  return call.viewport.width >= 1000 && std::ranges::any_of(call.vertices, [](const DrawVertex& v) {
           const float w = v.position[3];
           return w != 0 && std::abs(v.position[0]) > 100 * std::abs(w);
         });
}

DrawCall random_mesh(RandomKind kind) {
  for (std::size_t i = 0;; ++i) {
    DrawCall call = random_draw(1, i, able_driver());
    if (random_kind(i) == kind && crosses_the_eye_plane(call)) return call;
  }
}

}  // namespace

TEST_CASE("smallest draw: of a mesh one triangle remains, of small whole numbers") {
  const DrawCall smallest =
      smallest_draw(random_mesh(RandomKind::grid_mesh), crosses_the_eye_plane);
  CHECK(crosses_the_eye_plane(smallest));
  CHECK(primitives_of(smallest).size() == 1);
  CHECK(smallest.vertices.size() == 3);
  CHECK(smallest.indices.empty());
  CHECK(smallest.quantities == Quantities().set(bit(Quantity::noperspective)));
  CHECK(smallest.width == 4);
  CHECK(smallest.viewport == Viewport{0, 0, 4, 4});
  for (const DrawVertex& v : smallest.vertices) {
    for (const float x : v.position) CHECK((x == 0 || std::abs(x) == 1));
    CHECK(v.varying == std::array<float, 4>{});
  }
}

TEST_CASE("smallest draw: a strip becomes triangles") {
  const DrawCall smallest =
      smallest_draw(random_mesh(RandomKind::strip_mesh), crosses_the_eye_plane);
  CHECK(smallest.topology == Topology::triangles);
  CHECK(smallest.vertices.size() == 3);
}

TEST_CASE("smallest draw: what fails at a common edge keeps two triangles") {
  const auto shares_an_edge = [](const DrawCall& call) {
    const auto primitives = primitives_of(call);
    return primitives.size() >= 2 && !call.indices.empty();
  };
  const DrawCall smallest = smallest_draw(random_mesh(RandomKind::grid_mesh), shares_an_edge);
  CHECK(primitives_of(smallest).size() == 2);
  CHECK(smallest.indices.size() == 6);
}

TEST_CASE("smallest draw: a viewport is kept where the failure needs it, no larger than that") {
  DrawCall call = plain_call(
      "far", Topology::triangles,
      std::vector<std::array<float, 4>>{{5000, 1, 0, 1}, {-1, 0.3f, 0.1f, 1}, {0, 1, 0.7f, 3.3f}},
      able_driver());
  call.viewport = {-4080, -4080, 8192, 8192};
  const DrawCall smallest = smallest_draw(call, is_far_in_a_large_viewport);
  CHECK(smallest.viewport.width == 1024);
  CHECK(smallest.quantities.none());
  CHECK(smallest.vertices[0].position[0] == 128);
}

TEST_CASE("smallest draw: is itself when it is shrunk again, and the same each time") {
  for (const std::size_t number : {3u, 40u, 77u, 301u}) {
    const DrawCall call = lattice_draw(1, number, able_driver());
    const double x = call.vertices[0].position[0];
    const Predicate fails = [x](const DrawCall& c) {
      return (c.vertices[0].position[0] < 0) == (x < 0) && c.vertices[0].varying[3] != 0;
    };
    const DrawCall smallest = smallest_draw(call, fails);
    CHECK(cost_of(smallest) < cost_of(call));
    CHECK(smallest == smallest_draw(call, fails));
    CHECK(smallest == smallest_draw(smallest, fails));
  }
}

TEST_CASE("smallest draw: what does not fail stays as it is") {
  const DrawCall call = lattice_draw(1, 5, able_driver());
  CHECK(smallest_draw(call, [](const DrawCall&) { return false; }) == call);
}

TEST_CASE("smallest draw: no more is asked than the limits say") {
  std::size_t asked = 0;
  const Predicate counts = [&](const DrawCall& call) {
    ++asked;
    return crosses_the_eye_plane(call);
  };
  smallest_draw(random_mesh(RandomKind::grid_mesh), counts, {.asked = 20});
  CHECK(asked == 21);  // and the call itself
}

TEST_CASE("smallest draw: of a rasteriser with a fault it still shows that fault, and no more") {
  OwnDriver faulty(RasterFault::noperspective_nan), right;
  const auto is_not_finite = [](Driver& driver, const DrawCall& call) {
    const Judgement judgement =
        judge_pixels(call, std::get<Pixels>(driver.draw(call)), driver.info());
    return judgement.apart.empty() &&
           std::ranges::any_of(judgement.violations, [](const Violation& v) {
             return v.kind == ViolationKind::not_finite;
           });
  };
  std::size_t number = 0;
  while (lattice_stratum(number).primitive != 3 ||
         !is_not_finite(faulty, lattice_draw(1, number, faulty.info()))) {
    ++number;
  }
  const DrawCall smallest =
      smallest_draw(lattice_draw(1, number, faulty.info()),
                    [&](const DrawCall& call) { return is_not_finite(faulty, call); });
  CHECK(is_not_finite(faulty, smallest));
  CHECK_FALSE(is_not_finite(right, smallest));
  CHECK(smallest.vertices.size() == 3);
  CHECK(smallest.width <= 8);
  CHECK(smallest.quantities == Quantities().set(bit(Quantity::noperspective)));
}

TEST_CASE("draw simpler: a triangle out of a strip keeps its winding and its provoking vertex") {
  DrawCall strip = plain_call(
      "strip", Topology::triangle_strip,
      std::vector<std::array<float, 4>>{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1}},
      able_driver());
  for (const ProvokingVertex provoking : {ProvokingVertex::first, ProvokingVertex::last}) {
    strip.provoking = provoking;
    const std::vector<std::size_t> second = {1};
    const DrawCall list = with_primitives(strip, second);
    CHECK(list.topology == Topology::triangles);
    CHECK(list.indices.empty());
    const DrawVertex& provoking_one = list.vertices[provoking_vertex(list, 0)];
    CHECK(provoking_one == strip.vertices[provoking_vertex(strip, 1)]);
    // 2 1 3, from any of them on.
    const auto place = std::ranges::find(list.vertices, strip.vertices[2]);
    const auto after = place + 1 == list.vertices.end() ? list.vertices.begin() : place + 1;
    CHECK(*after == strip.vertices[1]);
  }
}

TEST_CASE("draw simpler: the numbers of a call are those of its case and back") {
  for (std::size_t number = 0; number < 100; ++number) {
    const DrawCall call = lattice_draw(1, number, able_driver());
    CHECK(with_numbers(call, numbers_of(call)) == call);
  }
}

}  // namespace clipscope::experiments
