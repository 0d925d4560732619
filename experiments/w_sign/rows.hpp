// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the tables about the sign of w, and what is said of them at the end.
#pragma once

#include "experiments/contestants/columns.hpp"
#include "experiments/judge/outcome.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"
#include "experiments/w_sign/measure.hpp"

namespace clipscope::experiments::w_sign {

// What bounds depth near the eye, as rows have it.
inline std::string depth_name(bool depth_clamp) {
  return depth_clamp ? "depth clamp" : "near plane";
}

struct CasesRow {
  std::string clipper, scalar;
  std::int64_t failures = 0;
  OutcomeCounts outcomes = {};

  static constexpr std::string_view kName = "w_sign";
  static constexpr std::string_view kTitle =
      "What each clipper does with w < 0, w = 0, tiny w and mixed signs";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "The cases of the themes w_sign and scale of the catalogue."};
  static constexpr auto columns() {
    using R = CasesRow;
    return std::tuple(contestant_columns(&R::clipper, &R::scalar),
                      column("failures", "fails", &R::failures),
                      columns_of_array(&R::outcomes, kOutcomeNames));
  }
};

struct PatternRow {
  std::string pattern, clipper, scalar;
  std::int64_t triangles = 0, failures = 0;
  OutcomeCounts outcomes = {};

  static constexpr std::string_view kName = "w_sign_patterns";
  static constexpr std::string_view kTitle =
      "Random clip-space triangles by the signs of w at their vertices";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "-, +: 0.1 to 10 in magnitude; -0, +0: zero of either sign; tiny: FLT_MIN to 1e-5. Vertices in random order. Outcomes of triangles that are visible in the exact answer or in this one. Clippers that need view space have no rows."};
  static constexpr auto columns() {
    using R = PatternRow;
    return std::tuple(column("pattern", "w of the vertices", &R::pattern),
                      contestant_columns(&R::clipper, &R::scalar),
                      column("triangles", &R::triangles), column("failures", "fails", &R::failures),
                      columns_of_array(&R::outcomes, kOutcomeNames));
  }
};

struct EpsilonRow {
  std::string surface, depth;
  double scale_m = 0, near_m = 0;
  std::string clipper;
  std::optional<double> epsilon;
  Loss loss;

  static constexpr std::string_view kName = "w_sign_epsilon";
  static constexpr std::string_view kTitle =
      "Surfaces past the eye: what w >= epsilon cuts away, by scale";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Lost: the exact visible area less the area drawn, on 3840 x 2160; and the depth between the nearest visible and the nearest drawn point. Drawn in double, so that rounding plays no part. With depth clamp near does not cut. A w-plane in front of what is visible costs nothing; behind it, everything in between."};
  static constexpr auto columns() {
    using R = EpsilonRow;
    return std::tuple(
        column("surface", &R::surface), column("depth", &R::depth),
        column("scale_m", "scale [m]", &R::scale_m), column("near_m", "near plane [m]", &R::near_m),
        column("clipper", &R::clipper), column("epsilon", &R::epsilon), group(&R::loss));
  }
};

struct PreventedRow {
  std::string input;
  double scale = 1;
  std::string depth, clipper;
  std::optional<double> epsilon;
  Hazards hazards;
  std::int64_t prevented = 0;
  LossTally loss;

  static constexpr std::string_view kName = "w_sign_prevented";
  static constexpr std::string_view kTitle =
      "What a w-plane prevents, and what it costs, on the same triangles";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "w = 0, w < 0, overflow: triangles whose divisions after clipping meet that, in float, a triangle counted once; 1/w counts. Prevented: how many fewer than without a w-plane. Vanished: triangles of 1 px^2 or more of which nothing is drawn. Lost: visible area not drawn, against the same clip coordinates clipped exactly."};
  static constexpr auto columns() {
    using R = PreventedRow;
    return std::tuple(column("input", &R::input), column("scale", &R::scale),
                      column("depth", &R::depth), column("clipper", &R::clipper),
                      column("epsilon", &R::epsilon), group(&R::hazards),
                      column("prevented", &R::prevented), group(&R::loss));
  }
};

struct PictureRow {
  std::string scene;
  std::size_t pixels = 0;
  std::uint64_t holes_px = 0, extra_px = 0, flipped_px = 0;
  double above_one_texel_percent = 0;

  static constexpr std::string_view kName = "w_sign_pictures";
  static constexpr std::string_view kTitle =
      "What cvv/naive shows of scenes that reach behind the eye, float";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Against the exact picture; both are in w_sign.png."};
  static constexpr auto columns() {
    using R = PictureRow;
    return std::tuple(
        column("scene", &R::scene), column("pixels", &R::pixels),
        column("holes_px", "holes [px]", &R::holes_px),
        column("extra_px", "extra [px]", &R::extra_px),
        column("flipped_px", "flipped [px]", &R::flipped_px),
        column("above_one_texel_percent", "above 1 texel [%]", &R::above_one_texel_percent));
  }
};

// The visible area of the wall that is lost over the scale of the scene, a line for each epsilon
// that loses any.
Plot loss_plot(const std::vector<EpsilonRow>& epsilon);

std::string finding(const std::vector<PatternRow>& patterns, const std::vector<EpsilonRow>& epsilon,
                    const std::vector<PreventedRow>& prevented);

}  // namespace clipscope::experiments::w_sign
