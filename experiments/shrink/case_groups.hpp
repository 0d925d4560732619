// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many hard cases as few batches: those with the same volume, projection and number of attributes
// in one, since a guest is asked batch by batch.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// A batch and where its primitives stand among the cases. The batch refers to the numbers.
struct CaseGroup {
  Batch batch;
  std::vector<std::size_t> places;
  std::vector<double> numbers;
};

// Groups keep the order of the cases. Cases with a number that is not finite are in none.
// Pre-condition: all cases have the same kind of primitive, which is no polygon.
std::deque<CaseGroup> grouped(std::span<const HardCase> cases);

}  // namespace clipscope::experiments
