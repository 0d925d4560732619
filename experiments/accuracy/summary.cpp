// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "experiments/accuracy/rows.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::accuracy {
namespace {

// The usual clipper of each space, and the one that computes every vertex from the original three.
constexpr std::array<std::string_view, 4> kUsual = {
    "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first",
    "barycentric/distance_matrix"};
constexpr double kSeen = 1;  // px: an error that can be seen

// The rows of a clipper in a scalar on scenes where some triangle had the right vertices.
std::vector<Row> judged_rows(const std::vector<Row>& rows, std::string_view clipper,
                             std::string_view scalar) {
  std::vector<Row> judged = rows_where(rows, &Row::clipper, clipper, &Row::scalar, scalar);
  std::erase_if(judged, [](const Row& row) { return !row.figures.px; });
  return judged;
}

double largest_px(const Row& row) { return row.figures.px->max; }

// The worst scene of each usual clipper in a scalar, the most accurate first.
std::vector<Row> worst_rows(const std::vector<Row>& rows, std::string_view scalar) {
  std::vector<Row> worst;
  for (const std::string_view clipper : kUsual) {
    const std::vector<Row> judged = judged_rows(rows, clipper, scalar);
    if (!judged.empty()) worst.push_back(*std::ranges::max_element(judged, {}, largest_px));
  }
  std::ranges::stable_sort(worst, {}, largest_px);
  return worst;
}

std::string px_text(const Row& row) {
  return fmt::format("{} px for {}", format_number(largest_px(row)), spoken_clipper(row.clipper));
}

std::string worst_sentence(const std::vector<Row>& worst) {
  const auto seen =
      std::ranges::count_if(worst, [](const Row& r) { return largest_px(r) >= kSeen; });
  const bool all = seen == std::ranges::ssize(worst);
  std::string text = fmt::format(
      "Float clipping {} be seen to be off{} where the vertices are the right ones: the largest error is {}",
      seen == 0 ? "can't" : "can", all || seen == 0 ? "" : ", but not in every space,",
      px_text(worst.front()));
  if (largest_px(worst.back()) > largest_px(worst.front())) text += " and " + px_text(worst.back());
  return text + ".";
}

// On which scenes that is, and on how many nobody's error can be seen.
std::string scenes_sentence(const std::vector<Row>& rows, const std::vector<Row>& worst) {
  std::vector<std::string> where;
  for (const std::string& scene : distinct(worst, &Row::scene)) where.push_back(spoken_set(scene));
  std::int64_t judged = 0, unseen = 0;
  for (const std::string& scene : distinct(rows, &Row::scene)) {
    const std::vector<Row> of_scene = worst_rows(rows_where(rows, &Row::scene, scene), "float");
    if (of_scene.empty()) continue;
    ++judged;
    unseen += largest_px(of_scene.back()) < kSeen;
  }
  return fmt::format(
      " It depends on the triangles: the worst are on {}, and on {} of {} scenes no error reaches a pixel.",
      listed(where), number_word(unseen), number_word(judged));
}

std::string double_sentence(const std::vector<Row>& rows) {
  const std::vector<Row> worst = worst_rows(rows, "double");
  if (worst.empty()) return "";
  return largest_px(worst.back()) < kSeen ? " In double no error can be seen on any scene."
                                          : " In double, too, errors can be seen.";
}

}  // namespace

Plot error_plot(const std::vector<Row>& rows) {
  Plot plot{.name = "accuracy",
            .title = "Largest error of float clipping on each scene",
            .caption = "Over the triangles whose vertices are the right ones, at 3840 x 2160.",
            .x = {.label = "scene"},
            .y = {.label = "largest error [px]", .logarithmic = true},
            .categories = distinct(rows, &Row::scene)};
  for (const std::string_view clipper : kUsual) {
    const std::vector<Row> in_float = judged_rows(rows, clipper, "float");
    if (in_float.empty()) continue;
    add_bars(plot, spoken_clipper(clipper), in_float, largest_px, &Row::scene);
  }
  return plot;
}

std::string finding(const std::vector<Row>& rows) {
  const std::vector<Row> worst = worst_rows(rows, "float");
  if (worst.empty()) {
    return "Nothing was judged: no usual clipper was asked for in float, or none had the right vertices of a visible triangle.";
  }
  return worst_sentence(worst) + scenes_sentence(rows, worst) + double_sentence(rows);
}

}  // namespace clipscope::experiments::accuracy
