// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distances in clip space that a promise bounds (promise.hpp).
#pragma once

#include "experiments/judge/promise.hpp"
#include "experiments/judge/promise_setting.hpp"

namespace clipscope::experiments {

// Whether the promise holds as far as distances tell. Pre-condition: is_liftable(polygon).
PromiseCheck check_distances(const Promise& promise, const reference::Truth& truth,
                             const ClipVolume& volume, const PromiseSetting& setting,
                             const PolygonView& polygon);

// Whether all vertices are points of clip space: finite, and 1/w not 0.
bool is_liftable(const PolygonView& polygon);

}  // namespace clipscope::experiments
