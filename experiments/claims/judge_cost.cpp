// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims about the time of triangle clippers, and about the operations behind it.
#include <algorithm>
#include <cmath>

#include "experiments/bounds/rows.hpp"
#include "experiments/claims/claim.hpp"
#include "experiments/claims/speed.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/perspective/rows.hpp"
#include "experiments/pictures/rows.hpp"

namespace clipscope::experiments::claims {
namespace {

std::vector<std::string> mixes(const Results& results) {
  return distinct(results.rows<cost::Row>(), &cost::Row::mix);
}

// Additions, multiplications, divisions and comparisons of the three spaces, on the first mix.
std::vector<Evidence> operations(const Results& results) {
  using R = cost::OperationsRow;
  const std::string& mix = results.rows<R>().front().mix;
  std::vector<Evidence> told_of;
  for (const std::string_view space : {kViewSpace, kClipSpace, kCvv}) {
    const R& row = results.row<R>(&R::mix, mix, &R::clipper, space);
    told_of.push_back(told(mix, "operations of " + spoken_clipper(space),
                           row.arithmetic() + row.comparisons, "per triangle"));
  }
  return told_of;
}

// How a space's time is to that of the rivals which it must beat.
enum class Beats : std::uint8_t { in_slowness, in_speed };

// The rival that it beats least clearly decides.
Evidence beside(const Results& results, const std::string& name, const std::string& mix,
                std::string_view space, const std::vector<std::string_view>& rivals, Beats how) {
  std::optional<Evidence> least;
  for (const std::string_view rival : rivals) {
    const MedianInterval own = speed_of(results, mix, space), other = speed_of(results, mix, rival);
    const bool by_speed = how == Beats::in_speed;
    const Evidence evidence = decided(
        name, fmt::format("{} over that of {}", by_speed ? "speed" : "time", spoken_clipper(rival)),
        by_speed ? ratio(own, other) : ratio(other, own), "times", above(1));
    if (!least || evidence.ends->low < least->ends->low) least = evidence;
  }
  return *least;
}

// A space against the others, on each mix: one triangle after the other with the same method, and
// many at once, where the claim speaks of computation as a whole.
Cases spaces(const Results& results, std::string_view space,
             const std::vector<std::string_view>& rivals, Beats how, std::string_view batch = "",
             std::string_view rival_batch = "") {
  Cases cases;
  for (const std::string& mix : mixes(results)) {
    cases.add(beside(results, mix, mix, space, rivals, how));
    if (batch.empty()) continue;
    cases.add(beside(results, mix + " in batches", mix, batch, {rival_batch}, how));
  }
  return cases;
}

Judgement view_is_slowest(const Results& results) {
  const Cases cases = spaces(results, kViewSpace, {kClipSpace, kCvv}, Beats::in_slowness,
                             "view/batch", "homogeneous/batch");
  return cases.judge(
      {fmt::format(
           "View space takes the longest everywhere, at least {} times as long as the next.",
           number_text(cases.least())),
       fmt::format("{}; elsewhere view space is not the slowest.", cases.where()),
       "View space takes the longest nowhere."},
      operations(results));
}

Judgement clip_is_fastest(const Results& results) {
  const Cases cases = spaces(results, kClipSpace, {kViewSpace, kCvv}, Beats::in_speed,
                             "homogeneous/batch", "view/batch");
  return cases.judge(
      {fmt::format("Clip space is the fastest everywhere, at least {} times as fast as the next.",
                   number_text(cases.least())),
       fmt::format("{}; elsewhere clip space is not the fastest.", cases.where()),
       "Clip space is the fastest nowhere."},
      operations(results));
}

Judgement cvv_is_slower(const Results& results) {
  const Cases cases = spaces(results, kClipSpace, {kCvv}, Beats::in_speed);
  return cases.judge({fmt::format("The CVV takes at least {} times as long on every mix.",
                                  number_text(cases.least())),
                      fmt::format("{}; there the CVV takes up to {} times as long.", cases.where(),
                                  number_text(cases.most_holding())),
                      "The CVV takes longer on no mix."});
}

// How many times as long as the other a clipper takes, which a claim puts a limit to.
Cases times_as_long(const Results& results, std::string_view clipper, std::string_view other,
                    double limit) {
  Cases cases;
  for (const std::string& mix : mixes(results)) {
    cases.add(decided(mix, "time over that of " + spoken_clipper(other),
                      ratio(speed_of(results, mix, other), speed_of(results, mix, clipper)),
                      "times", at_most(limit)));
  }
  return cases;
}

Judgement pipeline(const Results& results) {
  constexpr double kLittle = 1.10;
  const Cases cases = times_as_long(results, "homogeneous/pipeline", kClipSpace, kLittle);
  const std::string least = number_text(cases.least()), most = number_text(cases.most());
  return cases.judge(
      {fmt::format(
           "The pipeline takes at most {} times as long as cutting by the crossed planes alone.",
           most),
       fmt::format("{}; elsewhere the pipeline takes up to {} times as long.", cases.where(), most),
       fmt::format(
           "The pipeline takes {} to {} times as long as cutting by the crossed planes alone.",
           least, most)});
}

Judgement exact_signs(const Results& results) {
  const Cases cases = times_as_long(results, "view/exact_sign", kViewSpace, 2);
  return cases.judge(
      {fmt::format("Exact signs make clipping in view space take at most {} times as long.",
                   number_text(cases.most())),
       fmt::format("{}; elsewhere exact signs make clipping take up to {} times as long.",
                   cases.where(), number_text(cases.most())),
       fmt::format("Exact signs make clipping in view space take {} times as long and more.",
                   number_text(cases.least()))});
}

Judgement perspective_correction(const Results& results) {
  using R = perspective::CutRow;
  const auto error = [&](const char* clipper) {
    return std::ranges::max(
        results.figures<R>(&R::max_error, &R::clipper, clipper, &R::scalar, "exact"));
  };
  const double affine = 100 * error("cvv/naive"), correct = 100 * error("cvv/perspective");
  std::vector<Evidence> evidence = {
      decided("interpolated as positions are", "largest error of an attribute", affine,
              "% of its range", above(0)),
      decided("interpolated as a/w and 1/w", "largest error of an attribute", correct,
              "% of its range", exactly(0))};
  for (const std::string& mix : mixes(results)) {
    const MedianInterval price =
        ratio(speed_of(results, mix, "cvv/naive"), speed_of(results, mix, "cvv/perspective"));
    evidence.push_back(told(mix, "time over that without the correction", price.median, "times"));
  }
  return judged(
      std::move(evidence), false,
      {fmt::format(
           "Attributes cut after the divide are wrong by up to {} % of their range without the correction, and exact with it.",
           number_text(affine)),
       "",
       affine == 0
           ? "Attributes cut after the divide need no correction."
           : fmt::format("Even corrected attributes are wrong by up to {} % of their range.",
                         number_text(correct))});
}

Judgement dropping_whole(const Results& results) {
  using R = pictures::Row;
  constexpr std::string_view kWhole = "whole/any_outside";
  const std::string mix = mixes(results).front();
  const double holes = sum(results.figures<R>(&R::holes_px, &R::clipper, kWhole));
  const MedianInterval speed =
      ratio(speed_of(results, mix, kWhole), speed_of(results, mix, kClipSpace));
  std::vector<Evidence> evidence = {
      decided("all scenes", "holes in their pictures", holes, "px", above(0)),
      decided(mix, "speed over that of cutting", speed, "times", above(1))};
  for (const R& row : rows_where(results.rows<R>(), &R::clipper, kWhole)) {
    evidence.push_back(
        told(row.scene, "holes in the picture", static_cast<double>(row.holes_px), "px"));
  }
  return judged(
      std::move(evidence), holes > 0,
      {fmt::format("Dropping {} cutting on {}, and leaves holes of {} px.", pace_text(speed.median),
                   spoken_set(mix), number_text(holes)),
       fmt::format(
           "It speaks of holes alone, which take {} px; dropping is not clearly faster than cutting.",
           number_text(holes)),
       "Dropping whole triangles leaves no hole in any scene."});
}

Judgement divisions_spared(const Results& results) {
  using R = cost::OperationsRow;
  Cases cases;
  double saved = 0;
  for (const std::string& mix : distinct(results.rows<R>(), &R::mix)) {
    const double before = results.row<R>(&R::mix, mix, &R::clipper, kClipSpace).divisions;
    const double after = results.row<R>(&R::mix, mix, &R::clipper, "cvv/naive").divisions;
    cases.add(decided(mix, "divisions, against those of dividing first", before, "per triangle",
                      below(after)));
    saved = std::max(saved, after - before);
  }
  return cases.judge(
      {"Clip space divides less often than dividing first on every mix.",
       fmt::format("{}; there clip space spares up to {} divisions per triangle.", cases.where(),
                   number_text(saved)),
       "Clip space divides as often as dividing first, or more often, on every mix."});
}

Judgement clipless(const Results& results) {
  constexpr double kReported = 1.33;
  Cases cases;
  for (const PictureRow& row : results.rows<PictureRow>()) {
    if (!row.speedup) throw MissingFigure("table claims_clipless has no times of " + row.scene);
    cases.add(decided(row.scene, "speed over that with cutting", *row.speedup, "times",
                      at_least(kReported)));
  }
  return cases.judge(
      {fmt::format("Every scene is drawn {} times as fast without cutting, or faster.",
                   number_text(cases.least())),
       fmt::format("{}; at its best drawing without cutting {} drawing with it.", cases.where(),
                   pace_text(cases.most_holding())),
       fmt::format("At its best drawing without cutting {} drawing with it.",
                   pace_text(cases.most()))});
}

// The cheapest that got every vertex and every coordinate of a set right, against the float
// clippers of clip space that a renderer would take instead: one by one, or in batches. Infinite
// where nobody got all right.
Evidence price_of_rounding(const std::vector<frontier::Row>& rows) {
  constexpr double kExpensive = 2.0;  // times as long
  double usual_ns = HUGE_VAL, right_ns = HUGE_VAL;
  std::string right = "nobody, since none rounds right";
  for (const frontier::Row& r : rows) {
    if (!r.timing) continue;
    const double ns = r.timing->ns.median;
    const bool is_usual = r.clipper == kClipSpace || r.clipper == "homogeneous/batch";
    if (is_usual && r.scalar == "float") usual_ns = std::min(usual_ns, ns);
    if (r.correctly_rounded_percent < 100.0 || r.wrong_percent != 0.0 || ns >= right_ns) continue;
    right_ns = ns;
    right = spoken_contestant(r.clipper, r.scalar);
  }
  if (std::isinf(usual_ns)) {
    throw MissingFigure(fmt::format("table frontier has no time of {}", kClipSpace));
  }
  const std::string input = rows[0].contract == Contract::full
                                ? "from view space"
                                : fmt::format("in a stage by {} from {}", name_of(rows[0].contract),
                                              name_of(rows[0].from));
  return decided(fmt::format("{} {}", rows[0].set, input),
                 fmt::format("time of {} over the usual", right), right_ns / usual_ns, "times",
                 above(kExpensive));
}

Judgement correct_rounding(const Results& results) {
  using R = frontier::Row;
  const std::vector<R>& all = results.rows<R>();
  Cases cases;
  for (const std::string& set : distinct(all, &R::set)) {
    const std::vector<R> rows = rows_where(all, &R::set, set);
    const auto place = [](const R& row) { return std::pair(row.contract, row.from); };
    for (const auto& [contract, from] : distinct(rows, place)) {
      cases.add(price_of_rounding(rows_where(rows, &R::contract, contract, &R::from, from)));
    }
  }
  return cases.judge(
      {fmt::format(
           "The cheapest clipper that rounds right takes at least {} times as long as the usual float clipper.",
           number_text(cases.least())),
       fmt::format("{}; elsewhere rounding right takes at most {} times as long.", cases.where(),
                   number_text(cases.most_failing())),
       fmt::format(
           "The cheapest clipper that rounds right takes at most {} times as long as the usual float clipper.",
           number_text(cases.most()))});
}

Judgement bounding_volumes(const Results& results) {
  using R = bounds::Row;
  constexpr double kMost = 50;  // %
  const double lost = sum(results.figures<R>(&R::visible_lost));
  Cases places;
  double least = 100;          // of the places where most can be settled
  bool all_settleable = true;  // where most are settled, and nowhere else
  for (const std::string& place : distinct(results.rows<R>(), &R::place)) {
    const double settled =
        std::ranges::min(results.figures<R>(&R::settled_percent, &R::place, place));
    const double settleable =
        std::ranges::max(results.figures<R>(&R::settleable_percent, &R::place, place));
    places.add(decided(place, "objects that the worst bound settles", settled, "%", above(kMost)));
    all_settleable = all_settleable && (settleable > kMost) == (settled > kMost);
    if (settled > kMost) least = std::min(least, settled);
  }
  std::vector<Evidence> evidence = places.evidence();
  const bool some = std::ranges::any_of(evidence, [](const Evidence& e) { return *e.holds; });
  evidence.push_back(
      decided("all scenes", "visible triangles of rejected objects", lost, "", exactly(0)));
  return judged(
      std::move(evidence), lost == 0 && some,
      {fmt::format("Bounds settle at least {} % of the objects in every scene.",
                   number_text(least)),
       fmt::format("{}; there bounds settle at least {} % of them.",
                   all_settleable ? "Most objects lie wholly inside or wholly outside the view"
                                  : "The objects suit it",
                   number_text(least)),
       lost > 0 ? fmt::format("Bounds lose {} visible triangles.", number_text(lost))
                : "Bounds settle the most part of the objects in no scene."});
}

}  // namespace

std::vector<Claim> claims_about_cost() {
  return {
      {1, "View-space clipping needs the most computation.", "cost", view_is_slowest},
      {2, "Clip-space clipping needs the least and is the most efficient.", "cost",
       clip_is_fastest},
      {3, "CVV clipping is less efficient than clip-space clipping.", "cost", cvv_is_slower},
      {4, "CVV clipping must account for perspective correction.", "perspective",
       perspective_correction},
      {7, "Dropping whole triangles is cheap but leaves visible holes at the border.", "pictures",
       dropping_whole},
      {15, "A pipeline of independent plane clippers adds little latency.", "cost", pipeline},
      {17, "Bounding volumes settle most objects without touching their polygons.", "bounds",
       bounding_volumes},
      {19, "Clipping before the divide spares divisions for vertices outside.", "cost",
       divisions_spared},
      {29,
       "Geometric clipping can be avoided by 2D homogeneous rasterisation, 33 % faster (Olano and Greer 1997).",
       "claims", clipless},
      {31,
       "Floating-point filters make exact decisions at most about twice as slow, near free in practice (Shewchuk 1997; Bronnimann, Burnikel and Pion 2001).",
       "cost", exact_signs},
      {32, "Correct rounding is expensive (experience with mathematical libraries).", "frontier",
       correct_rounding}};
}

}  // namespace clipscope::experiments::claims
