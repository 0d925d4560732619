// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/measure.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "experiments/selection/replay_text.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/draw_scene.hpp"

namespace clipscope::experiments::watertight {
namespace {

using Pair = std::array<SceneTriangle, 2>;

// The triangles of an edge in view space.
Pair neighbours_of(const Scene& scene, const View& view, const SharedEdge& edge) {
  Pair triangles;
  for (std::size_t s = 0; s < 2; ++s) {
    view_triangles(scene, view, edge.triangles[s], std::span(triangles).subspan(s, 1));
  }
  return triangles;
}

SharedEdge edge_of(const WorstRow& row) {
  return {{row.first_triangle, row.second_triangle}, {row.first_corner, row.second_corner}};
}

// The edges of one view, and the two triangles beside each.
struct ViewEdges {
  std::vector<CutEdge> edges;
  std::vector<SceneTriangle> triangles = {};
};

ViewEdges view_edges(const Scene& scene, const View& view, std::vector<CutEdge> edges) {
  ViewEdges result{std::move(edges)};
  for (const CutEdge& e : result.edges) {
    const Pair pair = neighbours_of(scene, view, e.edge);
    result.triangles.insert(result.triangles.end(), pair.begin(), pair.end());
  }
  return result;
}

Answers clip_marked(const Contestant& contestant, const View& view,
                    std::span<const SceneTriangle> triangles) {
  std::vector<SceneTriangle> input;
  for (const SceneTriangle& t : triangles) input.push_back(marked(t, contestant));
  return clip(contestant, batch_of(view, input));
}

EdgeGap gap_of(const CutEdge& cut, const PolygonView& first, const PolygonView& second) {
  return edge_gap({first, cut.edge.opposite[0], cut.width_px[0]},
                  {second, cut.edge.opposite[1], cut.width_px[1]});
}

EdgeClass class_of(Outcode planes) {
  if (planes == 0) return EdgeClass::none;
  if (std::popcount(planes) > 1) return EdgeClass::several;
  return static_cast<EdgeClass>(std::countr_zero(planes));
}

void measure_view(const Contestant& contestant, const View& view, const ViewEdges& in,
                  Measured& out) {
  const Answers polygons = clip_marked(contestant, view, in.triangles);
  for (std::size_t e = 0; e < in.edges.size(); ++e) {
    const CutEdge& cut = in.edges[e];
    const EdgeGap gap = gap_of(cut, polygons[2 * e], polygons[2 * e + 1]);
    const GapTally one{1,           gap.identical, gap.absent, gap.lost, gap.t_junctions,
                       gap.lost_px, gap.crack_px};
    const Neighbours n = cut.different_neighbours ? Neighbours::different : Neighbours::same;
    out.row.all += one;
    if (cut.different_neighbours) out.row.different += one;
    out.by_class[{class_of(cut.planes), n}] += one;
    if (gap.crack_px <= out.worst.crack_px) continue;
    const auto& [triangles, opposite] = cut.edge;
    out.worst = {out.row.scene, out.row.clipper, out.row.scalar, view.label,  triangles[0],
                 triangles[1],  opposite[0],     opposite[1],    gap.crack_px};
  }
}

Verdict verdict(const Contestant& contestant, const GapTally& tally) {
  if (!contestant.promise.watertight) return Verdict::not_promised;
  if (tally.lost == tally.edges) return Verdict::no_edge;
  return tally.identical + tally.lost == tally.edges ? Verdict::kept : Verdict::broken;
}

}  // namespace

std::vector<Measured> measure(const Scene& scene, const Contestants& contestants,
                              const Options& options) {
  const std::vector<SharedEdge> edges = shared_edges(scene.mesh);
  std::vector<ViewEdges> all(scene.views.size()), few(scene.views.size());
  tbb::parallel_for(std::size_t{0}, scene.views.size(), [&](std::size_t v) {
    const View& view = scene.views[v];
    const auto cut = cut_edges(scene, view, edges, options.edges_per_view);
    all[v] = view_edges(scene, view, cut);
    few[v] = view_edges(scene, view, at_most(options.exact_edges_per_view, cut));
  });
  std::vector<Measured> measured(contestants.size());
  tbb::parallel_for(std::size_t{0}, contestants.size(), [&](std::size_t c) {
    const Contestant& contestant = *contestants[c];
    Measured& m = measured[c];
    m.row.scene = scene.name;
    m.row.clipper = contestant.clipper;
    m.row.scalar = contestant.scalar();
    const std::vector<ViewEdges>& views = contestant.format->is_exact() ? few : all;
    for (std::size_t v = 0; v < views.size(); ++v) {
      measure_view(contestant, scene.views[v], views[v], m);
    }
    m.row.promise = verdict(contestant, m.row.all);
  });
  return measured;
}

Crack crack_of(const Scene& scene, const WorstRow& row) {
  const View& view = find_view(scene, row.view);
  const CutEdge edge = cut_edges(scene, view, {edge_of(row)}, 0).front();
  const Answers answers = clip_marked(find_contestant(row.clipper, row.scalar), view,
                                      neighbours_of(scene, view, edge.edge));
  Crack crack{{}, gap_of(edge, answers[0], answers[1])};
  for (std::size_t s = 0; s < 2; ++s) {
    for (const VertexView& v : answers[s]) crack.polygons[s].push_back({v[0].value, v[1].value});
  }
  return crack;
}

WorstInput worst_input(const Scene& scene, const WorstRow& row) {
  const View& view = find_view(scene, row.view);
  const Pair pair = neighbours_of(scene, view, edge_of(row));
  const std::string first = hex_line(pair[0], 0), second = hex_line(pair[1], 0);
  const std::string replay =
      fmt::format("printf '%s\\n' '{}' '{}' | clipscope clip {} {} --depth {} --hex", first, second,
                  options_of(find_contestant(row.clipper, row.scalar)),
                  frustum_options(view.frustum), depth_option(view.frustum.depth));
  return {row.clipper, row.scalar, "crack_px", row.crack_px, first + "\n" + second, replay};
}

}  // namespace clipscope::experiments::watertight
