// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of half a century of papers: where they brought speed, and right answers.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/history/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::history {
namespace {

constexpr double kFaster = 1.05;  // times: less is no gain

std::string spoken_field(Field field) {
  return field == Field::segments ? "segments in space" : std::string(name_of(field));
}

const Row& fastest(const std::vector<Row>& rows) {
  return *std::ranges::max_element(rows, {}, [](const Row& row) { return *row.speedup; });
}

// The gain, and whether it is paid for in right answers.
std::string gain_text(const Row& best, const std::vector<Row>& of_field) {
  const std::string name = spoken_clipper(best.clipper);
  std::string text = fmt::format("the largest gain is that of {} ({}), {} as fast for {}.", name,
                                 best.year, times_text(*best.speedup), spoken_field(best.field));
  const Row* usual = find_row(of_field, &Row::clipper, usual_method(best.field));
  if (usual == nullptr || !usual->hard_right_percent || !best.hard_right_percent) return text;
  const double change = *best.hard_right_percent - *usual->hard_right_percent;
  text +=
      fmt::format(" On hard cases it is right {} the usual one.", change < 0   ? "less often than"
                                                                  : change > 0 ? "more often than"
                                                                               : "as often as");
  return text;
}

std::string right_text(const std::vector<Row>& timed) {
  std::vector<std::string> right;
  for (const Row& row : rows_where(timed, &Row::hard_right_percent, std::optional(100.0))) {
    right.push_back(spoken_clipper(row.clipper));
  }
  constexpr std::size_t kNamed = 3;
  if (right.empty()) return " None of them is right on every hard case in float.";
  if (right.size() > kNamed) {
    return fmt::format(" {} of them are right on every hard case in float.",
                       capitalised(number_word(static_cast<std::int64_t>(right.size()))));
  }
  return fmt::format(" Right on every hard case in float {} {}.", right.size() == 1 ? "is" : "are",
                     listed(right));
}

}  // namespace

std::string finding(const std::vector<Row>& rows) {
  std::vector<Row> timed = rows;
  std::erase_if(timed, [](const Row& row) { return !row.speedup; });
  if (timed.empty()) return "No published method was timed in float.";
  std::vector<std::string> gained, others;
  for (const Field field : {Field::plane, Field::segments, Field::triangles}) {
    const std::vector<Row> of_field = rows_where(timed, &Row::field, field);
    if (of_field.empty()) continue;
    const bool gains = *fastest(of_field).speedup > kFaster;
    (gains ? gained : others).push_back(spoken_field(field));
  }
  if (gained.empty()) {
    return fmt::format("No published method is faster than the usual one for {}.", listed(others)) +
           right_text(timed);
  }
  const Row& best = fastest(timed);
  std::string text =
      fmt::format("Published methods are faster than the usual one for {}", listed(gained));
  if (!others.empty()) text += fmt::format(", but not for {}", listed(others));
  return fmt::format("{}; {}{}", text, gain_text(best, rows_where(timed, &Row::field, best.field)),
                     right_text(timed));
}

}  // namespace clipscope::experiments::history
