// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of promises to the bit must find those broken that a clipper does not keep.
#include <limits>
#include <random>

#include "experiments/measure/bit_promise.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const Contestant<float>& contestant(std::string_view clipper) {
  return *std::get<const Contestant<float>*>(find_contestant(clipper, "float"));
}

using AnyTriangle = ClipTriangle<float, kRunTime>;

AnyTriangle random_triangle(std::mt19937_64& random) {
  AnyTriangle triangle;
  for (auto& v : triangle) {
    for (int i = 0; i < 4; ++i) {
      v.position[i] = static_cast<float>(static_cast<int>(random() % 4001) - 2000) / 700.0f;
    }
    v.position[3] = std::abs(v.position[3]);
    v.attributes.resize(1);
    v.attributes[0] = 0;
  }
  return triangle;
}

// The first complaint about a contestant on many triangles; empty if there is none.
std::string complaint(const Contestant<float>& c) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 3000; ++n) {
    const std::string text = broken_bits<float>(c, ClipVolume{}, random_triangle(random));
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
  Contestant<float> liar = contestant("textbook");
  liar.promise.watertight = true;
  CHECK(complaint(liar).find("not watertight") != std::string::npos);
}

TEST_CASE("bit promise: the distance matrix sums in the order of the vertices") {
  Contestant<float> liar = contestant("distance_matrix");
  liar.promise.rotation_invariant = true;
  CHECK(complaint(liar).find("another vertex first") != std::string::npos);
}

TEST_CASE("bit promise: a w-plane with epsilon depends on scale") {
  Contestant<float> liar = contestant("w_first_1_16384");
  liar.promise.scale_invariant = true;
  AnyTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle[i].position = {i == 1 ? 1e-5f : 0.0f, i == 2 ? 1e-5f : 0.0f, 0.0f, 2e-5f};
    triangle[i].attributes.resize(1);
    triangle[i].attributes[0] = 0;
  }
  CHECK(broken_bits<float>(liar, ClipVolume{}, triangle).find("scaled") != std::string::npos);
}

TEST_CASE("bit promise: a NaN is found") {
  Contestant<float> liar = contestant("textbook");
  liar.clip_one = [](const ClipVolume&, const AnyTriangle& triangle,
                     NdcPolygon<float, kRunTime>& out) {
    out.clear();
    for (int i = 0; i < 3; ++i) {
      NdcVertex<float, kRunTime> v;
      v.position = Vec4<float>(std::numeric_limits<float>::quiet_NaN());
      v.attributes = triangle[0].attributes;
      out.push_back(v);
    }
  };
  CHECK(complaint(liar).find("not total") != std::string::npos);
}

TEST_CASE("bit promise: view-space lengths scale with their frustum") {
  ViewTriangle<float, kRunTime> triangle;
  const float positions[3][3] = {{-3, 0, -4}, {0.5f, 0, -1.5f}, {0, 7, -20}};
  for (std::size_t i = 0; i < 3; ++i) {
    triangle[i].position = {positions[i][0], positions[i][1], positions[i][2]};
    triangle[i].attributes.resize(1);
    triangle[i].attributes[0] = static_cast<float>(i);
  }
  for (const auto kind : {ProjectionKind::perspective, ProjectionKind::parallel}) {
    Frustum<double> frustum;
    frustum.kind = kind;
    for (const Contestant<float>& c : contestants<float>()) {
      INFO(c.name);
      CHECK(broken_bits<float>(c, frustum, ClipVolume{}, triangle).empty());
    }
  }
}
