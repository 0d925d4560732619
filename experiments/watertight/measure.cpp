// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/measure.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <map>

#include "experiments/report/replay_text.hpp"

namespace clipscope::experiments {
namespace {

std::size_t class_of(Outcode planes) {
  if (planes == 0) return kNoPlane;
  if (std::popcount(planes) > 1) return kSeveralPlanes;
  return static_cast<std::size_t>(std::countr_zero(planes));
}

// The edges of one view, and the triangles beside them.
struct ViewEdges {
  std::vector<CutEdge> edges;
  std::vector<SceneTriangle> triangles;
  std::vector<std::array<std::size_t, 2>> sides;  // of edge e: indices of its triangles
};

ViewEdges view_edges(const Scene& scene, const View& view, std::vector<CutEdge> edges) {
  ViewEdges result{std::move(edges), {}, {}};
  std::map<std::uint32_t, std::size_t> known;
  for (const CutEdge& e : result.edges) {
    std::array<std::size_t, 2>& sides = result.sides.emplace_back();
    for (std::size_t s = 0; s < 2; ++s) {
      const std::uint32_t t = e.edge.triangles[s];
      const auto [place, is_new] = known.emplace(t, result.triangles.size());
      if (is_new) view_triangles(scene, view, t, std::span(&result.triangles.emplace_back(), 1));
      sides[s] = place->second;
    }
  }
  return result;
}

template <class T>
PolygonStream<T, kSceneAttributes> clip_marked(const Contestant<T>& contestant, const View& view,
                                               std::span<const SceneTriangle> triangles) {
  std::vector<ViewTriangle<T, kSceneAttributes>> input;
  const T mark = edge_mark<T>(contestant.name);
  for (const SceneTriangle& t : triangles) input.push_back(marked<T>(t, mark));
  PolygonStream<T, kSceneAttributes> polygons;
  contestant.view(projection_of<T>(view), input, polygons);
  return polygons;
}

template <class T>
using NdcSpan = std::span<const NdcVertex<T, kSceneAttributes>>;

template <class T>
EdgeGap gap_of(const CutEdge& cut, NdcSpan<T> first, NdcSpan<T> second) {
  return edge_gap<T>({first, cut.edge.opposite[0], cut.width_px[0]},
                     {second, cut.edge.opposite[1], cut.width_px[1]});
}

template <class T>
void measure_view(const Contestant<T>& contestant, const View& view, std::size_t view_number,
                  const ViewEdges& in, WatertightTally& tally) {
  const auto polygons = clip_marked(contestant, view, in.triangles);
  for (std::size_t e = 0; e < in.edges.size(); ++e) {
    const CutEdge& cut = in.edges[e];
    const EdgeGap gap = gap_of<T>(cut, polygons[in.sides[e][0]], polygons[in.sides[e][1]]);
    tally.by_class[class_of(cut.planes)][cut.different_neighbours ? 1 : 0].add(gap);
    if (gap.crack_px > tally.worst.gap.crack_px) tally.worst = {gap, view_number, cut};
  }
}

// Every so many edges that `limit` remain; 0: all.
std::vector<CutEdge> thinned(const std::vector<CutEdge>& edges, std::size_t limit) {
  if (limit == 0 || edges.size() <= limit) return edges;
  const std::size_t stride = (edges.size() + limit - 1) / limit;
  std::vector<CutEdge> result;
  for (std::size_t i = 0; i < edges.size(); i += stride) result.push_back(edges[i]);
  return result;
}

template <class T>
constexpr bool rounds(const Contestant<T>*) {
  return ScalarTraits<T>::precision > 0;
}

}  // namespace

void GapTally::add(const EdgeGap& gap) {
  *this += {1, gap.identical, gap.absent, gap.lost, gap.t_junctions, gap.lost_px, gap.crack_px};
}

GapTally& GapTally::operator+=(const GapTally& other) {
  edges += other.edges;
  identical += other.identical;
  absent += other.absent;
  lost += other.lost;
  t_junctions += other.t_junctions;
  lost_px = std::max(lost_px, other.lost_px);
  crack_px = std::max(crack_px, other.crack_px);
  return *this;
}

GapTally WatertightTally::total() const {
  GapTally sum;
  for (const auto& both : by_class) {
    sum += both[0];
    sum += both[1];
  }
  return sum;
}

GapTally WatertightTally::with_different_neighbours() const {
  GapTally sum;
  for (const auto& both : by_class) sum += both[1];
  return sum;
}

std::vector<WatertightTally> measure_watertight(const Scene& scene,
                                                std::span<const AnyContestant> contestants,
                                                const WatertightOptions& options) {
  const std::vector<SharedEdge> edges = shared_edges(scene.mesh);
  std::vector<ViewEdges> all(scene.views.size()), few(scene.views.size());
  tbb::parallel_for(std::size_t{0}, scene.views.size(), [&](std::size_t v) {
    const View& view = scene.views[v];
    const auto cut = cut_edges(scene, view, edges, options.edges_per_view);
    all[v] = view_edges(scene, view, cut);
    few[v] = view_edges(scene, view, thinned(cut, options.exact_edges_per_view));
  });
  std::vector<WatertightTally> tallies(contestants.size());
  tbb::parallel_for(std::size_t{0}, contestants.size(), [&](std::size_t c) {
    std::visit(
        [&](const auto* contestant) {
          const auto& views = rounds(contestant) ? all : few;
          for (std::size_t v = 0; v < views.size(); ++v) {
            measure_view(*contestant, scene.views[v], v, views[v], tallies[c]);
          }
        },
        contestants[c]);
  });
  return tallies;
}

std::string_view watertight_verdict(const AnyContestant& contestant, const GapTally& tally) {
  const bool promised = std::visit([](const auto* c) { return c->promise.watertight; }, contestant);
  if (!promised) return "-";
  return tally.identical + tally.lost == tally.edges ? "kept" : "broken";
}

std::array<SceneTriangle, 2> neighbours_of(const Scene& scene, const View& view,
                                           const SharedEdge& edge) {
  std::array<SceneTriangle, 2> triangles;
  for (std::size_t s = 0; s < 2; ++s) {
    view_triangles(scene, view, edge.triangles[s], std::span(triangles).subspan(s, 1));
  }
  return triangles;
}

ClippedPair clipped_pair(const AnyContestant& contestant, const View& view,
                         const std::array<SceneTriangle, 2>& triangles, const CutEdge& edge) {
  ClippedPair pair;
  std::visit(
      [&]<class T>(const Contestant<T>* c) {
        const auto polygons = clip_marked(*c, view, triangles);
        pair.gap = gap_of<T>(edge, polygons[0], polygons[1]);
        for (std::size_t s = 0; s < 2; ++s) {
          for (const auto& v : polygons[s]) {
            pair.polygons[s].push_back(
                {nearest_double(v.position[0]), nearest_double(v.position[1])});
          }
        }
      },
      contestant);
  return pair;
}

std::string input_text(const std::array<SceneTriangle, 2>& triangles) {
  return hex_line(triangles[0], 0) + "\n" + hex_line(triangles[1], 0);
}

std::string replay_command(const AnyContestant& contestant, const View& view,
                           const std::array<SceneTriangle, 2>& triangles) {
  return fmt::format(
      "printf '%s\\n' '{}' '{}' | clipscope clip --clipper {} --scalar {} {} --depth {} --hex",
      hex_line(triangles[0], 0), hex_line(triangles[1], 0), clipper_name(contestant),
      scalar_name(contestant), frustum_options(view.frustum), depth_option(view.frustum.depth));
}

}  // namespace clipscope::experiments
