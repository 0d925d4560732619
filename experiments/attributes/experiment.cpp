// SPDX-License-Identifier: GPL-3.0-or-later
//
// Attributes: planes crossed x clippers x scalars x interpolation modes, at vertices and inside.
#include <fmt/format.h>

#include "experiments/attributes/rows.hpp"
#include "experiments/contestants/fewer_attributes.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/store/piece_record.hpp"

namespace clipscope::experiments::attributes {
namespace {

constexpr std::array<std::string_view, 7> kClippers = {"textbook",
                                                       "view/sutherland_hodgman",
                                                       "homogeneous/sutherland_hodgman",
                                                       "homogeneous/pipeline",
                                                       "cvv/naive",
                                                       "cvv/perspective",
                                                       "barycentric/distance_matrix"};
constexpr int kPoints = 2;  // inside each triangle

void add_rows(const Contestant& contestant, int planes, const Tally& tally,
              TableOf<ErrorRow>& errors, TableOf<FlatRow>& flat) {
  const std::string clipper(contestant.clipper), scalar(contestant.scalar());
  const std::int64_t n = tally.triangles;
  for (int t = 0; t < kTreatments; ++t) {
    const auto treatment = static_cast<Treatment>(t);
    const TreatmentErrors& e = tally[treatment];
    errors.add({treatment, planes, clipper, scalar, n, e.absolute.quantile(0.5), e.absolute.max(),
                e.ulp.quantile(0.5), e.ulp.max(), e.inside});
  }
  const auto percent = [&](std::int64_t part) {
    return n == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(n);
  };
  flat.add({planes, clipper, scalar, n, tally.wrong, percent(tally.first_changed),
            percent(tally.last_changed), percent(tally.constant_changed)});
}

void measure_planes(const Selection& selection, int planes, TableOf<ErrorRow>& errors,
                    TableOf<FlatRow>& flat, PieceRecord& record) {
  const auto triangles = crossing_triangles(planes, selection.sample_or(100, 1000), selection.seed);
  const auto wanted = wanted_values(triangles, kPoints, selection.seed);
  const Batch batch = batch_of(attribute_frustum(), std::span(triangles));
  for (const Contestant* contestant :
       with_attributes(named_contestants(selection, kClippers), kSceneAttributes)) {
    const Tally tally = measure_errors(*contestant, triangles, wanted);
    add_rows(*contestant, planes, tally, errors, flat);
    if (tally.worst == 0) continue;
    record.worst_inputs.push_back(
        worst_input(*contestant, replay_text(batch, tally.worst_at), "attribute", tally.worst));
  }
}

void run(const ExperimentContext& context) {
  TableOf<ErrorRow> errors;
  TableOf<FlatRow> flat;
  Progress progress("attributes by planes crossed", kPlanes);
  for (int planes = 1; planes <= kPlanes; ++planes) {
    context.piece(fmt::format("planes {}", planes), {&errors, &flat}, [&](PieceRecord& record) {
      measure_planes(context.selection(), planes, errors, flat, record);
    });
    progress.advance();
  }
  const std::vector<ErrorRow> rows = errors.rows();
  context.emit(errors, flat, error_plot(rows), inside_plot(rows), treatments_plot(rows));
  context.finding(finding(rows, flat.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "attributes", "What does clipping do to attributes, by planes crossed and interpolation mode?",
    run};

}  // namespace clipscope::experiments::attributes
