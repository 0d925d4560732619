// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the answers' tables, and what makes them of the other experiments' results.
//
// Every word that a run could turn is decided from its figures. What a run lacks is thrown as
// MissingFigure by all of these but answers(), which says so in place of the answer.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/answers/evidence.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::answers {

// The experiments whose tables and pictures the answers come from, in the order of a run.
inline constexpr std::array<std::string_view, 7> kEvidence = {
    "cost", "frontier", "w_sign", "plane_order", "guard_band", "effects", "hard_cases"};

// One question of the page, and where its evidence lies.
struct Row {
  std::string id, question, answer, experiment, table;

  static constexpr std::string_view kName = "answers";
  static constexpr std::string_view kTitle = "Where should a triangle be clipped?";
  static constexpr auto columns() {
    return std::tuple(column("id", &Row::id), column("question", "question", &Row::question, 24),
                      column("answer", "answer", &Row::answer, 60),
                      column("experiment", &Row::experiment), column("table", &Row::table));
  }
};

std::vector<Row> answers(const Results& results);

// One step of a price list: who costs more than the step before, and buys something for it.
struct PriceRow {
  Contract contract = Contract::full;
  std::string step, clipper, scalar;
  MedianInterval ns;
  double over_fastest_percent = 0, over_last_percent = 0;
  Quality quality;

  static constexpr std::string_view kName = "answers_prices";
  static constexpr std::string_view kTitle =
      "What accuracy costs in time: from the fastest to exact arithmetic";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Contract copy: a renderer's stage, clip space in and out. Full: view space in, NDC out. Time: on the game-like mix; in percent over the fastest of the contract, and over the step before. Errors: the largest on 3840 x 2160; wrong: triangles with wrong vertices in a million; misrounded: coordinates that are not the nearest floats. Hard: the set of slivers.",
      "A step buys something if it halves one of its figures and doubles none. An error that rounding the result to float may cost counts as no better than another such error, unless it is 0."};
  static constexpr auto columns() {
    using R = PriceRow;
    using Q = Quality;
    return std::tuple(
        column("contract", &R::contract), column("step", "step", &R::step, 34),
        column("clipper", &R::clipper), column("scalar", &R::scalar),
        interval("ns_per_triangle", "ns", "ns/tri", &R::ns),
        column("over_fastest_percent", "over fastest [%]", &R::over_fastest_percent),
        column("over_last_percent", "over last [%]", &R::over_last_percent),
        group(&R::quality,
              std::tuple(
                  column("game_px", "error [px]", &Q::game_px),
                  column("hard_px", "hard error [px]", &Q::hard_px),
                  column("game_wrong_per_million", "wrong [/M]", &Q::game_wrong),
                  column("hard_wrong_per_million", "hard wrong [/M]", &Q::hard_wrong),
                  column("hard_misrounded_percent", "hard misrounded [%]", &Q::hard_misrounded))));
  }
};

struct PriceList {
  std::vector<PriceRow> steps;    // from the fastest on; empty if nobody was timed
  std::vector<std::string> idle;  // names of those that cost more than a step and buy nothing
};
PriceList price_list(const std::vector<Offer>& offers);

// Which clipper for whom.
struct ReaderRow {
  std::string reader, needs;
  std::string recommended = {}, clipper = {}, scalar = {}, order = {}, guard = {};
  double ns = 0, over_fastest_percent = 0;
  std::string otherwise = {};
  std::string picture = {};  // a file of the run, relative to its folder; empty if it has none

  static constexpr std::string_view kName = "answers_readers";
  static constexpr std::string_view kTitle = "Which clipper for whom";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Recommended: the fastest on the game-like mix of those that have what is needed. A batch clipper is asked about the catalogue's cases by its scalar form. Otherwise: what another that is often used does wrong.",
      "Order: what place of the near plane is the fastest in clip space in that scalar; no order: every vertex is computed from the original ones. Guard: a guard band, where leaving the sides to the rasteriser is faster than cutting them (guard_band)."};
  static constexpr auto columns() {
    using R = ReaderRow;
    return std::tuple(
        column("reader", "for", &R::reader, 24), column("needs", "needs", &R::needs, 30),
        column("recommended", "recommended", &R::recommended, 26), column("clipper", &R::clipper),
        column("scalar", &R::scalar), column("order", "order", &R::order, 20),
        column("guard", "guard", &R::guard, 20), column("ns_per_triangle", "ns/tri", &R::ns),
        column("over_fastest_percent", "over fastest [%]", &R::over_fastest_percent),
        column("otherwise", "otherwise", &R::otherwise, 40), column("picture", &R::picture));
  }
};

// has_file: whether the run has that file.
std::vector<ReaderRow> readers(const Results& results,
                               const std::function<bool(const std::string&)>& has_file);

// Methods by themes of the catalogue: on how many cases of each a method fails; empty where it
// takes none of them. The first row has the numbers of cases.
Table stability_table(const Catalogue& catalogue);

struct EffectRow {
  std::string scene, called_for;
  std::int64_t left_out = 0;
  std::optional<double> saved_percent;
  std::int64_t changed = 0;

  static constexpr std::string_view kName = "answers_effects";
  static constexpr std::string_view kTitle =
      "Which effects each scene calls for, and what leaving out the rest saves";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Saved: of the time of a pipeline with every effect. Changed: polygons that differ in a bit that the plan keeps."};
  static constexpr auto columns() {
    using R = EffectRow;
    return std::tuple(column("scene", &R::scene), column("called_for", "calls for", &R::called_for),
                      column("left_out", "effects left out", &R::left_out),
                      column("saved_percent", "time saved [%]", &R::saved_percent),
                      column("changed_polygons", "changed", &R::changed));
  }
};

std::vector<EffectRow> effect_rows(const Results& results);

// The frontier as one picture: time on the game-like mix, wrong answers on hard triangles, the
// steps of the price list with what each costs along the line that joins them.
Plot hero_plot(const std::vector<Offer>& offers, const PriceList& prices);

}  // namespace clipscope::experiments::answers
