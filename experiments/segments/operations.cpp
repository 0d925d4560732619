// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/operations.hpp"

#include <algorithm>
#include <array>

#include "experiments/measure/batches.hpp"
#include "experiments/scenes/families.hpp"
#include "experiments/scenes/random.hpp"
#include "spaces/clippers.hpp"

namespace clipscope::experiments {
namespace {

constexpr int K = kSceneAttributes;
constexpr std::uint64_t kDivide = 8;  // two ends, four divisions each

using Segment = ViewSegment<Counted, K>;

// The divisions of the perspective divide: of what is left after the cut in front of it.
std::uint64_t divide_divisions(const Contestant<Counted, 2>& contestant,
                               const Projection<Counted>& projection, const Segment& segment,
                               bool visible) {
  const ClipVolume& volume = projection.volume;
  const auto is_divided = [&](Outcode planes) {
    return cvv::cut_and_divide(volume, planes, to_clip(projection, segment)).has_value();
  };
  if (contestant.name == CvvLiangBarskyNaive::name) return kDivide;
  if (contestant.name.starts_with("cvv/")) return is_divided(bit(Plane::near)) ? kDivide : 0;
  if (contestant.name.starts_with("window/")) return is_divided(~kSidePlanes) ? kDivide : 0;
  return visible ? kDivide : 0;
}

void add(OperationCounts& sum, const OperationCounts& counts) {
  sum.additions += counts.additions;
  sum.multiplications += counts.multiplications;
  sum.divisions += counts.divisions;
  sum.comparisons += counts.comparisons;
}

void keep_largest(OperationCounts& most, const OperationCounts& counts) {
  most.additions = std::max(most.additions, counts.additions);
  most.multiplications = std::max(most.multiplications, counts.multiplications);
  most.divisions = std::max(most.divisions, counts.divisions);
  most.comparisons = std::max(most.comparisons, counts.comparisons);
}

DivisionSum& sum_of(SegmentFacts::Kind kind, SegmentOperations& operations) {
  switch (kind) {
    case SegmentFacts::Kind::accepted: return operations.accepted;
    case SegmentFacts::Kind::shortened: return operations.shortened;
    default: return operations.rejected;
  }
}

void count_one(const Contestant<Counted, 2>& contestant, const Projection<Counted>& projection,
               const Segment& segment, const SegmentFacts& facts, SegmentOperations& operations) {
  PolygonStream<Counted, K> out;
  operation_counts() = {};
  contestant.view(projection, std::span(&segment, 1), out);
  const OperationCounts counts = operation_counts();
  add(operations.total, counts);
  ++operations.segments;
  const std::uint64_t divide = divide_divisions(contestant, projection, segment, !out[0].empty());
  DivisionSum& sum = sum_of(facts.kind, operations);
  ++sum.segments;
  sum.cut_divisions += static_cast<std::int64_t>(counts.divisions - divide);
  sum.without_cut_division += counts.divisions == divide;
  sum.without_division += counts.divisions == 0;
  if (facts.kind == SegmentFacts::Kind::shortened) operations.ends_moved += facts.ends_outside;
}

// cut(a, b) sets the tally to 0 when all is ready, cuts, and returns the cut.
template <class Cut>
IntersectionCost cost_of(std::string form, std::uint64_t point_multiplications, Cut&& cut) {
  IntersectionCost cost{std::move(form), {}, 0, point_multiplications};
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    std::array<Vec3<Counted>, 2> ends;
    for (Vec3<Counted>& end : ends) {
      const glm::dvec3 p = 50.0 * random.in_cube();
      for (int c = 0; c < 3; ++c) end[c] = Counted(static_cast<float>(p[c]));
    }
    const SegmentSide side = cut(ends[0], ends[1]).side;
    const OperationCounts counts = operation_counts();
    if (side == SegmentSide::cut_first || side == SegmentSide::cut_second) {
      keep_largest(cost.cut, counts);
    } else {
      cost.divisions_uncut = std::max(cost.divisions_uncut, counts.divisions);
    }
  }
  return cost;
}

template <class V>
std::uint64_t point_multiplications(const V& a, const V& b) {
  const Counted half(0.5f);
  operation_counts() = {};
  interpolate(a, b, half);
  return operation_counts().multiplications;
}

IntersectionCost in_clip_space(std::string form, const Frustum<float>& frustum) {
  const Projection<Counted> projection = projection_from<Counted>(frustum_cast<double>(frustum));
  using Vertex = ClipVertex<Counted, 0>;
  return cost_of(
      std::move(form), point_multiplications(Vertex{}, Vertex{}),
      [&](const Vec3<Counted>& a, const Vec3<Counted>& b) {
        const Vertex first{to_clip(projection, a), {}}, second{to_clip(projection, b), {}};
        operation_counts() = {};
        return cut_segment(frustum.depth, Plane::left, first, second);
      });
}

IntersectionCost in_ndc(const Frustum<float>& frustum) {
  const Projection<Counted> projection = projection_from<Counted>(frustum_cast<double>(frustum));
  using Vertex = NdcVertex<Counted, 0>;
  return cost_of("after the divide: 1 + x >= 0", point_multiplications(Vertex{}, Vertex{}),
                 [&](const Vec3<Counted>& a, const Vec3<Counted>& b) {
                   const Vertex first{to_ndc(to_clip(projection, a)), {}};
                   const Vertex second{to_ndc(to_clip(projection, b)), {}};
                   operation_counts() = {};
                   return cut_segment(frustum.depth, Plane::left, first, second);
                 });
}

}  // namespace

std::vector<SegmentOperations> count_operations(
    const SegmentMix& mix, std::span<const Contestant<Counted, 2>* const> contestants,
    std::size_t sample) {
  std::vector<SegmentOperations> operations(contestants.size());
  for (const SegmentBatch& batch : mix.batches) {
    const auto truth = reference::Truth::of_frustum(frustum_cast<double>(batch.view.frustum));
    const auto projection = projection_of<Counted>(batch.view);
    const std::vector<Segment> segments = simplices_cast<Counted>(batch.segments);
    for (const std::size_t i : evenly_spaced(segments.size(), sample)) {
      const SegmentFacts facts = facts_of(truth, batch.segments[i]);
      for (std::size_t c = 0; c < contestants.size(); ++c) {
        count_one(*contestants[c], projection, segments[i], facts, operations[c]);
      }
    }
  }
  return operations;
}

std::vector<IntersectionCost> intersection_costs() {
  const Frustum<float> perspective = identity_view().frustum;
  Frustum<float> parallel{.kind = ProjectionKind::parallel};
  parallel.left = parallel.bottom = -20;
  parallel.right = parallel.top = 20;
  parallel.near = 1;
  parallel.far = 100;
  Frustum<float> oblique = parallel;
  oblique.shear_x = 0.5f;
  oblique.shear_y = 0.25f;

  const auto view_frustum = frustum_cast<Counted>(perspective);
  const PointNormalPlane<Counted> plane{{Counted(1.0f), Counted(2.0f), Counted(3.0f)},
                                        {Counted(0.5f), Counted(0.25f), Counted(2.0f)}};
  using ViewEnd = ViewVertex<Counted, 0>;
  const std::uint64_t view_point = point_multiplications(ViewEnd{}, ViewEnd{});
  return {cost_of("any plane: n . (x - p) >= 0", view_point,
                  [&](const Vec3<Counted>& a, const Vec3<Counted>& b) {
                    operation_counts() = {};
                    return cut_segment(plane, a, b);
                  }),
          cost_of("side of the frustum in view space: near x + left z >= 0", view_point,
                  [&](const Vec3<Counted>& a, const Vec3<Counted>& b) {
                    operation_counts() = {};
                    return cut_segment(view_distance(view_frustum, Plane::left, a),
                                       view_distance(view_frustum, Plane::left, b));
                  }),
          in_clip_space("clip space, perspective: w + x >= 0", perspective),
          in_clip_space("clip space, parallel", parallel),
          in_clip_space("clip space, oblique parallel", oblique),
          in_ndc(perspective)};
}

}  // namespace clipscope::experiments
