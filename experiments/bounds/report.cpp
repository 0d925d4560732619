// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kSame = "same";  // in the column same_polygons
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double percent(std::int64_t part, std::int64_t all) {
  return all == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(all);
}

// Nothing, if there is nothing that it could be a share of.
Cell share(std::int64_t part, std::int64_t all) {
  if (all == 0) return std::monostate();
  return percent(part, all);
}

std::string category_of(const RowView& row) {
  return fmt::format("{}, {}", row.text("scene"), row.text("object"));
}

std::size_t place_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

// A set of bars for each bound; set(series, place, row) fills in the bar of a row.
template <class Set>
std::optional<Plot> bars(Plot plot, const Table& table, Set&& set) {
  const std::vector<RowView> rows = rows_of(table);
  if (rows.empty()) return std::nullopt;
  const std::string clipper = rows.front().text("clipper");
  std::vector<std::string> bounds;
  for (const RowView& row : rows) {
    if (row.text("clipper") != clipper) continue;
    place_of(plot.categories, category_of(row));
    place_of(bounds, row.text("bound"));
  }
  for (const std::string& bound : bounds) {
    Series& series = plot.series.emplace_back();
    series.name = bound;
    series.y.assign(plot.categories.size(), kNone);
  }
  for (const RowView& row : rows) {
    if (row.text("clipper") != clipper) continue;
    set(plot.series[place_of(bounds, row.text("bound"))],
        place_of(plot.categories, category_of(row)), row);
  }
  return plot;
}

// The rows of the finding's figures: lowest and highest of a column over all rows that have it.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::string lowest, highest;

  void note(double value, const std::string& where) {
    if (value < low) {
      low = value;
      lowest = where;
    }
    if (value > high) {
      high = value;
      highest = where;
    }
  }
};

}  // namespace

Table bounds_table() {
  Table table("bounds", "Bounding volumes: what they settle, what that saves, what is lost",
              {{"scene", "scene"},
               {"object", "object"},
               {"bound", "bound"},
               {"objects", "objects"},
               {"rejected_percent", "rejected [%]"},
               {"accepted_percent", "accepted [%]"},
               {"closer_percent", "closer [%]"},
               {"settleable_percent", "settleable [%]"},
               {"settled_of_settleable_percent", "settled of it [%]"},
               {"triangles_untouched_percent", "untouched [%]"},
               {"triangles_uncut_percent", "uncut [%]"},
               {"ns_per_triangle_without", "ns without"},
               {"ns_per_triangle_with", "ns with"},
               {"speedup", "speedup"},
               {"speedup_low", "x low"},
               {"speedup_high", "x high"},
               {"same_polygons", "polygons", 30},
               {"judged_triangles", "judged tri"},
               {"visible_lost", "visible lost"},
               {"accepted_cut", "accepted cut"},
               {"clipper", "clipper"}});
  table.add_note(
      "Objects: those of all views together. Settleable: all outside or all inside in exact "
      "arithmetic, triangle by triangle, of the judged ones; settled of it: by the bound. "
      "Untouched: triangles of rejected objects; uncut: of accepted ones.");
  table.add_note(
      "ns: per triangle of the scene, in view space before; without bounds and with them, "
      "testing them included. Speedup: ratio of runs of the same round, median and 95 % interval. "
      "Polygons: the same to the bit, or what differs; then nothing is timed (-).");
  table.add_note(
      "Visible lost: judged triangles of rejected objects that have a point in the exact frustum. "
      "Accepted cut: judged triangles of accepted objects that are not all inside of it.");
  return table;
}

void add_bound(const ObjectScene& scene, const Contestant<float>& clipper,
               const BoundResult& result, Table& table, CellRecord& record) {
  const CullTally& t = result.tally;
  const std::string bound(result.bound), name(clipper.name);
  std::vector<Cell> cells = {scene.scene.name,
                             scene.object,
                             bound,
                             t.objects,
                             percent(t.rejected, t.objects),
                             percent(t.accepted, t.objects),
                             percent(t.objects - t.rejected - t.accepted, t.objects),
                             percent(t.settleable, t.judged_objects),
                             share(t.settled, t.settleable),
                             percent(t.triangles_rejected, t.triangles),
                             percent(t.triangles_accepted, t.triangles)};
  if (result.difference.empty()) {
    cells.insert(cells.end(),
                 {median_interval(result.ns_without).median, median_interval(result.ns_with).median,
                  result.speedup.median, result.speedup.low, result.speedup.high});
    const std::string series =
        fmt::format("{}, {}, {}, {}", scene.scene.name, scene.object, bound, name);
    record.samples.push_back({series + ", without", "ns/triangle", result.ns_without});
    record.samples.push_back({series + ", with", "ns/triangle", result.ns_with});
  } else {
    cells.insert(cells.end(), 5, std::monostate());
  }
  cells.insert(cells.end(), {result.difference.empty() ? std::string(kSame) : result.difference,
                             t.judged, t.visible_lost, t.accepted_cut, name});
  table.add_row(std::move(cells));
}

std::optional<Plot> settled_plot(const Table& table) {
  auto plot = bars({.name = "bounds",
                    .title = "Objects that a bounding volume settles",
                    .caption = "Share of objects that are rejected or accepted before any triangle "
                               "is looked at; grey: what exact arithmetic settles, triangle by "
                               "triangle, the most that any bound could.",
                    .x = {},
                    .y = {.label = "objects settled [%]", .from = 0, .to = 100},
                    .series = {}},
                   table, [](Series& series, std::size_t place, const RowView& row) {
                     series.y[place] = 100 - row.number("closer_percent");
                   });
  if (!plot) return plot;
  Series limit;
  limit.name = "exact arithmetic";
  limit.muted = true;
  limit.y.assign(plot->categories.size(), kNone);
  for (const RowView& row : rows_of(table)) {
    limit.y[place_of(plot->categories, category_of(row))] = row.number("settleable_percent");
  }
  plot->series.push_back(std::move(limit));
  return plot;
}

std::optional<Plot> speedup_plot(const Table& table) {
  return bars({.name = "bounds_speedup",
               .title = "Clipping with bounding volumes: how many times faster",
               .caption = "All triangles of all views, testing the volumes included, against "
                          "clipping every triangle; median and 95 % interval. Below 1: slower.",
               .x = {},
               .y = {.label = "speedup", .from = 0},
               .series = {}},
              table, [](Series& series, std::size_t place, const RowView& row) {
                if (row.text("same_polygons") != kSame) return;
                series.low.resize(series.y.size(), kNone);
                series.high.resize(series.y.size(), kNone);
                series.y[place] = row.number("speedup");
                series.low[place] = row.number("speedup_low");
                series.high[place] = row.number("speedup_high");
              });
}

std::string bounds_finding(const Table& table) {
  Range untouched, speedup, settled;
  std::int64_t judged = 0, lost = 0, cut = 0;
  for (const RowView& row : rows_of(table)) {
    const std::string where = category_of(row) + ", " + row.text("bound");
    settled.note(100 - row.number("closer_percent"), where);
    untouched.note(row.number("triangles_untouched_percent"), where);
    if (row.text("same_polygons") == kSame) speedup.note(row.number("speedup"), where);
    judged += row.count("judged_triangles");
    lost += row.count("visible_lost");
    cut += row.count("accepted_cut");
  }
  if (table.rows().empty()) return "";
  std::string finding = fmt::format(
      "Bounds settle {:.0f} % ({}) to {:.0f} % ({}) of the objects, and leave up to {:.0f} % of "
      "the "
      "triangles untouched; of {} exact verdicts {} on rejected objects find something visible, {} "
      "on accepted ones something to cut.",
      settled.low, settled.lowest, settled.high, settled.highest, untouched.high, judged, lost,
      cut);
  if (speedup.low <= speedup.high) {
    finding += fmt::format(" Clipping gets {:.2f} times ({}) to {:.2f} times ({}) as fast.",
                           speedup.low, speedup.lowest, speedup.high, speedup.highest);
  }
  return finding;
}

}  // namespace clipscope::experiments
