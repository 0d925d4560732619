// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the batch clippers promise beside the polygons: order, reuse of memory, threads, NaN and
// infinity.
#include <optional>
#include <set>
#include <string_view>
#include <thread>

#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/batch/inputs.hpp"

namespace clipscope::batch::tests {
namespace {

constexpr std::size_t kStride = 4;

std::vector<float> floats(std::span<const float> s) { return {s.begin(), s.end()}; }

// A triangle inside, one outside to the right, one whose right end is cut off by x <= w.
const std::vector<float> kThree = {0, 0, 0, 1, .5f, 0, 0, 1, 0, .5f, 0, 1,  //
                                   2, 0, 0, 1, 3,   0, 0, 1, 2, 1,   0, 1,  //
                                   0, 0, 0, 1, 2,   0, 0, 1, 0, 1,   0, 1};

}  // namespace

TEST_CASE("batch: every method of the list has a name of its own, and is listed by contract") {
  std::set<std::string_view> names;
  for_each_type(AllMethods{}, [&]<class M>() {
    CHECK(name(kMethod<M>) == M::name);
    CHECK(names.insert(M::name).second);
    CHECK(std::ranges::count(kStageMethods, kMethod<M>) == HasStage<M>);
    CHECK(std::ranges::count(kFullMethods, kMethod<M>) == HasFull<M>);
  });
  CHECK(name(Method::view) == "view/batch");
  CHECK(name(Method::correctly_rounded) == "barycentric/correctly_rounded_batch");
}

TEST_CASE("batch: copy writes what is inside and what is cut, in order") {
  Output out;
  for (const Method method : kStageMethods) {
    INFO(name(method));
    clip(method, {}, VertexArray{kThree.data(), 9, 0}, out);
    CHECK(out.inside().empty());
    REQUIRE(out.polygons().size() == 2);
    CHECK(out.polygons()[0].triangle == 0);
    CHECK(out.polygons()[1].triangle == 2);
    CHECK(floats(out.polygon(0)) == std::vector<float>(kThree.begin(), kThree.begin() + 12));
    const std::vector<float> cut = {0, 0, 0, 1, 1, 0, 0, 1, 1, .5f, 0, 1, 0, 1, 0, 1};
    CHECK(same_cycle(out.polygon(1), cut, kStride));
    CHECK(out.tally().rejected == 1);
    CHECK(out.tally().inside == 1);
    CHECK(out.tally().one_plane == (has_simd(method) ? 1 : 0));
  }
}

TEST_CASE("batch: indexed names what is inside and writes what is cut") {
  const std::vector<std::uint32_t> indices = {6, 7, 8, 0, 1, 2, 3, 4, 5, 0, 2, 1};
  Output out;
  for (const Method method : kStageMethods) {
    INFO(name(method));
    clip(method, {}, IndexedMesh{{kThree.data(), 9, 0}, indices}, out);
    CHECK(std::vector(out.inside().begin(), out.inside().end()) ==
          std::vector<std::uint32_t>{1, 3});
    REQUIRE(out.polygons().size() == 1);
    CHECK(out.polygons()[0].triangle == 0);
    CHECK(out.polygon(0).size() == 4 * kStride);
  }
}

TEST_CASE("batch: the method homogeneous has the bits of the scalar clipper before its divide") {
  Random random(3);
  for (const Numbers numbers : {Numbers::near_volume, Numbers::lattice, Numbers::wide}) {
    const Soup soup = make_soup(random, numbers, 0, 1000);
    Output out;
    clip(Method::homogeneous, {}, soup.array(), out);
    std::size_t next = 0;
    for (std::size_t t = 0; t < soup.triangles(); ++t) {
      ClipTriangle<float, 0> triangle;
      for (std::size_t i = 0; i < 3; ++i) {
        for (int c = 0; c < 4; ++c) triangle[i].position[c] = soup.vertices[12 * t + 4 * i + c];
      }
      NdcPolygon<float, 0> expected;
      HomogeneousSutherlandHodgman{}(ClipVolume{}, triangle, expected);
      std::vector<float> divided;
      if (next < out.polygons().size() && out.polygons()[next].triangle == t) {
        const std::span<const float> polygon = out.polygon(next++);
        for (std::size_t v = 0; v < polygon.size(); v += kStride) {
          for (std::size_t c = 0; c < 3; ++c) divided.push_back(polygon[v + c] / polygon[v + 3]);
          divided.push_back(1 / polygon[v + 3]);
        }
      }
      bool overflowed = false;  // 1/w may
      for (std::size_t i = 0; i < divided.size(); ++i) {
        overflowed = overflowed || (i % kStride != 3 && !std::isfinite(divided[i]));
      }
      if (overflowed) divided.clear();
      std::vector<float> scalar;
      for (const NdcVertex<float, 0>& v : expected) {
        for (int c = 0; c < 4; ++c) scalar.push_back(v.position[c]);
      }
      CAPTURE(t, divided, scalar);
      REQUIRE(same_cycle(divided, scalar, kStride));
    }
    CHECK(next == out.polygons().size());
  }
}

TEST_CASE("batch: an Output that has met a call allocates no more for one as large") {
  Random random(4);
  const Soup soup = make_soup(random, Numbers::near_volume, 4, 2000);
  Output out;
  clip(Method::correctly_rounded, {}, soup.mesh(), out);
  const float* vertices = out.vertices().data();
  const PolygonEnd* polygons = out.polygons().data();
  const std::uint32_t* inside = out.inside().data();
  for (const Method method : kStageMethods) clip(method, {}, soup.mesh(), out);
  CHECK(out.vertices().data() == vertices);
  CHECK(out.polygons().data() == polygons);
  CHECK(out.inside().data() == inside);
}

TEST_CASE("batch: threads with an Output each do not disturb each other") {
  Random random(6);
  const Soup soup = make_soup(random, Numbers::near_volume, 4, 3000);
  Output alone, first, second;
  clip(Method::barycentric, {}, soup.array(), alone);
  const auto work = [&soup](Output& out) {
    for (int i = 0; i < 5; ++i) clip(Method::barycentric, {}, soup.array(), out);
  };
  std::thread other(work, std::ref(second));
  work(first);
  other.join();
  CHECK(first_difference(alone, first) == std::nullopt);
  CHECK(first_difference(alone, second) == std::nullopt);
}

TEST_CASE("batch: a position that is not finite yields nothing, and nothing infinite comes out") {
  Random random(8);
  const Soup soup = make_soup(random, Numbers::special, 0, 4000);
  for (const Method method : kStageMethods) {
    INFO(name(method));
    Output out;
    clip(method, {}, soup.array(), out);
    CHECK(std::ranges::all_of(out.vertices(), [](float x) { return std::isfinite(x); }));
    bool from_finite = true;
    for (const PolygonEnd& p : out.polygons()) {
      for (std::size_t i = 0; i < 12; ++i) {
        from_finite = from_finite && std::isfinite(soup.vertices[12 * p.triangle + i]);
      }
    }
    CHECK(from_finite);
  }
}

TEST_CASE("batch: the eye itself, w = 0, is no vertex of an answer") {
  // (0, 0, 0, 0) is in the closed volume: with it two vertices are left, which enclose nothing.
  const std::vector<float> triangle = {0, 0, 0, 0, .5f, 0, 0, 1, 0, .5f, 0, 1};
  for (const Method method : kStageMethods) {
    INFO(name(method));
    Output out;
    clip(method, {}, VertexArray{triangle.data(), 3, 0}, out);
    CHECK(out.polygons().empty());
    clip(method, {}, IndexedMesh{{triangle.data(), 3, 0}, std::vector<std::uint32_t>{0, 1, 2}},
         out);
    CHECK(out.inside().empty());
    CHECK(out.polygons().empty());
  }
}

}  // namespace clipscope::batch::tests
