// SPDX-License-Identifier: GPL-3.0-or-later
//
// What clippers.hpp declares; for the sources that compile the clippers.
#pragma once

#include <vector>

#include "tests/spaces/clippers.hpp"

namespace clipscope::tests {

template <class C, Scalar T, std::size_t N>
ClipperIn<T, N> clipper_in() {
  ClipperIn<T, N> clipper{C::name, C::promise, nullptr, nullptr};
  clipper.from_view = [](const Projection<T>& projection,
                         const Simplex<Space::view, T, K, N>& primitive,
                         NdcPolygon<T, K>& out) { C{}(projection, primitive, out); };
  if constexpr (ClipsClipSpace<C, T, K, N>) {
    clipper.from_clip = [](const ClipVolume& volume, const Simplex<Space::clip, T, K, N>& primitive,
                           NdcPolygon<T, K>& out) { C{}(volume, primitive, out); };
  }
  return clipper;
}

template <Scalar T, std::size_t N>
std::span<const ClipperIn<T, N>> clippers() {
  static const std::vector<ClipperIn<T, N>> all = [] {
    std::vector<ClipperIn<T, N>> found;
    const auto add = [&]<class C>() {
      if constexpr (ClipsViewSpace<C, T, K, N>) found.push_back(clipper_in<C, T, N>());
    };
    using List = std::conditional_t<N == 3, AllClippers, AllSegmentClippers>;
    experiments::for_each_type(List{}, add);
    return found;
  }();
  return all;
}

}  // namespace clipscope::tests
