// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::watertight {
namespace {

Kind kind_of(const std::string& scene) {
  return scene == name_of(Kind::grazing) ? Kind::grazing : Kind::mesh;
}

double crack_px(const SummaryRow& row) { return row.all.crack_px; }
double lost_px(const SummaryRow& row) { return row.all.lost_px; }

// In the first scalar.
std::vector<SummaryRow> in_first_scalar(const std::vector<SummaryRow>& rows) {
  return rows_where(rows, &SummaryRow::scalar, rows.front().scalar);
}

bool has_edges(const SummaryRow& row) { return row.all.edges > 0; }
bool is_tight(const SummaryRow& row) { return row.all.t_junctions == 0; }

double tight_share(const std::vector<SummaryRow>& rows) {
  return static_cast<double>(std::ranges::count_if(rows, is_tight)) /
         static_cast<double>(rows.size());
}

// How many clippers leave both neighbours the same bits along an edge, of a mesh and grazing.
std::string tight_sentence(const std::vector<SummaryRow>& summary) {
  std::vector<SummaryRow> mesh = rows_where(summary, &SummaryRow::edges_of, Kind::mesh);
  std::vector<SummaryRow> grazing = rows_where(summary, &SummaryRow::edges_of, Kind::grazing);
  for (auto* rows : {&mesh, &grazing}) {
    if (!rows->empty()) *rows = in_first_scalar(*rows);
    std::erase_if(*rows, [](const SummaryRow& row) { return !has_edges(row); });
  }
  if (mesh.empty() && grazing.empty()) return "No edge lies beside a cut, so nothing was judged.";
  const auto& rows = mesh.empty() ? grazing : mesh;
  std::string text = fmt::format(
      "Along {} edges beside a cut {} leave both neighbours the same bits in {}",
      name_of(rows.front().edges_of),
      some_of(std::ranges::count_if(rows, is_tight), std::ranges::ssize(rows), "clippers"),
      spoken_scalar(rows.front().scalar));
  if (mesh.empty() || grazing.empty()) return text + ".";
  const double share = tight_share(grazing);
  return fmt::format("{}; along edges that graze a plane {} do.", text,
                     share == 0 ? "none" : quantity(share));
}

// Whose crack is the widest, and who loses a neighbour, in the first scalar. Empty where nothing
// was judged.
std::string worst_sentence(const std::vector<SummaryRow>& summary) {
  std::vector<SummaryRow> rows = in_first_scalar(summary);
  std::erase_if(rows, [](const SummaryRow& row) { return !has_edges(row); });
  if (rows.empty()) return "";
  const SummaryRow& widest = *std::ranges::max_element(rows, {}, crack_px);
  const SummaryRow& lost = *std::ranges::max_element(rows, {}, lost_px);
  std::vector<std::string> parts;
  if (crack_px(widest) > 0) {
    parts.push_back(fmt::format("the widest crack is that of {}", spoken_clipper(widest.clipper)));
  }
  if (lost_px(lost) > 0) {
    parts.push_back(
        fmt::format("the widest lost neighbour is that of {}", spoken_clipper(lost.clipper)));
  }
  if (parts.empty()) return " No clipper cracks, and none loses a neighbour.";
  return fmt::format(" {}.", capitalised(listed(parts)));
}

std::string promise_sentence(const std::vector<SummaryRow>& rows) {
  const auto kept = rows_where(rows, &SummaryRow::promise, Verdict::kept).size();
  std::vector<std::string> broken;
  for (const SummaryRow& row : rows_where(rows, &SummaryRow::promise, Verdict::broken)) {
    broken.push_back(spoken_contestant(row.clipper, row.scalar));
  }
  if (!broken.empty()) {
    return fmt::format(" Promises to be watertight are BROKEN by {}.", listed(broken));
  }
  if (kept > 0) return " All promises to be watertight are kept.";
  return rows_where(rows, &SummaryRow::promise, Verdict::no_edge).empty()
             ? " None of them promises to be watertight."
             : " No promise to be watertight could be judged.";
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
  if (summary.empty()) return "No clipper was asked for.";
  std::vector<std::string> cracked;
  for (const MeshRow& mesh : meshes) {
    if (mesh.edges.may_crack()) cracked.push_back(spoken_set(mesh.scene));
  }
  std::string text;
  if (!cracked.empty()) {
    text = fmt::format("Before any clipping there may be cracks in {}. ", listed(cracked));
  }
  return text + tight_sentence(summary) + worst_sentence(summary) + promise_sentence(summary);
}

}  // namespace clipscope::experiments::watertight
