// SPDX-License-Identifier: MIT
//
// What a method of the batch clippers says of itself.
//
// A method is a type. For one triangle in float it is a clipper (spaces/clipper.hpp): its call
// operator is the full contract, its `cut` is the stage; it may have one of the two alone. That is
// the plain version, which the SIMD code must give the bits of.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

#include "spaces/clipper.hpp"

namespace clipscope::batch {

// The SIMD code that has the bits of a method.
enum class Simd : std::uint8_t {
  none,         // there is none: the plain version clips
  view_planes,  // plane after plane in view space (planes-inl.hpp)
  clip_planes,  // plane after plane in clip space (planes-inl.hpp)
  clip_lanes,   // the same, as many triangles at once as there are lanes (lanes-inl.hpp)
  originals     // new vertices from the three original ones, in clip space (barycentric-inl.hpp)
};

template <class M>
concept HasStage = CutsInClipSpace<M, float, 4>;

template <class M>
concept HasFull = ClipsViewSpace<M, float, 4>;

// name, summary, source and promise are those of a clipper, the promise that of the full contract.
// May have a type BitsOf as well: the scalar clipper whose bits come out of the stage.
template <class M>
concept BatchMethod = requires {
  requires HasStage<M> || HasFull<M>;
  { M::name } -> std::convertible_to<std::string_view>;  // unique
  { M::summary } -> std::convertible_to<std::string_view>;
  { M::source } -> std::convertible_to<std::string_view>;
  { M::promise } -> std::convertible_to<Promise>;
  requires std::floating_point<typename M::Number>;  // what it computes in, to round to float once
  { M::simd } -> std::convertible_to<Simd>;
};

}  // namespace clipscope::batch
