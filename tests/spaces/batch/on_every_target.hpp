// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch clippers on each instruction set that this processor has and they are compiled for.
#pragma once

// As the clippers read it.
#include "spaces/batch/targets.hpp"

#include <hwy/highway.h>

#include "spaces/batch/batch.hpp"
#include "tests/catch.hpp"

namespace clipscope::batch::tests {

// Runs f on each in turn.
template <class F>
void on_every_target(F&& f) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    INFO("on " << target_name());
    f();
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace clipscope::batch::tests
