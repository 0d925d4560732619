// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the contestants of one scalar; included once per scalar, each in its own translation unit.
#pragma once

#include <array>

#include "experiments/contestants/contestant.hpp"
#include "spaces/clippers.hpp"

namespace clipscope::experiments {

template <class C, Scalar T>
Contestant<T> make_contestant() {
  constexpr int K = Contestant<T>::K;
  Contestant<T> contestant{.name = C::name,
                           .summary = C::summary,
                           .source = C::source,
                           .promise = C::promise,
                           .view = nullptr,
                           .clip = nullptr,
                           .view_one = nullptr,
                           .clip_one = nullptr};
  contestant.view = [](const Projection<T>& projection,
                       std::span<const ViewTriangle<T, K>> triangles, PolygonStream<T, K>& out) {
    NdcPolygon<T, K> polygon;
    for (const ViewTriangle<T, K>& triangle : triangles) {
      C{}(projection, triangle, polygon);
      out.append(polygon);
    }
  };
  contestant.view_one = [](const Projection<T>& projection,
                           const ViewTriangle<T, kRunTime>& triangle,
                           NdcPolygon<T, kRunTime>& out) { C{}(projection, triangle, out); };
  if constexpr (ClipsClipTriangles<C, T, K>) {
    contestant.clip = [](DepthRange depth, std::span<const ClipTriangle<T, K>> triangles,
                         PolygonStream<T, K>& out) {
      NdcPolygon<T, K> polygon;
      for (const ClipTriangle<T, K>& triangle : triangles) {
        C{}(depth, triangle, polygon);
        out.append(polygon);
      }
    };
    contestant.clip_one = [](DepthRange depth, const ClipTriangle<T, kRunTime>& triangle,
                             NdcPolygon<T, kRunTime>& out) { C{}(depth, triangle, out); };
  }
  return contestant;
}

template <Scalar T, class... Cs>
std::span<const Contestant<T>> contestants_of(TypeList<Cs...>) {
  static const std::array<Contestant<T>, sizeof...(Cs)> all = {make_contestant<Cs, T>()...};
  return all;
}

}  // namespace clipscope::experiments
