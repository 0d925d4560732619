// SPDX-License-Identifier: GPL-3.0-or-later
//
// Guests may take fewer attributes than a batch has: they are asked without the others, and their
// answers have as many as they take.
#pragma once

#include <variant>
#include <vector>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// A batch with the first attributes of another one, in numbers of its own.
class NarrowBatch {
 public:
  // most: attributes that are left, the distances to planes, which lead them, included.
  NarrowBatch(const Batch& batch, int most);
  NarrowBatch(const NarrowBatch&) = delete;  // the batch refers to the numbers
  NarrowBatch& operator=(const NarrowBatch&) = delete;

  const Batch& batch() const { return batch_; }

 private:
  std::variant<std::vector<float>, std::vector<double>> numbers_;
  Batch batch_;
};

// Whether a contestant that takes so many attributes is asked without some of the batch's.
bool has_more_attributes(const Batch& batch, int most);

// Without those that take fewer attributes.
Contestants with_attributes(Contestants contestants, int attributes);

// Prepares from narrow batches. What has no more attributes goes in as it is, so that nothing
// stands between the clock and the guest.
decltype(Contestant::prepare) with_fewer_attributes(decltype(Contestant::prepare) prepare,
                                                    int most);

}  // namespace clipscope::experiments
