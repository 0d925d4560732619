// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sign of w: cases of the catalogue and random triangles by pattern x clippers; what each w-plane
// w >= epsilon costs and prevents, by scale; and what clipping after the divide shows.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/experiment.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/w_sign/tables.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array kScales = {1.0,  0.3,  0.1,  0.03, 1e-2, 3e-3,
                                1e-3, 3e-4, 1e-4, 3e-5, 1e-5};  // m

// The cases about w, and those about the scale of homogeneous coordinates.
bool is_about_w(const HardCase& c) {
  return c.primitive == Primitive::triangle &&
         (c.name.starts_with("w_sign/") || c.name.starts_with("scale/"));
}

void judge_cases(const Selection& selection, Table& table) {
  for (const CaseContestant& contestant :
       case_contestants(Primitive::triangle, selection.clipper, selection.scalars)) {
    OutcomeCounts counts{};
    for (const HardCase& c : builtin_catalogue()) {
      if (!is_about_w(c)) continue;
      const Outcome outcome = contestant.answer(c, truth_polygon(c)).comparison.outcome;
      ++counts[static_cast<std::size_t>(outcome)];
    }
    add_w_sign_cases_row(table, contestant, counts);
  }
}

// Clippers of clip space, in float and double as far as they are asked for.
std::vector<AnyContestant> pattern_contestants(const Selection& selection) {
  std::vector<AnyContestant> contestants = selected_contestants(selection);
  std::erase_if(contestants, [](const AnyContestant& any) {
    const std::string_view scalar = scalar_name(any);
    return (scalar != "float" && scalar != "double") ||
           std::visit([](const auto* c) { return c->clip == nullptr; }, any);
  });
  return contestants;
}

void judge_pattern(const Selection& selection, const WPattern& pattern, Table& table,
                   CellRecord& record) {
  const auto contestants = pattern_contestants(selection);
  const std::size_t triangles = selection.sample != 0 ? selection.sample
                                : selection.quick     ? 40
                                                      : 400;
  constexpr std::size_t kChunks = 4;
  Progress progress("w " + pattern_name(pattern), kChunks);
  const auto make_chunk = [&](std::size_t i) {
    return pattern_chunk(pattern, triangles / kChunks, kChunks * selection.seed + i);
  };
  const auto tallies = sweep(kChunks, make_chunk, contestants, progress);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    add_w_sign_pattern_row(table, record, pattern_name(pattern), contestants[i], tallies[i]);
  }
}

void price_epsilon(Table& table) {
  for (const bool depth_clamp : {false, true}) {
    for (const double scale : kScales) {
      for (const auto& [name, surface] :
           {std::pair{"wall", wall_past_the_eye(scale, depth_clamp)},
            std::pair{"floor", floor_beneath_the_eye(scale, depth_clamp)}}) {
        const TruthPolygon truth = truth_polygon(surface);
        for (const WPlaneClipper& clipper : w_plane_clippers()) {
          const auto contestants =
              case_contestants(Primitive::triangle, clipper.clipper, {"double"});
          const CaseAnswer answer = contestants.front().answer(surface, truth);
          add_w_sign_epsilon_row(table, name, surface, scale, clipper,
                                 loss_of(truth, answer.polygon));
        }
      }
    }
  }
}

void count_prevented(const std::string& input, double scale, bool depth_clamp,
                     const std::vector<ClipBatch>& batches, Table& table) {
  const DivisionHazards without = count_hazards(batches, std::nullopt);
  for (const WPlaneClipper& clipper : w_plane_clippers()) {
    add_w_sign_prevented_row(
        table, {input, scale, depth_clamp, clipper, without,
                count_hazards(batches, clipper.epsilon), tally_loss(batches, clipper.clipper)});
  }
}

// The patterns' triangles, all in one batch.
std::vector<ClipBatch> pattern_batch(const Selection& selection, bool depth_clamp) {
  ClipBatch batch{{.depth_clamp = depth_clamp}, {}};
  for (const WPattern& pattern : all_patterns()) {
    const SweepChunk chunk = pattern_chunk(pattern, selection.quick ? 10 : 100, selection.seed);
    batch.triangles.insert(batch.triangles.end(), chunk.clip.begin(), chunk.clip.end());
  }
  return {batch};
}

std::vector<std::string> scenes_behind_the_eye(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"floor", "corridor"};
}

void draw_pictures(const ExperimentContext& context, Table& table, CellRecord& record) {
  const Selection& selection = context.selection();
  std::vector<EyePicture> pictures;
  const PictureSize size = selection.quick ? PictureSize{480, 270} : PictureSize{720, 405};
  pictures.push_back(draw_eye_picture(triangle_behind_the_eye(), size));
  for (const std::string& name : scenes_behind_the_eye(selection)) {
    pictures.push_back(draw_eye_picture(load_selected_scene(selection, name), size));
  }
  for (const EyePicture& picture : pictures) add_w_sign_picture_row(table, picture);
  std::vector<PanelRow> rows;
  for (const EyePicture& picture : pictures) rows.push_back(panel_row(picture));
  write_png(context.out() / "w_sign.png", side_by_side(rows), "clipping after the divide");
  record.pictures.push_back({"w_sign.png",
                             "Surfaces that reach behind the eye: clipped after the divide (left) "
                             "and exactly (right)."});
}

}  // namespace

void run_w_sign(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table cases = w_sign_cases_table(), patterns = w_sign_patterns_table(),
        epsilon = w_sign_epsilon_table();
  Table prevented = w_sign_prevented_table(), pictures = w_sign_pictures_table();
  context.cell("cases", {&cases}, [&](CellRecord&) { judge_cases(selection, cases); });
  for (const WPattern& pattern : all_patterns()) {
    context.cell("w " + pattern_name(pattern), {&patterns},
                 [&](CellRecord& record) { judge_pattern(selection, pattern, patterns, record); });
  }
  context.cell("epsilon", {&epsilon}, [&](CellRecord&) { price_epsilon(epsilon); });
  for (const bool depth_clamp : {false, true}) {
    context.cell(fmt::format("prevented patterns {}", depth_clamp), {&prevented}, [&](CellRecord&) {
      count_prevented("patterns", 1, depth_clamp, pattern_batch(selection, depth_clamp), prevented);
    });
    for (const std::string& name : scenes_behind_the_eye(selection)) {
      for (const double scale : {1.0, 1e-3, 1e-6}) {
        context.cell(fmt::format("prevented {} {:g} {}", name, scale, depth_clamp), {&prevented},
                     [&](CellRecord&) {
                       const Scene scene = load_selected_scene(selection, name);
                       count_prevented(scene.name, scale, depth_clamp,
                                       scaled_batches(scene, scale, depth_clamp, 600), prevented);
                     });
      }
    }
  }
  context.cell("pictures", {&pictures},
               [&](CellRecord& record) { draw_pictures(context, pictures, record); });
  for (const Table* table : {&cases, &patterns, &epsilon, &prevented, &pictures}) {
    context.emit(*table);
  }
  context.emit_file(context.out() / "w_sign.png");
  context.emit(w_sign_loss_plot(epsilon));
  context.finding(w_sign_finding(patterns, epsilon, prevented));
}

}  // namespace clipscope::experiments
