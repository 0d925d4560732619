// SPDX-License-Identifier: GPL-3.0-or-later
//
// Worst cases: the records of chains and of near ties, judged anew and searched beyond.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/machine/files.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/survey/case_batch.hpp"
#include "experiments/worst_cases/campaigns.hpp"
#include "experiments/worst_cases/rows.hpp"

namespace clipscope::experiments::worst_cases {
namespace {

Search search_of(const Selection& selection) {
  constexpr std::size_t kDay = 10;  // characters of "2026-11-30"
  return {selection.seed, selection.sample_or(256, 5000), date_now().substr(0, kDay)};
}

std::optional<double> figure_in(const Record* record) {
  return record == nullptr ? std::nullopt : std::optional(record->figure);
}

WorstInput input_of(const Contestant& contestant, std::string measure, const Record& record) {
  return worst_input(contestant, replay_text(CaseBatch(record.hard_case), 0), std::move(measure),
                     record.figure);
}

// The records of one scalar: judged, searched beyond, and the improved file.
void search_chains(const ExperimentContext& context, const Contestants& chains,
                   const std::string& scalar, TableOf<ChainRow>& table) {
  KeptFile file = builtin_kept(fmt::format("chains_{}.cases", scalar));
  const std::string name = "chains in " + scalar;
  context.piece(name, {&table}, [&](PieceRecord& record) {
    const std::vector<ChainKind> kinds = chain_kinds(chains);
    Progress progress(name, kinds.size());
    for (const ChainKind& kind : kinds) {
      const Record* const kept = file.find(name_of(kind));
      const std::optional<double> before = figure_in(kept);
      const ChainResult result = searched(kind, kept, search_of(context.selection()));
      table.add({std::string(kind.contestant->clipper), scalar, kind.inputs, kind.measure, before,
                 result.worst ? std::optional(result.worst->figure) : std::nullopt,
                 result.standing});
      if (result.worst) {
        const auto& [figure, hard_case] = *result.worst;
        record.worst_inputs.push_back(
            input_of(*kind.contestant,
                     fmt::format("{} {}", name_of(kind.measure), experiments::name_of(kind.inputs)),
                     *result.worst));
        file.put(figure, unit_of(kind.measure), hard_case);
      }
      progress.advance();
    }
    write_file(context.out() / file.name(), file.text());
  });
  context.emit_file(context.out() / file.name());
}

void take(TieRecord which, const TieResult& result, TieRow& row) {
  row.standing = std::max(row.standing, result.standing);
  if (!result.nearest) return;
  if (which == TieRecord::one_exponent) row.one_exponent_ulp = result.nearest->figure;
  if (which == TieRecord::any_exponents) row.any_exponents_ulp = result.nearest->figure;
  if (which == TieRecord::tie) row.ties = Ties::kept;
  row.is_right = row.is_right && is_rounded_right(result.nearest->hard_case);
}

TieRow searched_row(const TieKind& kind, const Search& search, KeptFile& file,
                    PieceRecord& record) {
  TieRow row{.kind = spoken_kind(kind),
             .limit_ulp = least_distance_ulp(kind),
             .ties = has_ties(kind.place) ? Ties::none : Ties::impossible,
             .is_right = true};
  for (const TieRecord which : kTieRecords) {
    const std::string name = name_of(kind, which);
    const TieResult result = searched(kind, which, file.find(name), search);
    take(which, result, row);
    if (!result.nearest) continue;
    record.worst_inputs.push_back(input_of(correctly_rounded(), name, *result.nearest));
    file.put(result.nearest->figure, "ulp from a tie", result.nearest->hard_case);
  }
  return row;
}

void search_ties(const ExperimentContext& context, TableOf<TieRow>& table) {
  KeptFile file = builtin_kept("near_ties.cases");
  context.piece("near ties", {&table}, [&](PieceRecord& record) {
    const Search search = search_of(context.selection());
    const std::vector<TieKind> kinds = all_tie_kinds();
    Progress progress("near ties", kinds.size() + 1);
    const std::vector<TieTally> chance = tallies_of_chance(search);
    progress.advance();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      TieRow row = searched_row(kinds[i], search, file, record);
      row.chance_ulp = chance[i].nearest_ulp;
      row.chance_numbers = chance[i].numbers;
      row.chance_ties = chance[i].ties;
      row.expected_ulp = expected_nearest_ulp(chance[i].numbers);
      table.add(row);
      progress.advance();
    }
    write_file(context.out() / file.name(), file.text());
  });
  context.emit_file(context.out() / file.name());
}

// What campaigns counted of the contestants selected.
TableOf<CampaignRow> campaigns_of(const Contestants& selected) {
  TableOf<CampaignRow> table;
  for (const CampaignRow& row : builtin_campaigns().counts) {
    const bool is_selected = std::ranges::any_of(selected, [&](const Contestant* contestant) {
      return contestant->clipper == row.clipper && contestant->scalar() == row.scalar;
    });
    if (is_selected) table.add(row);
  }
  return table;
}

TableOf<CampaignCommandRow> campaign_commands() {
  TableOf<CampaignCommandRow> table;
  for (const CampaignCommandRow& row : builtin_campaigns().commands) table.add(row);
  return table;
}

void run(const ExperimentContext& context) {
  TableOf<ChainRow> records;
  for (const std::string& scalar : context.selection().scalars) {
    if (scalar != kFormat<float>.name && scalar != kFormat<double>.name) continue;
    const Contestants chains = chain_contestants(context.selection(), scalar);
    if (!chains.empty()) search_chains(context, chains, scalar, records);
  }
  TableOf<TieRow> ties;
  const Contestants all = selected_contestants(context.selection());
  if (std::ranges::find(all, &correctly_rounded()) != all.end()) search_ties(context, ties);
  TableOf<WorstRow> worst;
  for (const WorstRow& row : worst_rows(records.rows())) worst.add(row);
  const TableOf<CampaignRow> campaigns = campaigns_of(all);
  context.emit(worst, ties, campaigns, records);
  if (!campaigns.rows().empty()) context.emit(campaign_commands());
  if (!ties.rows().empty()) context.emit(tie_plot(ties.rows()));
  context.finding(finding(worst.rows(), ties.rows(), campaigns.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "worst_cases", "What are the worst inputs known, and how near to a tie can a number be?", run};

}  // namespace clipscope::experiments::worst_cases
