// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

std::string name_of(const Entry& entry) { return entry.clipper + " " + entry.scalar; }

// Nothing is said about errors where nothing is visible.
Cell number(double value) {
  if (std::isnan(value)) return std::monostate();
  return value;
}

std::string standing_text(const FrontierRank& rank) {
  switch (rank.standing) {
    case Standing::unranked: return "not timed";
    case Standing::frontier: return "yes";
    default: return "no";
  }
}

std::string what_is_bought(ErrorMeasure measure, const Entry& from, const Entry& to) {
  const double before = from.error(measure), after = to.error(measure);
  switch (measure) {
    case ErrorMeasure::max_px:
      return fmt::format("{} px instead of {}", format_number(after), format_number(before));
    case ErrorMeasure::misrounded:
      return fmt::format("{} % more correctly rounded coordinates", format_number(before - after));
    default:
      return fmt::format("{} % wrong vertex sets instead of {}", format_number(after),
                         format_number(before));
  }
}

// The steps of a set in a contract by a measure, from the fastest on.
std::vector<RowView> steps_in(const Table& steps, const std::string& set,
                              const std::string& contract, ErrorMeasure measure) {
  std::vector<RowView> rows = rows_of(steps);
  std::erase_if(rows, [&](const RowView& row) {
    return row.text("set") != set || row.text("contract") != contract ||
           row.text("measure") != error_measure_name(measure);
  });
  return rows;
}

// "; from A (30 ns, 0.1 px) +20 % time buys B (36 ns, 1e-9 px); the most accurate is …": where the frontier by
// max px begins, its first step and its end.
std::string chain_of(const std::string& set, const Table& steps) {
  const std::vector<RowView> rows = steps_in(steps, set, "full", ErrorMeasure::max_px);
  if (rows.empty()) return "";
  const auto place = [](const RowView& row, const std::string& end) {
    return fmt::format("{} ({} ns, {} px)", row.text(end), format_number(row.number("ns_" + end)),
                       format_number(row.number("max_px_" + end)));
  };
  std::string chain = fmt::format("; from {} {:+.0f} % time buys {}", place(rows.front(), "from"),
                                  rows.front().number("time_percent"), place(rows.front(), "to"));
  if (rows.size() > 1) chain += fmt::format("; the most accurate is {}", place(rows.back(), "to"));
  return chain;
}

// "; copy: +4 % time buys 18 % more correctly rounded coordinates (A to B)": each step along the rounding
// frontier of a contract of the stage.
std::string stage_steps(const std::string& set, const std::string& contract, const Table& steps) {
  std::vector<std::string> texts;
  for (const RowView& row : steps_in(steps, set, contract, ErrorMeasure::misrounded)) {
    texts.push_back(fmt::format("{:+.0f} % time buys {} ({} to {})", row.number("time_percent"),
                                row.text("buys"), row.text("from"), row.text("to")));
  }
  if (texts.empty()) return "";
  return fmt::format("; in the stage by {} {}", contract, fmt::join(texts, ", "));
}

Cell dominated_by_cell(const FrontierRank& rank, std::span<const Entry> entries) {
  if (!rank.dominated_by) return std::monostate();
  return name_of(entries[*rank.dominated_by]);
}

}  // namespace

std::vector<std::string> sets_of(const Table& frontier) {
  std::vector<std::string> sets;
  for (const RowView& row : rows_of(frontier)) {
    if (sets.empty() || sets.back() != row.text("set")) sets.push_back(row.text("set"));
  }
  return sets;
}

FrontierKeys frontier_keys(ErrorMeasure measure) {
  switch (measure) {
    case ErrorMeasure::max_px: return {"max_px", "on_frontier", "dominated_by"};
    case ErrorMeasure::misrounded:
      return {"misrounded_percent", "on_rounding_frontier", "rounding_dominated_by"};
    default: return {"wrong_percent", "on_wrong_frontier", "wrong_dominated_by"};
  }
}

Table frontier_table() {
  Table table("frontier", "Error and time on the same triangles, and who is beaten in both",
              {{"set", "set"},
               {"contract", "contract"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_textbook", "x textbook"},
               {"speedup_low", "95 % low"},
               {"speedup_high", "high"},
               {"max_px", "max px"},
               {"q999_px", "99.9 % px"},
               {"correctly_rounded_percent", "rounded right %"},
               {"misrounded_percent", "misrounded %"},
               {"wrong_percent", "wrong set %"},
               {"on_frontier", "frontier"},
               {"dominated_by", "by"},
               {"on_rounding_frontier", "rounding frontier"},
               {"rounding_dominated_by", "by"},
               {"on_wrong_frontier", "wrong-set frontier"},
               {"wrong_dominated_by", "by"},
               {"judged_triangles", "judged"},
               {"visible_triangles", "visible"}});
  table.add_note(
      "Every contestant is judged on all triangles of the set and timed on the same, a slow one on "
      "a "
      "leading share of them (they are shuffled). Errors are over visible triangles, wrong ones "
      "included: max px is the largest distance on a screen of 3840 x 2160 between what is drawn "
      "and "
      "what should be. Rounded right: coordinates that, kept as floats, are the floats nearest to "
      "the "
      "exact ones. Wrong set: triangles with the wrong vertices.");
  table.add_note(
      "Frontier (by max px, by misrounded coordinates, by wrong sets): no other contestant is at "
      "most "
      "as slow (median), at most as far off, and better in one of the two; times differ if their "
      "95 % intervals are apart. Each contract has frontiers of its own. Not timed: the answers "
      "break "
      "the promise (frontier_refused).");
  table.add_note(
      "Contract full: view space in, NDC out, judged against the exact frustum. Copy and "
      "reference: "
      "the stage, the same triangles in clip space, clip space out, batch clippers in SIMD; judged "
      "against what is exact for these clip coordinates. Rounded right is then about x, y, z, w.");
  return table;
}

Table frontier_steps_table() {
  Table table("frontier_steps", "What the next step along the frontier costs, and what it buys",
              {{"set", "set"},
               {"contract", "contract"},
               {"measure", "by"},
               {"from", "from"},
               {"to", "to"},
               {"time_percent", "time +%"},
               {"buys", "buys"},
               {"ns_from", "ns from"},
               {"ns_to", "ns to"},
               {"max_px_from", "max px from"},
               {"max_px_to", "to"},
               {"correctly_rounded_percent_from", "rounded right % from"},
               {"correctly_rounded_percent_to", "to"},
               {"wrong_percent_from", "wrong set % from"},
               {"wrong_percent_to", "to"}});
  return table;
}

Table frontier_refused_table() {
  return Table("frontier_refused", "Contestants that are not timed since they break their promise",
               {{"set", "set"},
                {"contract", "contract"},
                {"clipper", "clipper"},
                {"scalar", "scalar"},
                {"reason", "reason"}});
}

void add_frontier_rows(const std::string& set, std::span<const Entry> entries, Table& table) {
  for (const Entry& e : entries) {
    std::vector<Cell> cells = {set, e.contract, e.clipper, e.scalar};
    if (e.timing.refused.empty()) {
      const Timing& t = e.timing;
      cells.insert(cells.end(), {t.ns.median, t.ns.low, t.ns.high, t.speedup.median, t.speedup.low,
                                 t.speedup.high});
    } else {
      cells.resize(cells.size() + 6);
    }
    const bool visible = e.accuracy.visible > 0;
    const double nothing = std::nan("");
    cells.push_back(number(visible ? e.accuracy.error_px.max() : nothing));
    cells.push_back(number(visible ? e.accuracy.error_px.quantile(0.999) : nothing));
    cells.push_back(number(e.accuracy.correctly_rounded_percent()));
    cells.push_back(number(e.error(ErrorMeasure::misrounded)));
    cells.push_back(number(e.error(ErrorMeasure::wrong)));
    for (const ErrorMeasure measure : kErrorMeasures) {
      cells.emplace_back(standing_text(e.rank(measure)));
      cells.push_back(dominated_by_cell(e.rank(measure), entries));
    }
    cells.emplace_back(e.accuracy.triangles);
    cells.emplace_back(e.accuracy.visible);
    table.add_row(std::move(cells));
  }
}

void add_step_rows(const std::string& set, std::span<const Entry> entries, Table& table) {
  for (const ErrorMeasure measure : kErrorMeasures) {
    const std::vector<std::size_t> steps = steps_of(entries, measure);
    for (std::size_t i = 1; i < steps.size(); ++i) {
      const Entry &from = entries[steps[i - 1]], &to = entries[steps[i]];
      const double more_time = 100 * (to.timing.ns.median / from.timing.ns.median - 1);
      table.add_row(
          {set, to.contract, std::string(error_measure_name(measure)), name_of(from), name_of(to),
           more_time, what_is_bought(measure, from, to), from.timing.ns.median, to.timing.ns.median,
           from.error(ErrorMeasure::max_px), to.error(ErrorMeasure::max_px),
           number(from.accuracy.correctly_rounded_percent()),
           number(to.accuracy.correctly_rounded_percent()), number(from.error(ErrorMeasure::wrong)),
           number(to.error(ErrorMeasure::wrong))});
    }
  }
}

void add_refused_rows(const std::string& set, std::span<const Entry> entries, Table& table) {
  for (const Entry& e : entries) {
    if (!e.timing.refused.empty())
      table.add_row({set, e.contract, e.clipper, e.scalar, e.timing.refused});
  }
}

std::string frontier_finding(const Table& frontier, const Table& steps) {
  std::vector<std::string> sentences;
  for (const std::string& set : sets_of(frontier)) {
    int timed = 0, members = 0;
    for (const RowView& row : rows_of(frontier)) {
      if (row.text("set") != set || row.text("contract") != "full") continue;
      if (row.text("on_frontier") == "not timed") continue;
      ++timed;
      members += row.text("on_frontier") == "yes" ? 1 : 0;
    }
    std::string sentence =
        fmt::format("{}: {} of {} are not dominated{}", set, members, timed, chain_of(set, steps));
    for (const char* contract : {"copy", "reference"}) {
      sentence += stage_steps(set, contract, steps);
    }
    sentences.push_back(std::move(sentence));
  }
  return fmt::format("{}.", fmt::join(sentences, ". "));
}

}  // namespace clipscope::experiments
