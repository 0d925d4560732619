// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/builtin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/mesh_bits.hpp"
#include "tests/experiments/scenes/messages.hpp"

namespace clipscope::experiments {
namespace {

using Corners = std::array<std::array<float, 3>, 3>;

// 4:3 at near 0.5; every number a short binary fraction.
Frustum<float> off_centre() {
  Frustum<float> f;
  f.left = -0.5f, f.right = 0.75f, f.bottom = -0.375f, f.top = 0.5f;
  f.near = 0.5f, f.far = 256;
  return f;
}

Frustum<float> parallel() {
  Frustum<float> f;
  f.kind = ProjectionKind::parallel;
  f.left = -4, f.right = 4, f.bottom = -3, f.top = 3, f.near = -2, f.far = 20;
  f.shear_x = 0.25f;
  return f;
}

Corners corners_of(const Mesh& mesh, std::size_t i) {
  const auto& t = mesh.triangles[i];
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

// Which planes a point is outside of, from its slopes x / depth and y / depth: perspective, w > 0.
std::array<bool, 6> outside_of(const Frustum<float>& f, const std::array<float, 3>& p) {
  const double depth = -double{p[2]};
  const double x = p[0] / depth * f.near, y = p[1] / depth * f.near;
  return {x<f.left, x> f.right, y<f.bottom, y> f.top, depth<f.near, depth> f.far};
}

constexpr std::array kClasses = {SoupClass::inside,         SoupClass::outside,
                                 SoupClass::straddling,     SoupClass::crossing_w0,
                                 SoupClass::several_planes, SoupClass::several_planes_behind};

// A triangle may be of two classes.
std::map<SoupClass, int> count_classes(const Mesh& mesh, const Frustum<float>& frustum) {
  std::map<SoupClass, int> counts;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const SoupClass kind : kClasses) {
      counts[kind] += is_of_class(kind, frustum, corners_of(mesh, i));
    }
  }
  return counts;
}

TEST_CASE("soup: the shares are exact, largest remainders first") {
  const SoupShares shares{.inside = 60, .outside = 35, .straddling = 5, .crossing_w0 = 1};
  const Frustum<float> frustum = off_centre();
  auto counts = count_classes(make_soup(shares, 1000, 3, frustum), frustum);
  // 594.06, 346.53, 49.50 and 9.90 of 1000.
  CHECK(counts[SoupClass::inside] == 594);
  CHECK(counts[SoupClass::outside] == 347);
  CHECK(counts[SoupClass::straddling] == 49);
  CHECK(counts[SoupClass::crossing_w0] == 10);
}

TEST_CASE("soup: inside triangles have every vertex inside") {
  const Frustum<float> frustum = off_centre();
  for (const auto& p : make_soup({.inside = 1}, 500, 1, frustum).positions) {
    CHECK(outside_of(frustum, p) == std::array<bool, 6>{});
  }
}

TEST_CASE("soup: straddling triangles have vertices inside and outside, all in front of the eye") {
  const Frustum<float> frustum = off_centre();
  const Mesh mesh = make_soup({.straddling = 1}, 500, 1, frustum);
  int many = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    int inside = 0;
    std::array<bool, 6> crossed = {};
    for (const auto& p : corners_of(mesh, i)) {
      CHECK(p[2] < 0);
      const auto outside = outside_of(frustum, p);
      inside += outside == std::array<bool, 6>{};
      for (int k = 0; k < 6; ++k) crossed[k] = crossed[k] || outside[k];
    }
    CHECK((inside == 1 || inside == 2));
    many += std::ranges::count(crossed, true) > 2;
  }
  CHECK(many < 25);
}

TEST_CASE("soup: outside triangles lie beyond one plane, some of them behind the eye") {
  const Frustum<float> frustum = off_centre();
  const Mesh mesh = make_soup({.outside = 1}, 500, 1, frustum);
  int behind = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners t = corners_of(mesh, i);
    if (std::ranges::all_of(t, [](const auto& p) { return p[2] > -0.5f; })) {
      behind += std::ranges::all_of(t, [](const auto& p) { return p[2] > 0; });
      continue;  // beyond near
    }
    REQUIRE(std::ranges::all_of(t, [](const auto& p) { return p[2] < 0; }));
    std::array<bool, 6> all = {true, true, true, true, true, true};
    for (const auto& p : t) {
      const auto outside = outside_of(frustum, p);
      for (int k = 0; k < 6; ++k) all[k] = all[k] && outside[k];
    }
    CHECK(std::ranges::count(all, true) >= 1);
  }
  CHECK(behind > 50);
}

TEST_CASE("soup: triangles across w = 0 reach from inside the volume to behind the eye") {
  const Frustum<float> frustum = off_centre();
  const Mesh mesh = make_soup({.crossing_w0 = 1}, 500, 1, frustum);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners t = corners_of(mesh, i);
    CHECK(std::ranges::any_of(t, [](const auto& p) { return p[2] > 0; }));
    CHECK(std::ranges::any_of(t, [&](const auto& p) {
      return p[2] < 0 && outside_of(frustum, p) == std::array<bool, 6>{};
    }));
  }
}

TEST_CASE("soup: triangles across several planes leave two by some vertex, none by all") {
  const Frustum<float> frustum = off_centre();
  const Mesh mesh = make_soup({.several_planes = 1}, 500, 1, frustum);
  int behind = 0, two_or_more = 0, no_vertex_inside = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners t = corners_of(mesh, i);
    if (std::ranges::any_of(t, [](const auto& p) { return p[2] > 0; })) {
      ++behind;
      CHECK(std::ranges::any_of(t, [](const auto& p) { return p[2] < 0; }));
      continue;
    }
    std::array<int, 6> outside = {};
    int inside = 0;
    for (const auto& p : t) {
      const auto of = outside_of(frustum, p);
      for (std::size_t k = 0; k < 6; ++k) outside[k] += of[k];
      inside += of == std::array<bool, 6>{};
    }
    CHECK(std::ranges::count(outside, 3) == 0);
    two_or_more += 6 - std::ranges::count(outside, 0) >= 2;
    no_vertex_inside += inside == 0;
  }
  CHECK(behind == 250);
  CHECK(two_or_more == 250);
  CHECK(no_vertex_inside > 25);
}

TEST_CASE("soup: in a parallel projection triangles across several planes are all of one kind") {
  const Frustum<float> frustum = parallel();
  auto counts =
      count_classes(make_soup({.inside = 1, .several_planes = 1}, 200, 1, frustum), frustum);
  CHECK(counts[SoupClass::inside] == 100);
  CHECK(counts[SoupClass::several_planes] == 100);
  CHECK(counts[SoupClass::several_planes_behind] == 0);
}

TEST_CASE("soup: classes come in random order, each triangle with vertices of its own") {
  const Frustum<float> frustum = off_centre();
  const Mesh mesh = make_soup({.inside = 1, .outside = 1}, 1000, 1, frustum);
  int changes = 0;
  for (std::size_t i = 0; i + 1 < mesh.triangles.size(); ++i) {
    changes += is_of_class(SoupClass::inside, frustum, corners_of(mesh, i)) !=
               is_of_class(SoupClass::inside, frustum, corners_of(mesh, i + 1));
  }
  CHECK((400 < changes && changes < 600));
  CHECK(mesh.positions.size() == 3000);
  CHECK(mesh.attributes.size() == 3000);
}

TEST_CASE("soup: a seed gives the same bits on every platform, another seed others") {
  const SoupShares shares{.inside = 2, .outside = 2, .straddling = 2, .crossing_w0 = 2};
  const auto soup = [&](std::uint64_t seed) { return make_soup(shares, 100, seed, off_centre()); };
  CHECK(hash_of(soup(1)) == 0xd67f3878f85a2f5eu);
  CHECK(hash_of(soup(2)) != hash_of(soup(1)));
  CHECK(hash_of(make_soup({.several_planes = 1}, 100, 1, off_centre())) == 0x55487f5703f5613fu);
}

TEST_CASE("soup: parallel projections and an infinite far plane have soups too") {
  Frustum<float> infinite = off_centre();
  infinite.infinite_far = true;
  const Frustum<float> frustum = GENERATE_COPY(parallel(), infinite);
  const Mesh mesh = make_soup({.inside = 2, .outside = 1, .straddling = 1}, 400, 1, frustum);
  auto counts = count_classes(mesh, frustum);
  CHECK(counts[SoupClass::inside] == 200);
  CHECK(counts[SoupClass::outside] == 100);
  CHECK(counts[SoupClass::straddling] == 100);
}

TEST_CASE("soup: a vertex on or next to a plane belongs to no class") {
  const Frustum<float> f = off_centre();
  const std::array<float, 3> inside = {0, 0, -2}, other = {0.1f, 0.2f, -3};
  const float right = f.right / f.near * 2;
  const auto is = [&](SoupClass kind, float x) {
    return is_of_class(kind, f, Corners{inside, other, {x, 0, -2}});
  };
  for (const SoupClass kind : kClasses) {
    CHECK(!is(kind, right));
    CHECK(!is(kind, std::nextafter(right, 0.0f)));
    CHECK(is(kind, right * 0.99f) == (kind == SoupClass::inside));
    CHECK(is(kind, right * 1.01f) == (kind == SoupClass::straddling));
  }
}

TEST_CASE("soup: a volume too thin for any triangle is refused, not searched for ever") {
  Frustum<float> thin = off_centre();
  thin.far = std::nextafter(thin.near, 1.0f);
  CHECK(
      contains(message_of<UsageError>([&] { make_soup({.inside = 1}, 1, 1, thin); }), "too thin"));
}

TEST_CASE("soup: shares that make no soup are refused") {
  const auto refused = [](const SoupShares& shares, const Frustum<float>& frustum) {
    return message_of<UsageError>([&] { make_soup(shares, 10, 1, frustum); });
  };
  CHECK(contains(refused({}, off_centre()), "all shares are 0"));
  CHECK(contains(refused({.inside = -1}, off_centre()), "a share of -1"));
  CHECK(contains(refused({.several_planes = -1}, off_centre()), "a share of -1"));
  CHECK(contains(refused({.crossing_w0 = 1}, parallel()), "nothing can cross w = 0"));
}

}  // namespace
}  // namespace clipscope::experiments
