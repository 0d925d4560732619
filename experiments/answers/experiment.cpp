// SPDX-License-Identifier: GPL-3.0-or-later
//
// Answers: what a person takes away from a run in one minute, each with its evidence.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/answers/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/report/experiment.hpp"

namespace clipscope::experiments::answers {
namespace {

constexpr std::size_t kFewIdle = 8;

// Who costs more than a step and buys nothing: by name, the first of them, and how many more.
std::string idle_text(Contract contract, std::vector<std::string> idle) {
  const std::size_t more = idle.size() > kFewIdle ? idle.size() - kFewIdle : 0;
  idle.resize(idle.size() - more);
  return fmt::format("Contract {}: these cost more than a step and buy nothing: {}{}.",
                     name_of(contract), fmt::join(idle, "; "),
                     more > 0 ? fmt::format("; and {} more (table frontier)", more) : "");
}

void emit_prices(const ExperimentContext& context, const Results& results) {
  const Contest contest(results);
  TableOf<PriceRow> table;
  for (const Contract contract : {Contract::copy, Contract::full}) {
    const PriceList prices = price_list(contest.offers(contract));
    for (const PriceRow& step : prices.steps) table.add(step);
    if (!prices.idle.empty()) table.add_note(idle_text(contract, prices.idle));
  }
  table.add_note(machine_description());
  context.emit(table);
  const std::vector<Offer> full = contest.offers(Contract::full);
  if (!full.empty()) context.emit(hero_plot(full, price_list(full)));
}

void emit_readers(const ExperimentContext& context, const Results& results) {
  const auto has_file = [&](const std::string& file) {
    return std::filesystem::exists(context.out().parent_path() / file);
  };
  TableOf<ReaderRow> table;
  for (const ReaderRow& row : readers(results, has_file)) table.add(row);
  context.emit(table);
}

void emit_effects(const ExperimentContext& context, const Results& results) {
  TableOf<EffectRow> table;
  for (const EffectRow& row : effect_rows(results)) table.add(row);
  context.emit(table);
}

// A table of what a run lacks is left out: the answers say so.
template <class F>
void if_there(F&& emit) {
  try {
    emit();
  } catch (const MissingFigure&) {
  }
}

// All of this belongs to no piece: a resumed run may know more.
void run(const ExperimentContext& context) {
  const Results results([&](const std::string& name) { return context.emitted(name); });
  TableOf<Row> table;
  for (const Row& row : answers(results)) table.add(row);
  context.emit(table);
  if_there([&] { emit_prices(context, results); });
  if_there([&] { emit_readers(context, results); });
  if_there([&] { context.emit(stability_table(Catalogue(results))); });
  if_there([&] { emit_effects(context, results); });
  context.finding(table.rows().front().answer);
}

}  // namespace

extern constinit const Experiment kExperiment{
    "answers", "Where should a triangle be clipped, and what does accuracy cost?", run};

}  // namespace clipscope::experiments::answers
