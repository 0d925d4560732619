// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time of clipping all objects of a view, with bounding volumes and without.
//
// Without, every triangle goes through the clipper. With, a rejected object's triangles are left out,
// an accepted one's are projected and divided, the others' clipped; making the view's planes and
// testing the volumes is in the time. Triangles are in view space before: what is saved by not moving rejected ones there is not
// counted. Polygons are the same, bit for bit: that is checked before anything is timed.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/bounds/culler.hpp"
#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// A clipper in float and a view of a scene, ready to be clipped.
class CulledView {
 public:
  // triangles: in the order of the objects. Everything given must outlive this.
  CulledView(const Contestant<float>& clipper, const View& view, const Objects& objects,
             std::span<const SceneTriangle> triangles);

  // What differs between the polygons with the answers and without; empty if nothing does.
  std::string first_difference(std::span<const Visibility> answers);

  // ns per triangle of the whole view.
  double clip_all();
  double clip_culled(const Culler& culler);

 private:
  template <class Work>
  double timed(Work&& work);
  void clip(const TriangleRange& range);
  void project(const TriangleRange& range);
  // Empties the output before it leaves the cache.
  void make_room();

  const Contestant<float>& clipper_;
  const View& view_;
  const Objects& objects_;
  std::span<const SceneTriangle> triangles_;
  Projection<float> projection_;
  std::vector<Visibility> answers_;
  PolygonStream<float, kSceneAttributes> out_;
};

}  // namespace clipscope::experiments
