// SPDX-License-Identifier: MIT
//
// The contract that makes clippers interchangeable, and the promise that each one makes.
//
// A clipper is a stateless function object: a view-space triangle and a projection in, one convex
// polygon in the canonical view volume out (0 or 3 to 9 vertices, in the triangle's own winding), each
// vertex with x y z in NDC, 1/w and its attributes as the true values at that point. A clipper
// whose method starts at clip coordinates also takes a clip-space triangle. Clippers are total: no
// throw, no allocation (but `textbook`, whose point it is), no globals.
#pragma once

#include <concepts>
#include <string_view>

#include "spaces/polygon.hpp"
#include "spaces/projection.hpp"

namespace clipscope {

// What a clipper promises for finite input, in terms of backward error: the polygon is what exact
// clipping would give had each clip-space coordinate been moved by at most
//
//     ulps * u * M * amplification
//
// where u is the scalar's unit roundoff, M the largest sum of magnitudes of the terms that make up a
// clip-space coordinate of the triangle's vertices, and amplification is 1 or, for methods that cut
// after the divide, w_max / w_min over the triangle (after its near cut where there is one). Exact
// scalars have u = 0: there the promise is the exact answer.
// `clipscope verify` checks it on every triangle, and the tests try to break it.
struct Promise {
  // Which finite triangles the promise speaks of.
  enum class Domain {
    any,
    divisible,       // w > 0 on the part in front of the near plane: all that view space can give
    in_front,        // every vertex in front of the near plane, and w > 0 on it
    all_or_nothing,  // any, but a straddling triangle is kept or dropped whole
  };
  enum class Amplification { none, w_ratio };

  Domain domain = Domain::any;
  bool covers = true;      // no visible part is lost
  bool contained = true;   // nothing outside the volume is drawn
  bool attributes = true;  // attributes share the bound, relative to their own largest magnitude
  double ulps = 0;
  Amplification amplification = Amplification::none;
};

// Worst-case bounds that promises are made of, in units of u M, to first order in u.
// Project and divide: 3 for the rounding of a matrix entry, 3 for a product and two sums, 3 for x/w, 1/w
// and taking their quotient.
inline constexpr double kProjectUlps = 9;
// One cut: 6 for t (three roundings of a quotient of distances, along an edge of at most 2 M), 2 for
// b - a, 2 for its product with t, 1 for the sum, 3 for a view-space distance. New vertices are cut again
// by later planes: six times at most.
inline constexpr double kChainUlps = kProjectUlps + 6 * 14;

template <class C, class T, int K>
concept ClipsViewTriangles = requires(const C clip, const Projection<T>& projection,
                                      const ViewTriangle<T, K>& triangle, NdcPolygon<T, K>& out) {
  clip(projection, triangle, out);
};

template <class C, class T, int K>
concept ClipsClipTriangles = requires(const C clip, DepthRange depth,
                                      const ClipTriangle<T, K>& triangle, NdcPolygon<T, K>& out) {
  clip(depth, triangle, out);
};

template <class C>
concept Clipper = std::is_empty_v<C> && std::default_initializable<C> && requires {
  { C::name } -> std::convertible_to<std::string_view>;     // space/method, unique
  { C::summary } -> std::convertible_to<std::string_view>;  // one line
  { C::source } -> std::convertible_to<std::string_view>;   // authors, title, year
  { C::promise } -> std::convertible_to<Promise>;
} && ClipsViewTriangles<C, float, 4>;

// A list of types, for the lists of clippers and scalars.
template <class... Ts>
struct TypeList {
  static constexpr int size = sizeof...(Ts);
};

}  // namespace clipscope
