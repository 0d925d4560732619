// SPDX-License-Identifier: GPL-3.0-or-later
//
// What bounding volumes answered, held against exact arithmetic, triangle by triangle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/bounds/objects.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/bounds/visibility.hpp"

namespace clipscope::experiments {

// Exact verdicts on a view's triangles, in the order of the objects; those of objects that are not
// judged are left out.
struct ExactView {
  std::vector<bool> is_judged;              // by object
  std::vector<reference::Verdict> verdict;  // by triangle

  // Of an object: rejected or accepted if all its triangles are, else it must be looked at.
  Visibility object(const TriangleRange& range) const;
};

// triangles: of the view, in the order of the objects. At most `limit` triangles are judged, those of
// evenly spaced objects; 0: all.
ExactView judge_view(const Objects& objects, std::span<const SceneTriangle> triangles,
                     const Frustum<float>& frustum, std::size_t limit);

// Sums over views; percentages of them are the table's.
struct CullTally {
  std::int64_t objects = 0, rejected = 0, accepted = 0;
  std::int64_t triangles = 0, triangles_rejected = 0, triangles_accepted = 0;

  std::int64_t judged_objects = 0;
  std::int64_t judged = 0;        // triangles with an exact verdict
  std::int64_t visible_lost = 0;  // of these, in the volume though their object was rejected
  std::int64_t accepted_cut = 0;  // of these, not all inside though their object was accepted
  std::int64_t settled = 0;       // judged objects that the bound settled
  std::int64_t settleable = 0;    // judged objects that exact arithmetic settles
};

void add(const Objects& objects, std::span<const Visibility> answers, const ExactView& exact,
         CullTally& tally);

}  // namespace clipscope::experiments
