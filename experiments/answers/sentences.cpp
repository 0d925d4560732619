// SPDX-License-Identifier: GPL-3.0-or-later
//
// The answers as sentences. Each is decided from the run's figures; where they turn, it turns.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "experiments/answers/rows.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::answers {
namespace {

const std::string kFloat = "float";

// The usual method in each of the three spaces: the planes one after the other, near plane first.
struct Space {
  std::string clipper, place;
};
const std::array kSpaces = {Space{"homogeneous/sutherland_hodgman", "homogeneous clip space"},
                            Space{"view/sutherland_hodgman", "view space"},
                            Space{"cvv/near_first", "the view volume after the divide"}};

struct Measured {
  const Space* space;
  MedianInterval figure;
};

std::string where_fastest(const Results& results) {
  using R = cost::Row;
  std::vector<Measured> times;
  for (const Space& space : kSpaces) {
    const R& row =
        results.row<R>(&R::mix, kGameLike, &R::clipper, space.clipper, &R::scalar, kFloat);
    if (!row.timing) throw MissingFigure(space.clipper + " was not timed on " + kGameLike);
    times.push_back({&space, row.timing->ns});
  }
  std::ranges::stable_sort(times, {}, [](const Measured& m) { return m.figure.median; });
  const auto slower = [&](std::size_t i) {
    return times_text(times[i].figure.median / times[0].figure.median);
  };
  if (!is_below(times[0].figure, times[1].figure)) {
    return fmt::format(
        "In {} or in {}, which take the same time on the game-like mix; in {} the same method takes {} as long.",
        times[0].space->place, times[1].space->place, times[2].space->place, slower(2));
  }
  return fmt::format(
      "In {}: on the game-like mix the same method takes {} as long in {}, and {} as long in {}.",
      times[0].space->place, slower(1), times[1].space->place, slower(2), times[2].space->place);
}

std::string most_accurate(const Results& results) {
  const Contest contest(results);
  struct Error {
    const Space* space;
    double px;
  };
  std::vector<Error> errors;
  for (const Space& space : kSpaces) {
    errors.push_back(
        {&space, contest.offer({space.clipper, kFloat}, Contract::full).quality.game_px});
  }
  std::ranges::stable_sort(errors, {}, &Error::px);
  const Error &least = errors.front(), &most = errors.back();
  if (most.px <= 2 * least.px) {
    return fmt::format(
        "The three spaces err alike in float, by up to {:.2g} px on the game-like mix.", most.px);
  }
  return fmt::format(
      "In float the most accurate is {}: its largest error on the game-like mix is {:.2g} px, and {:.2g} px in {}.",
      least.space->place, least.px, most.px, most.space->place);
}

bool makes_no_mistake(const Offer& offer) {
  return offer.quality.hard_wrong == 0 && offer.quality.hard_misrounded == 0;
}

// The fastest that gets triangles wrong, or else that misses nearest floats.
// Pre-condition: the fastest of all does.
std::string who_errs(const std::vector<Offer>& offers) {
  const auto found =
      std::ranges::find_if(offers, [](const Offer& o) { return o.quality.hard_wrong > 0; });
  const Offer& offer = found == offers.end() ? offers.front() : *found;
  return fmt::format(
      "{} {}", spoken_contestant(offer.clipper, offer.scalar),
      offer.quality.hard_wrong > 0 ? "gets hard triangles wrong" : "misses nearest floats");
}

// What certainty costs where it costs the most, over all mixes, layouts and places that the input
// comes from; empty where the run does not say.
std::string worst_price(const Results& results) {
  try {
    const cost::CertaintyRow& most = cost::dearest(results.rows<cost::CertaintyRow>());
    if (!most.is_dear()) return " Correct rounding is as fast as the fastest on every mix.";
    return fmt::format(" At its worst, {}, correct rounding takes {:.0f} % more time.",
                       cost::where_text(most), 100 * (most.price.median - 1));
  } catch (const MissingFigure&) {
    return "";
  }
}

// What the correctly rounded clipper takes over the fastest that is not, on the game-like mix by
// copy from memory, round by round; nothing where the run does not say.
std::optional<MedianInterval> paired_price(const Results& results) {
  using R = cost::CertaintyRow;
  try {
    return results
        .row<R>(&R::mix, cost::kGameLikeStage, &R::contract, Contract::copy, &R::from,
                InputFrom::memory)
        .price;
  } catch (const MissingFigure&) {
    return std::nullopt;
  }
}

// The fastest that makes no mistake over the fastest: of the same rounds if they were in such, else
// of two times.
MedianInterval times_fastest(const Results& results, const Offer& certain, const Offer& fastest) {
  if (const auto paired = paired_price(results)) return *paired;
  return {certain.ns.median / fastest.ns.median, certain.ns.low / fastest.ns.high,
          certain.ns.high / fastest.ns.low};
}

// What certainty costs a stage on the game-like mix: the fastest that makes no mistake against the
// fastest.
std::string usual_price(const Results& results, const std::vector<Offer>& offers,
                        const Offer& certain) {
  const std::string name = spoken_contestant(certain.clipper, certain.scalar);
  const Offer& fastest = offers.front();
  if (&certain == &fastest) {
    return fmt::format(
        "Nothing on the game-like mix: {} is the fastest as a renderer's stage, and makes no mistake.",
        name);
  }
  const MedianInterval times = times_fastest(results, certain, fastest);
  if (times.low <= 1) {
    return fmt::format(
        "Nothing that this run can measure on the game-like mix: as a renderer's stage {}, which makes no mistake, is as fast as the fastest; {}.",
        name, who_errs(offers));
  }
  return fmt::format(
      "On the game-like mix a renderer's stage takes {:.0f} % more time with {}, which makes no mistake, than with the fastest; {}.",
      100 * (times.median - 1), name, who_errs(offers));
}

std::string price(const Results& results) {
  const std::vector<Offer> offers = Contest(results).offers(Contract::copy);
  if (offers.empty()) throw MissingFigure("no clipper was timed as a renderer's stage");
  const auto found = std::ranges::find_if(offers, makes_no_mistake);
  if (found == offers.end()) return "More than was tried: every clipper makes mistakes.";
  return usual_price(results, offers, *found) + worst_price(results);
}

std::string behind_the_eye(const Results& results) {
  const Catalogue catalogue(results);
  const std::string theme = "w_sign";
  const Tally divided = catalogue.tally({"cvv/perspective", kFloat}, theme),
              clipped = catalogue.tally({"homogeneous/sutherland_hodgman", kFloat}, theme);
  if (divided.cases == 0 || clipped.cases == 0) {
    throw MissingFigure("nobody was asked about " + theme);
  }
  if (divided.failures <= clipped.failures) {
    return fmt::format(
        "Dividing first does no harm where w <= 0: it fails on {:.0f} % of the hard cases, clip space on {:.0f} %.",
        divided.failed_percent(), clipped.failed_percent());
  }
  return fmt::format(
      "Clip before the divide: where w <= 0 dividing first fails on {:.0f} % of the hard cases, clip space on {:.0f} %.",
      divided.failed_percent(), clipped.failed_percent());
}

std::string who_stays_right(const Results& results) {
  const Catalogue catalogue(results);
  std::vector<std::pair<Tally, std::string>> asked;
  std::int64_t most = 0;
  for (const std::string_view clipper : clipper_names()) {
    const Tally tally = catalogue.tally({std::string(clipper), kFloat});
    most = std::max(most, tally.cases);
    asked.emplace_back(tally, clipper);
  }
  // Who starts in view space is asked about few cases, and proves little by getting them right.
  std::erase_if(asked, [&](const auto& a) { return a.first.cases * 2 < most || most == 0; });
  if (asked.empty()) throw MissingFigure("no triangle clipper was judged in float");
  std::vector<std::string> right;
  std::int64_t fewest = most;
  for (const auto& [tally, clipper] : asked) {
    if (tally.failures == 0) right.push_back(spoken_clipper(clipper));
    if (tally.failures > 0) fewest = std::min(fewest, tally.failures);
  }
  if (right.size() == asked.size()) {
    return "All triangle clippers get every hard case right in float.";
  }
  const std::string who =
      right.empty() ? "none" : (right.size() == 1 ? "only " : "") + listed(right);
  return fmt::format(
      "In float {} of {} triangle clippers {} every hard case right; {} fails on {}.", who,
      asked.size(), right.size() > 1 ? "get" : "gets", right.empty() ? "the best" : "the next best",
      fewest);
}

std::string what_scenes_need(const Results& results) {
  std::vector<double> saved;
  std::int64_t changed = 0;
  for (const EffectRow& row : effect_rows(results)) {
    if (row.saved_percent) saved.push_back(*row.saved_percent);
    changed += row.changed;
  }
  if (saved.empty()) throw MissingFigure("no planned pipeline was timed");
  const double median = median_interval(saved).median, most = std::ranges::max(saved);
  return fmt::format(
      "A pipeline of just the effects that a scene calls for takes {:.0f} % less time at the median scene, up to {:.0f} % less, and {}.",
      median, most, changed == 0 ? "changes nothing" : "changes polygons");
}

struct Question {
  const char *id, *question, *experiment, *table;
  std::string (*answer)(const Results&);
};

constexpr Question kQuestions[] = {
    {"space", "Where should a triangle be clipped?", "cost", "cost", where_fastest},
    {"accuracy", "Which space is the most accurate?", "frontier", "frontier", most_accurate},
    {"price", "What does accuracy cost in time?", "cost", "cost_certainty", price},
    {"w", "What about points behind the eye?", "w_sign", "hard_cases_verdicts", behind_the_eye},
    {"stability", "Who stays right on hard cases?", "hard_cases", "answers_stability",
     who_stays_right},
    {"effects", "What of it does a scene need?", "effects", "answers_effects", what_scenes_need}};

}  // namespace

std::vector<Row> answers(const Results& results) {
  std::vector<Row> rows;
  for (const Question& q : kQuestions) {
    std::string answer;
    try {
      answer = q.answer(results);
    } catch (const MissingFigure& missing) {
      answer = fmt::format("This run does not say: {}.", missing.what());
    }
    rows.push_back({q.id, q.question, answer, q.experiment, q.table});
  }
  return rows;
}

}  // namespace clipscope::experiments::answers
