// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does a clipper keep what it promises to the bit (spaces/clipper.hpp): total, watertight, invariant
// under rotation of the vertices and under scaling by 2^k?
//
// The clipper is asked again about the triangle rotated, scaled, and beside a neighbour that shares its
// first edge; the answers must have the same bits. Nothing exact is needed.
#pragma once

#include <string>

#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/promise.hpp"

namespace clipscope::experiments {

// What the promise breaks on this triangle; empty if it keeps it. Scaling is tried only where
// coordinates leave room for it in the format; watertightness not where the edge lies in a plane, since
// one side may keep nothing but the edge then.
// Pre-condition: the triangle is finite and has at least one attribute.
template <class T>
std::string broken_bits(const Contestant<T>& contestant, const Frustum<double>& frustum,
                        const ClipVolume& volume, const ViewTriangle<T, kRunTime>& triangle);
// Pre-condition: the clipper takes clip-space triangles.
template <class T>
std::string broken_bits(const Contestant<T>& contestant, const ClipVolume& volume,
                        const ClipTriangle<T, kRunTime>& triangle);

// Breaks the check for this reason, unless it is empty.
void break_by_bits(PromiseCheck& check, const std::string& reason);

}  // namespace clipscope::experiments
