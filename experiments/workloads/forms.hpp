// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every form in which a hard case can be drawn.
#pragma once

#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

// The plain call of the case first (see plain_call), called by its name; then, each called "name
// (form)":
//   order        triangles and polygons as strip, fan, indexed, rotated, reversed; segments as a
//                strip, indexed, reversed; provoking by the other vertex
//   volume       the other depth range; depth clamp; 1 clip distance and as many as there are
//   window       256 px; a viewport that lies beside the target; one of 8192 px, its middle and its
//                corners in the target
//   points       of 2, 5 and 16 px
//   quantities   each alone, gl_PrimitiveID too
// A case in view space is drawn by its clip coordinates, rounded once to float; sides that are open
// are closed, and a clamp of one plane of depth becomes one of both. Of a driver without the case's
// depth range the other one takes its place. Forms whose numbers are no floats are left out.
// A form may be one that the driver can't draw (`inability`).
std::vector<DrawCall> forms_of(const HardCase& hard_case, const DriverInfo& info);

}  // namespace clipscope::experiments
