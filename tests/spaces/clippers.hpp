// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every clipper in every scalar behind two plain function pointers, so that a test is compiled once
// per scalar and not once per clipper. The clippers themselves are compiled in clippers_in_*.cpp.
#pragma once

#include <span>
#include <string_view>

#include "tests/spaces/triangles.hpp"

namespace clipscope::tests {

// A clipper of triangles (N = 3) or segments (N = 2) in T, with K attributes.
template <Scalar T, std::size_t N>
struct ClipperIn {
  using Number = T;

  std::string_view name;
  Promise promise;
  void (*from_view)(const Projection<T>&, const Simplex<Space::view, T, K, N>&, NdcPolygon<T, K>&);
  // Null where the clipper takes view space only.
  void (*from_clip)(const ClipVolume&, const Simplex<Space::clip, T, K, N>&, NdcPolygon<T, K>&);

  bool takes_clip_space() const { return from_clip != nullptr; }

  NdcPolygon<T, K> operator()(const Simplex<Space::view, T, K, N>& primitive,
                              const Projection<T>& projection = Projection<T>(Frustum<T>{})) const {
    NdcPolygon<T, K> out;
    from_view(projection, primitive, out);
    return out;
  }
  // Pre-condition: takes_clip_space().
  NdcPolygon<T, K> operator()(const Simplex<Space::clip, T, K, N>& primitive,
                              const ClipVolume& volume = {}) const {
    NdcPolygon<T, K> out;
    from_clip(volume, primitive, out);
    return out;
  }
};

// The clippers that there are in T, in the order of spaces/clippers.hpp.
template <Scalar T, std::size_t N = 3>
std::span<const ClipperIn<T, N>> clippers();

// Calls f(clipper) for each clipper in each scalar; its type is clipper.Number.
template <class Scalars = experiments::AllScalars, std::size_t N = 3, class F>
void for_every_clipper(F&& f) {
  experiments::for_each_type(Scalars{}, [&]<class T>() {
    for (const ClipperIn<T, N>& clipper : clippers<T, N>()) {
      INFO(clipper.name << " in " << experiments::kFormat<T>.name);
      f(clipper);
    }
  });
}

// The scalar of such a clipper.
template <class Clipper>
using NumberOf = typename std::remove_cvref_t<Clipper>::Number;

// Whether a clipper keeps the contract for every view-space triangle, by its promise.
inline bool keeps_contract(const Promise& promise) {
  return promise.covers && promise.contained && promise.attributes &&
         promise.domain != Promise::Domain::in_front;
}

// Whether it keeps it for every clip-space triangle.
template <Scalar T, std::size_t N>
bool keeps_clip_contract(const ClipperIn<T, N>& clipper) {
  return clipper.takes_clip_space() && keeps_contract(clipper.promise) &&
         clipper.promise.domain == Promise::Domain::any;
}

}  // namespace clipscope::tests
