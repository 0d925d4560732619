// SPDX-License-Identifier: GPL-3.0-or-later
//
// Attributes: planes crossed x clippers x scalars x interpolation modes, at vertices and inside.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "experiments/attributes/attribute_errors.hpp"
#include "experiments/attributes/tables.hpp"
#include "experiments/experiment.hpp"
#include "experiments/perspective/named_contestants.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/report/replay_text.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::string_view, 7> kClippers = {"textbook",
                                                       "view/sutherland_hodgman",
                                                       "homogeneous/sutherland_hodgman",
                                                       "homogeneous/pipeline",
                                                       "cvv/naive",
                                                       "cvv/perspective",
                                                       "barycentric/distance_matrix"};
constexpr std::size_t kTriangles = 1000, kQuickTriangles = 100;  // for each number of planes
constexpr int kPoints = 2;                                       // inside each triangle

std::vector<Wanted> wanted_of(const std::vector<AttributeTriangle>& triangles, std::uint64_t seed) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(attribute_frustum()));
  std::vector<Wanted> wanted(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
    wanted[i] = wanted_values(truth, triangles[i], kPoints, seed + i);
  });
  return wanted;
}

WorstInput worst_input(const AnyContestant& contestant, const AttributeTriangle& triangle,
                       double error) {
  const std::string input = hex_line(triangle);
  return {std::string(clipper_name(contestant)),
          std::string(scalar_name(contestant)),
          "attribute",
          error,
          input,
          fmt::format("echo '{}' | clipscope explain {} --clipper {} --scalar {}", input,
                      attribute_options(), clipper_name(contestant), scalar_name(contestant))};
}

void measure_planes(const Selection& selection, int planes, AttributeTables& tables,
                    CellRecord& record) {
  const std::size_t count = selection.sample != 0 ? selection.sample
                            : selection.quick     ? kQuickTriangles
                                                  : kTriangles;
  const auto triangles = crossing_triangles(planes, count, selection.seed);
  const auto wanted = wanted_of(triangles, selection.seed);
  for (const AnyContestant& contestant : named_contestants(selection, kClippers)) {
    const AttributeTally tally = attribute_errors(contestant, triangles, wanted);
    add_tally(tables, planes, contestant, tally);
    if (tally.worst > 0) {
      record.worst_inputs.push_back(
          worst_input(contestant, triangles[tally.worst_at], tally.worst));
    }
  }
}

}  // namespace

void run_attributes(const ExperimentContext& context) {
  AttributeTables tables;
  Progress progress("attributes by planes crossed", kPlanes);
  for (int planes = 1; planes <= kPlanes; ++planes) {
    context.cell(
        fmt::format("planes {}", planes), {&tables.errors, &tables.flat},
        [&](CellRecord& record) { measure_planes(context.selection(), planes, tables, record); });
    progress.advance();
  }
  context.emit(tables.errors);
  context.emit(tables.flat);
  context.emit(error_over_planes(tables));
  context.emit(error_inside(tables));
  context.emit(error_of_treatments(tables));
  context.finding(attributes_finding(tables));
}

}  // namespace clipscope::experiments
