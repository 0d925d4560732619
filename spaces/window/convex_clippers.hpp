// SPDX-License-Identifier: MIT
//
// The list of the methods that clip segments of the plane by a convex polygon. To add one: write
// its header, include it here and add its name to the list. In which scalars it exists is what its
// call operator takes.
#pragma once

#include "spaces/window/convex_cyrus_beck.hpp"
#include "spaces/window/convex_dual.hpp"
#include "spaces/window/convex_extremes.hpp"
#include "spaces/window/convex_pruning.hpp"
#include "spaces/window/convex_skala.hpp"
#include "spaces/window/convex_skala_homogeneous.hpp"
#include "spaces/window/convex_skala_logarithmic.hpp"

namespace clipscope {

template <class C, class T>
concept ClipsByConvexWindow = requires(const C clip, const ConvexWindow<T>& window,
                                       const Segment2<T>& segment) {
  { C::name } -> std::convertible_to<std::string_view>;     // convex/method, unique
  { C::summary } -> std::convertible_to<std::string_view>;  // one line
  { C::source } -> std::convertible_to<std::string_view>;   // authors, title, year
  { clip(window, segment) } -> std::same_as<std::optional<Segment2<T>>>;
};

using AllConvexWindowClippers =
    TypeList<ConvexCyrusBeck, ConvexSkala, ConvexSkalaLogarithmic, ConvexExtremes,
             ConvexSkalaHomogeneous, ConvexPruning, ConvexDual>;

}  // namespace clipscope
