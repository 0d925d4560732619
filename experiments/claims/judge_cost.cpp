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

struct ThreeSpaces {
  std::string mix;
  Speed view, clip, cvv;

  std::string text() const {
    return fmt::format("{} {:.3g}/{:.3g}/{:.3g}", mix, view.ns, clip.ns, cvv.ns);
  }
};

std::vector<ThreeSpaces> three_spaces(const Results& results) {
  std::vector<ThreeSpaces> mixes;
  for (const std::string& mix : results.texts("cost", "mix")) {
    mixes.push_back({mix, speed(results, mix, kViewSpace), speed(results, mix, kClipSpace),
                     speed(results, mix, kCvv)});
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

// On which mixes something holds, and the times of the three spaces on all of them.
Finding by_mix(const Results& results, std::string_view condition,
               const std::function<bool(const ThreeSpaces&)>& holds) {
  std::vector<std::string> where, times;
  const std::vector<ThreeSpaces> mixes = three_spaces(results);
  for (const ThreeSpaces& mix : mixes) {
    if (holds(mix)) where.push_back(mix.mix);
    times.push_back(mix.text());
  }
  const ClaimVerdict verdict = verdict_of(where.size(), mixes.size());
  std::string because;
  if (verdict == ClaimVerdict::conditional) {
    because = fmt::format("The mix is {} ({}). ", fmt::join(where, ", "), condition);
  }
  because += fmt::format("View/clip/CVV take, in ns: {}.", fmt::join(times, "; "));
  return {verdict, because};
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

Finding judge_view_needs_most(const Results& results) {
  Finding finding =
      by_mix(results, "elsewhere it is not the slowest of the three", [](const ThreeSpaces& mix) {
        return is_faster(mix.clip, mix.view) && is_faster(mix.cvv, mix.view);
      });
  finding.because += operations_text(results);
  return finding;
}

Finding judge_clip_needs_least(const Results& results) {
  Finding finding =
      by_mix(results, "elsewhere it is not the fastest of the three", [](const ThreeSpaces& mix) {
        return is_faster(mix.clip, mix.view) && is_faster(mix.clip, mix.cvv);
      });
  finding.because += operations_text(results);
  return finding;
}

Finding judge_cvv_less_efficient(const Results& results) {
  return by_mix(results, "elsewhere it is not slower",
                [](const ThreeSpaces& mix) { return is_faster(mix.clip, mix.cvv); });
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
  std::vector<std::string> where, ratios;
  const std::vector<std::string> mixes = results.texts("cost", "mix");
  for (const std::string& mix : mixes) {
    const double ratio =
        speed(results, mix, kClipSpace).median / speed(results, mix, "homogeneous/pipeline").median;
    if (ratio <= kLittle) where.push_back(mix);
    ratios.push_back(fmt::format("{} {:.2f}", mix, ratio));
  }
  std::string because = fmt::format(
      "Against cutting by the crossed planes alone the pipeline takes, times: {} (little: at most "
      "{:.2f}).",
      fmt::join(ratios, ", "), kLittle);
  const ClaimVerdict verdict = verdict_of(where.size(), mixes.size());
  if (verdict == ClaimVerdict::conditional) {
    because = fmt::format("The mix is {}. ", fmt::join(where, ", ")) + because;
  }
  return {verdict, because};
}

Finding judge_divisions_spared(const Results& results) {
  std::vector<std::string> where, texts;
  const std::vector<std::string> mixes = results.texts("cost_operations", "mix");
  for (const std::string& mix : mixes) {
    const auto divisions = [&](const std::string& clipper) {
      return results.number("cost_operations", "divisions", {{"mix", mix}, {"clipper", clipper}});
    };
    const double before = divisions(kClipSpace), after = divisions("cvv/naive");
    if (before < after) where.push_back(mix);
    texts.push_back(fmt::format("{} {:.3g} to {:.3g}", mix, before, after));
  }
  std::string because = fmt::format("Divisions per triangle, clip space to divide first: {}.",
                                    fmt::join(texts, "; "));
  const ClaimVerdict verdict = verdict_of(where.size(), mixes.size());
  if (verdict == ClaimVerdict::conditional) {
    because = fmt::format("Vertices are outside: mix {}. ", fmt::join(where, ", ")) + because;
  }
  return {verdict, because};
}

Finding judge_clipless(const Results& results) {
  const std::string table = "claims_clipless";
  constexpr double kReported = 1.33;
  std::vector<std::string> where, texts;
  const std::vector<std::string> scenes = results.texts(table, "scene");
  for (const std::string& scene : scenes) {
    const double speedup = results.number(table, "speedup", {{"scene", scene}});
    if (speedup >= kReported) where.push_back(scene);
    texts.push_back(fmt::format("{} {:.2f}", scene, speedup));
  }
  const ClaimVerdict verdict = verdict_of(where.size(), scenes.size());
  std::string because =
      fmt::format("Pictures without cutting, times faster: {}.", fmt::join(texts, ", "));
  if (verdict == ClaimVerdict::conditional) {
    because = fmt::format("The scene is {}. ", fmt::join(where, ", ")) + because;
  }
  return {verdict, because};
}

Finding judge_filters(const Results& results) {
  constexpr double kTwice = 2.0;
  std::vector<std::string> where, ratios;
  const std::vector<std::string> mixes = results.texts("cost", "mix");
  for (const std::string& mix : mixes) {
    const double ratio =
        speed(results, mix, kViewSpace).median / speed(results, mix, "view/exact_sign").median;
    if (ratio <= kTwice) where.push_back(mix);
    ratios.push_back(fmt::format("{} {:.2f}", mix, ratio));
  }
  return {verdict_of(where.size(), mixes.size()),
          fmt::format("View-space clipping with exact signs takes, times the plain one: {}.",
                      fmt::join(ratios, ", "))};
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

Finding judge_correct_rounding(const Results& results) {
  // The cheapest contestant all of whose coordinates are correctly rounded, by set of triangles.
  constexpr double kExpensive = 2.0;  // times the fastest float clipper in clip space
  std::vector<std::string> texts;
  std::vector<std::string> where;
  const std::vector<std::string> sets = results.texts("frontier", "set");
  for (const std::string& set : sets) {
    const double plain =
        results.number("frontier", "ns_per_triangle",
                       {{"set", set}, {"clipper", kClipSpace}, {"scalar", "float"}});
    double cheapest = HUGE_VAL;
    std::string which = "none";
    for (const auto& row : results.rows(
             "frontier",
             {"clipper", "scalar", "ns_per_triangle", "correctly_rounded_percent", "wrong_percent"},
             {{"set", set}})) {
      const auto* ns = std::get_if<double>(&row[2]);
      const auto* right = std::get_if<double>(&row[3]);
      const auto* wrong = std::get_if<double>(&row[4]);
      if (!ns || !right || !wrong || *right < 100 || *wrong > 0 || *ns >= cheapest) continue;
      cheapest = *ns;
      which = format_cell(row[0]) + " in " + format_cell(row[1]);
    }
    if (cheapest > kExpensive * plain) where.push_back(set);
    texts.push_back(std::isfinite(cheapest)
                        ? fmt::format("{} {:.3g} times ({})", set, cheapest / plain, which)
                        : set + " none");
  }
  std::string because = fmt::format(
      "The cheapest that rounded every coordinate right costs, against float clipping in clip "
      "space: "
      "{}.",
      fmt::join(texts, "; "));
  const ClaimVerdict verdict = verdict_of(where.size(), sets.size());
  if (verdict == ClaimVerdict::conditional) {
    because = fmt::format("The set is {}. ", fmt::join(where, ", ")) + because;
  }
  return {verdict, because};
}

}  // namespace clipscope::experiments
