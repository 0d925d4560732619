// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many hard cases as few batches, and where each stands: a guest is asked batch by batch.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "experiments/survey/case_batch.hpp"

namespace clipscope::experiments {

// A batch, and where its primitives stand among the cases.
struct CaseGroup {
  CaseGroup(std::span<const HardCase* const> cases, std::vector<std::size_t> all_places)
      : batch(cases), places(std::move(all_places)) {}

  CaseBatch batch;
  std::vector<std::size_t> places;
};

// Groups keep the order of the cases. Cases with a number that is not finite are in none.
std::deque<CaseGroup> grouped(std::span<const HardCase> cases);

}  // namespace clipscope::experiments
