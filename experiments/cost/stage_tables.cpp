// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/stage_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kMemory = "memory";  // in place of a clipper's contract

void append(const MedianInterval& interval, std::vector<Cell>& cells) {
  cells.insert(cells.end(), {interval.median, interval.low, interval.high});
}

// Gigabytes per second.
double speed(double bytes, double ns) { return bytes / ns; }

// The builds that a plot or finding speaks of: the scalar clippers' only one, and SIMD.
bool is_best_build(const RowView& row) { return row.text("build") != "plain"; }

std::string label_of(const RowView& row) {
  return fmt::format("{} {}", row.text("clipper"), row.text("scalar"));
}

// The row of a clipper in its best build; nothing if it was not timed.
std::optional<RowView> find_row(const Table& table, const std::string& mix,
                                std::string_view clipper, std::string_view contract) {
  for (const RowView& row : rows_of(table)) {
    if (row.text("mix") == mix && row.text("clipper") == clipper &&
        row.text("contract") == contract && is_best_build(row) &&
        row.find_number("ns_per_triangle")) {
      return row;
    }
  }
  return std::nullopt;
}

std::optional<RowView> fastest_row(const Table& table, const std::string& mix,
                                   std::string_view contract) {
  std::optional<RowView> fastest;
  for (const RowView& row : rows_of(table)) {
    if (row.text("mix") != mix || row.text("contract") != contract) continue;
    const auto ns = row.find_number("ns_per_triangle");
    if (ns && (!fastest || *ns < fastest->number("ns_per_triangle"))) fastest = row;
  }
  return fastest;
}

// "copy 12.3 x (homogeneous/batch, 10 ns; correctly rounded 1.05 times its time)"
std::string contract_text(const Table& stage, const std::string& mix, std::string_view contract) {
  const auto fastest = fastest_row(stage, mix, contract);
  if (!fastest || fastest->text("clipper") == "textbook") return "";
  std::string text = fmt::format(
      "{} {} x ({}, {} ns", contract, format_number(fastest->number("speedup_to_textbook")),
      fastest->text("clipper"), format_number(fastest->number("ns_per_triangle")));
  if (const auto rounded = find_row(stage, mix, "barycentric/correctly_rounded_batch", contract)) {
    text +=
        fmt::format("; correctly rounded {:.2f} times its time", rounded->number("times_fastest"));
  }
  return text + ")";
}

// How much faster than textbook a clipper would be that does nothing but move the bytes of a contract.
Series memory_limit(const Table& stage, std::string_view contract,
                    const std::vector<std::string>& mixes) {
  Series series{.name = "limit of memory", .x = {}, .y = {}, .muted = true};
  for (const std::string& mix : mixes) {
    const auto fastest = fastest_row(stage, mix, contract);
    series.y.push_back(100 * fastest->number("speedup_to_textbook") /
                       fastest->number("limit_percent"));
  }
  return series;
}

std::string growing_label(Growing growing) {
  switch (growing) {
    case Growing::triangles: return "triangles";
    case Growing::attributes: return "floats per vertex, position included";
    case Growing::planes: return "planes that a triangle crosses";
    default: return "threads";
  }
}

}  // namespace

Table cost_stage_table() {
  Table table("cost_stage",
              "The stage: clip-space triangles in, clip-space polygons out, no divide",
              {{"mix", "mix"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"build", "build"},
               {"contract", "contract"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_textbook", "x textbook"},
               {"speedup_low", "95 % low"},
               {"speedup_high", "high"},
               {"times_fastest", "time / fastest"},
               {"fastest_low", "95 % low"},
               {"fastest_high", "high"},
               {"bytes_in", "B in"},
               {"bytes_out", "B out"},
               {"gigabytes_per_second", "GB/s"},
               {"limit_percent", "% of limit"},
               {"limit_low", "95 % low"},
               {"limit_high", "high"}});
  table.add_note(
      "Contracts: copy, an array of vertices in, every surviving triangle written out; reference, "
      "streams of positions in, inside triangles by number; indexed, a mesh in, each vertex "
      "classified once. Four attributes. x textbook, and time / that of the contract's fastest: "
      "medians of the ratios of the same round.");
  table.add_note(
      "B in, B out: bytes that the contract reads and that the answer takes, per triangle. The "
      "memory limit is what passes over the same bytes (contract `memory`) take in the same round; "
      "% of limit: that time over the clipper's, 100 where it does nothing but move bytes. Answers "
      "go to a block that stays in cache. Not timed (-): see cost_stage_refused.");
  return table;
}

Table cost_stage_mixes_table() {
  return Table("cost_stage_mixes", "The inputs of the stage, by outcodes",
               {{"mix", "mix"},
                {"contracts", "contracts"},
                {"triangles", "triangles"},
                {"inside_percent", "inside %"},
                {"outside_percent", "outside %"},
                {"straddling_percent", "straddling %"},
                {"megabytes", "MB"}});
}

Table cost_stage_refused_table() {
  return Table("cost_stage_refused", "Not timed: the answers break the promise of the stage",
               {{"mix", "mix"},
                {"clipper", "clipper"},
                {"build", "build"},
                {"contract", "contract"},
                {"reason", "reason", 50}});
}

Table cost_growth_table() {
  Table table("cost_growth", "How the time of the stage grows",
              {{"grows", "grows"},
               {"n", "n"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"contract", "contract"},
               {"triangles", "triangles"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_textbook", "x textbook"}});
  table.add_note(
      "triangles: the first n of a game-like soup; beyond its size it streams through again and "
      "again. attributes: floats beside the position. planes: every triangle is cut by exactly n. "
      "threads: the soup in n parts, time by the clock on the wall. Column triangles: clipped in "
      "one run. Batch clippers in SIMD.");
  return table;
}

void add_stage_rows(const std::string& mix, const StageMeasurement& measured, Table& table) {
  for (const MemoryTiming& pass : measured.passes) {
    std::vector<Cell> cells = {mix, std::string(pass_name(pass.pass)), std::string("-"),
                               std::string("-"), std::string(kMemory)};
    append(pass.timing.ns, cells);
    append(pass.timing.speedup, cells);
    cells.resize(cells.size() + 3);  // no contract of its own to be the fastest of
    const double out = pass.pass == MemoryPass::copy_everything ? pass.bytes : 0;
    cells.insert(cells.end(), {pass.bytes, out, speed(pass.bytes + out, pass.timing.ns.median)});
    cells.resize(table.columns().size());
    table.add_row(std::move(cells));
  }
  for (const StageTiming& t : measured.contestants) {
    std::vector<Cell> cells = {mix, t.method, t.scalar, t.build, t.contract};
    if (t.timing.refused.empty()) {
      append(t.timing.ns, cells);
      append(t.timing.speedup, cells);
      append(t.times_fastest, cells);
      cells.insert(cells.end(), {t.bytes.positions + t.bytes.rest, t.bytes.out,
                                 speed(t.bytes.total(), t.timing.ns.median)});
      append(t.limit_percent, cells);
    }
    cells.resize(table.columns().size());
    table.add_row(std::move(cells));
  }
}

void add_mix_row(const StageInput& input, StageContract contract, Table& table) {
  const StageShares shares = shares_of(input, contract);
  const std::size_t triangles = input.size(contract);
  table.add_row(
      {input.name, std::string(input.indices.empty() ? "copy, reference" : "indexed"),
       static_cast<std::int64_t>(triangles), shares.inside, shares.outside, shares.straddling,
       bytes_of(MemoryPass::read_everything, input) * static_cast<double>(triangles) / 1e6});
}

void add_stage_refused_rows(const std::string& mix, const StageMeasurement& measured,
                            Table& table) {
  for (const StageTiming& t : measured.contestants) {
    if (t.timing.refused.empty()) continue;
    table.add_row({mix, t.method, t.build, t.contract, t.timing.refused});
  }
}

void add_growth_rows(std::span<const GrowthPoint> points, Table& table) {
  for (const GrowthPoint& p : points) {
    std::vector<Cell> cells = {std::string(growing_name(p.growing)), p.n, p.clipper, p.scalar,
                               p.contract};
    if (p.timing.refused.empty()) {
      cells.emplace_back(p.triangles);
      append(p.timing.ns, cells);
      if (p.timing.speedup.median > 0) cells.emplace_back(p.timing.speedup.median);
    }
    cells.resize(table.columns().size());
    table.add_row(std::move(cells));
  }
}

Plot stage_plot(const Table& stage, StageContract contract) {
  const std::string name(contract_name(contract));
  Plot plot{.name = "cost_stage_" + name,
            .title = fmt::format("The stage by {}: times faster than the textbook", name),
            .caption =
                "Clip-space triangles in, clip-space polygons out; ratios to the textbook in the "
                "same round, with 95 % intervals. Batch clippers in SIMD. Grey: what moving the "
                "same bytes takes, the limit of memory.",
            .x = {.label = "mix"},
            .y = {.label = "times faster than textbook"},
            .series = {}};
  std::map<std::string, std::map<std::string, RowView>> rows;  // by clipper, by mix
  std::vector<std::string> order;
  for (const RowView& row : rows_of(stage)) {
    if (row.text("contract") != name || row.text("clipper") == "textbook" || !is_best_build(row) ||
        !row.find_number("speedup_to_textbook")) {
      continue;
    }
    const std::string label = label_of(row);
    if (!rows.contains(label)) order.push_back(label);
    rows[label].insert_or_assign(row.text("mix"), row);
    const auto& categories = plot.categories;
    if (std::find(categories.begin(), categories.end(), row.text("mix")) == categories.end()) {
      plot.categories.push_back(row.text("mix"));
    }
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& label : order) {
    Series series{.name = label, .x = {}, .y = {}};
    for (const std::string& mix : plot.categories) {
      const auto found = rows[label].find(mix);
      const auto number = [&](std::string_view key) {
        return found == rows[label].end() ? kNone : found->second.number(key);
      };
      series.y.push_back(number("speedup_to_textbook"));
      series.low.push_back(number("speedup_low"));
      series.high.push_back(number("speedup_high"));
    }
    plot.series.push_back(std::move(series));
  }
  if (!plot.series.empty()) plot.series.push_back(memory_limit(stage, name, plot.categories));
  return plot;
}

Plot growth_plot(const Table& growth, Growing growing) {
  const bool by_magnitude = growing == Growing::triangles || growing == Growing::attributes;
  Plot plot{.name = fmt::format("cost_growth_{}", growing_name(growing)),
            .title = fmt::format("Time per triangle by {}", growing_name(growing)),
            .caption =
                "The stage: clip-space triangles in, clip-space polygons out, batch clippers in "
                "SIMD; medians with 95 % intervals.",
            .x = {.label = growing_label(growing), .logarithmic = by_magnitude},
            .y = {.label = "time [ns per triangle]", .logarithmic = true},
            .series = {}};
  for (const RowView& row : rows_of(growth)) {
    const auto ns = row.find_number("ns_per_triangle");
    if (row.text("grows") != growing_name(growing) || !ns) continue;
    const std::string name = fmt::format("{} {}", row.text("clipper"), row.text("contract"));
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const Series& s) { return s.name == name; });
    if (series == plot.series.end()) {
      plot.series.push_back(
          {.name = name, .x = {}, .y = {}, .muted = row.text("clipper") == "textbook"});
      series = plot.series.end() - 1;
    }
    const double offset = growing == Growing::attributes ? 4 : 0;
    series->x.push_back(static_cast<double>(row.count("n")) + offset);
    series->y.push_back(*ns);
    series->low.push_back(row.number("ns_low"));
    series->high.push_back(row.number("ns_high"));
  }
  return plot;
}

std::string stage_finding(const Table& stage) {
  std::vector<std::string> sentences;
  for (const std::string& mix : distinct_texts(stage, "mix")) {
    std::vector<std::string> parts;
    for (const StageContract contract : kStageContracts) {
      const std::string text = contract_text(stage, mix, contract_name(contract));
      if (!text.empty()) parts.push_back(text);
    }
    if (!parts.empty()) sentences.push_back(fmt::format("{}: {}", mix, fmt::join(parts, ", ")));
  }
  if (sentences.empty()) return "";
  return fmt::format("The stage, times faster than textbook: {}.", fmt::join(sentences, ". "));
}

}  // namespace clipscope::experiments
