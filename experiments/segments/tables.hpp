// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the line clippers and their rows.
#pragma once

#include "experiments/report/table.hpp"
#include "experiments/segments/judge.hpp"
#include "experiments/segments/operations.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

// Mix x clipper x scalar: time, ratio to the baseline, what is wrong, error.
Table segment_times_table();
// Adds a row, and to the record the samples and the worst inputs.
void add_time(const SegmentMix& mix, const SegmentContestant& contestant, const Timing& timing,
              const SegmentTally& tally, Table& table, CellRecord& record);

// Mix x clipper: operations per segment, and divisions by what becomes of a segment.
Table operations_table();
void add_operations(const SegmentMix& mix, const Contestant<Counted, 2>& contestant,
                    const SegmentOperations& operations, Table& table);

// One segment against one plane, by the plane's form.
Table intersection_table();
void add_intersection(const IntersectionCost& cost, Table& table);

}  // namespace clipscope::experiments
