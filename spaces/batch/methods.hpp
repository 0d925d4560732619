// SPDX-License-Identifier: MIT
//
// The methods of the batch clippers, and what can be asked of the list of them.
#pragma once

#include <array>

#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/barycentric/distance_matrix.hpp"
#include "spaces/batch/batch.hpp"
#include "spaces/batch/method.hpp"
#include "spaces/batch/plain_triangle.hpp"
#include "spaces/homogeneous/mcguire.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/view/sutherland_hodgman.hpp"

namespace clipscope::batch {

struct ViewBatch : ViewSutherlandHodgman {
  static constexpr std::string_view name = "view/batch";
  static constexpr std::string_view summary =
      "many triangles at once: Sutherland-Hodgman in view space, in SIMD";
  using Number = float;
  static constexpr Simd simd = Simd::view_planes;
};

struct HomogeneousBatch : HomogeneousSutherlandHodgman {
  static constexpr std::string_view name = "homogeneous/batch";
  static constexpr std::string_view summary =
      "many triangles at once: Sutherland-Hodgman in clip space, in SIMD";
  using Number = float;
  using BitsOf = HomogeneousSutherlandHodgman;
  static constexpr Simd simd = Simd::clip_planes;
};

// The stage alone: the full contract would be that of `homogeneous/batch`.
struct McGuireBatch {
  static constexpr std::string_view name = "homogeneous/mcguire_batch";
  static constexpr std::string_view summary =
      "many triangles at once: McGuire's cases, a triangle in each lane of a register";
  static constexpr std::string_view source = HomogeneousMcGuire::source;
  static constexpr Promise promise = HomogeneousMcGuire::promise;
  using Number = float;
  using BitsOf = HomogeneousMcGuire;
  static constexpr Simd simd = Simd::clip_lanes;

  template <int K>
  static ClipPolygon<float, K> cut(const ClipVolume& volume,
                                   const ClipTriangle<float, K>& triangle) {
    return HomogeneousMcGuire::cut(volume, triangle);
  }
};

// What computes in more than float rounds every coordinate and attribute once, and a coordinate
// times w by three roundings, which is less than projecting and dividing in float.
struct HomogeneousBatchDouble {
  static constexpr std::string_view name = "homogeneous/batch_double";
  static constexpr std::string_view summary = "the same in double, rounded to float once";
  static constexpr std::string_view source = HomogeneousSutherlandHodgman::source;
  static constexpr Promise promise{.ulps = kProjectUlps, .watertight = true};
  using Number = double;
  static constexpr Simd simd = Simd::clip_planes;

  template <int K>
  void operator()(const Projection<float>& projection, const ViewTriangle<float, K>& triangle,
                  NdcPolygon<float, K>& out) const {
    plain::clip_in_double(projection, triangle, out, HomogeneousSutherlandHodgman{});
  }
  template <int K>
  static ClipPolygon<float, K> cut(const ClipVolume& volume,
                                   const ClipTriangle<float, K>& triangle) {
    return plain::cut_in_double(volume, triangle);
  }
};

struct BarycentricBatch {
  static constexpr std::string_view name = "barycentric/batch";
  static constexpr std::string_view summary =
      "many triangles at once: every vertex from the three original ones, in double";
  static constexpr std::string_view source = DistanceMatrix::source;
  static constexpr Promise promise{
      .ulps = kProjectUlps, .watertight = true, .rotation_invariant = false};
  using Number = double;
  static constexpr Simd simd = Simd::originals;

  template <int K>
  void operator()(const Projection<float>& projection, const ViewTriangle<float, K>& triangle,
                  NdcPolygon<float, K>& out) const {
    const auto clip = [](const ClipVolume& volume, const ClipTriangle<double, K>& wide,
                         NdcPolygon<double, K>& polygon) {
      divide(plain::cut_from_originals(volume, wide), polygon);
    };
    plain::clip_in_double(projection, triangle, out, clip);
  }
  template <int K>
  static ClipPolygon<float, K> cut(const ClipVolume& volume,
                                   const ClipTriangle<float, K>& triangle) {
    return plain::cut_from_originals(volume, triangle);
  }
};

struct CorrectlyRoundedBatch : CorrectlyRounded {
  static constexpr std::string_view name = "barycentric/correctly_rounded_batch";
  static constexpr std::string_view summary =
      "many triangles at once: decisions exact, every float the nearest to the exact value";
  using Number = double;
  static constexpr Simd simd = Simd::originals;
};

template <class... Ms>
constexpr bool holds_methods(TypeList<Ms...>) {
  static_assert((BatchMethod<Ms> && ...), "a type of AllMethods is no method: see method.hpp");
  return true;
}
static_assert(holds_methods(AllMethods{}));

// Calls f.template operator()<M>() for the method's type.
template <class F>
constexpr void with_method(Method method, F&& f) {
  for_each_type(AllMethods{}, [&]<class M>() {
    if (method == kMethod<M>) f.template operator()<M>();
  });
}

constexpr bool has_simd(Method method) {
  bool has = false;
  with_method(method, [&]<class M>() { has = M::simd != Simd::none; });
  return has;
}

// The methods at those places of the list where there is a true.
template <bool... kHas>
constexpr auto methods_with() {
  std::array<Method, (std::size_t{kHas} + ...)> methods{};
  std::size_t count = 0;
  int place = 0;
  ((kHas ? void(methods[count++] = Method(place++)) : void(++place)), ...);
  return methods;
}

inline constexpr auto kStageMethods = []<class... Ms>(TypeList<Ms...>) {
  return methods_with<HasStage<Ms>...>();
}(AllMethods{});
inline constexpr auto kFullMethods = []<class... Ms>(TypeList<Ms...>) {
  return methods_with<HasFull<Ms>...>();
}(AllMethods{});

}  // namespace clipscope::batch
