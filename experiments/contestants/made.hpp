// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sources that make contestants: one per scalar, since they take long to compile, and one for
// each kind that has a scalar of its own.
#pragma once

#include <vector>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

template <Scalar T>
std::vector<Contestant> made_in();
std::vector<Contestant> made_of_cuts();     // the steps before the divide, in float and double
std::vector<Contestant> made_in_plane();    // of segments in the window, without depth
std::vector<Contestant> made_in_batches();  // the batch clippers, under the full contract
std::vector<Contestant> made_for_stages();  // scalar and batch clippers as stages

// Says what clipper C is; the caller adds how it is prepared, and what else its kind has.
template <class C>
Contestant describe(const Format& format) {
  return {.clipper = C::name,
          .summary = C::summary,
          .source = C::source,
          .format = &format,
          .promise = C::promise};
}

}  // namespace clipscope::experiments
