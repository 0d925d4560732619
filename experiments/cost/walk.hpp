// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which triangles of an input are clipped next, so that those of a small list are not always the
// same: a branch predictor learns some thousand triangles by heart, which no renderer's are.
#pragma once

#include <algorithm>
#include <cstddef>

#include "experiments/stage/stage_timing.hpp"

namespace clipscope::experiments::cost {

// What each thread of a contestant does in one run: it clips lists of so many triangles, each in
// calls of kStageBlock at most, until there were `total`.
struct Load {
  std::size_t list = 0, total = 0;
};

// The way of a thread through its part of the input: each run goes on where the last has stopped,
// so that a list comes again only when the part was gone through.
struct Walk {
  std::size_t first, size, next = 0;

  // f(first, count) for the calls of a run; the walk after it.
  template <class F>
  Walk over(const Load& load, F&& f) const {
    Walk walk = *this;
    for (std::size_t done = 0, in_list = 0; done < load.total;) {
      const std::size_t count =
          std::min({kStageBlock, load.list - in_list, size - walk.next, load.total - done});
      f(first + walk.next, count);
      done += count;
      in_list = (in_list + count) % load.list;
      walk.next = (walk.next + count) % size;
    }
    return walk;
  }
};

}  // namespace clipscope::experiments::cost
