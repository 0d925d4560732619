// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured of the published line clippers in the plane and on hard sets.
#include "experiments/segments/literature.hpp"

#include "experiments/contestants/year.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/selection/replay_text.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/verdicts.hpp"

namespace clipscope::experiments::segments {
namespace {

Tally judge(const Contestant& contestant, const Batch& batch,
            std::span<const TruthPolygon> truths) {
  Tally tally;
  const auto comparisons = compare(clip(contestant, batch), truths);
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    tally.add(comparisons[i], [&] { return replay_text(batch, i); });
  }
  return tally;
}

// What the contestant's method does in the counting scalar; nothing where there is no such form.
std::optional<OperationCounts> operations_of(const Contestant& contestant, const Batch& batch) {
  const Contestant* counting =
      find_in_contract(contestant.clipper, kFormat<Counted>.name, Contract::plane, 2);
  if (counting == nullptr) return std::nullopt;
  const std::unique_ptr<Runner> runner = counting->prepare(std::span(&batch, 1));
  operation_counts() = {};
  runner->clip(0, 0, batch.size());
  return operation_counts();
}

void add_operations(const OperationCounts& counts, std::size_t segments, PlaneRow& row) {
  const auto per_segment = [&](std::uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(segments);
  };
  row.additions = per_segment(counts.additions);
  row.multiplications = per_segment(counts.multiplications);
  row.divisions = per_segment(counts.divisions);
  row.comparisons = per_segment(counts.comparisons);
}

// The timings of those contestants that compute in the scalar, against the baseline in it.
void time_in_scalar(std::string_view scalar, std::span<const Batch> batches,
                    const Contestants& contestants, const ContestClock& clock,
                    std::vector<PlaneRow>& rows) {
  Contestants timed;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (contestants[i]->scalar() != scalar) continue;
    timed.push_back(contestants[i]);
    places.push_back(i);
  }
  if (timed.empty()) return;
  const Contestant& baseline = *find_in_contract(kPlaneBaseline, scalar, Contract::plane, 2);
  const std::vector<Timing> timings = time_contestants(batches, timed, baseline, clock);
  for (std::size_t i = 0; i < timed.size(); ++i) rows[places[i]].timing = if_timed(timings[i]);
}

}  // namespace

Contestants contestants_in(Contract contract, const std::string& clipper_pattern,
                           const std::vector<std::string>& scalars) {
  Contestants found;
  for (const Contestant* full : case_contestants(Primitive::segment, clipper_pattern, scalars)) {
    const Contestant* c = find_in_contract(full->clipper, full->scalar(), contract, 2);
    if (c != nullptr) found.push_back(c);
  }
  return found;
}

std::vector<PlaneRow> measure_in_plane(const ClipSegments& mix, const Contestants& contestants,
                                       std::size_t judged, const ContestClock& clock) {
  const ClipSegments sample = thinned(mix, judged);
  const Batch batch = mix.batch(), sample_batch = sample.batch();
  const auto truths = truth_polygons(reference::Truth::of_clip(sample_batch.volume), sample_batch);
  std::vector<PlaneRow> rows;
  for (const Contestant* c : contestants) {
    const Tally tally = judge(*c, sample_batch, truths);
    PlaneRow& row = rows.emplace_back(PlaneRow{.mix = mix.name,
                                               .year = year_of(c->source),
                                               .clipper = std::string(c->clipper),
                                               .scalar = std::string(c->scalar()),
                                               .visible = sum_of(tally.outcomes),
                                               .wrong = tally.failures,
                                               .wrong_kinds = wrong_kinds(tally),
                                               .max_px = tally.max_px});
    if (!c->format->is_float()) continue;
    const auto counts = operations_of(*c, sample_batch);
    if (counts) add_operations(*counts, sample.size(), row);
  }
  for (const std::string_view scalar : {kFormat<float>.name, kFormat<double>.name}) {
    time_in_scalar(scalar, std::span(&batch, 1), contestants, clock, rows);
  }
  return rows;
}

std::vector<HardRow> judge_hard_set(const ClipSegments& set, const Contestants& contestants) {
  const Batch batch = set.batch();
  const auto truths = truth_polygons(reference::Truth::of_clip(batch.volume), batch);
  std::vector<HardRow> rows;
  for (const Contestant* c : contestants) {
    if (!c->takes(batch)) continue;
    const Tally tally = judge(*c, batch, truths);
    rows.push_back({.set = set.name,
                    .contract = c->contract,
                    .year = year_of(c->source),
                    .clipper = std::string(c->clipper),
                    .scalar = std::string(c->scalar()),
                    .segments = static_cast<std::int64_t>(set.size()),
                    .wrong = tally.failures,
                    .wrong_kinds = wrong_kinds(tally),
                    .first = tally.failing});
  }
  return rows;
}

}  // namespace clipscope::experiments::segments
