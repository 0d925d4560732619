// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/rows.hpp"

#include <fmt/format.h>

#include <cmath>

namespace clipscope::experiments::frontier {
namespace {

std::string short_name(const Entry& entry) {
  return fmt::format("{} {}", entry.contestant->clipper, entry.contestant->scalar());
}

std::optional<double> if_number(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

Place place_of(const FrontierRank& rank, std::span<const Entry> entries) {
  if (!rank.dominated_by) return {rank.standing, {}};
  return {rank.standing, short_name(entries[*rank.dominated_by])};
}

std::string what_is_bought(Measure measure, const Entry& from, const Entry& to) {
  const double before = from.error(measure), after = to.error(measure);
  switch (measure) {
    case Measure::max_px:
      return fmt::format("{} px instead of {}", format_number(after), format_number(before));
    case Measure::misrounded:
      return fmt::format("{} % more correctly rounded coordinates", format_number(before - after));
    default:
      return fmt::format("{} % wrong vertex sets instead of {}", format_number(after),
                         format_number(before));
  }
}

}  // namespace

void add_rows(const std::string& set, std::span<const Entry> entries, TableOf<Row>& table) {
  for (const Entry& e : entries) {
    Row row{.set = set,
            .contract = e.contestant->contract,
            .from = e.from,
            .clipper = std::string(e.contestant->clipper),
            .scalar = std::string(e.contestant->scalar()),
            .timing = if_timed(e.timing),
            .correctly_rounded_percent = if_number(e.accuracy.correctly_rounded_percent()),
            .misrounded_percent = if_number(e.error(Measure::misrounded)),
            .wrong_percent = if_number(e.error(Measure::wrong)),
            .by_px = place_of(e.rank(Measure::max_px), entries),
            .by_rounding = place_of(e.rank(Measure::misrounded), entries),
            .by_wrong = place_of(e.rank(Measure::wrong), entries),
            .judged_triangles = e.accuracy.triangles,
            .visible_triangles = e.accuracy.visible};
    if (e.accuracy.visible > 0) {
      row.max_px = if_number(e.accuracy.error_px.max());
      row.q999_px = if_number(e.accuracy.error_px.quantile(0.999));
    }
    table.add(row);
  }
}

void add_rows(const std::string& set, std::span<const Entry> entries, TableOf<StepRow>& table) {
  for (const Measure measure : kMeasures) {
    const std::vector<std::size_t> steps = steps_of(entries, measure);
    for (std::size_t i = 1; i < steps.size(); ++i) {
      const Entry &from = entries[steps[i - 1]], &to = entries[steps[i]];
      table.add({.set = set,
                 .contract = to.contestant->contract,
                 .input_from = to.from,
                 .measure = measure,
                 .from = short_name(from),
                 .to = short_name(to),
                 .time_percent = 100 * (to.timing.ns.median / from.timing.ns.median - 1),
                 .buys = what_is_bought(measure, from, to),
                 .ns_from = from.timing.ns.median,
                 .ns_to = to.timing.ns.median,
                 .max_px_from = from.error(Measure::max_px),
                 .max_px_to = to.error(Measure::max_px),
                 .rounded_from = if_number(from.accuracy.correctly_rounded_percent()),
                 .rounded_to = if_number(to.accuracy.correctly_rounded_percent()),
                 .wrong_from = if_number(from.error(Measure::wrong)),
                 .wrong_to = if_number(to.error(Measure::wrong))});
    }
  }
}

void add_rows(const std::string& set, std::span<const Entry> entries, TableOf<RefusedRow>& table) {
  for (const Entry& e : entries) {
    // Whom the stage refused from memory it refuses from cache.
    const bool is_repeated = e.contestant->contract != Contract::full && e.from == InputFrom::cache;
    if (e.timing.is_timed() || is_repeated) continue;
    table.add({set, e.contestant->contract, std::string(e.contestant->clipper),
               std::string(e.contestant->scalar()), e.timing.refused});
  }
}

}  // namespace clipscope::experiments::frontier
