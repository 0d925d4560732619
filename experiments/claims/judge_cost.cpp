// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "experiments/claims/judges.hpp"

namespace clipscope::experiments {
namespace {

// How many times faster than textbook a clipper is on a mix, in float, with its 95 % interval.
struct Speed {
  double ns = 0, median = 0, low = 0, high = 0;
};

Speed speed(const Results& results, const std::string& mix, const std::string& clipper) {
  const auto figure = [&](const std::string& column) {
    return results.number("cost", column,
                          {{"mix", mix}, {"clipper", clipper}, {"scalar", "float"}});
  };
  return {figure("ns_per_triangle"), figure("speedup_to_textbook"), figure("speedup_low"),
          figure("speedup_high")};
}

// Beyond the intervals of both.
bool is_faster(const Speed& a, const Speed& b) { return a.low > b.high; }

// The spaces side by side on a mix: one triangle after the other with the same method, and many at once.
// Of the distance matrix, a space of its own, the claims say nothing: it stands beside them.
struct Spaces {
  std::string mix;
  Speed view, clip, cvv, barycentric;
  Speed view_batch, clip_batch, barycentric_batch;

  std::string text() const {
    return fmt::format("{} {:.3g}/{:.3g}/{:.3g}/{:.3g}", mix, view.ns, clip.ns, cvv.ns,
                       barycentric.ns);
  }
  std::string batch_text() const {
    return fmt::format("{} {:.3g}/{:.3g}/-/{:.3g}", mix, view_batch.ns, clip_batch.ns,
                       barycentric_batch.ns);
  }
};

std::vector<Spaces> spaces_by_mix(const Results& results) {
  std::vector<Spaces> mixes;
  for (const std::string& mix : results.texts("cost", "mix")) {
    const auto of = [&](const std::string& clipper) { return speed(results, mix, clipper); };
    mixes.push_back({mix, of(kViewSpace), of(kClipSpace), of(kCvv), of(kBarycentric),
                     of("view/batch"), of("homogeneous/batch"), of("barycentric/batch")});
  }
  return mixes;
}

// Operations per triangle of all kinds.
double operations(const Results& results, const std::string& mix, const std::string& clipper) {
  double sum = 0;
  for (const char* kind : {"additions", "multiplications", "divisions", "comparisons"}) {
    sum += results.number("cost_operations", kind, {{"mix", mix}, {"clipper", clipper}});
  }
  return sum;
}

constexpr const char* kTimes = "View/clip/CVV/barycentric take, in ns: {}.";

// On which mixes something holds, and the times of the spaces on all of them.
Finding by_mix(const Results& results, const std::string& condition,
               const std::function<bool(const Spaces&)>& holds) {
  Cases cases;
  for (const Spaces& mix : spaces_by_mix(results)) cases.note(mix.mix, holds(mix), mix.text());
  return cases.finding("The mix is {} (" + condition + "). ",
                       fmt::format(fmt::runtime(kTimes), cases.figures("; ")));
}

// The same, and whether it holds as well where view and clip space take many triangles at once, in SIMD.
Finding by_mix_and_batches(const Results& results, const std::string& condition,
                           const std::function<bool(const Spaces&)>& holds) {
  Cases cases;
  std::vector<std::string> alone, batches;
  for (const Spaces& mix : spaces_by_mix(results)) {
    cases.note(mix.mix, holds(mix), mix.text());
    cases.note(mix.mix + " in batches", is_faster(mix.clip_batch, mix.view_batch),
               mix.batch_text());
    alone.push_back(mix.text());
    batches.push_back(mix.batch_text());
  }
  return cases.finding("The mix is {} (" + condition + "). ",
                       fmt::format(fmt::runtime(std::string(kTimes) + " In batches: {}."),
                                   fmt::join(alone, "; "), fmt::join(batches, "; ")));
}

std::string operations_text(const Results& results) {
  const std::string mix = results.texts("cost_operations", "mix").front();
  return fmt::format(" Operations on {}: {:.0f}/{:.0f}/{:.0f}.", mix,
                     operations(results, mix, kViewSpace), operations(results, mix, kClipSpace),
                     operations(results, mix, kCvv));
}

}  // namespace

ClaimVerdict verdict_of(std::size_t holds, std::size_t of) {
  if (holds == 0) return ClaimVerdict::refuted;
  return holds == of ? ClaimVerdict::confirmed : ClaimVerdict::conditional;
}

void Cases::note(const std::string& name, bool holds, const std::string& figures) {
  ++all_;
  if (holds) holds_.push_back(name);
  figures_.push_back(figures);
}

std::string Cases::figures(std::string_view separator) const {
  return fmt::format("{}", fmt::join(figures_, separator));
}

Finding Cases::finding(std::string_view condition, const std::string& because) const {
  const ClaimVerdict verdict = verdict_of(holds_.size(), all_);
  if (verdict != ClaimVerdict::conditional) return {verdict, because};
  return {verdict, fmt::format(fmt::runtime(condition), fmt::join(holds_, ", ")) + because};
}

Finding judge_view_needs_most(const Results& results) {
  Finding finding = by_mix_and_batches(
      results, "elsewhere it is not the slowest of the three", [](const Spaces& mix) {
        return is_faster(mix.clip, mix.view) && is_faster(mix.cvv, mix.view);
      });
  finding.because += operations_text(results);
  return finding;
}

Finding judge_clip_needs_least(const Results& results) {
  Finding finding = by_mix_and_batches(
      results, "elsewhere it is not the fastest of the three", [](const Spaces& mix) {
        return is_faster(mix.clip, mix.view) && is_faster(mix.clip, mix.cvv);
      });
  finding.because += operations_text(results);
  return finding;
}

Finding judge_cvv_less_efficient(const Results& results) {
  return by_mix(results, "elsewhere it is not slower",
                [](const Spaces& mix) { return is_faster(mix.clip, mix.cvv); });
}

Finding judge_dropping_whole(const Results& results) {
  const std::string mix = results.texts("cost", "mix").front();
  const Speed whole = speed(results, mix, "whole/any_outside");
  const Speed clip = speed(results, mix, kClipSpace);
  double holes = 0;
  std::string where;
  for (const std::string& scene : results.texts("pictures", "scene")) {
    const double n = results.number("pictures", "holes_px",
                                    {{"scene", scene}, {"clipper", "whole/any_outside"}});
    holes += n;
    where += fmt::format("{}{:.0f} px of {}", where.empty() ? "" : ", ", n, scene);
  }
  const bool cheap = is_faster(whole, clip);
  const std::string because = fmt::format("On {} it takes {:.3g} ns, cutting {:.3g} ns; holes: {}.",
                                          mix, whole.ns, clip.ns, where);
  if (cheap && holes > 0) return {ClaimVerdict::confirmed, because};
  if (!cheap && holes > 0) {
    return {ClaimVerdict::conditional, "Of the claim only the holes are true. " + because};
  }
  return {ClaimVerdict::refuted, because};
}

Finding judge_pipeline(const Results& results) {
  constexpr double kLittle = 1.10;  // of the time of the clipper that plans its planes
  Cases cases;
  for (const std::string& mix : results.texts("cost", "mix")) {
    const double ratio =
        speed(results, mix, kClipSpace).median / speed(results, mix, "homogeneous/pipeline").median;
    cases.note(mix, ratio <= kLittle, fmt::format("{} {:.2f}", mix, ratio));
  }
  return cases.finding(
      "The mix is {}. ",
      fmt::format("Against cutting by the crossed planes alone the pipeline takes, times: {} "
                  "(little: at most {:.2f}).",
                  cases.figures(), kLittle));
}

Finding judge_divisions_spared(const Results& results) {
  Cases cases;
  for (const std::string& mix : results.texts("cost_operations", "mix")) {
    const auto divisions = [&](const std::string& clipper) {
      return results.number("cost_operations", "divisions", {{"mix", mix}, {"clipper", clipper}});
    };
    const double before = divisions(kClipSpace), after = divisions("cvv/naive");
    cases.note(mix, before < after, fmt::format("{} {:.3g} to {:.3g}", mix, before, after));
  }
  return cases.finding(
      "Vertices are outside: mix {}. ",
      fmt::format("Divisions per triangle, clip space to divide first: {}.", cases.figures("; ")));
}

Finding judge_clipless(const Results& results) {
  const std::string table = "claims_clipless";
  constexpr double kReported = 1.33;
  Cases cases;
  for (const std::string& scene : results.texts(table, "scene")) {
    const double speedup = results.number(table, "speedup", {{"scene", scene}});
    cases.note(scene, speedup >= kReported, fmt::format("{} {:.2f}", scene, speedup));
  }
  return cases.finding("The scene is {}. ",
                       fmt::format("Pictures without cutting, times faster: {}.", cases.figures()));
}

Finding judge_filters(const Results& results) {
  constexpr double kTwice = 2.0;
  Cases cases;
  for (const std::string& mix : results.texts("cost", "mix")) {
    const double ratio =
        speed(results, mix, kViewSpace).median / speed(results, mix, "view/exact_sign").median;
    cases.note(mix, ratio <= kTwice, fmt::format("{} {:.2f}", mix, ratio));
  }
  return cases.finding(
      "The mix is {}. ",
      fmt::format("View-space clipping with exact signs takes, times the plain one: {}.",
                  cases.figures()));
}

Finding judge_bounds(const Results& results) {
  std::size_t most = 0, rows = 0;
  double least = 100, largest = 0;
  for (const std::string& scene : results.texts("bounds", "scene")) {
    for (const std::string& bound : results.texts("bounds", "bound", {{"scene", scene}})) {
      for (const double closer :
           results.numbers("bounds", "closer_percent", {{"scene", scene}, {"bound", bound}})) {
        const double settled = 100 - closer;
        ++rows;
        most += settled > 50;
        least = std::min(least, settled);
        largest = std::max(largest, settled);
      }
    }
  }
  double lost = 0;
  for (const double n : results.numbers("bounds", "visible_lost", {})) lost += n;
  std::string because = fmt::format(
      "They settle {:.0f} to {:.0f} % of the objects, by scene and bound, more than half in {} of "
      "{} "
      "rows; visible triangles lost: {:.0f}.",
      least, largest, most, rows, lost);
  const ClaimVerdict verdict = lost > 0 ? ClaimVerdict::refuted : verdict_of(most, rows);
  if (verdict == ClaimVerdict::conditional)
    because = "Objects are small beside the view. " + because;
  return {verdict, because};
}

namespace {

// The cheapest contestant on a set that got every vertex and every coordinate right; infinite if there is
// none.
struct Cheapest {
  double ns = HUGE_VAL;
  std::string name;
};

Cheapest cheapest_rounded_right(const Results& results, const RowKey& where) {
  Cheapest cheapest;
  for (const auto& row : results.rows(
           "frontier",
           {"clipper", "scalar", "ns_per_triangle", "correctly_rounded_percent", "wrong_percent"},
           where)) {
    const auto* ns = std::get_if<double>(&row[2]);
    const auto* right = std::get_if<double>(&row[3]);
    const auto* wrong = std::get_if<double>(&row[4]);
    if (!ns || !right || !wrong || *right < 100 || *wrong > 0 || *ns >= cheapest.ns) continue;
    cheapest = {*ns, format_cell(row[0]) + " in " + format_cell(row[1])};
  }
  return cheapest;
}

// The fastest float clipper of clip space that a renderer would take instead: one by one, or in batches.
double fastest_in_float(const Results& results, const RowKey& where) {
  double ns = HUGE_VAL;
  for (const auto& row :
       results.rows("frontier", {"clipper", "scalar", "ns_per_triangle"}, where)) {
    const std::string clipper = format_cell(row[0]);
    const auto* time = std::get_if<double>(&row[2]);
    if (clipper != kClipSpace && clipper != "homogeneous/batch") continue;
    if (format_cell(row[1]) == "float" && time) ns = std::min(ns, *time);
  }
  if (std::isfinite(ns)) return ns;
  throw MissingFigure("table frontier: " + kClipSpace + " in float was not timed");
}

}  // namespace

Finding judge_correct_rounding(const Results& results) {
  constexpr double kExpensive = 2.0;  // times float clipping in clip space
  Cases cases;
  for (const std::string& set : results.texts("frontier", "set")) {
    for (const std::string& contract : results.texts("frontier", "contract", {{"set", set}})) {
      const RowKey where = {{"set", set}, {"contract", contract}};
      const Cheapest c = cheapest_rounded_right(results, where);
      const std::string name = set + " " + contract;
      const std::string times = std::isfinite(c.ns)
                                    ? fmt::format("{} {:.3g} times ({})", name,
                                                  c.ns / fastest_in_float(results, where), c.name)
                                    : name + " none";
      cases.note(name, c.ns > kExpensive * fastest_in_float(results, where), times);
    }
  }
  return cases.finding(
      "The set and contract are {}. ",
      fmt::format("The cheapest that rounded every coordinate right costs, against the fastest "
                  "float clipping in clip space: {}.",
                  cases.figures("; ")));
}

}  // namespace clipscope::experiments
