// SPDX-License-Identifier: GPL-3.0-or-later
//
// The step before the divide alone, `cut`: divided, it is what the clipper answers.
#include <bit>
#include <cmath>
#include <set>
#include <string_view>

#include "tests/catch.hpp"
#include "tests/spaces/triangles.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::for_each_type;

namespace {

using Floats = TypeList<float, double>;

const ClipVolume kVolumes[] = {{},
                               {.depth = DepthRange::zero_to_one},
                               {.depth = DepthRange::reversed},
                               {.depth_clamp = true},
                               {.depth_clamp = kClampFar},
                               {.clip_distances = 2},
                               {.open_sides = true}};

template <class T>
bool same_bits(const T& a, const T& b) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <class T>
bool same_bits(const NdcPolygon<T, K>& a, const NdcPolygon<T, K>& b) {
  if (a.size() != b.size()) return false;
  for (int i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      if (!same_bits(a[i].position[c], b[i].position[c])) return false;
    }
    for (int k = 0; k < K; ++k) {
      if (!same_bits(a[i].attributes[k], b[i].attributes[k])) return false;
    }
  }
  return true;
}

// Numbers of any magnitude, so that now and then a sum overflows.
Corners wide_corners(std::mt19937_64& random) {
  Corners corners = random_corners(random, 1);
  for (auto& corner : corners) {
    for (double& x : corner) x = std::ldexp(x, static_cast<int>(random() % 268) - 140);
  }
  return corners;
}

// Half of them in front of the eye; the attributes can be clip distances.
template <class T>
ClipTriangle<T, K> some_triangle(std::mt19937_64& random, int i) {
  Corners corners = i % 3 == 0   ? lattice_corners(random)
                    : i % 3 == 1 ? random_corners(random, 2)
                                 : random_corners(random, 1);
  if (i % 2 == 0) {
    for (auto& corner : corners) corner[3] = std::abs(corner[3]);
  }
  ClipTriangle<T, K> triangle = clip_triangle<T>(corners);
  const Corners attributes = random_corners(random, 4);
  for (std::size_t v = 0; v < 3; ++v) {
    for (int k = 0; k < K; ++k) {
      triangle[v].attributes[k] = static_cast<T>(attributes[v][static_cast<std::size_t>(k)]);
    }
  }
  return triangle;
}

// The clipper's polygon before the divide, in clip space in the usual volume, or in view space.
// Functions, since what is discarded in a generic lambda is still looked up where it depends on
// nothing but that lambda's caller.
template <class C, class T>
ClipPolygon<T, K> cut(const ClipTriangle<T, K>& triangle) {
  return C::cut({}, triangle);
}
template <class C, class T>
ViewPolygon<T, K> cut(const Projection<T>& projection, const ViewTriangle<T, K>& triangle) {
  return C::cut(projection, triangle);
}

// What the clipper's own divide makes of its polygon.
template <class C, class T>
NdcPolygon<T, K> divided_cut(const ClipVolume& volume, const ClipTriangle<T, K>& triangle) {
  NdcPolygon<T, K> out;
  if constexpr (std::same_as<C, DistanceMatrix>) {
    for (const auto& v : C::cut_weighted(volume, triangle)) out.push_back(C::to_ndc(v));
    clear_if_overflowed(out);
  } else {
    divide(C::cut(volume, triangle), out);
  }
  return out;
}

template <class Polygon>
bool is_proper(const Polygon& polygon) {
  for (const auto& v : polygon) {
    if (!has_finite_position(v)) return false;
  }
  return polygon.empty() || polygon.size() >= 3;
}

}  // namespace

TEST_CASE("cut step: these clippers have it") {
  std::set<std::string_view> in_clip_space, in_view_space;
  for_each_type(AllClippers{}, [&]<class C>() {
    if constexpr (CutsInClipSpace<C, float, K>) in_clip_space.insert(C::name);
    if constexpr (CutsInViewSpace<C, float, K>) in_view_space.insert(C::name);
  });
  CHECK(in_clip_space ==
        std::set<std::string_view>{
            "textbook", "homogeneous/sutherland_hodgman", "homogeneous/near_last",
            "homogeneous/w_first_0", "homogeneous/w_first_flt_min", "homogeneous/w_first_1_16384",
            "homogeneous/w_first_1e-5", "homogeneous/pipeline", "homogeneous/blinn_newell",
            "homogeneous/mcguire", "homogeneous/from_outside", "homogeneous/weighted_ends",
            "homogeneous/from_inside", "homogeneous/opposite_planes", "barycentric/distance_matrix",
            "barycentric/correctly_rounded"});
  CHECK(in_view_space == std::set<std::string_view>{"view/sutherland_hodgman", "view/exact_sign",
                                                    "view/unit_normals"});
}

TEST_CASE("cut step: the divided polygon has the bits of the clipper's answer") {
  for_each_type(AllClippers{}, [&]<class C>() {
    for_each_type(Floats{}, [&]<class T>() {
      if constexpr (CutsInClipSpace<C, T, K> && !C::promise.correctly_rounded) {
        INFO(C::name << " in " << experiments::kFormat<T>.name);
        std::mt19937_64 random(1);
        int drawn = 0;
        for (int i = 0; i < 3000; ++i) {
          const ClipVolume& volume = kVolumes[static_cast<std::size_t>(i) % std::size(kVolumes)];
          const ClipTriangle<T, K> triangle = some_triangle<T>(random, i);
          const NdcPolygon<T, K> answer = clip<C>(triangle, volume);
          CAPTURE(i);
          REQUIRE(same_bits(divided_cut<C>(volume, triangle), answer));
          drawn += !answer.empty();
        }
        CHECK(drawn > 500);
      }
    });
  });
}

TEST_CASE("cut step: vertices are finite and in front of the eye, three or more") {
  for_each_type(AllClippers{}, [&]<class C>() {
    for_each_type(Floats{}, [&]<class T>() {
      if constexpr (CutsInClipSpace<C, T, K>) {
        INFO(C::name << " in " << experiments::kFormat<T>.name);
        std::mt19937_64 random(2);
        for (int i = 0; i < 3000; ++i) {
          const ClipTriangle<T, K> triangle =
              i % 2 == 0 ? some_triangle<T>(random, i) : clip_triangle<T>(wide_corners(random));
          const ClipPolygon<T, K> polygon = cut<C>(triangle);
          CAPTURE(i);
          REQUIRE(is_proper(polygon));
          for (const ClipVertex<T, K>& v : polygon) REQUIRE(0 <= v.position[3]);
        }
      }
    });
  });
}

TEST_CASE("cut step: in exact arithmetic the distance matrix's, divided, is its answer") {
  using experiments::Exact;
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const ClipTriangle<Exact, K> triangle = clip_triangle<Exact>(lattice_corners(random));
    NdcPolygon<Exact, K> divided;
    divide(DistanceMatrix::cut({}, triangle), divided);
    CHECK(same_cycle(divided, clip<DistanceMatrix>(triangle)));
  }
}

TEST_CASE("cut step: in view space the polygon, projected and divided, has the answer's bits") {
  for_each_type(AllClippers{}, [&]<class C>() {
    for_each_type(Floats{}, [&]<class T>() {
      if constexpr (CutsInViewSpace<C, T, K>) {
        INFO(C::name << " in " << experiments::kFormat<T>.name);
        Projection<T> projection(Frustum<T>{});
        std::mt19937_64 random(4);
        int drawn = 0;
        for (int i = 0; i < 3000; ++i) {
          Corners corners = i % 2 == 0 ? random_corners(random, 4) : lattice_corners(random);
          const ViewTriangle<T, K> triangle = view_triangle<T>(corners);
          projection.volume.open_sides = i % 4 == 0;
          const ViewPolygon<T, K> polygon = cut<C>(projection, triangle);
          CAPTURE(i);
          REQUIRE(is_proper(polygon));
          ClipPolygon<T, K> projected;
          for (const ViewVertex<T, K>& v : polygon) projected.push_back(to_clip(projection, v));
          NdcPolygon<T, K> divided, answer;
          divide(projected, divided);
          C{}(projection, triangle, answer);
          REQUIRE(same_bits(divided, answer));
          drawn += !answer.empty();
        }
        CHECK(drawn > 500);
      }
    });
  });
}
