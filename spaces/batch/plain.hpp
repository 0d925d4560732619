// SPDX-License-Identifier: MIT
//
// The batch clippers in plain C++: what the SIMD code has to answer, bit for bit, and what clips
// for it where it gives up (clip distances, depth clamp, open sides, vertices that aren't finite,
// polygons that rounding has made other than convex, floats that only expansions settle).
#pragma once

#include "spaces/batch/batch.hpp"
#include "spaces/batch/layout.hpp"

namespace clipscope::batch::plain {

// The contracts.
void copy(Method method, const ClipVolume& volume, const VertexArray& in, Output& out);
void reference(Method method, const ClipVolume& volume, const TriangleStreams& in, Output& out);
void indexed(Method method, const ClipVolume& volume, const IndexedMesh& mesh, Output& out);
void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
          Output& out);

// One triangle: writes the polygon's vertices to `out` and returns how many they are.
int cut(Method method, const ClipVolume& volume, int attributes, const float* const vertex[3],
        float* out);
// Writes the floats marked in `open` (not 0) of one vertex of the polygon that
// CorrectlyRounded::cut gives: the one where the boundary passes from line `from` to line `to`.
// Lines 0 to 2 are the triangle's edges, each opposite to its vertex, then come the planes in the
// order of `kAllPlanes`. Pre-condition: all floats are finite.
void write_corner(DepthRange depth, std::size_t floats, const float* const vertex[3], int from,
                  int to, const std::uint32_t* open, float* out);
// vertices: three of a ViewVertexArray.
int cut_full(Method method, const Projection<float>& projection, int attributes,
             const float* vertices, float* out);

}  // namespace clipscope::batch::plain
