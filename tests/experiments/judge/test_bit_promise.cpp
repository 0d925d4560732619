// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of promises to the bit must find those broken that a clipper does not keep.
#include <cmath>
#include <limits>
#include <random>

#include "experiments/judge/questions.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/handmade.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

Contestant contestant(std::string_view clipper) { return find_contestant(clipper, "float"); }

using AnyTriangle = ClipTriangle<float, 1>;

std::string broken(const Contestant& c, const AnyTriangle& triangle) {
  return broken_bits(c, batch_of(ClipVolume{}, std::span(&triangle, 1)));
}

AnyTriangle random_triangle(std::mt19937_64& random) {
  AnyTriangle triangle;
  for (auto& v : triangle) {
    for (int i = 0; i < 4; ++i) {
      v.position[i] = static_cast<float>(static_cast<int>(random() % 4001) - 2000) / 700.0f;
    }
    v.position[3] = std::abs(v.position[3]);
    v.attributes[0] = 0;
  }
  return triangle;
}

// The first complaint about a contestant on many triangles; empty if there is none.
std::string complaint(const Contestant& c) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 3000; ++n) {
    const std::string text = broken(c, random_triangle(random));
    if (!text.empty()) return text;
  }
  return {};
}

}  // namespace

TEST_CASE("bit promise: a clipper that keeps it is not blamed") {
  for (const char* name : {"textbook", "homogeneous/sutherland_hodgman", "homogeneous/pipeline",
                           "homogeneous/blinn_newell", "barycentric/distance_matrix"}) {
    INFO(name);
    CHECK(complaint(contestant(name)).empty());
  }
}

TEST_CASE("bit promise: textbook is not watertight, and is found out if it says so") {
  Contestant liar = contestant("textbook");
  liar.promise.watertight = true;
  CHECK(complaint(liar).find("not watertight") != std::string::npos);
}

TEST_CASE("bit promise: the distance matrix sums in the order of the vertices") {
  Contestant liar = contestant("distance_matrix");
  liar.promise.rotation_invariant = true;
  CHECK(complaint(liar).find("another vertex first") != std::string::npos);
}

TEST_CASE("bit promise: a w-plane with epsilon depends on scale") {
  Contestant liar = contestant("w_first_1_16384");
  liar.promise.scale_invariant = true;
  AnyTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle[i].position = {i == 1 ? 1e-5f : 0.0f, i == 2 ? 1e-5f : 0.0f, 0.0f, 2e-5f};
    triangle[i].attributes[0] = 0;
  }
  CHECK(broken(liar, triangle).find("scaled") != std::string::npos);
}

TEST_CASE("bit promise: a mean that changes a constant by an ulp is found out") {
  const Contestant honest = contestant("textbook");
  const Contestant liar = altered(honest, [](Numbers& polygon) {
    for (auto& v : polygon) v[4] = std::nextafter(static_cast<float>(v[4]), 0.0f);
  });
  CHECK(complaint(liar).find("not constant") != std::string::npos);
}

TEST_CASE(
    "bit promise: Blinn and Newell's vertices may lie outside the volume, by an ulp or more") {
  Contestant liar = contestant("blinn_newell");
  liar.promise.confined = true;
  CHECK(complaint(liar).find("not confined") != std::string::npos);
  CHECK(complaint(contestant("correctly_rounded")).empty());
  CHECK(complaint(contestant("any_outside")).empty());
}

TEST_CASE("bit promise: a NaN is found") {
  const Contestant honest = contestant("textbook");
  const Contestant liar = altered(honest, [](Numbers& polygon) {
    polygon.assign(3, std::vector<double>(5, std::numeric_limits<double>::quiet_NaN()));
  });
  CHECK(complaint(liar).find("not total") != std::string::npos);
}

TEST_CASE("bit promise: view-space lengths scale with their frustum") {
  ViewTriangle<float, 1> triangle;
  const float positions[3][3] = {{-3, 0, -4}, {0.5f, 0, -1.5f}, {0, 7, -20}};
  for (std::size_t i = 0; i < 3; ++i) {
    triangle[i].position = {positions[i][0], positions[i][1], positions[i][2]};
    triangle[i].attributes[0] = static_cast<float>(i);
  }
  for (const auto kind : {ProjectionKind::perspective, ProjectionKind::parallel}) {
    Frustum<float> frustum;
    frustum.kind = kind;
    for (const Contestant* c : select_contestants("*", {"float"})) {
      INFO(c->clipper);
      const std::span<const ViewTriangle<float, 1>> triangles(&triangle, 1);
      CHECK(broken_bits(*c, batch_of(frustum, triangles)).empty());
    }
  }
}
