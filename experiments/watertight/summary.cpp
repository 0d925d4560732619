// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace clipscope::experiments::watertight {
namespace {

Kind kind_of(const std::string& scene) {
  return scene == name_of(Kind::grazing) ? Kind::grazing : Kind::mesh;
}

double crack_px(const SummaryRow& row) { return row.all.crack_px; }
double lost_px(const SummaryRow& row) { return row.all.lost_px; }

// "in float 18 of 19 clippers leave both neighbours the same bits; textbook cracks by up to 0.26 px
// (in double 2e-10)": in the first scalar, and the widest crack's clipper in the second.
std::string crack_finding(const std::vector<SummaryRow>& rows) {
  const std::vector<std::string> scalars = distinct(rows, &SummaryRow::scalar);
  const auto in_first = rows_where(rows, &SummaryRow::scalar, scalars.front());
  const auto tight =
      std::ranges::count_if(in_first, [](const SummaryRow& r) { return r.all.t_junctions == 0; });
  std::string text = fmt::format("in {} {} of {} clippers leave both neighbours the same bits",
                                 scalars.front(), tight, in_first.size());
  const SummaryRow& widest = *std::ranges::max_element(in_first, {}, crack_px);
  if (crack_px(widest) == 0) return text;
  text +=
      fmt::format("; {} cracks by up to {} px", widest.clipper, format_number(crack_px(widest)));
  if (scalars.size() == 1) return text;
  for (const SummaryRow& row :
       rows_where(rows, &SummaryRow::scalar, scalars[1], &SummaryRow::clipper, widest.clipper)) {
    text += fmt::format(" (in {} {})", scalars[1], format_number(crack_px(row)));
  }
  return text;
}

// Pre-condition: at least one row.
std::string kind_finding(const std::vector<SummaryRow>& rows) {
  const auto edges_of = [](const SummaryRow& row) { return row.all.edges; };
  const std::int64_t edges = edges_of(*std::ranges::max_element(rows, {}, edges_of));
  const std::string_view kind = name_of(rows.front().edges_of);
  if (edges == 0) return fmt::format("No {} edge lies beside a cut, so nothing was judged.", kind);
  std::string text = fmt::format("{} {} edges beside a cut: {}", edges, kind, crack_finding(rows));
  const SummaryRow& lost = *std::ranges::max_element(rows, {}, lost_px);
  if (lost_px(lost) > 0) {
    text += fmt::format("; {} loses neighbours up to {} px wide", lost.clipper,
                        format_number(lost_px(lost)));
  }
  return text + ".";
}

std::string promise_finding(const std::vector<SummaryRow>& rows) {
  const auto kept = rows_where(rows, &SummaryRow::promise, Verdict::kept).size();
  std::vector<std::string> broken;
  for (const SummaryRow& row : rows_where(rows, &SummaryRow::promise, Verdict::broken)) {
    broken.push_back(row.clipper + " in " + row.scalar);
  }
  if (kept == 0 && broken.empty()) {
    return rows_where(rows, &SummaryRow::promise, Verdict::no_edge).empty()
               ? "None of them promises to be watertight."
               : "No promise to be watertight could be judged.";
  }
  if (broken.empty()) return fmt::format("All {} promises to be watertight are kept.", kept);
  return fmt::format("BROKEN: {} of {} promises to be watertight, by {}.", broken.size(),
                     kept + broken.size(), fmt::join(broken, ", "));
}

}  // namespace

std::vector<SummaryRow> summary_rows(const std::vector<Row>& by_scene) {
  std::vector<SummaryRow> sums;
  for (const Kind kind : {Kind::mesh, Kind::grazing}) {
    std::vector<Row> rest = by_scene;
    std::erase_if(rest, [&](const Row& row) { return kind_of(row.scene) != kind; });
    while (!rest.empty()) {
      SummaryRow sum{.edges_of = kind, .clipper = rest[0].clipper, .scalar = rest[0].scalar};
      GapTally different;
      std::erase_if(rest, [&](const Row& row) {
        if (row.clipper != sum.clipper || row.scalar != sum.scalar) return false;
        sum.all += row.all;
        different += row.different;
        sum.promise = std::max(sum.promise, row.promise);
        return true;
      });
      sum.different_identical_percent = different.identical_percent();
      sums.push_back(sum);
    }
  }
  return sums;
}

std::optional<WorstRow> widest_crack(const std::vector<WorstRow>& worst) {
  if (worst.empty()) return std::nullopt;
  return *std::ranges::max_element(worst, {}, [](const WorstRow& row) {
    return std::pair{kind_of(row.scene) == Kind::mesh, row.crack_px};
  });
}

Plot crack_plot(const std::vector<SummaryRow>& summary) {
  Plot plot{.name = "watertight",
            .title = "Widest crack between neighbours after clipping",
            .caption = "No bar: every edge has the same vertices on both sides, bit for bit.",
            .x = {.label = "clipper"},
            .y = {.label = "widest crack [px at 3840 x 2160]", .logarithmic = true}};
  std::vector<SummaryRow> shown = summary;
  std::erase_if(shown, [](const auto& r) { return r.scalar != "float" && r.scalar != "double"; });
  plot.categories = distinct(shown, &SummaryRow::clipper);
  for (const Kind kind : distinct(shown, &SummaryRow::edges_of)) {
    for (const std::string& scalar : distinct(shown, &SummaryRow::scalar)) {
      add_bars(plot, fmt::format("{}, {}", scalar, name_of(kind)), shown, crack_px,
               &SummaryRow::clipper, &SummaryRow::edges_of, kind, &SummaryRow::scalar, scalar);
    }
  }
  return plot;
}

std::string finding(const std::vector<MeshRow>& meshes, const std::vector<SummaryRow>& summary) {
  std::string text;
  for (const MeshRow& mesh : meshes) {
    if (!mesh.edges.may_crack()) continue;
    text += fmt::format("Before any clipping {} has {}. ", mesh.scene, crack_text(mesh.edges));
  }
  for (const Kind kind : distinct(summary, &SummaryRow::edges_of)) {
    text += kind_finding(rows_where(summary, &SummaryRow::edges_of, kind)) + " ";
  }
  return text + promise_finding(summary);
}

}  // namespace clipscope::experiments::watertight
