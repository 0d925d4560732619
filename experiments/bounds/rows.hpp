// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the table of bounding volumes.
#pragma once

#include "experiments/bounds/measure.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::bounds {

inline constexpr std::string_view kSame = "same";  // polygons, with bounds and without

struct Row {
  std::string scene, object, bound;
  std::int64_t objects = 0;
  double rejected_percent = 0, accepted_percent = 0, closer_percent = 0, settleable_percent = 0;
  std::optional<double> settled_of_settleable_percent = {};
  double untouched_percent = 0, uncut_percent = 0;
  std::optional<double> ns_without = {}, ns_with = {};
  std::optional<MedianInterval> speedup = {};
  std::string polygons;  // kSame, or what differs
  std::int64_t judged_triangles = 0, visible_lost = 0, accepted_cut = 0;
  std::string clipper;

  std::string place() const { return scene + ", " + object; }
  double settled_percent() const { return 100 - closer_percent; }

  static constexpr std::string_view kName = "bounds";
  static constexpr std::string_view kTitle =
      "Bounding volumes: what they settle, what that saves, what is lost";
  static constexpr std::array<std::string_view, 3> kNotes = {
      "Objects: those of all views together. Settleable: all outside or all inside in exact arithmetic, triangle by triangle, of the judged ones; settled of it: by the bound. Untouched: triangles of rejected objects; uncut: of accepted ones.",
      "ns: per triangle of the scene, in view space before; without bounds and with them, testing them included. Speedup: ratio of runs of the same round, median and 95 % interval. Polygons: the same to the bit, or what differs; then nothing is timed (-).",
      "Visible lost: judged triangles of rejected objects that have a point in the exact frustum. Accepted cut: judged triangles of accepted objects that are not all inside of it."};
  static constexpr auto columns() {
    using R = Row;
    return std::tuple(column("scene", &R::scene), column("object", &R::object),
                      column("bound", &R::bound), column("objects", &R::objects),
                      column("rejected_percent", "rejected [%]", &R::rejected_percent),
                      column("accepted_percent", "accepted [%]", &R::accepted_percent),
                      column("closer_percent", "closer [%]", &R::closer_percent),
                      column("settleable_percent", "settleable [%]", &R::settleable_percent),
                      column("settled_of_settleable_percent", "settled of it [%]",
                             &R::settled_of_settleable_percent),
                      column("triangles_untouched_percent", "untouched [%]", &R::untouched_percent),
                      column("triangles_uncut_percent", "uncut [%]", &R::uncut_percent),
                      column("ns_per_triangle_without", "ns without", &R::ns_without),
                      column("ns_per_triangle_with", "ns with", &R::ns_with),
                      interval("speedup", "speedup", "speedup", &R::speedup),
                      column("same_polygons", "polygons", &R::polygons, 30),
                      column("judged_triangles", "judged tri", &R::judged_triangles),
                      column("visible_lost", "visible lost", &R::visible_lost),
                      column("accepted_cut", "accepted cut", &R::accepted_cut),
                      column("clipper", &R::clipper));
  }
};

inline double percent(std::int64_t part, std::int64_t all) {
  return all == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(all);
}

inline Row row_of(const ObjectScene& scene, const Contestant& clipper, const Result& result) {
  const CullTally& t = result.tally;
  Row row{.scene = scene.scene.name,
          .object = scene.object,
          .bound = std::string(result.bound),
          .objects = t.objects,
          .rejected_percent = percent(t.rejected, t.objects),
          .accepted_percent = percent(t.accepted, t.objects),
          .closer_percent = percent(t.objects - t.rejected - t.accepted, t.objects),
          .settleable_percent = percent(t.settleable, t.judged_objects),
          .untouched_percent = percent(t.triangles_rejected, t.triangles),
          .uncut_percent = percent(t.triangles_accepted, t.triangles),
          .polygons = result.with.is_timed() ? std::string(kSame) : result.with.refused,
          .judged_triangles = t.judged,
          .visible_lost = t.visible_lost,
          .accepted_cut = t.accepted_cut,
          .clipper = std::string(clipper.clipper)};
  if (t.settleable > 0) row.settled_of_settleable_percent = percent(t.settled, t.settleable);
  if (result.with.is_timed()) {
    row.ns_without = result.without.ns.median;
    row.ns_with = result.with.ns.median;
    row.speedup = result.with.speedup;
  }
  return row;
}

// What is said of bounding volumes at the end, from the rows of their table alone.

// Both of the first clipper of the table. Pre-condition: rows.
Plot settled_plot(const std::vector<Row>& rows);  // share of objects settled, by scene
Plot speedup_plot(const std::vector<Row>& rows);

std::string finding(const std::vector<Row>& rows);

}  // namespace clipscope::experiments::bounds
