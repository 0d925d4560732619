// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mixes of view-space segments that the line clippers meet each other on.
//
// Drawings: random lines over a square extent, seen through a window that is a part of it. A line starts
// anywhere in the extent and is 1/64 of it to all of it long, every binade of lengths equally likely;
// `long_lines` go from anywhere to anywhere. Their depths stay away from near and far, and the depths of
// both ends are within a factor of two: the sides of the window alone clip.
// Classes: segments that are inside, outside one plane, and so on; exact arithmetic decides which
// (reference/), so that a class holds what its name says.
// Wireframes: the edges of a scene's triangles, from all its views.
//
// Guarantees: the same bits for the same name, seed and size.
// Does not guarantee: that the lengths follow any particular drawing.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/commands/selection.hpp"
#include "experiments/scenes/scene.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {

using SceneSegment = ViewSegment<float, kSceneAttributes>;

// Segments of one view.
struct SegmentBatch {
  View view;
  std::vector<SceneSegment> segments;
};

struct SegmentMix {
  std::string name, description;
  std::vector<SegmentBatch> batches;

  std::size_t size() const;
};

// The names of all mixes that are made here, in the order in which they are shown.
std::vector<std::string> builtin_mixes();

// At least one segment, `size` of them. Errors: UsageError for an unknown name.
SegmentMix make_mix(std::string_view name, std::size_t size, std::uint64_t seed);

// Each edge of the scene's mesh once per view, evenly spaced and at most `size` in all (at least one
// per view). Named "wireframe NAME".
SegmentMix make_wireframe(const Scene& scene, std::size_t size);

// The numbers of at most `sample` of `count` things, evenly spaced. Pre-condition: sample > 0.
std::vector<std::size_t> evenly_spaced(std::size_t count, std::size_t sample);

// What exact arithmetic says about a segment.
struct SegmentFacts {
  int ends_outside = 0;      // of the volume: those that must move if anything is visible
  int crossings = 0;         // planes that some end is outside of, counted per end
  bool share_plane = false;  // both ends are outside the same plane
  bool behind_eye = false;   // some end is: w < 0
  enum class Kind { accepted, shortened, rejected } kind = Kind::rejected;
};

SegmentFacts facts_of(const reference::Truth& truth, const SceneSegment& segment);

std::vector<reference::InputVertex> input_segment(const SceneSegment& segment);

}  // namespace clipscope::experiments
