// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured of line clippers: outcomes, times, operations.
//
// Exact arithmetic says which segments are accepted, rejected and shortened. Cut divisions are all
// divisions but the four per vertex of the perspective divide: one for each parameter of an
// intersection, and after the divide one more for the attributes of each new end.
#include "experiments/segments/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/selection/select.hpp"
#include "spaces/clippers.hpp"

namespace clipscope::experiments::segments {
namespace {

constexpr std::uint64_t kDivide = 8;  // divisions of two ends, four each
constexpr std::array kKinds = {&OperationCounts::additions, &OperationCounts::multiplications,
                               &OperationCounts::divisions, &OperationCounts::comparisons};

// Sums over segments, by Facts::Kind where they are arrays.
struct Operations {
  OperationCounts total;
  std::array<std::uint64_t, 3> segments{}, cut_divisions{};
  std::uint64_t rejected_free = 0, rejected_undivided = 0;  // segments without a (cut) division
  std::uint64_t ends_moved = 0;  // of the shortened segments, in exact arithmetic
};

// The divisions of the perspective divide: of what is left after the cut in front of it.
std::uint64_t divide_divisions(std::string_view clipper, const Projection<float>& projection,
                               const SceneSegment& segment, bool visible) {
  const auto is_divided = [&](Outcode planes) {
    return cvv::cut_and_divide(projection.volume, planes, to_clip(projection, segment)).has_value();
  };
  if (clipper == CvvLiangBarskyNaive::name) return kDivide;
  if (clipper.starts_with("cvv/")) return is_divided(bit(Plane::near)) ? kDivide : 0;
  if (clipper.starts_with("window/")) return is_divided(~kSidePlanes) ? kDivide : 0;
  return visible ? kDivide : 0;
}

// The counts of one segment, `divide` of its divisions by the perspective divide.
void add(const OperationCounts& counts, std::uint64_t divide, const Facts& facts,
         Operations& operations) {
  for (const auto kind : kKinds) operations.total.*kind += counts.*kind;
  ++operations.segments[facts.kind];
  operations.cut_divisions[facts.kind] += counts.divisions - divide;
  if (facts.kind == Facts::rejected) {
    operations.rejected_free += counts.divisions == divide;
    operations.rejected_undivided += counts.divisions == 0;
  } else if (facts.kind == Facts::shortened) {
    operations.ends_moved += static_cast<std::uint64_t>(facts.ends_outside);
  }
}

OperationsRow row_of(const std::string& mix, const Contestant& contestant, const Operations& o) {
  const auto per = [](std::uint64_t sum, std::uint64_t count) -> std::optional<double> {
    if (count == 0) return std::nullopt;
    return static_cast<double>(sum) / static_cast<double>(count);
  };
  const auto& [accepted, shortened, rejected] = o.segments;
  const auto& [cut_accepted, cut_shortened, cut_rejected] = o.cut_divisions;
  const std::uint64_t all = accepted + shortened + rejected;
  return {.mix = mix,
          .clipper = std::string(contestant.clipper),
          .additions = per(o.total.additions, all),
          .multiplications = per(o.total.multiplications, all),
          .divisions = per(o.total.divisions, all),
          .comparisons = per(o.total.comparisons, all),
          .cut_divisions = per(cut_accepted + cut_shortened + cut_rejected, all),
          .rejected_percent = per(100 * rejected, all),
          .rejected_free_percent = per(100 * o.rejected_free, rejected),
          .rejected_undivided_percent = per(100 * o.rejected_undivided, rejected),
          .divisions_per_accepted = per(cut_accepted, accepted),
          .divisions_per_rejected = per(cut_rejected, rejected),
          .divisions_per_shortened = per(cut_shortened, shortened),
          .moved_ends_per_shortened = per(o.ends_moved, shortened)};
}

// prepare(p): an end of a segment from a point of view space; distance(end): from the plane.
template <class Prepare, class Distance>
IntersectionRow cost_of(std::string form, const Prepare& prepare, const Distance& distance) {
  Random random(1);
  const auto next_end = [&] {
    const glm::dvec3 p = 50.0 * random.in_cube();
    Vec3<Counted> end;
    for (int c = 0; c < 3; ++c) end[c] = Counted(static_cast<float>(p[c]));
    return prepare(end);
  };
  IntersectionRow row{.form = std::move(form)};
  for (int i = 0; i < 1000; ++i) {
    const auto first = next_end(), second = next_end();
    operation_counts() = {};
    const SegmentSide side = cut_segment(distance(first), distance(second)).side;
    const OperationCounts counts = operation_counts();
    if (side == SegmentSide::cut_first || side == SegmentSide::cut_second) {
      for (const auto kind : kKinds) row.cut.*kind = std::max(row.cut.*kind, counts.*kind);
    } else {
      row.divisions_uncut = std::max(row.divisions_uncut, counts.divisions);
    }
  }
  const auto end = next_end();
  operation_counts() = {};
  interpolate(end, end, Counted(0.5f));
  row.point_multiplications = operation_counts().multiplications;
  return row;
}

Projection<Counted> counted_projection(const Frustum<float>& frustum) {
  return projection_from<Counted>(frustum_cast<double>(frustum));
}

IntersectionRow cost_in_clip_space(std::string form, const Frustum<float>& frustum) {
  return cost_of(
      std::move(form),
      [projection = counted_projection(frustum)](const Vec3<Counted>& p) {
        return ClipVertex<Counted, 0>{to_clip(projection, p), {}};
      },
      [&](const auto& end) { return signed_distance(frustum.depth, Plane::left, end); });
}

}  // namespace

std::vector<Tally> judge(const Mix& mix, const Contestants& contestants) {
  std::vector<Tally> tallies(contestants.size());
  for (const SegmentView& v : mix.views) {
    const Batch batch = v.batch();
    const auto truths = truth_polygons(reference::Truth::of_frustum(batch.frustum), batch);
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      const auto comparisons = compare(clip(*contestants[c], batch), truths);
      for (std::size_t i = 0; i < comparisons.size(); ++i) {
        tallies[c].add(comparisons[i], [&] { return replay_text(batch, i); });
      }
    }
  }
  return tallies;
}

std::string wrong_kinds(const Tally& tally) {
  std::vector<std::string> kinds;
  for (std::size_t i = 0; i < tally.outcomes.size(); ++i) {
    if (!is_failure(static_cast<Outcome>(i)) || tally.outcomes[i] == 0) continue;
    kinds.push_back(fmt::format("{} {}", tally.outcomes[i], kOutcomeNames[i]));
  }
  return fmt::format("{}", fmt::join(kinds, ", "));
}

std::vector<Timing> time_clippers(const Mix& mix, const Contestants& contestants,
                                  const ContestClock& clock) {
  std::vector<Batch> batches;
  for (const SegmentView& v : mix.views) batches.push_back(v.batch());
  return time_contestants(batches, contestants,
                          find_contestant("homogeneous/cohen_sutherland", "float", 2), clock);
}

std::vector<OperationsRow> count_operations(const Mix& mix, const Contestants& contestants) {
  std::vector<Operations> operations(contestants.size());
  for (const SegmentView& v : mix.views) {
    const Batch batch = v.batch();
    const Projection<float> projection(v.view.frustum);
    const auto truth = reference::Truth::of_frustum(batch.frustum);
    std::vector<Facts> facts;
    for (const SceneSegment& segment : v.segments) facts.push_back(facts_of(truth, segment));
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      const std::unique_ptr<Runner> runner = contestants[c]->prepare(std::span(&batch, 1));
      for (std::size_t i = 0; i < facts.size(); ++i) {
        operation_counts() = {};
        runner->clip(0, i, 1);
        const OperationCounts counts = operation_counts();
        const bool visible = !runner->answers()[0].empty();
        add(counts, divide_divisions(contestants[c]->clipper, projection, v.segments[i], visible),
            facts[i], operations[c]);
      }
    }
  }
  std::vector<OperationsRow> rows;
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    rows.push_back(row_of(mix.name, *contestants[c], operations[c]));
  }
  return rows;
}

std::vector<IntersectionRow> intersection_costs() {
  const Frustum<float> perspective = identity_view().frustum;
  const Frustum<float> parallel{.kind = ProjectionKind::parallel,
                                .left = -20,
                                .right = 20,
                                .bottom = -20,
                                .top = 20,
                                .near = 1,
                                .far = 100};
  Frustum<float> oblique = parallel;
  oblique.shear_x = 0.5f;
  oblique.shear_y = 0.25f;
  const auto frustum = frustum_cast<Counted>(perspective);
  const PointNormalPlane<Counted> plane{{Counted(1.0f), Counted(2.0f), Counted(3.0f)},
                                        {Counted(0.5f), Counted(0.25f), Counted(2.0f)}};
  const auto in_view_space = [](const Vec3<Counted>& p) { return ViewVertex<Counted, 0>{p, {}}; };
  const auto in_ndc = [projection = counted_projection(perspective)](const Vec3<Counted>& p) {
    return NdcVertex<Counted, 0>{to_ndc(to_clip(projection, p)), {}};
  };
  return {
      cost_of("any plane: n . (x - p) >= 0", in_view_space,
              [&](const auto& end) { return signed_distance(plane, end.position); }),
      cost_of("side of the frustum in view space: near x + left z >= 0", in_view_space,
              [&](const auto& end) { return view_distance(frustum, Plane::left, end.position); }),
      cost_in_clip_space("clip space, perspective: w + x >= 0", perspective),
      cost_in_clip_space("clip space, parallel", parallel),
      cost_in_clip_space("clip space, oblique parallel", oblique),
      cost_of("after the divide: 1 + x >= 0", in_ndc,
              [&](const auto& end) { return signed_distance(frustum.depth, Plane::left, end); })};
}

}  // namespace clipscope::experiments::segments
