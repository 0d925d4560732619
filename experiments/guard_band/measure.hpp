// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a guard band leaves to the rasteriser, what it can't leave to it, and what it saves: tallies
// of triangles and pixels, pictures, and times.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "experiments/clock/clock.hpp"
#include "experiments/guard_band/band.hpp"
#include "experiments/render/heat_map.hpp"
#include "experiments/survey/draw_scene.hpp"

namespace clipscope::experiments::guard_band {

inline constexpr double kNoSides = std::numeric_limits<double>::infinity();

// All triangles of some views. Pixels are those of a 3840 x 2160 screen.
struct Tally {
  std::int64_t triangles = 0, rejected = 0, side_cut = 0;
  std::int64_t polygons = 0, vertices = 0;
  // Pixels that a rasteriser looks at that goes through each fan triangle's bounding box, scissored
  // to the screen.
  double visited_px = 0;
  double area_px2 = 0;  // of the polygons, with what reaches beyond the screen

  std::int64_t passed() const { return triangles - rejected; }
  // The share of these that had to be cut at a side; 0 if there are none.
  double cut_percent() const;
};

Tally tally_band(std::span<const SampledView> views, const GuardBand& band);
// The same for full clipping: homogeneous/sutherland_hodgman in float. side_cut: those with a
// vertex outside a side of the volume after near and far have cut.
Tally tally_full(std::span<const SampledView> views);

// A rasteriser whose vertex coordinates are signed fixed-point numbers of so many integer bits,
// counted from the middle of a 3840 x 2160 screen.
struct FixedPoint {
  int integer_bits;

  double band_px() const;  // half width of what can be addressed
  GuardBand band() const;
  // Bits of an edge function (b - a) x (p - a) without overflow, at `subpixel_bits` per pixel: two
  // products of differences of two such numbers, subtracted.
  int edge_function_bits(int subpixel_bits) const;
};

// Points: does the full test draw other pixels than near and far alone with scissoring?
struct PointTally {
  std::int64_t points = 0, kept_full = 0, kept_near_far = 0;
  std::int64_t drawn = 0;   // by near and far alone, pixels on the screen
  std::int64_t differ = 0;  // points that one way draws and the other does not
};
// The triangles' vertices, in float.
PointTally tally_points(std::span<const SampledView> views);

// Pictures of polygons that reach beyond the screen, scissored by the rasteriser.
struct Drawing {
  std::optional<GuardBand> band;  // none: full clipping, homogeneous/sutherland_hodgman
  bool snapped = false;           // vertices rounded to 1/256 px, as rasterizers do
};

// The whole scene in float, each triangle clipped as the drawing asks and drawn as a fan.
FrameBuffer draw(const Scene& scene, const View& view, const PictureSize& size,
                 const Drawing& drawing);

// Pixels of which the one picture shows another triangle, or another side of it, than the other.
std::int64_t unlike_pixels(const FrameBuffer& drawn, const FrameBuffer& full);

// The time of a geometry stage with a guard band against that of full clipping, on the same
// triangles in the same rounds.
//
// Both take view-space triangles and write NDC polygons one after the other, in float. What the
// rasteriser spends more is not in it: see Tally.
// Answers are checked before anything is timed: the polygon must lie on the triangle and cover all
// of it that is visible (PromiseChecker); with a band it may reach out of the volume.
struct Times {
  Timing full;                // homogeneous/sutherland_hodgman; ratios refer to it
  Timing scissored;           // homogeneous/guard_band: a band of 16, scissored in software
  std::vector<Timing> bands;  // one for each band given
};

// Pre-condition: there is a triangle.
Times time_bands(std::span<const SampledView> views, std::span<const GuardBand> bands, int rounds);

}  // namespace clipscope::experiments::guard_band
