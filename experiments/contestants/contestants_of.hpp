// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the contestants of one scalar; included once per scalar, each in its own translation unit.
#pragma once

#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "spaces/clippers.hpp"

namespace clipscope::experiments {

// Where: a projection or a volume.
template <class C, class Where, class Primitive, class T, int K>
void clip_batch(const Where& where, std::span<const Primitive> primitives,
                PolygonStream<T, K>& out) {
  NdcPolygon<T, K> polygon;
  for (const Primitive& primitive : primitives) {
    C{}(where, primitive, polygon);
    out.append(polygon);
  }
}

template <class C, class Where, class Primitive, class T>
void clip_one(const Where& where, const Primitive& primitive, NdcPolygon<T, kRunTime>& out) {
  C{}(where, primitive, out);
}

template <class C, Scalar T, std::size_t N>
Contestant<T, N> make_contestant() {
  using Result = Contestant<T, N>;
  Result contestant{.name = C::name,
                    .summary = C::summary,
                    .source = C::source,
                    .promise = C::promise,
                    .view = clip_batch<C>,
                    .clip = nullptr,
                    .view_one = clip_one<C>,
                    .clip_one = nullptr};
  if constexpr (ClipsClipSpace<C, T, Result::K, N>) {
    contestant.clip = clip_batch<C>;
    contestant.clip_one = clip_one<C>;
  }
  return contestant;
}

template <Scalar T, std::size_t N, class... Cs>
std::span<const Contestant<T, N>> contestants_of(TypeList<Cs...>) {
  static const std::vector<Contestant<T, N>> all = [] {
    std::vector<Contestant<T, N>> list;
    const auto add = [&]<class C>() {
      if constexpr (ClipsViewSpace<C, T, kSceneAttributes, N>) {
        list.push_back(make_contestant<C, T, N>());
      }
    };
    (add.template operator()<Cs>(), ...);
    return list;
  }();
  return all;
}

}  // namespace clipscope::experiments
