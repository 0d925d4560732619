// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cuts of all triangle clippers that have one, in float and in double. They have a source of
// their own since GCC bounds what inlining may add to a source: beside whole clippers both would be
// slower.
#include "experiments/contestants/typed.hpp"

namespace clipscope::experiments {
namespace {

// Up to the divide.
template <class C, class Where, Scalar T, Space S, int K, Space kOut>
void cut_block(const Where& where, const PointSize<T>&, std::span<const Triangle<S, T, K>> block,
               PolygonStream<T, K, kOut>& out) {
  for (const Triangle<S, T, K>& triangle : block) {
    if constexpr (S == Space::view && kOut == Space::clip) {
      out.append(C::cut(where.volume, to_clip(where, triangle)));
    } else {
      out.append(C::cut(where, triangle));
    }
  }
}

// The space in which a clipper's polygon is before the divide.
template <class C, Scalar T>
inline constexpr Space kCutSpace =
    CutsInClipSpace<C, T, kSceneAttributes> ? Space::clip : Space::view;

template <class C, Scalar T, int K, Space kOut>
BlockClips<T, K, 3, kOut> cuts_of() {
  BlockClips<T, K, 3, kOut> cuts;
  cuts.view = cut_block<C, Projection<T>, T, Space::view, K, kOut>;
  if constexpr (kOut == Space::clip) cuts.clip = cut_block<C, ClipVolume, T, Space::clip, K, kOut>;
  return cuts;
}

template <class C, Scalar T>
Contestant make_cutting_contestant() {
  constexpr Space kOut = kCutSpace<C, T>;
  Contestant contestant = describe<C>(kFormat<T>);
  contestant.contract = Contract::cut;
  contestant.takes_clip_space = kOut == Space::clip;
  contestant.prepare =
      prepare_blocks(cuts_of<C, T, kSceneAttributes, kOut>(), cuts_of<C, T, kRunTime, kOut>());
  return contestant;
}

template <Scalar T, class... Cs>
void add_cuts(TypeList<Cs...>, std::vector<Contestant>& all) {
  const auto add = [&]<class C>() {
    if constexpr (CutsInViewSpace<C, T, kSceneAttributes> ||
                  CutsInClipSpace<C, T, kSceneAttributes>) {
      all.push_back(make_cutting_contestant<C, T>());
    }
  };
  (add.template operator()<Cs>(), ...);
}

}  // namespace

std::vector<Contestant> made_of_cuts() {
  std::vector<Contestant> all;
  add_cuts<float>(AllClippers{}, all);
  add_cuts<double>(AllClippers{}, all);
  return all;
}

}  // namespace clipscope::experiments
