// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/answers/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiments/frontier/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/judge/outcome.hpp"

namespace clipscope::experiments::answers {
namespace {

constexpr double kPerMillion = 1e6 / 100;  // from percent

std::array<double, 5> compared(const Quality& q) {
  const auto px = [](double error) { return error == 0 ? 0 : std::max(error, kRoundingPx); };
  return {px(q.game_px), px(q.hard_px), q.game_wrong, q.hard_wrong, q.hard_misrounded};
}

// Who was timed on the game-like mix, with what was found there and on hard triangles.
std::vector<Offer> joined(const std::vector<frontier::Row>& rows) {
  using R = frontier::Row;
  std::vector<Offer> offers;
  for (const R& game : rows_where(rows, &R::set, kGameLike)) {
    const R* hard = find_row(rows, &R::set, kHard, &R::contract, game.contract, &R::clipper,
                             game.clipper, &R::scalar, game.scalar);
    if (!game.is_main() || !game.timing || !game.max_px || !hard || !hard->max_px) continue;
    offers.push_back({game.contract,
                      game.clipper,
                      game.scalar,
                      game.timing->ns,
                      {.game_px = *game.max_px,
                       .hard_px = *hard->max_px,
                       .game_wrong = *game.wrong_percent * kPerMillion,
                       .hard_wrong = *hard->wrong_percent * kPerMillion,
                       .hard_misrounded = *hard->misrounded_percent}});
  }
  std::ranges::stable_sort(offers, {}, [](const Offer& o) { return o.ns.median; });
  return offers;
}

}  // namespace

bool buys_something(const Quality& worse, const Quality& better) {
  const auto from = compared(worse), to = compared(better);
  bool halves = false;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (to[i] > 2 * from[i]) return false;
    halves |= to[i] < from[i] && to[i] <= from[i] / 2;
  }
  return halves;
}

std::string wrong_text(double per_million, std::string_view triangles) {
  return fmt::format("gets {:.0f} of a million {} triangles wrong", per_million, triangles);
}

std::string misrounded_text(double percent) {
  return fmt::format("misses the nearest float in {} % of the coordinates", format_number(percent));
}

Name judged_as(const std::string& clipper, const std::string& scalar) {
  static const std::map<std::string, Name> kScalarForms = {
      {"view/batch", {"view/sutherland_hodgman", "float"}},
      {"homogeneous/batch", {"homogeneous/sutherland_hodgman", "float"}},
      {"homogeneous/batch_double", {"homogeneous/sutherland_hodgman", "double"}},
      {"barycentric/batch", {"barycentric/distance_matrix", "double"}},
      {"barycentric/correctly_rounded_batch", {"barycentric/correctly_rounded", "float"}}};
  const auto form = kScalarForms.find(clipper);
  return form == kScalarForms.end() ? Name(clipper, scalar) : form->second;
}

Contest::Contest(const Results& results) : offers_(joined(results.rows<frontier::Row>())) {}

Catalogue::Catalogue(const Results& results) {
  std::set<std::string> known;
  for (const hard_cases::VerdictRow& row : results.rows<hard_cases::VerdictRow>()) {
    const std::string theme = row.hard_case.substr(0, row.hard_case.find('/'));
    if (!cases_.contains(theme)) themes_.push_back(theme);
    if (known.insert(row.hard_case).second) ++cases_[theme];
    if (row.outcome == Outcome::not_applicable) continue;
    tallies_[{row.clipper, row.scalar}][theme] += {1, is_failure(row.outcome) ? 1 : 0};
  }
}

std::vector<Offer> Contest::offers(Contract contract) const {
  std::vector<Offer> offers = offers_;
  std::erase_if(offers, [&](const Offer& o) { return o.contract != contract; });
  return offers;
}

const Offer& Contest::offer(const Name& name, Contract contract) const {
  for (const Contract wanted : {contract, Contract::full}) {
    const auto found = std::ranges::find_if(offers_, [&](const Offer& o) {
      return o.contract == wanted && Name(o.clipper, o.scalar) == name;
    });
    if (found != offers_.end()) return *found;
  }
  throw MissingFigure(fmt::format("{} {} was not timed on {}", name.first, name.second, kGameLike));
}

Tally Catalogue::tally(const Name& name, const std::string& theme) const {
  const auto contestant = tallies_.find(name);
  if (contestant == tallies_.end()) return {};
  const auto found = contestant->second.find(theme);
  return found == contestant->second.end() ? Tally() : found->second;
}

Tally Catalogue::tally(const Name& name) const {
  Tally sum;
  for (const std::string& theme : themes_) sum += tally(name, theme);
  return sum;
}

}  // namespace clipscope::experiments::answers
