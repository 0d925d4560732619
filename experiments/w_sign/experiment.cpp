// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sign of w: cases of the catalogue and random triangles by pattern x clippers; what each
// w-plane w >= epsilon costs and prevents, by scale; and what clipping after the divide shows.
#include <fmt/format.h>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/survey/verdicts.hpp"
#include "experiments/w_sign/rows.hpp"

namespace clipscope::experiments::w_sign {
namespace {

constexpr std::array kScales = {1.0,  0.3,  0.1,  0.03, 1e-2, 3e-3,
                                1e-3, 3e-4, 1e-4, 3e-5, 1e-5};  // m

// The cases about w, and those about the scale of homogeneous coordinates.
bool is_about_w(const HardCase& c) {
  return c.primitive == Primitive::triangle &&
         (c.name.starts_with("w_sign/") || c.name.starts_with("scale/"));
}

void judge_catalogue(const Selection& selection, TableOf<CasesRow>& table) {
  for (const Contestant* contestant :
       case_contestants(Primitive::triangle, selection, selection.scalars)) {
    CasesRow row{std::string(contestant->clipper), std::string(contestant->scalar())};
    for (const HardCase& c : builtin_catalogue()) {
      if (!is_about_w(c)) continue;
      const Outcome outcome = judge_case(*contestant, c, truth_polygon(c)).outcome;
      ++row.outcomes[static_cast<std::size_t>(outcome)];
      row.failures += is_failure(outcome);
    }
    table.add(row);
  }
}

// Clippers of clip space, in float and double as far as they are asked for.
void judge_pattern(const Selection& selection, const Pattern& pattern, TableOf<PatternRow>& table,
                   PieceRecord& record) {
  Contestants contestants = selected_contestants(selection);
  std::erase_if(contestants, [](const Contestant* c) {
    return !c->takes_clip_space || (c->scalar() != "float" && c->scalar() != "double");
  });
  constexpr std::size_t kChunks = 4;
  const std::size_t triangles = selection.sample_or(40, 400) / kChunks;
  const std::string name = pattern_name(pattern);
  Progress progress("w " + name, kChunks);
  const auto make_chunk = [&](std::size_t i) {
    return pattern_chunk(pattern, triangles, kChunks * selection.seed + i);
  };
  const std::vector<Tally> tallies = sweep({kChunks, make_chunk}, contestants, progress);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Tally& tally = tallies[i];
    table.add({name, std::string(contestants[i]->clipper), std::string(contestants[i]->scalar()),
               tally.primitives, tally.failures, tally.outcomes});
    if (tally.failing.empty()) continue;
    record.worst_inputs.push_back(
        worst_input(*contestants[i], tally.failing,
                    fmt::format("{}, w {}", name_of(tally.failing_outcome()), name), tally.max_px));
  }
}

// Clippers draw in double, so that rounding plays no part.
void price_epsilon(TableOf<EpsilonRow>& table) {
  for (const bool depth_clamp : {false, true}) {
    for (const double scale : kScales) {
      for (const Surface& surface : kSurfaces) {
        const HardCase hard_case = case_of(surface, scale, depth_clamp);
        const TruthPolygon truth = truth_polygon(hard_case);
        for (const WPlaneClipper& clipper : w_plane_clippers()) {
          const Answers answers = clip_case(find_contestant(clipper.name, "double"), hard_case);
          table.add({std::string(surface.name), depth_name(depth_clamp), scale,
                     hard_case.frustum.near, std::string(clipper.name), clipper.epsilon,
                     loss_of(truth, positions_of(answers[0]))});
        }
      }
    }
  }
}

void count_prevented(const std::string& input, double scale, bool depth_clamp,
                     const std::vector<SweepChunk>& chunks, TableOf<PreventedRow>& table) {
  const Hazards without = count_hazards(chunks, w_plane_clippers().front());
  for (const WPlaneClipper& clipper : w_plane_clippers()) {
    const Hazards with = count_hazards(chunks, clipper);
    table.add({input, scale, depth_name(depth_clamp), std::string(clipper.name), clipper.epsilon,
               with, without.total() - with.total(), tally_loss(chunks, clipper)});
  }
}

std::vector<SweepChunk> pattern_chunks(const Selection& selection, bool depth_clamp) {
  std::vector<SweepChunk> chunks;
  for (const Pattern& pattern : all_patterns()) {
    chunks.push_back(pattern_chunk(pattern, selection.quick ? 10 : 100, selection.seed));
    chunks.back().volume.depth_clamp = depth_clamp;
  }
  return chunks;
}

void draw_pictures(const ExperimentContext& context, const std::vector<std::string>& scenes,
                   TableOf<PictureRow>& table, PieceRecord& record) {
  const Selection& selection = context.selection();
  const PictureSize size = selection.quick ? PictureSize{480, 270} : PictureSize{720, 405};
  std::vector<Picture> pictures = {draw_picture(triangle_behind_the_eye(), size)};
  for (const std::string& name : scenes) {
    pictures.push_back(draw_picture(load_selected_scene(selection, name), size));
  }
  for (const Picture& p : pictures) {
    table.add({p.scene, p.exact.pixels(), p.counts[PixelFate::hole], p.counts[PixelFate::extra],
               p.counts[PixelFate::flipped], 100 * p.counts.share_above_one});
  }
  write_png(context.out() / "w_sign.png", side_by_side(pictures), "clipping after the divide");
  record.pictures.push_back(
      {"w_sign.png",
       "Surfaces that reach behind the eye: clipped after the divide (left) and exactly (right)."});
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const auto scenes = selection.scenes_or({"floor", "corridor"});  // they reach behind the eye
  TableOf<CasesRow> cases;
  TableOf<PatternRow> patterns;
  TableOf<EpsilonRow> epsilon;
  TableOf<PreventedRow> prevented;
  TableOf<PictureRow> pictures;
  context.piece("cases", {&cases}, [&](PieceRecord&) { judge_catalogue(selection, cases); });
  for (const Pattern& pattern : all_patterns()) {
    context.piece("w " + pattern_name(pattern), {&patterns}, [&](PieceRecord& record) {
      judge_pattern(selection, pattern, patterns, record);
    });
  }
  context.piece("epsilon", {&epsilon}, [&](PieceRecord&) { price_epsilon(epsilon); });
  for (const bool depth_clamp : {false, true}) {
    context.piece(fmt::format("prevented patterns {}", depth_clamp), {&prevented},
                  [&](PieceRecord&) {
                    count_prevented("patterns", 1, depth_clamp,
                                    pattern_chunks(selection, depth_clamp), prevented);
                  });
    for (const std::string& name : scenes) {
      for (const double scale : {1.0, 1e-3, 1e-6}) {
        context.piece(fmt::format("prevented {} {:g} {}", name, scale, depth_clamp), {&prevented},
                      [&](PieceRecord&) {
                        const Scene scene = load_selected_scene(selection, name);
                        count_prevented(scene.name, scale, depth_clamp,
                                        scaled_chunks(scene, scale, depth_clamp, 600), prevented);
                      });
      }
    }
  }
  context.piece("pictures", {&pictures},
                [&](PieceRecord& record) { draw_pictures(context, scenes, pictures, record); });
  cases.add_note(machine_description());
  context.emit(cases, patterns, epsilon, prevented, pictures);
  context.emit_file(context.out() / "w_sign.png");
  context.emit(loss_plot(epsilon.rows()));
  context.finding(finding(patterns.rows(), epsilon.rows(), prevented.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "w_sign", "What happens where w <= 0, and what does a plane w >= epsilon cost?", run};

}  // namespace clipscope::experiments::w_sign
