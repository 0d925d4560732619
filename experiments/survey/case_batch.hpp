// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hard cases as batches, and primitives of batches as hard cases.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/batch.hpp"

namespace clipscope::experiments {

// Cases that are clipped against the same volume, with as many vertices and attributes. The batch
// refers to numbers of its own, so that it is neither copied nor moved.
struct CaseBatch : Batch {
  explicit CaseBatch(const HardCase& hard_case);
  // Pre-condition: there is one, and all are alike.
  explicit CaseBatch(std::span<const HardCase* const> cases);
  CaseBatch(const CaseBatch&) = delete;
  CaseBatch& operator=(const CaseBatch&) = delete;

 private:
  std::vector<double> own_numbers_;
  std::vector<std::size_t> own_ends_;
};

// The cases in groups of such as fit into one batch, each in the order given; at most `most` in
// one.
std::vector<std::vector<const HardCase*>> alike(std::span<const HardCase* const> cases,
                                                std::size_t most);

// A primitive of a batch; where it comes from, why it is hard and what is expected stay empty.
HardCase case_of(const Batch& batch, std::size_t primitive, std::string name);

}  // namespace clipscope::experiments
