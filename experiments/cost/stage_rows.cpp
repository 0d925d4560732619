// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the stage's tables, from what was measured, and what certainty costs in words.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/contestants/spoken.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::cost {
namespace {

StageRow stage_row(const std::string& mix, InputFrom from, const MemoryTiming& pass) {
  const double out = pass.pass == MemoryPass::copy_everything ? pass.bytes : 0;
  return {.mix = mix,
          .from = from,
          .clipper = std::string(name_of(pass.pass)),
          .scalar = "-",
          .build = "-",
          .contract = std::string(kBytesAlone),
          .timing = StageFigures{pass.timing},
          .bytes_in = pass.bytes,
          .bytes_out = out,
          .gigabytes_per_second = (pass.bytes + out) / pass.timing.ns.median};
}

StageRow stage_row(const std::string& mix, InputFrom from, const StageTiming& timing) {
  const Contestant& c = *timing.contestant;
  StageRow row{.mix = mix,
               .from = from,
               .clipper = std::string(c.clipper),
               .scalar = std::string(c.scalar()),
               .build = std::string(c.build),
               .contract = std::string(name_of(c.contract)),
               .timing = {}};
  if (timing.timing.is_timed()) {
    row.timing = StageFigures{timing.timing, timing.limit_percent, timing.times_fastest};
    row.bytes_in = timing.bytes.positions + timing.bytes.rest;
    row.bytes_out = timing.bytes.out;
    row.gigabytes_per_second = timing.bytes.total() / row.timing->ns.median;
  }
  return row;
}

bool is_certain(const Contestant& c) { return c.stage_promise == StagePromise::correctly_rounded; }

// The fastest of a contract among those who promise correct rounding, or who don't; null if none
// was timed.
const StageTiming* fastest_of(const StageMeasurement& measured, Contract contract, bool certain) {
  const StageTiming* fastest = nullptr;
  for (const StageTiming& t : measured.contestants) {
    if (t.contestant->contract != contract || is_certain(*t.contestant) != certain) continue;
    if (!t.timing.is_timed()) continue;
    if (fastest == nullptr || t.timing.ns.median < fastest->timing.ns.median) fastest = &t;
  }
  return fastest;
}

}  // namespace

void StageTables::add(const std::string& mix, const StageMeasurement& measured,
                      PieceRecord& record) {
  const std::string place = fmt::format("stage {} {}", mix, name_of(measured.from));
  for (const MemoryTiming& pass : measured.passes) {
    stage.add(stage_row(mix, measured.from, pass));
    record.add(fmt::format("{} {}", place, name_of(pass.pass)), pass.timing);
  }
  for (const StageTiming& t : measured.contestants) {
    const StageRow row = stage_row(mix, measured.from, t);
    stage.add(row);
    record.add(
        fmt::format("{} {} {} {} {}", place, row.clipper, row.scalar, row.build, row.contract),
        t.timing);
    if (t.timing.is_timed()) continue;
    refused.add({mix, measured.from, row.clipper, row.build, row.contract, t.timing.refused});
  }
  for (const CertaintyRow& row : certainty_rows(mix, measured)) certainty.add(row);
}

MixRow mix_row(const StageInput& input, Contract contract) {
  const std::size_t triangles = input.size(contract);
  return {input.name, input.indices.empty() ? "copy, number" : "indexed",
          static_cast<std::int64_t>(triangles), shares_of(input, contract),
          bytes_of(MemoryPass::read_everything, input) * static_cast<double>(triangles) / 1e6};
}

std::vector<CertaintyRow> certainty_rows(const std::string& mix, const StageMeasurement& measured) {
  std::vector<CertaintyRow> rows;
  for (const Contract contract : kStageContracts) {
    const StageTiming *certain = fastest_of(measured, contract, true),
                      *fastest = fastest_of(measured, contract, false);
    if (certain == nullptr || fastest == nullptr) continue;
    const auto speedup = [](const StageTiming& t) {
      return t.timing.speedup ? t.timing.speedup->median : 0;
    };
    rows.push_back(
        {.mix = mix,
         .contract = contract,
         .from = measured.from,
         .fastest = std::string(fastest->contestant->clipper),
         .fastest_ns = fastest->timing.ns.median,
         .certain_ns = certain->timing.ns.median,
         .price = median_interval(ratios(certain->timing.samples_ns, fastest->timing.samples_ns)),
         .fastest_limit = fastest->limit_percent.median,
         .certain_limit = certain->limit_percent.median,
         .fastest_speedup = speedup(*fastest),
         .certain_speedup = speedup(*certain)});
  }
  return rows;
}

const CertaintyRow& dearest(const std::vector<CertaintyRow>& certainty) {
  return *std::ranges::max_element(certainty, {},
                                   [](const CertaintyRow& row) { return row.price.median; });
}

std::string where_text(const CertaintyRow& row) {
  const std::string form =
      row.contract == Contract::indexed ? "indexed" : fmt::format("by {}", name_of(row.contract));
  return fmt::format("on {} {}, from {}", spoken_set(row.mix), form, name_of(row.from));
}

std::string certainty_finding(const std::vector<CertaintyRow>& certainty) {
  if (certainty.empty()) return "";
  std::vector<std::string> free;
  for (const std::string& mix : distinct(certainty, &CertaintyRow::mix)) {
    const std::vector<CertaintyRow> rows = rows_where(certainty, &CertaintyRow::mix, mix);
    if (std::ranges::none_of(rows, &CertaintyRow::is_dear)) free.push_back(spoken_set(mix));
  }
  const std::string subject = "In a renderer's stage correct rounding";
  const CertaintyRow& most = dearest(certainty);
  if (!most.is_dear()) return subject + " is free on every mix, from memory and from cache.";
  if (free.empty()) {
    return fmt::format("{} costs time on every mix, and most {}.", subject, where_text(most));
  }
  return fmt::format("{} is free on {}, and costs most {}.", subject, listed(free),
                     where_text(most));
}

}  // namespace clipscope::experiments::cost
