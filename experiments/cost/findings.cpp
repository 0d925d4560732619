// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of cost from view space on: which space is the fastest.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "experiments/contestants/spoken.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::cost {
namespace {

constexpr std::string_view kReference = "homogeneous/sutherland_hodgman";
// One for each space; dividing first without a near cut is compared, too, but is no rival: it is
// wrong where w <= 0.
constexpr std::array<std::string_view, 3> kSpaces = {"view/sutherland_hodgman", kReference,
                                                     "cvv/near_first"};
constexpr std::array<std::string_view, 4> kCompared = {kSpaces[0], kSpaces[1], kSpaces[2],
                                                       "cvv/perspective"};

std::optional<double> ratio(const std::optional<double>& part, const std::optional<double>& whole) {
  if (!part || !whole || *whole == 0) return std::nullopt;
  return *part / *whole;
}

SpaceRow space_row(const std::string& mix, std::string_view clipper, const std::string& scalar,
                   const std::vector<Row>& times, const std::vector<OperationsRow>& operations) {
  using Operations = OperationsRow;
  SpaceRow row{.mix = mix, .clipper = std::string(clipper), .scalar = scalar};
  const auto ns = [&](std::string_view c) -> std::optional<MedianInterval> {
    const Row* found = find_row(times, &Row::mix, mix, &Row::clipper, c, &Row::scalar, scalar,
                                &Row::is_timed, true);
    return found == nullptr ? std::nullopt : std::optional(found->timing->ns);
  };
  const auto median = [&](std::string_view c) -> std::optional<double> {
    const auto found = ns(c);
    return found ? std::optional(found->median) : std::nullopt;
  };
  const auto count = [&](std::string_view c, auto figure) -> std::optional<double> {
    const auto* found = find_row(operations, &Operations::mix, mix, &Operations::clipper, c);
    return found == nullptr ? std::nullopt : std::optional(std::invoke(figure, *found));
  };
  const auto count_ratio = [&](auto figure) {
    return ratio(count(clipper, figure), count(kReference, figure));
  };
  row.ns = ns(clipper);
  row.time = ratio(median(clipper), median(kReference));
  row.arithmetic = count_ratio(&Operations::arithmetic);
  row.divisions = count_ratio(&Operations::divisions);
  return row;
}

// The timed spaces on a mix, the fastest first.
std::vector<SpaceRow> rivals_on(const std::vector<SpaceRow>& spaces, const std::string& mix) {
  std::vector<SpaceRow> rivals = rows_where(spaces, &SpaceRow::mix, mix);
  std::erase_if(rivals, [](const SpaceRow& row) {
    return !row.ns || std::ranges::find(kSpaces, row.clipper) == kSpaces.end();
  });
  std::ranges::stable_sort(rivals, {}, [](const SpaceRow& row) { return row.ns->median; });
  return rivals;
}

std::string name(const SpaceRow& row) { return spoken_clipper(row.clipper); }

// "view space takes 1.7 times as long and dividing behind a near cut 1.6 times".
std::string slower_text(const std::vector<SpaceRow>& slower, const SpaceRow& fastest) {
  std::vector<std::string> texts;
  for (const SpaceRow& row : slower) {
    const std::string times = times_text(row.ns->median / fastest.ns->median);
    texts.push_back(texts.empty() ? fmt::format("{} takes {} as long", name(row), times)
                                  : fmt::format("{} {}", name(row), times));
  }
  return listed(texts);
}

// "Clip space is the fastest of the three spaces: on the game-like mix view space takes 1.7 times
// as long ..."; those whose intervals meet that of the fastest are as fast.
std::string order_sentence(const std::vector<SpaceRow>& rivals) {
  const std::string on = spoken_set(rivals.front().mix);
  if (rivals.size() == 1) {
    return fmt::format("{} was compared with no other space on {}.",
                       capitalised(name(rivals.front())), on);
  }
  const auto is_slower = [&](const SpaceRow& row) { return is_below(*rivals.front().ns, *row.ns); };
  std::vector<std::string> equals;
  std::vector<SpaceRow> rows_behind;
  std::ranges::copy_if(rivals, std::back_inserter(rows_behind), is_slower);
  for (const SpaceRow& row : rivals) {
    if (!is_slower(row)) equals.push_back(name(row));
  }
  const std::string slower = slower_text(rows_behind, rivals.front());
  if (equals.size() > 1) {
    return fmt::format("{} are equally fast on {}{}.", capitalised(listed(equals)), on,
                       slower.empty() ? "" : ", where " + slower);
  }
  return fmt::format("{} is the fastest of {} spaces: on {} {}.", capitalised(equals.front()),
                     number_word(static_cast<std::int64_t>(rivals.size())), on, slower);
}

// On which of the other mixes another space is ahead, or that there is none. Empty with one mix.
std::string mixes_sentence(const std::vector<SpaceRow>& spaces) {
  const std::vector<std::string> mixes = distinct(spaces, &SpaceRow::mix);
  const std::string first = rivals_on(spaces, mixes.front()).front().clipper;
  std::vector<std::string> behind;
  std::size_t compared = 0;
  for (const std::string& mix : mixes) {
    const std::vector<SpaceRow> rivals = rivals_on(spaces, mix);
    if (mix == mixes.front() || rivals.size() < 2) continue;
    ++compared;
    const SpaceRow* row = find_row(rivals, &SpaceRow::clipper, first);
    if (row == nullptr || !is_below(*rivals.front().ns, *row->ns)) continue;
    behind.push_back(fmt::format("{} is ahead on {}", name(rivals.front()), spoken_set(mix)));
  }
  if (compared == 0) return "";
  if (behind.empty()) return " No other space is ahead on any other mix.";
  return fmt::format(" The order depends on the mix: {}.", listed(behind));
}

// Who of the first mix needs the most of something.
std::string operations_sentence(const std::vector<SpaceRow>& first_mix) {
  const auto most = [&](auto figure) -> const SpaceRow* {
    const SpaceRow* found = nullptr;
    for (const SpaceRow& row : first_mix) {
      if (!(row.*figure) || std::ranges::find(kSpaces, row.clipper) == kSpaces.end()) continue;
      if (found == nullptr || *(row.*figure) > *(found->*figure)) found = &row;
    }
    return found;
  };
  const SpaceRow *arithmetic = most(&SpaceRow::arithmetic), *divisions = most(&SpaceRow::divisions);
  if (arithmetic == nullptr || divisions == nullptr) return "";
  if (arithmetic == divisions) {
    return fmt::format(" {} needs the most arithmetic and the most divisions.",
                       capitalised(name(*arithmetic)));
  }
  return fmt::format(" {} needs the most arithmetic, {} the most divisions.",
                     capitalised(name(*arithmetic)), name(*divisions));
}

}  // namespace

std::vector<SpaceRow> space_rows(const std::vector<Row>& times,
                                 const std::vector<OperationsRow>& operations) {
  std::vector<SpaceRow> rows;
  if (times.empty()) return rows;
  const bool has_float = find_row(times, &Row::scalar, "float") != nullptr;
  const std::string scalar = has_float ? "float" : times.front().scalar;
  for (const std::string& mix : distinct(times, &Row::mix)) {
    for (const std::string_view clipper : kCompared) {
      const SpaceRow row = space_row(mix, clipper, scalar, times, operations);
      if (row.ns || row.arithmetic) rows.push_back(row);
    }
  }
  return rows;
}

std::string space_finding(const std::vector<SpaceRow>& spaces) {
  if (spaces.empty()) return "None of the three spaces was timed.";
  const std::string& mix = spaces.front().mix;
  const std::vector<SpaceRow> rivals = rivals_on(spaces, mix);
  if (rivals.empty()) return "None of the three spaces was timed.";
  return order_sentence(rivals) + mixes_sentence(spaces) +
         operations_sentence(rows_where(spaces, &SpaceRow::mix, mix));
}

}  // namespace clipscope::experiments::cost
