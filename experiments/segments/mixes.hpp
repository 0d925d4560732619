// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mixes of view-space segments that the line clippers meet each other on.
//
// Drawings: random lines over a square extent, seen through a window that is a part of it. A line
// starts anywhere in the extent and is 1/64 of it to all of it long, every binade of lengths
// equally likely; `long_lines` go from anywhere to anywhere. Their depths stay away from near and
// far, and the depths of both ends are within a factor of two: the sides of the window alone clip.
// Classes: segments that are inside, outside one plane, and so on; exact arithmetic decides which
// (reference/), so that a class holds what its name says.
// Wireframes: the edges of a scene's triangles, from all its views.
//
// Guarantees: the same bits for the same name, seed and size.
// Does not guarantee: that the lengths follow any particular drawing.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/contestants/batch.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments::segments {

using SceneSegment = ViewSegment<float, kSceneAttributes>;

// Segments of one view.
struct SegmentView {
  View view;
  std::vector<SceneSegment> segments;

  Batch batch() const { return batch_of(view.frustum, std::span(segments)); }
};

struct Mix {
  std::string name;
  std::vector<SegmentView> views;
};

// The names of all mixes that are made here, in the order in which they are shown.
std::vector<std::string> builtin_mixes();

// `size` segments of one view. Errors: UsageError for an unknown name.
Mix make_mix(std::string_view name, std::size_t size, std::uint64_t seed);

// Each edge of the scene's mesh once per view, evenly spaced and at most `size` in all (at least
// one per view). The mix is named "wireframe NAME".
Mix make_wireframe(const Scene& scene, std::size_t size);

// At most `limit` segments of each view, evenly spaced.
Mix thinned(Mix mix, std::size_t limit);

// What exact arithmetic says about a segment.
struct Facts {
  int ends_outside = 0;      // of the volume: those that must move if anything is visible
  int crossings = 0;         // planes that some end is outside of, counted per end
  bool share_plane = false;  // both ends are outside the same plane
  bool behind_eye = false;   // some end is: w < 0
  enum Kind { accepted, shortened, rejected } kind = rejected;
};

Facts facts_of(const reference::Truth& truth, std::span<const reference::InputVertex, 2> ends);
Facts facts_of(const reference::Truth& truth, const SceneSegment& segment);

}  // namespace clipscope::experiments::segments
