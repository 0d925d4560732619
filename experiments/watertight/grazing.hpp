// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of triangles whose shared edge all but lies in a plane of the volume: where rounding decides on
// which side of that plane a new vertex of the edge is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

inline constexpr std::string_view kGrazing = "grazing";

// `pairs` pairs in view space, named "grazing". The ends of a shared edge are random points on a plane,
// up to 2^-12 of their distance off it and at random inside or outside of other planes; one triangle
// reaches far beyond the plane, the other one stays within, so that only one is cut by it.
Scene make_grazing_scene(std::size_t pairs, std::uint64_t seed);

}  // namespace clipscope::experiments
