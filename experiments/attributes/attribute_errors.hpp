// SPDX-License-Identifier: GPL-3.0-or-later
//
// What clippers make of attributes, against what they are in truth, by treatment.
//
// The contestants interpolate attributes as smooth ones. The treatments are the ways in which a pipeline
// gets the other modes out of such a clipper, right or wrong. Only triangles with the right vertices are
// judged: those are matched in order, at the rotation that brings them closest.
// At points inside, the clipper's polygon is drawn as a fan: its values there are computed without rounding
// from its vertices, so that what is measured is the clipper's error alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/attributes/wanted.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/statistics.hpp"

namespace clipscope::experiments {

enum class Treatment : std::uint8_t {
  smooth,   // as it is; wanted and drawn: smooth
  times_w,  // a w through the clipper, times 1/w in its scalar; wanted and drawn: noperspective
  noperspective,  // as it is, though wanted and drawn is noperspective
  flat            // the provoking vertex's value at all vertices; wanted and drawn: smooth
};
inline constexpr int kTreatments = 4;

// Of one treatment. `absolute` and `ulp` have one value for each vertex.
struct TreatmentErrors {
  LogHistogram absolute, ulp;
  double inside = 0;  // the largest at points inside, absolute
};

struct AttributeTally {
  std::int64_t triangles = 0;  // with the right vertices
  std::int64_t wrong = 0;      // without
  std::array<TreatmentErrors, kTreatments> errors;

  // Triangles by what becomes of flat values that differ from vertex to vertex: the polygon's first vertex
  // carries another value than the triangle's; the last vertex of some triangle of its fan does.
  std::int64_t first_changed = 0, last_changed = 0;
  // Triangles in which one value given to all vertices changed a bit.
  std::int64_t constant_changed = 0;

  double worst = 0;          // the largest absolute error of smooth attributes at a vertex
  std::size_t worst_at = 0;  // the triangle that it is on
};

// Clips the triangles and judges them in parallel; the result does not depend on the number of threads.
// Pre-condition: one Wanted for each triangle.
AttributeTally attribute_errors(const AnyContestant& contestant,
                                std::span<const AttributeTriangle> triangles,
                                std::span<const Wanted> wanted);

// What `clipscope explain` must be told to read such a triangle.
std::string attribute_options();

}  // namespace clipscope::experiments
