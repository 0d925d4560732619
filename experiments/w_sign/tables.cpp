// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/w_sign/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "experiments/measure/machine.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kPlain = "homogeneous/sutherland_hodgman";

std::vector<Column> with_outcomes(std::vector<Column> columns) {
  for (const std::string_view name : kOutcomeNames) {
    columns.push_back({std::string(name), std::string(name)});
  }
  return columns;
}

Cell epsilon_cell(const std::optional<float>& epsilon) {
  if (epsilon) return double{*epsilon};
  return {};
}

Cell length_cell(const std::optional<double>& length) {
  if (length) return *length;
  return {};
}

std::string depth_name(bool depth_clamp) { return depth_clamp ? "depth clamp" : "near plane"; }

}  // namespace

Table w_sign_cases_table() {
  Table table("w_sign", "What each clipper does with w < 0, w = 0, tiny w and mixed signs",
              with_outcomes({{"clipper", "clipper"}, {"scalar", "scalar"}, {"failures", "fails"}}));
  table.add_note("The cases of the themes w_sign and scale of the catalogue.");
  table.add_note(machine_description());
  return table;
}

void add_w_sign_cases_row(Table& table, const CaseContestant& contestant,
                          const OutcomeCounts& counts) {
  std::int64_t failures = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (is_failure(static_cast<Outcome>(i))) failures += counts[i];
  }
  std::vector<Cell> cells = {contestant.clipper, contestant.scalar, failures};
  cells.insert(cells.end(), counts.begin(), counts.end());
  table.add_row(std::move(cells));
}

Table w_sign_patterns_table() {
  Table table("w_sign_patterns", "Random clip-space triangles by the signs of w at their vertices",
              with_outcomes({{"pattern", "w of the vertices"},
                             {"clipper", "clipper"},
                             {"scalar", "scalar"},
                             {"triangles", "triangles"},
                             {"failures", "fails"}}));
  table.add_note(
      "-, +: 0.1 to 10 in magnitude; -0, +0: zero of either sign; tiny: FLT_MIN to 1e-5. Vertices "
      "in "
      "random order. Outcomes of triangles that are visible in the exact answer or in this one. "
      "Clippers that need view space have no rows.");
  return table;
}

void add_w_sign_pattern_row(Table& table, CellRecord& record, const std::string& pattern,
                            const AnyContestant& contestant, const SweepTally& tally) {
  const std::string clipper(clipper_name(contestant)), scalar(scalar_name(contestant));
  std::vector<Cell> cells = {pattern, clipper, scalar, tally.triangles, tally.failures};
  cells.insert(cells.end(), tally.outcomes.begin(), tally.outcomes.end());
  table.add_row(std::move(cells));
  if (tally.failing.empty()) return;
  const std::size_t colon = tally.failing.find(" : ");
  const std::string input = tally.failing.substr(colon + 3);
  record.worst_inputs.push_back(
      {clipper, scalar, fmt::format("{}, w {}", outcome_name(tally.failing_outcome), pattern),
       tally.max_px, input,
       fmt::format("echo '{}' | clipscope explain {} --clipper {} --scalar {}", input,
                   tally.failing.substr(0, colon), clipper, scalar)});
}

Table w_sign_epsilon_table() {
  Table table("w_sign_epsilon", "Surfaces past the eye: what w >= epsilon cuts away, by scale",
              {{"surface", "surface"},
               {"depth", "depth"},
               {"scale_m", "scale [m]"},
               {"near_m", "near plane [m]"},
               {"clipper", "clipper"},
               {"epsilon", "epsilon"},
               {"visible_px2", "visible [px^2]"},
               {"lost_px2", "lost [px^2]"},
               {"lost_percent", "lost [%]"},
               {"nearest_visible_m", "nearest visible [m]"},
               {"nearest_drawn_m", "nearest drawn [m]"},
               {"lost_depth_m", "lost depth [m]"}});
  table.add_note(
      "Lost: the exact visible area less the area drawn, on 3840 x 2160; and the depth between the "
      "nearest visible and the nearest drawn point. Drawn in double, so that rounding plays no "
      "part. "
      "With depth clamp near does not cut. A w-plane in front of what is visible costs nothing; "
      "behind it, everything in between.");
  return table;
}

void add_w_sign_epsilon_row(Table& table, const std::string& surface, const HardCase& hard_case,
                            double scale, const WPlaneClipper& clipper, const VisibleLoss& loss) {
  table.add_row({surface, depth_name(hard_case.volume.depth_clamp), scale, hard_case.frustum.near,
                 std::string(clipper.clipper), epsilon_cell(clipper.epsilon), loss.visible_px2,
                 loss.lost_px2(), 100 * loss.lost_px2() / loss.visible_px2,
                 length_cell(loss.nearest_visible), length_cell(loss.nearest_drawn),
                 length_cell(loss.lost_depth())});
}

Table w_sign_prevented_table() {
  Table table("w_sign_prevented",
              "What a w-plane prevents, and what it costs, on the same triangles",
              {{"input", "input"},
               {"scale", "scale"},
               {"depth", "depth"},
               {"clipper", "clipper"},
               {"epsilon", "epsilon"},
               {"triangles", "triangles"},
               {"zero_w", "w = 0"},
               {"negative_w", "w < 0"},
               {"overflow", "overflow"},
               {"prevented", "prevented"},
               {"vanished", "vanished"},
               {"lost_px2", "lost [px^2]"},
               {"lost_percent", "lost [%]"}});
  table.add_note(
      "w = 0, w < 0, overflow: triangles whose divisions after clipping meet that, in float, a "
      "triangle counted once; 1/w counts. Prevented: how many fewer than without a w-plane. "
      "Vanished: "
      "triangles of 1 px^2 or more of which nothing is drawn. Lost: visible area not drawn, "
      "against the same clip coordinates clipped exactly.");
  return table;
}

void add_w_sign_prevented_row(Table& table, const PreventedRow& r) {
  table.add_row({r.input, r.scale, depth_name(r.depth_clamp), std::string(r.clipper.clipper),
                 epsilon_cell(r.clipper.epsilon), r.with.triangles, r.with.zero_w,
                 r.with.negative_w, r.with.overflow, r.without.total() - r.with.total(),
                 r.loss.vanished, r.loss.lost_px2,
                 r.loss.visible_px2 == 0 ? 0.0 : 100 * r.loss.lost_px2 / r.loss.visible_px2});
}

Table w_sign_pictures_table() {
  Table table("w_sign_pictures", "What cvv/naive shows of scenes that reach behind the eye, float",
              {{"scene", "scene"},
               {"pixels", "pixels"},
               {"holes_px", "holes [px]"},
               {"extra_px", "extra [px]"},
               {"flipped_px", "flipped [px]"},
               {"above_one_texel_percent", "above 1 texel [%]"}});
  table.add_note("Against the exact picture; both are in w_sign.png.");
  return table;
}

void add_w_sign_picture_row(Table& table, const EyePicture& picture) {
  const auto pixels = [&](PixelFate fate) {
    return static_cast<std::int64_t>(picture.counts[fate]);
  };
  table.add_row({picture.scene, static_cast<std::int64_t>(picture.exact.pixels()),
                 pixels(PixelFate::hole), pixels(PixelFate::extra), pixels(PixelFate::flipped),
                 100 * picture.counts.share_above_one});
}

Plot w_sign_loss_plot(const Table& epsilon) {
  Plot plot{.name = "w_sign_epsilon",
            .title = "What a plane w >= epsilon cuts away of a wall past the eye",
            .caption =
                "The part of the visible area that is lost, by the scale of the scene. A scene "
                "in metres loses nothing; the smaller its lengths, the more of it lies "
                "nearer than epsilon.",
            .x = {.label = "scale of the scene [m]", .logarithmic = true},
            .y = {.label = "visible area lost [%]", .from = 0.0, .to = 105.0},
            .series = {}};
  for (const RowView& row : rows_of(epsilon)) {
    if (row.text("surface") != "wall" || row.text("clipper") == kPlain) continue;
    const std::string name =
        fmt::format("w >= {:.2g}, {}", row.number("epsilon"), row.text("depth"));
    auto series = std::ranges::find(plot.series, name, &Series::name);
    if (series == plot.series.end()) {
      series = plot.series.insert(series, Series{.name = name, .x = {}, .y = {}});
    }
    series->x.push_back(row.number("scale_m"));
    series->y.push_back(row.number("lost_percent"));
  }
  std::erase_if(plot.series, [](const Series& s) { return std::ranges::max(s.y) < 0.01; });
  return plot;
}

std::string w_sign_finding(const Table& patterns, const Table& epsilon, const Table& prevented) {
  std::vector<std::string> parts;
  std::int64_t plain = 0, naive = 0, triangles = 0;
  for (const RowView& row : rows_of(patterns)) {
    if (row.text("scalar") != "float") continue;
    if (row.text("clipper") == kPlain) {
      plain += row.count("failures");
      triangles += row.count("triangles");
    }
    if (row.text("clipper") == "cvv/naive") naive += row.count("failures");
  }
  if (triangles > 0) {
    parts.push_back(
        fmt::format("of {} random triangles with every sign of w float clip space fails "
                    "on {}, clipping after the divide on {}",
                    triangles, plain, naive));
  }
  std::int64_t in_patterns = 0, in_scenes = 0, clipped_in_scenes = 0;
  for (const RowView& row : rows_of(prevented)) {
    if (row.text("clipper") != kPlain) continue;
    const std::int64_t hazards =
        row.count("zero_w") + row.count("negative_w") + row.count("overflow");
    (row.text("input") == "patterns" ? in_patterns : in_scenes) += hazards;
    if (row.text("input") != "patterns") clipped_in_scenes += row.count("triangles");
  }
  parts.push_back(fmt::format(
      "without a w-plane {} of {} triangles of scenes, with and without a near plane, leave a "
      "division by 0, by a negative w or an overflow, and {} of the random ones",
      in_scenes, clipped_in_scenes, in_patterns));
  std::set<std::string> told;
  for (const RowView& row : rows_of(epsilon)) {
    if (row.number("lost_percent") < 1 || !told.insert(row.text("clipper")).second) continue;
    parts.push_back(fmt::format("{} loses {:.0f} % of a visible {} in a scene of {:g} m ({})",
                                row.text("clipper"), row.number("lost_percent"),
                                row.text("surface"), row.number("scale_m"), row.text("depth")));
  }
  return fmt::format("{}.", fmt::join(parts, "; "));
}

}  // namespace clipscope::experiments
