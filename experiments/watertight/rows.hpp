// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the tables of `watertight`. Lengths are px on a screen of 3840 x 2160.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/scenes/mesh_edges.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::watertight {

// What became of many edges; see EdgeGap.
struct GapTally {
  std::int64_t edges = 0, identical = 0, absent = 0, lost = 0, t_junctions = 0;
  double lost_px = 0, crack_px = 0;  // the largest

  GapTally& operator+=(const GapTally& other) {
    edges += other.edges;
    identical += other.identical;
    absent += other.absent;
    lost += other.lost;
    t_junctions += other.t_junctions;
    lost_px = std::max(lost_px, other.lost_px);
    crack_px = std::max(crack_px, other.crack_px);
    return *this;
  }
  double identical_percent() const {
    return edges == 0 ? 0 : 100.0 * static_cast<double>(identical) / static_cast<double>(edges);
  }

  static constexpr auto columns() {
    using T = GapTally;
    return std::tuple(column("edges", &T::edges), column("identical", &T::identical),
                      derived("bit_identical_percent", "[%]", &T::identical_percent),
                      column("absent", &T::absent), column("lost", &T::lost),
                      column("max_lost_px", "widest [px]", &T::lost_px),
                      column("t_junctions", "T-junctions", &T::t_junctions),
                      column("max_crack_px", "max crack [px]", &T::crack_px));
  }
};

// What became of a clipper's promise to be watertight, the later the more it decides. The promise
// speaks of neighbours of which both have something left (see judge/promise.hpp); that one of them
// is lost is counted apart. no_edge: there was nothing to judge it by.
enum class Verdict { not_promised, no_edge, kept, broken };
constexpr std::array<std::string_view, 4> names_of(Verdict) {
  return {"-", "no edge", "kept", "broken"};
}

// What a mesh was like before anybody clipped it.
struct MeshRow {
  std::string scene;
  std::int64_t triangles = 0;
  MeshEdges edges;

  static constexpr std::string_view kName = "watertight_meshes";
  static constexpr std::string_view kTitle = "The edges of the meshes before any clipping";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Open: beside one triangle. Crowded: beside more than two. T-junctions: ends of open edges that lie within another open edge but for the rounding of coordinates to float, and how far off it, in the mesh's units. Split: open edges beside another one whose ends are the same but for rounding. Repeated: triangles given again. A picture may crack at these however it is clipped; the other tables look at edges that two triangles share to the bit."};
  static constexpr auto columns() {
    using R = MeshRow;
    using E = MeshEdges;
    return std::tuple(
        column("scene", &R::scene), column("triangles", &R::triangles),
        group(&R::edges,
              std::tuple(column("edges", &E::edges), column("open", &E::open),
                         column("crowded", &E::crowded),
                         column("t_junctions", "T-junctions", &E::t_junctions),
                         column("t_distance", "off the edge", &E::t_distance),
                         column("split", &E::split),
                         column("repeated_triangles", "repeated", &E::repeated_triangles))));
  }
};

struct Row {
  std::string scene, clipper, scalar;
  GapTally all, different;  // different: the triangles are not outside of the same planes
  Verdict promise = Verdict::not_promised;

  static constexpr std::string_view kName = "watertight";
  static constexpr std::string_view kTitle = "What two neighbours keep of the edge that they share";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Edges: shared by two triangles, partly visible, one neighbour at least cut. Identical: both polygons have the same vertices on the edge, bit for bit: x, y, z, 1/w and an attribute; absent: of them, neither has any. Lost: one polygon is empty, or all of it lies on the edge; and how wide the widest lost one should be.",
      "T-junctions: vertices on the edge without a partner in the other polygon. Crack: how far the farthest of them is from the other polygon, or, if that is less, how wide that one should be, on 3840 x 2160. Different planes: the triangles are not outside of the same planes. Exact arithmetic is asked about fewer edges."};
  static constexpr auto columns() {
    using R = Row;
    using T = GapTally;
    return std::tuple(
        column("scene", &R::scene), contestant_columns(&R::clipper, &R::scalar), group(&R::all),
        group(&R::different,
              std::tuple(
                  column("different_planes_edges", "different planes: edges", &T::edges),
                  column("different_planes_identical", "identical", &T::identical),
                  derived("different_planes_identical_percent", "[%]", &T::identical_percent))),
        column("promise", "promise watertight", &R::promise));
  }
};

// The planes that cut an edge: one of the six, in the order of Plane; several; or none, where the
// edge is inside and only neighbours are cut.
enum class EdgeClass { left, right, bottom, top, near, far, several, none };
constexpr std::array<std::string_view, 8> names_of(EdgeClass) {
  return {"left", "right", "bottom", "top", "near", "far", "several", "none"};
}

// Whether the neighbours are outside of the same planes.
enum class Neighbours { same, different };
constexpr std::array<std::string_view, 2> names_of(Neighbours) { return {"the same", "different"}; }

struct PlaneRow {
  std::string scene, clipper, scalar;
  EdgeClass plane = EdgeClass::none;
  Neighbours neighbours = Neighbours::same;
  GapTally tally;

  static constexpr std::string_view kName = "watertight_planes";
  static constexpr std::string_view kTitle = "The same by the plane that cuts the edge";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Several: more than one plane cuts the edge. None: all of the edge is inside, a neighbour is cut."};
  static constexpr auto columns() {
    using R = PlaneRow;
    return std::tuple(column("scene", &R::scene), contestant_columns(&R::clipper, &R::scalar),
                      column("plane", &R::plane),
                      column("neighbours", "both cut by", &R::neighbours), group(&R::tally));
  }
};

struct WorstRow {
  std::string scene, clipper, scalar, view;
  std::uint32_t first_triangle = 0, second_triangle = 0;
  int first_corner = 0, second_corner = 0;  // opposite to the edge
  double crack_px = 0;

  static constexpr std::string_view kName = "watertight_worst";
  static constexpr std::string_view kTitle = "The edge with the widest crack";
  static constexpr auto columns() {
    using R = WorstRow;
    return std::tuple(column("scene", &R::scene), contestant_columns(&R::clipper, &R::scalar),
                      column("view", "view", &R::view, 18),
                      column("first_triangle", "first triangle", &R::first_triangle),
                      column("second_triangle", "second", &R::second_triangle),
                      column("first_corner", "opposite corner", &R::first_corner),
                      column("second_corner", "second", &R::second_corner),
                      column("crack_px", "crack [px]", &R::crack_px));
  }
};

enum class Kind { mesh, grazing };
constexpr std::array<std::string_view, 2> names_of(Kind) { return {"mesh", "grazing"}; }

struct SummaryRow {
  Kind edges_of = Kind::mesh;
  std::string clipper, scalar;
  GapTally all = {};
  double different_identical_percent = 0;
  Verdict promise = Verdict::not_promised;

  static constexpr std::string_view kName = "watertight_summary";
  static constexpr std::string_view kTitle = "Shared edges after clipping, over all scenes";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Mesh: edges of real meshes. Grazing: edges made to lie within rounding of a plane that one of the neighbours crosses. The other columns: as in the table watertight."};
  static constexpr auto columns() {
    using R = SummaryRow;
    return std::tuple(column("edges_of", "edges of", &R::edges_of),
                      contestant_columns(&R::clipper, &R::scalar), group(&R::all),
                      column("different_planes_identical_percent",
                             "different planes: identical [%]", &R::different_identical_percent),
                      column("promise", "promise watertight", &R::promise));
  }
};

// What is said of shared edges at the end, from the rows of the tables alone.

// Over all scenes: meshes, then grazing edges.
std::vector<SummaryRow> summary_rows(const std::vector<Row>& by_scene);

// The row with the widest crack, in a mesh if there is any; none if there is no crack.
std::optional<WorstRow> widest_crack(const std::vector<WorstRow>& worst);

// The widest crack by clipper in float and double.
Plot crack_plot(const std::vector<SummaryRow>& summary);

// The answer to the experiment's question: what the meshes were like before, then what clipping
// did.
std::string finding(const std::vector<MeshRow>& meshes, const std::vector<SummaryRow>& summary);

}  // namespace clipscope::experiments::watertight
