// SPDX-License-Identifier: GPL-3.0-or-later
//
// One scene taken apart into objects, through all its views, by every kind of bounding volume: what
// the bounds answered, held against exact arithmetic triangle by triangle, and the time of clipping
// with bounds and without.
//
// Without, every triangle goes through the clipper. With, a rejected object's triangles are left
// out, an accepted one's are projected and divided, the others' clipped; making the view's planes
// and testing the volumes is in the time. Triangles are in view space before: what is saved by not
// moving rejected ones there is not counted.
#pragma once

#include <memory>
#include <string_view>

#include "experiments/bounds/objects.hpp"
#include "experiments/clock/clock.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/contestants/polygon_stream.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments::bounds {

// Exact verdicts on a view's triangles, in the order of the objects. Some objects are not judged.
struct ExactView {
  std::vector<bool> is_judged;              // by object
  std::vector<reference::Verdict> verdict;  // by triangle

  // An object is rejected or accepted if all its triangles are; else it must be looked at.
  Visibility object(const TriangleRange& range) const;
};

// triangles: of the view, in the order of the objects. At most `limit` triangles are judged, those
// of evenly spaced objects; 0: all.
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

// A clipper in float and a view of a scene, ready to be clipped.
class CulledView {
 public:
  // triangles: in the order of the objects. Everything given must outlive this, and this its tasks.
  CulledView(const Contestant& clipper, const View& view, const Objects& objects,
             std::span<const SceneTriangle> triangles);

  // What differs between the polygons with the answers and without; empty if every bit is the same.
  std::string first_difference(std::span<const Visibility> answers);

  // Each clips the whole view; triangles are what is counted. The checks hold the clipper to its
  // promise, and a culler to the same polygons.
  Task clip_all();
  Task clip_culled(const Culler& culler);

 private:
  void clip(const TriangleRange& range) { runner_->clip(0, range.first, range.count); }
  void project(const TriangleRange& range);
  // What is drawn of an object whose bound gives the answer.
  Answers drawn(const TriangleRange& range, Visibility answer);

  const Contestant& clipper_;
  const View& view_;
  const Objects& objects_;
  std::span<const SceneTriangle> triangles_;
  Batch batch_;
  Projection<float> projection_;
  std::unique_ptr<Runner> runner_;
  std::vector<Visibility> answers_;
  PolygonStream<float, kSceneAttributes> projected_;
};

struct Options {
  int rounds = 21;
  std::size_t judged_triangles = 0;  // of each view, by exact arithmetic; 0: all
};

struct Result {
  std::string_view bound;
  CullTally tally;
  // Means over the views, round by round; the ratio is that of `with` to `without`. Where polygons
  // differ from those without, both are refused.
  Timing without, with;
};

// One result per kind of volume that the objects allow, in the order of bound_kinds().
std::vector<Result> measure(const ObjectScene& scene, const Contestant& clipper,
                            const Options& options);

}  // namespace clipscope::experiments::bounds
