// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

#include "experiments/watertight/grazing.hpp"

namespace clipscope::experiments {
namespace {

double percent(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

const std::vector<Column> kGapColumns = {{"edges", "edges"},
                                         {"identical", "identical"},
                                         {"bit_identical_percent", "[%]"},
                                         {"absent", "absent"},
                                         {"lost", "lost"},
                                         {"max_lost_px", "widest [px]"},
                                         {"t_junctions", "T-junctions"},
                                         {"max_crack_px", "max crack [px]"}};

void append_gap(const GapTally& t, std::vector<Cell>& cells) {
  cells.insert(cells.end(), {t.edges, t.identical, percent(t.identical, t.edges), t.absent, t.lost,
                             t.lost_px, t.t_junctions, t.crack_px});
}

GapTally gap_of(const RowView& row) {
  return {row.count("edges"),        row.count("identical"),   row.count("absent"),
          row.count("lost"),         row.count("t_junctions"), row.number("max_lost_px"),
          row.number("max_crack_px")};
}

std::vector<Column> with_gap_columns(std::vector<Column> columns) {
  columns.insert(columns.end(), kGapColumns.begin(), kGapColumns.end());
  return columns;
}

// Of one clipper and scalar over several scenes.
struct Sum {
  GapTally all, different;
  std::string promise = "-";
};

using SumKey = std::array<std::string, 3>;  // kind of edges, clipper, scalar

void add_row_to(const RowView& row, Sum& sum) {
  sum.all += gap_of(row);
  sum.different.edges += row.count("different_planes_edges");
  sum.different.identical += row.count("different_planes_identical");
  if (sum.promise != "broken") sum.promise = row.text("promise");
}

std::string kind_of(const std::string& scene) {
  return scene == kGrazing ? std::string(kGrazing) : "mesh";
}

// Its place in the list, to which it is added if it is not there.
std::size_t place_in(std::vector<std::string>& list, const std::string& name) {
  const auto found = std::ranges::find(list, name);
  if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
  list.push_back(name);
  return list.size() - 1;
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

// "in float 18 of 19 clippers leave both neighbours the same bits; textbook cracks by up to 0.26 px (in
// double 2e-10)": in the first scalar, and the widest crack's clipper in the second.
std::string crack_finding(const std::vector<RowView>& rows,
                          const std::vector<std::string>& scalars) {
  std::size_t clippers = 0, tight = 0;
  const RowView* widest = nullptr;
  for (const RowView& row : rows) {
    if (row.text("scalar") != scalars.front()) continue;
    ++clippers;
    tight += row.count("t_junctions") == 0;
    if (widest == nullptr || row.number("max_crack_px") > widest->number("max_crack_px"))
      widest = &row;
  }
  std::string text = fmt::format("in {} {} of {} clippers leave both neighbours the same bits",
                                 scalars.front(), tight, clippers);
  if (widest->number("max_crack_px") == 0) return text;
  text += fmt::format("; {} cracks by up to {} px", widest->text("clipper"),
                      format_number(widest->number("max_crack_px")));
  for (const RowView& row : rows) {
    if (scalars.size() > 1 && row.text("scalar") == scalars[1] &&
        row.text("clipper") == widest->text("clipper")) {
      text += fmt::format(" (in {} {})", scalars[1], format_number(row.number("max_crack_px")));
    }
  }
  return text;
}

// Pre-condition: at least one row.
std::string kind_finding(const std::vector<RowView>& rows) {
  std::vector<std::string> scalars;
  std::int64_t edges = 0;
  const RowView* lost = &rows.front();
  for (const RowView& row : rows) {
    place_in(scalars, row.text("scalar"));
    edges = std::max(edges, row.count("edges"));
    if (row.number("max_lost_px") > lost->number("max_lost_px")) lost = &row;
  }
  std::string text = fmt::format("{} {} edges beside a cut: {}", edges,
                                 rows.front().text("edges_of"), crack_finding(rows, scalars));
  if (lost->number("max_lost_px") > 0) {
    text += fmt::format("; {} loses neighbours up to {} px wide", lost->text("clipper"),
                        format_number(lost->number("max_lost_px")));
  }
  return text + ".";
}

std::string promise_finding(const std::vector<RowView>& rows) {
  std::size_t kept = 0;
  std::vector<std::string> broken;
  for (const RowView& row : rows) {
    if (row.text("promise") == "kept") ++kept;
    if (row.text("promise") == "broken") {
      broken.push_back(row.text("clipper") + " in " + row.text("scalar"));
    }
  }
  if (kept == 0 && broken.empty()) return "None of them promises to be watertight.";
  if (broken.empty()) return fmt::format("All {} promises to be watertight are kept.", kept);
  return fmt::format("BROKEN: {} of {} promises to be watertight, by {}.", broken.size(),
                     kept + broken.size(), joined(broken));
}

}  // namespace

Table watertight_table() {
  std::vector<Column> columns =
      with_gap_columns({{"scene", "scene"}, {"clipper", "clipper"}, {"scalar", "scalar"}});
  columns.insert(columns.end(), {{"different_planes_edges", "different planes: edges"},
                                 {"different_planes_identical", "identical"},
                                 {"different_planes_identical_percent", "[%]"},
                                 {"promise", "promise watertight"}});
  Table table("watertight", "What two neighbours keep of the edge that they share", columns);
  table.add_note(
      "Edges: shared by two triangles, partly visible, one neighbour at least cut. Identical: both "
      "polygons have the same vertices on the edge, bit for bit: x, y, z, 1/w and an attribute; "
      "absent: of them, neither has any. Lost: one polygon is empty, or all of it lies on the "
      "edge; "
      "and how wide the widest lost one should be.");
  table.add_note(
      "T-junctions: vertices on the edge without a partner in the other polygon. Crack: how far "
      "the "
      "farthest of them is from the other polygon, or, if that is less, how wide that one should "
      "be, on 3840 x 2160. Different planes: the triangles are not outside of the same planes. "
      "Exact arithmetic is asked about fewer edges.");
  return table;
}

void add_scene(const std::string& scene, Contestants contestants, Tallies tallies, Table& table) {
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    const GapTally total = tallies[c].total();
    const GapTally different = tallies[c].with_different_neighbours();
    std::vector<Cell> row = {scene, std::string(clipper_name(contestants[c])),
                             std::string(scalar_name(contestants[c]))};
    append_gap(total, row);
    row.insert(row.end(),
               {different.edges, different.identical, percent(different.identical, different.edges),
                std::string(watertight_verdict(contestants[c], total))});
    table.add_row(std::move(row));
  }
}

Table planes_table() {
  Table table("watertight_planes", "The same by the plane that cuts the edge",
              with_gap_columns({{"scene", "scene"},
                                {"clipper", "clipper"},
                                {"scalar", "scalar"},
                                {"plane", "plane"},
                                {"neighbours", "both cut by"}}));
  table.add_note(
      "Several: more than one plane cuts the edge. None: all of the edge is inside, a neighbour is "
      "cut.");
  return table;
}

void add_planes(const std::string& scene, Contestants contestants, Tallies tallies, Table& table) {
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    for (std::size_t k = 0; k < kEdgeClasses.size(); ++k) {
      for (const bool different : {false, true}) {
        const GapTally& tally = tallies[c].by_class[k][different];
        if (tally.edges == 0) continue;
        std::vector<Cell> row = {scene, std::string(clipper_name(contestants[c])),
                                 std::string(scalar_name(contestants[c])),
                                 std::string(kEdgeClasses[k]),
                                 std::string(different ? "different" : "the same")};
        append_gap(tally, row);
        table.add_row(std::move(row));
      }
    }
  }
}

Table worst_table() {
  return Table("watertight_worst", "The edge with the widest crack",
               {{"scene", "scene"},
                {"clipper", "clipper"},
                {"scalar", "scalar"},
                {"view", "view", 18},
                {"first_triangle", "first triangle"},
                {"second_triangle", "second"},
                {"first_corner", "opposite corner"},
                {"second_corner", "second"},
                {"crack_px", "crack [px]"}});
}

void add_worst(const Scene& scene, Contestants contestants, Tallies tallies, Table& table,
               CellRecord& record) {
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    const WorstGap& worst = tallies[c].worst;
    if (worst.gap.crack_px == 0) continue;
    const auto number = [](auto n) { return static_cast<std::int64_t>(n); };
    table.add_row({scene.name, std::string(clipper_name(contestants[c])),
                   std::string(scalar_name(contestants[c])), scene.views[worst.view].label,
                   number(worst.edge.edge.triangles[0]), number(worst.edge.edge.triangles[1]),
                   number(worst.edge.edge.opposite[0]), number(worst.edge.edge.opposite[1]),
                   worst.gap.crack_px});
    const View& view = scene.views[worst.view];
    const auto triangles = neighbours_of(scene, view, worst.edge.edge);
    record.worst_inputs.push_back({std::string(clipper_name(contestants[c])),
                                   std::string(scalar_name(contestants[c])), "crack_px",
                                   worst.gap.crack_px, input_text(triangles),
                                   replay_command(contestants[c], view, triangles)});
  }
}

Table summary_table(const Table& by_scene) {
  std::vector<Column> columns =
      with_gap_columns({{"edges_of", "edges of"}, {"clipper", "clipper"}, {"scalar", "scalar"}});
  columns.insert(columns.end(),
                 {{"different_planes_identical_percent", "different planes: identical [%]"},
                  {"promise", "promise watertight"}});
  Table table("watertight_summary", "Shared edges after clipping, over all scenes", columns);
  std::vector<SumKey> order;
  std::map<SumKey, Sum> sums;
  for (const RowView& row : rows_of(by_scene)) {
    const SumKey key = {kind_of(row.text("scene")), row.text("clipper"), row.text("scalar")};
    if (!sums.contains(key)) order.push_back(key);
    add_row_to(row, sums[key]);
  }
  std::ranges::stable_sort(order, std::ranges::greater{}, [](const SumKey& k) { return k[0]; });
  for (const SumKey& key : order) {
    const Sum& sum = sums[key];
    std::vector<Cell> row(key.begin(), key.end());
    append_gap(sum.all, row);
    row.insert(row.end(), {percent(sum.different.identical, sum.different.edges), sum.promise});
    table.add_row(std::move(row));
  }
  table.add_note(
      "Mesh: edges of real meshes. Grazing: edges made to lie within rounding of a plane that one "
      "of the neighbours crosses. The other columns: as in the table watertight.");
  return table;
}

Plot crack_plot(const Table& summary) {
  Plot plot;
  plot.name = "watertight";
  plot.title = "Widest crack between neighbours after clipping";
  plot.caption = "No bar: every edge has the same vertices on both sides, bit for bit.";
  plot.x.label = "clipper";
  plot.y = {.label = "widest crack [px at 3840 x 2160]", .logarithmic = true};
  std::vector<std::string> names;
  for (const RowView& row : rows_of(summary)) {
    const std::string& scalar = row.text("scalar");
    if (scalar != "float" && scalar != "double") continue;
    const std::size_t category = place_in(plot.categories, row.text("clipper"));
    const std::size_t series = place_in(names, scalar + ", " + row.text("edges_of"));
    if (series == plot.series.size()) plot.series.emplace_back().name = names.back();
    std::vector<double>& y = plot.series[series].y;
    y.resize(std::max(y.size(), category + 1));
    y[category] = row.number("max_crack_px");
  }
  for (Series& series : plot.series) series.y.resize(plot.categories.size());
  return plot;
}

std::string watertight_finding(const Table& summary) {
  std::vector<std::string> kinds, parts;
  std::vector<std::vector<RowView>> rows_by_kind;
  for (const RowView& row : rows_of(summary)) {
    const std::size_t kind = place_in(kinds, row.text("edges_of"));
    rows_by_kind.resize(kinds.size());
    rows_by_kind[kind].push_back(row);
  }
  for (const auto& rows : rows_by_kind) parts.push_back(kind_finding(rows));
  return fmt::format("{} {}", fmt::join(parts, " "), promise_finding(rows_of(summary)));
}

std::optional<RowView> widest_crack(const Table& worst) {
  std::optional<RowView> widest;
  for (const RowView& row : rows_of(worst)) {
    const auto rank = [](const RowView& r) {
      return std::pair{kind_of(r.text("scene")) == "mesh", r.number("crack_px")};
    };
    if (!widest || rank(row) > rank(*widest)) widest = row;
  }
  return widest;
}

}  // namespace clipscope::experiments
