// SPDX-License-Identifier: MIT
//
// The contract that makes clippers interchangeable, and the promise that each one makes.
//
// A clipper is a stateless function object: a view-space primitive (a triangle, a segment, a point)
// and a projection in; one convex polygon in the canonical view volume out (a triangle gives 0 or 3
// to 9 vertices, more with clip distances, in its own winding; a segment 0 or 2, in its own order;
// a point 0 or 1), each vertex with x y z in NDC, 1/w and its attributes as the true values at that
// point. A clipper whose method starts at clip coordinates also takes clip-space primitives and the
// volume.
//
// Clippers are total: no throw, no allocation (but `textbook`, whose point it is), no globals. The
// policy for NaN and infinity, the same for all of them:
//   - a primitive with a position coordinate that is NaN or infinite yields nothing;
//   - attributes are not looked at, clip distances apart: a vertex whose clip distance is NaN is
//     outside of it;
//   - from finite positions no NaN and no infinite x, y or z comes out: where a result overflows on
//     its way, nothing comes out. 1/w may overflow to infinity.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string_view>

#include "spaces/planes.hpp"
#include "spaces/polygon.hpp"
#include "spaces/projection.hpp"

namespace clipscope {

// As a bound: there is none where numbers are rounded. Exact scalars are promised the exact answer.
inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// What a clipper promises for finite input. The error bound is a backward error: the polygon is
// what exact clipping would give had each clip-space coordinate been moved by at most
//
//     ulps * (u * M + eta) * amplification
//
// where u is the scalar's unit roundoff, eta its smallest positive number (an operation that
// underflows is off by half of it), M the largest sum of magnitudes of the terms that make up a
// clip-space coordinate of the triangle's vertices, and amplification is 1 or, for methods that cut
// after the divide, w_max / w_min over the triangle (after its near cut where there is one). For
// attributes M is the largest of their own magnitudes; methods that cut after the divide
// interpolate a / w, so that eta counts w_max times there where that is more than 1.
// Exact scalars have u = eta = 0: there the promise is the exact answer.
//
// It speaks of triangles whose visible part keeps w above that error (all that a near plane lets
// through), of numbers that do not overflow, and of frusta of which the entries of the matrix are 0
// or normal numbers, the squares of the sides' slopes do not overflow, and the distance between two
// sides on the near plane times M is a normal number. `clipscope verify` checks a promise on every
// triangle, and the tests try to break it.
struct Promise {
  // Which finite triangles the error bound speaks of.
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
  bool attributes = true;  // attributes share the bound
  double ulps = 0;
  Amplification amplification = Amplification::none;

  // The rest holds to the bit, for every triangle (`total`) or as long as nothing over- or
  // underflows.
  bool total = true;        // never a NaN or an infinite x, y or z from finite positions
  bool watertight = false;  // vertices on an edge depend on that edge alone, not on its direction
  bool rotation_invariant = true;  // the same vertices whichever of the input's vertices is first
  bool scale_invariant =
      true;  // the same for homogeneous coordinates (or view-space lengths) times 2^k
  // An attribute that has one value at all vertices of the primitive has that value at all vertices
  // of the polygon. 0 equals -0.
  bool constants = true;
  // Every |x| and |y| is at most 1, and every z is in its range where near and far clip. Not in
  // double-double, whose quotient of two numbers may round beyond that of larger ones.
  bool confined = false;
  // Every coordinate, 1/w and attribute is the exact one rounded once, to nearest, ties to even,
  // and the vertices are those of the exact polygon, some of them repeated where it has no area;
  // nothing where z rounds to infinity. The truth of view-space triangles is that of the frustum's
  // exact numbers. In float only; `domain` does not limit it.
  bool correctly_rounded = false;

  // Options of the volume that the method takes. Where it does not, its answer is "not applicable".
  bool depth_clamp = true;
  bool clip_distances = true;
  bool open_sides = true;
};

// Whether a clipper that promises this can be asked to clip against the volume.
constexpr bool is_applicable(const Promise& promise, const ClipVolume& volume) {
  return (promise.depth_clamp || !volume.depth_clamp) &&
         (promise.clip_distances || volume.clip_distances == 0) &&
         (promise.open_sides || !volume.open_sides);
}

// Worst-case bounds that promises are made of, in units of u M, to first order in u.
// Project and divide: 3 for the rounding of a matrix entry, 3 for a product and two sums, 3 for
// x/w, 1/w and taking their quotient.
inline constexpr double kProjectUlps = 9;
// One cut: 6 for t (three roundings of a quotient of distances, along an edge of at most 2 M), 2
// for b - a, 2 for its product with t, 1 for the sum, 3 for a view-space distance. New vertices are
// cut again by later planes: six times at most.
inline constexpr double kChainUlps = kProjectUlps + 6 * 14;

template <class C, class T, int K, std::size_t N = 3>
concept ClipsViewSpace = requires(const C clip, const Projection<T>& projection,
                                  const Simplex<Space::view, T, K, N>& primitive,
                                  NdcPolygon<T, K>& out) {
  clip(projection, primitive, out);
};

template <class C, class T, int K, std::size_t N = 3>
concept ClipsClipSpace = requires(const C clip, const ClipVolume& volume,
                                  const Simplex<Space::clip, T, K, N>& primitive,
                                  NdcPolygon<T, K>& out) {
  clip(volume, primitive, out);
};

// Optional: the step before the divide alone. C::cut gives the polygon inside the volume: nothing,
// which is also what it gives where a coordinate overflows, or at least three vertices with w > 0.
// `divide` (homogeneous/divide.hpp) makes of it the answer of the call operator, bit for bit. A
// clipper of which that is not true says so.
template <class C, class T, int K>
concept CutsInClipSpace = requires(const ClipVolume& volume, const ClipTriangle<T, K>& triangle) {
  { C::cut(volume, triangle) } -> std::same_as<ClipPolygon<T, K>>;
};

// The same of a method that cuts in view space, where there is no w.
template <class C, class T, int K>
concept CutsInViewSpace = requires(const Projection<T>& projection,
                                   const ViewTriangle<T, K>& triangle) {
  { C::cut(projection, triangle) } -> std::same_as<ViewPolygon<T, K>>;
};

// A clipper of primitives with N vertices.
template <class C, std::size_t N = 3>
concept Clipper = std::is_empty_v<C> && std::default_initializable<C> && requires {
  { C::name } -> std::convertible_to<std::string_view>;     // space/method, unique
  { C::summary } -> std::convertible_to<std::string_view>;  // one line
  { C::source } -> std::convertible_to<std::string_view>;   // authors, title, year
  { C::promise } -> std::convertible_to<Promise>;
} && ClipsViewSpace<C, float, 4, N>;

// The call operators of a clipper that starts at clip coordinates. What it does there is the static
// Steps::clip(volume, primitive, out), which says by its types what it takes; what open sides do
// not own does not get there. Steps may be the clipper itself, which is incomplete where its base
// is made; Self puts the question off until the call. Up to clang 15 a constraint that names an
// incomplete class is false, without a word.
template <class Steps>
struct StartsInClipSpace {
  template <Scalar T, int K, std::size_t N, class Self = Steps>
  requires requires(const ClipVolume& volume, const Simplex<Space::clip, T, K, N>& primitive,
                    NdcPolygon<T, K>& out) {
    Self::clip(volume, primitive, out);
  }
  constexpr void operator()(const Projection<T>& projection,
                            const Simplex<Space::view, T, K, N>& primitive,
                            NdcPolygon<T, K>& out) const {
    (*this)(projection.volume, to_clip(projection, primitive), out);
  }

  template <Scalar T, int K, std::size_t N, class Self = Steps>
  requires requires(const ClipVolume& volume, const Simplex<Space::clip, T, K, N>& primitive,
                    NdcPolygon<T, K>& out) {
    Self::clip(volume, primitive, out);
  }
  constexpr void operator()(const ClipVolume& volume,
                            const Simplex<Space::clip, T, K, N>& primitive,
                            NdcPolygon<T, K>& out) const {
    if (is_beyond_open_side(volume, primitive)) return out.clear();
    Self::clip(volume, primitive, out);
  }
};

// The same for triangles whose attributes are not copied before they are needed:
// Steps::clip(volume, positions, source, out), where `source` gives the attributes.
template <class Steps>
struct StartsAtClipPositions {
  template <Scalar T, int K, class Self = Steps>
  requires requires(const ClipVolume& volume, const std::array<Vec4<T>, 3>& positions,
                    const ViewTriangle<T, K>& source, NdcPolygon<T, K>& out) {
    Self::clip(volume, positions, source, out);
  }
  constexpr void operator()(const Projection<T>& projection, const ViewTriangle<T, K>& triangle,
                            NdcPolygon<T, K>& out) const {
    const std::array positions = {to_clip(projection, triangle[0].position),
                                  to_clip(projection, triangle[1].position),
                                  to_clip(projection, triangle[2].position)};
    if (is_beyond_open_side(projection.volume, positions)) return out.clear();
    Self::clip(projection.volume, positions, triangle, out);
  }

  template <Scalar T, int K, class Self = Steps>
  requires requires(const ClipVolume& volume, const std::array<Vec4<T>, 3>& positions,
                    const ClipTriangle<T, K>& source, NdcPolygon<T, K>& out) {
    Self::clip(volume, positions, source, out);
  }
  constexpr void operator()(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                            NdcPolygon<T, K>& out) const {
    if (is_beyond_open_side(volume, triangle)) return out.clear();
    Self::clip(volume, {triangle[0].position, triangle[1].position, triangle[2].position}, triangle,
               out);
  }
};

// A list of types, for the lists of clippers and scalars.
template <class... Ts>
struct TypeList {
  static constexpr int size = sizeof...(Ts);
};

// Calls f.template operator()<T>() for each type of the list.
template <class... Ts, class F>
constexpr void for_each_type(TypeList<Ts...>, F&& f) {
  (f.template operator()<Ts>(), ...);
}

// The place of T in a list, from 0 on.
template <class T, class... Ts>
constexpr int index_of(TypeList<Ts...>) {
  static_assert((std::same_as<T, Ts> || ...));
  int i = 0;
  (void)((!std::same_as<T, Ts> && (++i, true)) && ...);
  return i;
}

// An entry of a list of clippers: C, and whether its call operators take clip-space primitives
// beside view-space ones. The list holds C to that, so that none is missing where a compiler
// rejects a constraint.
template <class C, bool kTakesClipSpace>
struct ClipperEntry {
  template <std::size_t N>
  struct Checked {
    static_assert(Clipper<C, N>, "no Clipper of view-space primitives with N vertices");
    static_assert(ClipsClipSpace<C, float, 4, N> == kTakesClipSpace,
                  "the call operators take other spaces than the list of clippers says");
    using type = C;
  };
};
template <class C>
using ViewOnly = ClipperEntry<C, false>;
template <class C>
using ViewAndClip = ClipperEntry<C, true>;

// The list of the clippers of primitives with N vertices.
template <std::size_t N, class... Entries>
using ClipperList = TypeList<typename Entries::template Checked<N>::type...>;
template <class... Entries>
using TriangleClippers = ClipperList<3, Entries...>;
template <class... Entries>
using SegmentClippers = ClipperList<2, Entries...>;
template <class... Entries>
using PointClippers = ClipperList<1, Entries...>;

}  // namespace clipscope
