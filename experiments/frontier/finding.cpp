// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of accuracy and time: the price of correct rounding, and where the frontier leads.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::frontier {
namespace {

constexpr double kNearlyFree = 10, kHalf = 50, kTwice = 100;  // percent of time

// The rows of a set, contract and place that were timed and judged, the fastest first.
std::vector<Row> timed_rows(const std::vector<Row>& rows, const std::string& set, Contract contract,
                            InputFrom from) {
  std::vector<Row> timed =
      rows_where(rows, &Row::set, set, &Row::contract, contract, &Row::from, from);
  std::erase_if(timed, [](const Row& row) { return !row.timing || !row.misrounded_percent; });
  std::ranges::stable_sort(timed, {}, [](const Row& row) { return row.timing->ns.median; });
  return timed;
}

// What a set asks of time for coordinates that are proved to be right.
struct Price {
  std::string set;       // in words
  double percent = 0;    // of time, over the fastest
  std::string unproved;  // the fastest that has every coordinate right without a proof, if any
};

std::vector<Price> prices_of(const std::vector<Row>& rows, Contract contract) {
  std::vector<Price> prices;
  for (const auto& [set, from] :
       distinct(rows, [](const Row& r) { return std::pair(r.set, r.from); })) {
    const std::vector<Row> timed = timed_rows(rows, set, contract, from);
    const auto proved = std::ranges::find_if(timed, [](const Row& row) {
      return row.clipper.starts_with("barycentric/correctly_rounded");
    });
    if (proved == timed.end()) continue;
    const auto right = std::ranges::find(timed, std::optional(0.0), &Row::misrounded_percent);
    const bool is_cached = contract != Contract::full && from == InputFrom::cache;
    prices.push_back({spoken_set(set) + (is_cached ? " from cache" : ""),
                      100 * (proved->timing->ns.median / timed.front().timing->ns.median - 1),
                      right < proved ? spoken_contestant(right->clipper, right->scalar) : ""});
  }
  return prices;
}

std::string_view claim_of(const Price& price) {
  if (price.percent <= kNearlyFree) return "is nearly free";
  if (price.percent <= kHalf) return "costs less than half as much time again";
  return price.percent <= kTwice ? "costs less than twice the time" : "more than doubles the time";
}

std::string more_time(const Price& price) {
  return price.percent < 0.5 ? "no more time" : fmt::format("{:.0f} % more time", price.percent);
}

// Its price on the first set and on the dearest one.
std::string price_sentence(const std::vector<Price>& prices, std::string_view where) {
  const Price& first = prices.front();
  const Price& dearest = *std::ranges::max_element(prices, {}, &Price::percent);
  const std::string text =
      fmt::format("{} correct rounding {} on {}, where it takes {} than the fastest clipper.",
                  where, claim_of(first), first.set, more_time(first));
  if (dearest.set == first.set) return text;
  const std::string more = more_time(dearest);
  return claim_of(dearest) == claim_of(first)
             ? fmt::format("{} On no set is it dearer than on {}, at {}.", text, dearest.set, more)
             : fmt::format("{} On {} it {}, at {}.", text, dearest.set, claim_of(dearest), more);
}

// Who has the same coordinates for less, without a proof.
std::string unproved_sentence(const std::vector<Price>& prices) {
  const Price& dearest = *std::ranges::max_element(prices, {}, &Price::percent);
  if (dearest.unproved.empty()) return "";
  return fmt::format(
      " What it buys is the proof: on {} {} has every coordinate right, too, and is faster.",
      dearest.set, dearest.unproved);
}

std::string rounding_text(const std::vector<Row>& rows) {
  for (const auto& [contract, where] : {std::pair{Contract::copy, "In the stage of a renderer"},
                                        std::pair{Contract::number, "In the stage of a renderer"},
                                        std::pair{Contract::full, "From view space on"}}) {
    const std::vector<Price> prices = prices_of(rows, contract);
    if (!prices.empty()) return price_sentence(prices, where) + unproved_sentence(prices);
  }
  return "No clipper that promises correct rounding was timed.";
}

// The scalars of the frontier by largest error from view space on, the fastest first, and how many
// contestants it leaves behind.
std::string way_text(const std::vector<Row>& rows, const std::string& set) {
  std::vector<std::string> scalars;
  std::size_t behind = 0;
  std::vector<Row> timed;
  for (const InputFrom from : distinct(rows, &Row::from)) {
    const std::vector<Row> there = timed_rows(rows, set, Contract::full, from);
    timed.insert(timed.end(), there.begin(), there.end());
  }
  for (const Row& row : timed) {
    if (row.by_px.standing != Standing::frontier) {
      ++behind;
    } else if (std::ranges::find(scalars, spoken_scalar(row.scalar)) == scalars.end()) {
      scalars.push_back(spoken_scalar(row.scalar));
    }
  }
  if (scalars.empty()) return "";
  const double share = static_cast<double>(behind) / static_cast<double>(timed.size());
  const std::string way =
      scalars.size() == 1
          ? fmt::format("all that is worth its time computes in {}", scalars.front())
          : fmt::format("smaller errors are bought by going from {}", fmt::join(scalars, " to "));
  return fmt::format(
      " From view space on, on {}, {}; {} contestants are beaten in both error and time.",
      spoken_set(set), way, quantity(share));
}

}  // namespace

std::string finding(const std::vector<Row>& rows) {
  const auto judged = std::ranges::find_if(
      rows, [](const Row& row) { return row.by_px.standing != Standing::unranked; });
  if (judged == rows.end()) return "No contestant could be judged and timed.";
  return rounding_text(rows) + way_text(rows, judged->set);
}

}  // namespace clipscope::experiments::frontier
