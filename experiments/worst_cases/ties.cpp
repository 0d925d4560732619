// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/ties.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/hunt/hunt.hpp"
#include "experiments/judge/questions.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/case_batch.hpp"
#include "experiments/worst_cases/constructed.hpp"

namespace clipscope::experiments::worst_cases {
namespace {

// Rates prey by how near it is to a tie: the logarithm of the distance, so that larger is nearer.
class TieRater : public hunt::Rater {
 public:
  explicit TieRater(const TieKind& kind) : kind_(kind) {}

  int attributes() const override { return 1; }

  hunt::Evaluated evaluate(const hunt::Setting& setting, std::span<const hunt::Prey> litter,
                           double floor, const hunt::Outcomes&) const override {
    constexpr std::size_t kMost = 8;
    hunt::Evaluated evaluated;
    const std::vector<double> values = exact_values(setting, litter);
    for (std::size_t i = 0; i < litter.size(); ++i) {
      if (!(values[i] > floor)) continue;
      evaluated.worst.push_back(litter[i]);
      evaluated.worst.back().value = values[i];
    }
    std::ranges::stable_sort(evaluated.worst, std::ranges::greater(), &hunt::Prey::value);
    evaluated.worst.resize(std::min(evaluated.worst.size(), kMost));
    return evaluated;
  }

  std::vector<double> exact_values(const hunt::Setting& setting,
                                   std::span<const hunt::Prey> litter) const override {
    std::vector<double> values;
    for (const hunt::Prey& prey : litter) {
      const HardCase c = marked(hunt::case_of(setting, prey, attributes()));
      const std::optional<double> ulp = tie_tally(kind_, exact_polygon(c)).nearest_ulp;
      values.push_back(ulp ? -std::log2(*ulp) : 0);
    }
    return values;
  }

 private:
  const TieKind kind_;
};

std::optional<HardCase> bred(const TieKind& kind, const HardCase& start, const Search& search) {
  const bool is_of_attribute = kind.quantity == Quantity::attribute;
  const hunt::Hunted hunted =
      hunt::hunt(correctly_rounded(),
                 {.measure = is_of_attribute ? hunt::Measure::attribute : hunt::Measure::ulp,
                  .seed = search.seed,
                  .evaluations = search.sample,
                  .catalogue = false,
                  .space = kind.space,
                  .plain = true,
                  .begin_with = start},
                 TieRater(kind));
  if (!hunted.worst) return std::nullopt;
  return marked(hunted.worst->cases.front());
}

// start: the record, if there is one.
std::optional<HardCase> search_for(const TieKind& kind, TieRecord record,
                                   std::optional<HardCase> start, const Search& search) {
  Random random(search.seed);
  const std::size_t attempts = kAttempts * search.sample;
  if (record != TieRecord::any_exponents) {
    const Aim aim = record == TieRecord::tie ? Aim::tie : Aim::near_tie;
    return constructed(kind, aim, attempts, random);
  }
  if (!start) {
    start = has_ties(kind.place) ? beside_a_tie(kind)
                                 : constructed(kind, Aim::near_tie, attempts, random);
  }
  return start ? bred(kind, *start, search) : std::nullopt;
}

HardCase random_triangle(Space space, Random& random) {
  HardCase c;
  c.space = space;
  const auto number = [&](double low, double high) {
    const double x = random.uniform(low, high);
    return double{static_cast<float>(x)};
  };
  c.vertices.resize(3);
  for (reference::InputVertex& v : c.vertices) {
    for (const std::size_t k : {0, 1}) v.position[k] = number(-4, 4);
    v.position[2] = space == Space::view ? number(-6, 0) : number(-4, 4);
    if (space == Space::clip) v.position[3] = number(-1, 4);
    v.attributes[0] = number(-1, 1);
  }
  return marked(c);
}

}  // namespace

std::string name_of(const TieKind& kind, TieRecord record) {
  return fmt::format("{}_{}", name_of(kind), names_of(record)[static_cast<std::size_t>(record)]);
}

std::optional<double> figure_of(const TieKind& kind, TieRecord record, const HardCase& hard_case) {
  if (record == TieRecord::one_exponent && !has_one_exponent(hard_case)) return std::nullopt;
  const TieTally tally = tie_tally(kind, exact_polygon(hard_case));
  if (record != TieRecord::tie) return tally.nearest_ulp;
  return tally.ties > 0 ? std::optional(0.0) : std::nullopt;
}

TieResult searched(const TieKind& kind, TieRecord record, const Record* kept,
                   const Search& search) {
  TieResult result;
  std::optional<double> again;
  if (kept != nullptr) {
    again = figure_of(kind, record, kept->hard_case);
    result.standing = again == kept->figure ? Standing::kept : Standing::moved;
    if (again) result.nearest = Record{*again, kept->hard_case};
  }
  const bool is_done = record == TieRecord::tie && (again || !has_ties(kind.place));
  const std::optional<HardCase> start =
      kept != nullptr ? std::optional(kept->hard_case) : std::nullopt;
  std::optional<HardCase> found;
  if (!is_done) found = search_for(kind, record, start, search);
  if (!found) return result;
  const std::optional<double> figure = figure_of(kind, record, *found);
  if (!figure || (again && *figure >= *again)) return result;
  result.standing = again ? Standing::improved : Standing::added;
  found->name = name_of(kind, record);
  found->source =
      search.text(record == TieRecord::any_exponents ? "hunt for near ties" : "number theory");
  result.nearest = Record{*figure, *found};
  return result;
}

const Contestant& correctly_rounded() {
  return find_contestant("barycentric/correctly_rounded", "float");
}

bool is_rounded_right(const HardCase& hard_case) {
  const Examined examined =
      examine(correctly_rounded(), CaseBatch(hard_case), {Question::correctly_rounded}).front();
  return examined.judged.contains(Question::correctly_rounded) && examined.violations.empty();
}

std::vector<TieTally> tallies_of_chance(const Search& search) {
  const std::vector<TieKind> kinds = all_tie_kinds();
  std::vector<TieTally> tallies(kinds.size());
  for (const Space space : {Space::clip, Space::view}) {
    Random random(search.seed);
    for (std::size_t i = 0; i < search.sample; ++i) {
      const reference::ExactPolygon polygon = exact_polygon(random_triangle(space, random));
      for (std::size_t k = 0; k < kinds.size(); ++k) {
        if (kinds[k].space == space) tallies[k] += tie_tally(kinds[k], polygon);
      }
    }
  }
  return tallies;
}

double expected_nearest_ulp(std::size_t numbers) {
  return 1 / (2 * (static_cast<double>(numbers) + 1));
}

}  // namespace clipscope::experiments::worst_cases
