// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs that do a clipper's first steps alone, as contestants (split.cpp). In float and double.
#pragma once

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments::cost {

// The positions of view-space triangles to clip space, or on to NDC; no attributes.
template <class T>
Contestant transforming(Space space);

// The cut of view/sutherland_hodgman, then to clip space.
template <class T>
Contestant cutting_and_transforming();

}  // namespace clipscope::experiments::cost
