// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contracts that contestants work under: what goes in, and what comes out.
//
//   full     primitives in view space or clip space in, polygons in NDC out (spaces/clipper.hpp)
//   cut      the same up to the divide: polygons in clip space out, of a method that cuts in view
//            space polygons in view space, in its scalar
//   plane    segments of the plane in and out, the window alone clips: no depth, no attributes, as
//            papers on clipping in two dimensions have it
//
// As a stage of a renderer (spaces/batch/batch.hpp), in floats, clip space in and out:
//
//   copy     an array of vertices in; every surviving triangle is written
//   number   twelve streams of coordinates in; inside triangles by number, only cut ones are
//            written
//   indexed  an indexed mesh in; out as in `number`
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace clipscope::experiments {

enum class Contract : std::uint8_t { full, cut, plane, copy, number, indexed };

constexpr std::array<std::string_view, 6> names_of(Contract) {
  return {"full", "cut", "plane", "copy", "number", "indexed"};
}

inline constexpr std::array kStageContracts = {Contract::copy, Contract::number, Contract::indexed};

}  // namespace clipscope::experiments
