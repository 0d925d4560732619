// SPDX-License-Identifier: MIT
//
// No cut at all: triangles are kept or dropped whole, the shortcut of early games.
//
//   whole/any_outside  drops a triangle if any vertex is outside; leaves holes at the border
//   whole/all_outside  drops a triangle only if all vertices are outside one plane; what is kept
//                      may reach out of the volume, and is left to the rasteriser
//
// Does not guarantee: the contract. That is what they are measured for. whole/all_outside divides
// whatever w it finds: a vertex behind the eye is mirrored, one at w = 0 goes to infinity.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

enum class DropWhen { any_outside, all_outside };

template <DropWhen kDropWhen>
struct WholeTriangle : StartsInClipSpace<WholeTriangle<kDropWhen>> {
  static constexpr bool kAny = kDropWhen == DropWhen::any_outside;
  static constexpr std::string_view name = kAny ? "whole/any_outside" : "whole/all_outside";
  static constexpr std::string_view summary =
      kAny
          ? "no cut: drops a triangle if any vertex is outside (holes at the border)"
          : "no cut: drops a triangle if all vertices are outside one plane (reaches out of the volume)";
  static constexpr std::string_view source = "practice of early real-time renderers";
  static constexpr Promise promise{.domain = Promise::Domain::all_or_nothing,
                                   .covers = !kAny,
                                   .contained = kAny,
                                   .ulps = kProjectUlps,
                                   .watertight = !kAny,
                                   .confined = kAny};

  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                             NdcPolygon<T, K>& out) {
    const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
      return clip_outcode(volume.depth, triangle[i].position);
    });
    out.clear();
    if ((kAny ? code.any : code.all) != 0 || !has_finite_positions(triangle)) return;
    for (const ClipVertex<T, K>& v : triangle) {
      if (!can_divide_by(v.position[3])) {
        out.clear();
        return;
      }
      out.push_back(to_ndc(v));
    }
    clear_if_overflowed(out);
  }
};

using WholeAnyOutside = WholeTriangle<DropWhen::any_outside>;
using WholeAllOutside = WholeTriangle<DropWhen::all_outside>;

}  // namespace clipscope
