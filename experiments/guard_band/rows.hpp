// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the guard band's tables, and what is said of them at the end.
#pragma once

#include "experiments/guard_band/measure.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::guard_band {

enum class Method { full, band, scissored };
constexpr std::array<std::string_view, 3> names_of(Method) { return {"full", "band", "scissored"}; }

struct WorkRow {
  std::string scene;
  Method method = Method::full;
  std::optional<double> band;
  std::int64_t triangles = 0;
  double reach_percent = 0;
  std::optional<double> cut_percent;
  double vertices_per_polygon = 0, visited_ratio = 0, area_ratio = 0;
  std::optional<Timing> timing;

  static constexpr std::string_view kName = "guard_band";
  static constexpr std::string_view kTitle =
      "Sides left to the rasteriser beyond a guard band, float";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Band: half width in half widths of the screen; -: no side is ever cut. Full: homogeneous/sutherland_hodgman; scissored: homogeneous/guard_band, which also scissors. Reach: triangles not outside one plane; cut: of those, cut at a side of the band.",
      "Visited, area: pixels in the bounding boxes (within 3840 x 2160) of what is drawn, and its area with what reaches beyond the screen, over those of full clipping. x full: full clipping's time over this one's in the same round; band 1 is full clipping by the bands' code."};
  static constexpr auto columns() {
    using R = WorkRow;
    return std::tuple(
        column("scene", &R::scene), column("method", &R::method), column("band", &R::band),
        column("triangles", &R::triangles), column("reach_percent", "reach [%]", &R::reach_percent),
        column("cut_percent", "cut [%]", &R::cut_percent),
        column("vertices_per_polygon", "vertices", &R::vertices_per_polygon),
        column("visited_ratio", "visited x", &R::visited_ratio),
        column("area_ratio", "area x", &R::area_ratio),
        group(&R::timing,
              Timing::columns("ns_per_triangle", "ns/tri", "speedup_to_full", "x full")));
  }
};

struct FixedRow {
  std::string scene;
  int integer_bits = 0;
  double band_px = 0, band_x = 0, band_y = 0;
  std::int64_t cut_triangles = 0;
  double cut_percent = 0;
  int edge_function_bits = 0;

  static constexpr std::string_view kName = "guard_band_fixed";
  static constexpr std::string_view kTitle =
      "Triangles that leave what fixed-point vertices can address";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Signed coordinates with so many integer bits, counted from the middle of 3840 x 2160 px. Cut: of the triangles not outside one plane. Edge function: bits without overflow at 8 sub-pixel bits."};
  static constexpr auto columns() {
    using R = FixedRow;
    return std::tuple(
        column("scene", &R::scene), column("integer_bits", "integer bits", &R::integer_bits),
        column("band_px", "band [px]", &R::band_px), column("band_x", "band in x", &R::band_x),
        column("band_y", "band in y", &R::band_y),
        column("cut_triangles", "cut", &R::cut_triangles),
        column("cut_percent", "cut [%]", &R::cut_percent),
        column("edge_function_bits", "edge function [bit]", &R::edge_function_bits));
  }
};

struct PointsRow {
  std::string scene;
  PointTally tally;

  static constexpr std::string_view kName = "guard_band_points";
  static constexpr std::string_view kTitle =
      "Points tested by near and far alone, the sides by the pixel";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Drawn: kept by near and far, on a pixel of 3840 x 2160. Differ: of these, not kept by all six planes. The triangles' vertices as points of one pixel."};
  static constexpr auto columns() {
    using R = PointsRow;
    using T = PointTally;
    return std::tuple(
        column("scene", &R::scene),
        group(&R::tally, std::tuple(column("points", &T::points),
                                    column("kept_full", "kept by all planes", &T::kept_full),
                                    column("kept_near_far", "by near, far", &T::kept_near_far),
                                    column("drawn", &T::drawn), column("differ", &T::differ))));
  }
};

struct PictureRow {
  std::string scene;
  Method method = Method::full;
  std::optional<double> band;
  std::string vertices;
  std::int64_t holes_px = 0, extra_px = 0, unlike_full_px = 0;
  double max_error_texel = 0, median_error_texel = 0;

  static constexpr std::string_view kName = "guard_band_pictures";
  static constexpr std::string_view kTitle = "The scissored picture against the exact one";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Vertices: float, or rounded to 1/256 px. Holes, extra: pixels covered in one picture only. Unlike full: another triangle than with full clipping of the same vertices. Error: of texture coordinates at pixel centres against exact, in texels of a 1024-texel texture."};
  static constexpr auto columns() {
    using R = PictureRow;
    return std::tuple(column("scene", &R::scene), column("method", &R::method),
                      column("band", &R::band), column("vertices", &R::vertices),
                      column("holes_px", "holes [px]", &R::holes_px),
                      column("extra_px", "extra [px]", &R::extra_px),
                      column("unlike_full_px", "unlike full [px]", &R::unlike_full_px),
                      column("max_error_texel", "max error [texel]", &R::max_error_texel),
                      column("median_error_texel", "median [texel]", &R::median_error_texel));
  }
};

// The share of triangles that must be cut at a side, over the band, by scene.
Plot cut_plot(const std::vector<WorkRow>& work);
// Full clipping's time over the band's, over the band, by scene, with intervals.
Plot time_plot(const std::vector<WorkRow>& work);

std::string finding(const std::vector<WorkRow>& work, const std::vector<PictureRow>& pictures);

}  // namespace clipscope::experiments::guard_band
