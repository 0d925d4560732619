// SPDX-License-Identifier: GPL-3.0-or-later
//
// What line clippers cost in operations, machine and compiler aside, by what becomes of a segment.
//
// Exact arithmetic says which segments are accepted, rejected and shortened. Cut divisions are all
// divisions but the four per vertex of the perspective divide: one for each parameter of an
// intersection, and after the divide one more for the attributes of each new end.
#pragma once

#include "experiments/segments/timing.hpp"
#include "spaces/counting.hpp"

namespace clipscope::experiments {

// Sums over segments of one kind.
struct DivisionSum {
  std::int64_t segments = 0;
  std::int64_t cut_divisions = 0;
  std::int64_t without_cut_division = 0;  // segments
  std::int64_t without_division = 0;      // segments that are not even divided by w
};

struct SegmentOperations {
  std::int64_t segments = 0;
  OperationCounts total;
  DivisionSum accepted, shortened, rejected;
  std::int64_t ends_moved = 0;  // of the shortened segments, in exact arithmetic
};

// One for each contestant, in their order, over at most `sample` evenly spaced segments of each batch.
std::vector<SegmentOperations> count_operations(
    const SegmentMix& mix, std::span<const Contestant<Counted, 2>* const> contestants,
    std::size_t sample);

// One segment against one plane, the building block (spaces/plane_segment.hpp), in one of the forms that
// a plane can have.
struct IntersectionCost {
  std::string form;
  OperationCounts cut;                      // to find the parameter where the plane cuts
  std::uint64_t divisions_uncut = 0;        // where it does not
  std::uint64_t point_multiplications = 0;  // the new point, without attributes
};

// The most that any of many random segments costs; the fixed seed makes them the same each time.
std::vector<IntersectionCost> intersection_costs();

}  // namespace clipscope::experiments
