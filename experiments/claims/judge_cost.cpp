// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/bounds/rows.hpp"
#include "experiments/claims/claim.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/perspective/rows.hpp"
#include "experiments/pictures/rows.hpp"
#include "experiments/segments/rows.hpp"

namespace clipscope::experiments::claims {
namespace {

// A clipper's time on a mix in float, and how many times faster than the table's baseline it is.
struct Speed {
  double ns = 0;
  MedianInterval speedup;

  // Faster beyond the intervals of both.
  bool operator>(const Speed& other) const { return speedup.low > other.speedup.high; }
};

template <class Row = cost::Row>
Speed speed(const Results& results, const std::string& mix, std::string_view clipper) {
  const Row& row = results.row<Row>(&Row::mix, mix, &Row::clipper, clipper, &Row::scalar, "float");
  if (row.timing && row.timing->speedup) return {row.timing->ns.median, *row.timing->speedup};
  throw MissingFigure(fmt::format("table {} has no time of {} on {}", Row::kName, clipper, mix));
}

std::vector<std::string> mixes(const Results& results) {
  return distinct(results.rows<cost::Row>(), &cost::Row::mix);
}

using Clippers = std::array<std::string_view, 4>;

// The spaces side by side: one triangle after the other with the same method, and many at once. The
// claims say nothing of the distance matrix, a space of its own, which stands beside them.
constexpr Clippers kAlone = {kViewSpace, kClipSpace, kCvv, "barycentric/distance_matrix"};
constexpr Clippers kBatches = {"view/batch", "homogeneous/batch", "", "barycentric/batch"};

std::string times(const Results& results, const std::string& mix, const Clippers& clippers) {
  std::vector<std::string> ns;
  for (const std::string_view c : clippers) {
    ns.push_back(c.empty() ? "-" : fmt::format("{:.3g}", speed(results, mix, c).ns));
  }
  return fmt::format("{} {}", mix, fmt::join(ns, "/"));
}

std::string operations_text(const Results& results) {
  using R = cost::OperationsRow;
  const std::string& mix = results.rows<R>().front().mix;
  const auto operations = [&](std::string_view clipper) {
    const R& row = results.row<R>(&R::mix, mix, &R::clipper, clipper);
    return row.arithmetic() + row.comparisons;
  };
  return fmt::format("Operations on {}: {:.0f}/{:.0f}/{:.0f}.", mix, operations(kViewSpace),
                     operations(kClipSpace), operations(kCvv));
}

// Judges by the mixes on which it holds of the speeds of view space, clip space and CVV. In
// batches: and by whether clip space is faster than view space as well where both take many
// triangles at once.
template <class Holds>
auto by_mix(std::string_view elsewhere, bool in_batches, Holds holds) {
  return [=](const Results& results) {
    Cases cases;
    std::vector<std::string> alone, batches;
    for (const std::string& mix : mixes(results)) {
      const auto of = [&](std::string_view clipper) { return speed(results, mix, clipper); };
      cases.add(mix, holds(of(kViewSpace), of(kClipSpace), of(kCvv)));
      alone.push_back(times(results, mix, kAlone));
      if (!in_batches) continue;
      cases.add(mix + " in batches", of("homogeneous/batch") > of("view/batch"));
      batches.push_back(times(results, mix, kBatches));
    }
    std::string more;
    if (in_batches) {
      more = fmt::format(" In batches: {}. {}", fmt::join(batches, "; "), operations_text(results));
    }
    return cases.judge(fmt::format("The mix is {{}} (elsewhere it is not {}). ", elsewhere),
                       "View/clip/CVV/barycentric take, in ns: {}.{}", fmt::join(alone, "; "),
                       more);
  };
}

bool view_is_slowest(const Speed& view, const Speed& clip, const Speed& cvv) {
  return clip > view && cvv > view;
}
bool clip_is_fastest(const Speed& view, const Speed& clip, const Speed& cvv) {
  return clip > view && clip > cvv;
}
bool cvv_is_slower(const Speed&, const Speed& clip, const Speed& cvv) { return clip > cvv; }

// Judges by the mixes on which `clipper` takes at most so many times as long as `other`.
auto by_ratio(std::string_view clipper, std::string_view other, double at_most,
              const char* figures) {
  return [=](const Results& results) {
    Cases cases;
    for (const std::string& mix : mixes(results)) {
      const double ratio =
          speed(results, mix, other).speedup.median / speed(results, mix, clipper).speedup.median;
      cases.add(mix, ratio <= at_most, fmt::format("{} {:.2f}", mix, ratio));
    }
    return cases.judge("The mix is {}. ", "{}",
                       fmt::format(fmt::runtime(figures), cases.figures(", "), at_most));
  };
}

Judgement perspective_correction(const Results& results) {
  using R = perspective::CutRow;
  const auto error = [&](const char* clipper) {
    return std::ranges::max(
        results.figures<R>(&R::max_error, &R::clipper, clipper, &R::scalar, "exact"));
  };
  const double affine = error("cvv/naive"), correct = error("cvv/perspective");
  std::vector<std::string> prices;
  for (const std::string& mix : mixes(results)) {
    const double ns = speed(results, mix, "cvv/perspective").ns;
    prices.push_back(
        fmt::format("{} {:+.0f} %", mix, 100 * (ns / speed(results, mix, "cvv/naive").ns - 1)));
  }
  return confirmed_if(
      affine > 0 && correct == 0,
      "In exact arithmetic new vertices cut after the divide have attributes wrong by up to {:.2g} of their range if they are interpolated as positions are, by {:.2g} with a/w and 1/w. The correction changes the time by: {}.",
      affine, correct, fmt::join(prices, ", "));
}

Judgement dropping_whole(const Results& results) {
  using R = pictures::Row;
  constexpr std::string_view kWhole = "whole/any_outside";
  const std::string mix = mixes(results).front();
  const Speed whole = speed(results, mix, kWhole), clip = speed(results, mix, kClipSpace);
  const bool has_holes = sum(results.figures<R>(&R::holes_px, &R::clipper, kWhole)) > 0;
  std::vector<std::string> holes;
  for (const R& row : rows_where(results.rows<R>(), &R::clipper, kWhole)) {
    holes.push_back(fmt::format("{} px of {}", row.holes_px, row.scene));
  }
  return true_only_when("Of the claim only the holes are true. ", has_holes,
                        has_holes && whole > clip,
                        "On {} it takes {:.3g} ns, cutting {:.3g} ns; holes: {}.", mix, whole.ns,
                        clip.ns, fmt::join(holes, ", "));
}

Judgement divisions_spared(const Results& results) {
  using R = cost::OperationsRow;
  Cases cases;
  for (const std::string& mix : distinct(results.rows<R>(), &R::mix)) {
    const double before = results.row<R>(&R::mix, mix, &R::clipper, kClipSpace).divisions;
    const double after = results.row<R>(&R::mix, mix, &R::clipper, "cvv/naive").divisions;
    cases.add(mix, before < after, fmt::format("{} {:.3g} to {:.3g}", mix, before, after));
  }
  return cases.judge("Vertices are outside: mix {}. ",
                     "Divisions per triangle, clip space to divide first: {}.",
                     cases.figures("; "));
}

Judgement clipless(const Results& results) {
  constexpr double kReported = 1.33;
  Cases cases;
  for (const PictureRow& row : results.rows<PictureRow>()) {
    if (!row.speedup) throw MissingFigure("table claims_clipless has no times of " + row.scene);
    const double speedup = row.speedup->median;
    cases.add(row.scene, speedup >= kReported, fmt::format("{} {:.2f}", row.scene, speedup));
  }
  return cases.judge("The scene is {}. ", "Pictures without cutting, times faster: {}.",
                     cases.figures(", "));
}

// The cheapest that got every vertex and every coordinate of a set right, against the float
// clippers of clip space that a renderer would take instead: one by one, or in batches.
void add_rounding(const std::vector<frontier::Row>& rows, Cases& cases) {
  constexpr double kExpensive = 2.0;  // times as long
  const std::string name = fmt::format("{} {}", rows[0].set, name_of(rows[0].contract));
  double usual_ns = HUGE_VAL, right_ns = HUGE_VAL;
  std::string right;
  for (const frontier::Row& r : rows) {
    if (!r.timing) continue;
    const double ns = r.timing->ns.median;
    const bool is_usual = r.clipper == kClipSpace || r.clipper == "homogeneous/batch";
    if (is_usual && r.scalar == "float") usual_ns = std::min(usual_ns, ns);
    if (r.correctly_rounded_percent < 100.0 || r.wrong_percent != 0.0 || ns >= right_ns) continue;
    right_ns = ns;
    right = r.clipper + " in " + r.scalar;
  }
  if (std::isinf(usual_ns)) {
    throw MissingFigure(fmt::format("table frontier has no time of {}", kClipSpace));
  }
  const double ratio = right_ns / usual_ns;
  cases.add(
      name, ratio > kExpensive,
      std::isinf(ratio) ? name + " none" : fmt::format("{} {:.3g} times ({})", name, ratio, right));
}

Judgement correct_rounding(const Results& results) {
  using R = frontier::Row;
  const std::vector<R>& all = results.rows<R>();
  Cases cases;
  for (const std::string& set : distinct(all, &R::set)) {
    const std::vector<R> rows = rows_where(all, &R::set, set);
    for (const Contract contract : distinct(rows, &R::contract)) {
      add_rounding(rows_where(rows, &R::contract, contract), cases);
    }
  }
  return cases.judge(
      "The set and contract are {}. ",
      "The cheapest that rounded every coordinate right costs, against the fastest float clipping in clip space: {}.",
      cases.figures("; "));
}

Judgement line_outcodes(const Results& results) {
  using R = segments::OperationsRow;
  const auto figure = [&](std::optional<double> R::*member, const char* mix) {
    return results.figures<R>(member, &R::mix, mix, &R::clipper, "homogeneous/cohen_sutherland")
        .front();
  };
  const double rejected = figure(&R::rejected_percent, "window_1_64");
  const double free = rejected * figure(&R::rejected_free_percent, "window_1_64") / 100;
  const double cuts = figure(&R::divisions_per_shortened, "cross_several");
  const double ends = figure(&R::moved_ends_per_shortened, "cross_several");
  const bool rejects_most = free > 50, repeats = cuts > ends;
  return true_only_when(
      rejects_most ? "Of its first half. " : "Of its second half. ", rejects_most || repeats,
      rejects_most && repeats,
      "Through a window of 1/64 it rejects {:.1f} % of all segments without an intersection; across several planes it computes {:.2f} for {:.2f} ends that move.",
      free, cuts, ends);
}

Judgement liang_barsky(const Results& results) {
  using R = segments::OperationsRow;
  constexpr std::string_view kClipper = "homogeneous/liang_barsky";
  const auto speedup = [&](const char* mix) {
    return speed<segments::TimeRow>(results, mix, kClipper).speedup;
  };
  const auto most = [&](std::optional<double> R::*member) {
    return std::ranges::max(results.figures<R>(member, &R::clipper, kClipper));
  };
  const MedianInterval inside = speedup("inside"), outside = speedup("outside");
  const double accepted = most(&R::divisions_per_accepted);
  const double rejected = most(&R::divisions_per_rejected);
  const bool as_cheap = inside.high >= 1 && outside.high >= 1;
  const bool divides_only = accepted == 0 && rejected == 0;
  return true_only_when(
      as_cheap ? "Of acceptance and rejection. " : "Of divisions, not of time. ",
      as_cheap || divides_only, as_cheap && divides_only,
      "Its speed is {:.2f} times that of Cohen-Sutherland inside and {:.2f} times outside (float); divisions per accepted segment at most {:.2f}, per rejected {:.2f}.",
      inside.median, outside.median, accepted, rejected);
}

Judgement plane_segment(const Results& results) {
  const auto& forms = results.rows<segments::IntersectionRow>();
  std::size_t normalised = 0, cheap = 0;
  bool general = false;
  for (const auto& [form, cut, uncut, point] : forms) {
    if (form.starts_with("any plane")) {
      general = cut.multiplications == 6 && cut.divisions == 1;
    } else if (form.find("frustum in view space") == std::string::npos) {
      ++normalised;
      cheap += cut.multiplications == 0 && cut.divisions == 1;
    }
  }
  if (normalised == 0) throw MissingFigure("table segments_intersection has no normalised form");
  return confirmed_if(
      general && cheap == normalised,
      "Counted: {} multiplications and {} division for any plane; {} of {} normalised forms take no multiplication and 1 division.",
      forms[0].cut.multiplications, forms[0].cut.divisions, cheap, normalised);
}

Judgement bounding_volumes(const Results& results) {
  using R = bounds::Row;
  const std::vector<double> settled = results.figures<R>(&R::settled_percent);
  const auto most = std::ranges::count_if(settled, [](double percent) { return percent > 50; });
  const double lost = sum(results.figures<R>(&R::visible_lost));
  const bool all = most == std::ssize(settled);
  return true_only_when(
      "Objects are small beside the view. ", lost == 0 && most > 0, lost == 0 && all,
      "They settle {:.0f} to {:.0f} % of the objects, by scene and bound, more than half in {} of {} rows; visible triangles lost: {:.0f}.",
      std::ranges::min(settled), std::ranges::max(settled), most, settled.size(), lost);
}

}  // namespace

std::vector<Claim> claims_about_cost() {
  return {
      {1, "View-space clipping needs the most computation.", "cost",
       by_mix("the slowest of the three", true, view_is_slowest)},
      {2, "Clip-space clipping needs the least and is the most efficient.", "cost",
       by_mix("the fastest of the three", true, clip_is_fastest)},
      {3, "CVV clipping is less efficient than clip-space clipping.", "cost",
       by_mix("slower", false, cvv_is_slower)},
      {4, "CVV clipping must account for perspective correction.", "perspective",
       perspective_correction},
      {7, "Dropping whole triangles is cheap but leaves visible holes at the border.", "pictures",
       dropping_whole},
      {13,
       "Cohen-Sutherland rejects most segments without any intersection when the window is small; it repeats work when a segment must be shortened several times.",
       "segments", line_outcodes},
      {14, "Liang-Barsky accepts and rejects as cheaply, and divides only when it shortens.",
       "segments", liang_barsky},
      {15, "A pipeline of independent plane clippers adds little latency.", "cost",
       by_ratio(
           "homogeneous/pipeline", kClipSpace, 1.10,
           "Against cutting by the crossed planes alone the pipeline takes, times: {} (little: at most {:.2f}).")},
      {17, "Bounding volumes settle most objects without touching their polygons.", "bounds",
       bounding_volumes},
      {18,
       "A general plane-segment intersection costs 6 multiplications and 1 division; in a normalised (also oblique) volume 1 division.",
       "segments", plane_segment},
      {19, "Clipping before the divide spares divisions for vertices outside.", "cost",
       divisions_spared},
      {29,
       "Geometric clipping can be avoided by 2D homogeneous rasterisation, 33 % faster (Olano and Greer 1997).",
       "claims", clipless},
      {31,
       "Floating-point filters make exact decisions at most about twice as slow, near free in practice (Shewchuk 1997; Bronnimann, Burnikel and Pion 2001).",
       "cost",
       by_ratio("view/exact_sign", kViewSpace, 2,
                "View-space clipping with exact signs takes, times the plain one: {}.")},
      {32, "Correct rounding is expensive (experience with mathematical libraries).", "frontier",
       correct_rounding}};
}

}  // namespace clipscope::experiments::claims
