// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims about geometry, most of them judged by exact cases that are counted for and against them.
#include <fmt/args.h>

#include <algorithm>

#include "experiments/accuracy/rows.hpp"
#include "experiments/claims/claim.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/guard_band/rows.hpp"

namespace clipscope::experiments::claims {
namespace {

// A count with at least one case.
const CountRow& count(const Results& results, std::string_view quantity) {
  const CountRow& row = results.row<CountRow>(&CountRow::quantity, quantity);
  if (row.cases > 0) return row;
  throw MissingFigure(fmt::format("table {} has no case of: {}", CountRow::kName, quantity));
}

std::string share_text(const CountRow& row) {
  return fmt::format("{} of {}", row.count, row.cases);
}

// What is counted, and how the count decides: cases against a claim in any circumstances, or in
// some alone, or cases that are told of.
enum class Weighs : std::uint8_t { always, sometimes, never };
struct Counted {
  std::string_view quantity;
  Weighs weighs = Weighs::always;
};

Evidence evidence_of(const CountRow& row, Weighs weighs) {
  const auto figure = static_cast<double>(row.count);
  std::string unit = fmt::format("of {}", row.cases);
  return weighs == Weighs::never
             ? told(row.title, row.quantity, figure, std::move(unit))
             : decided(row.title, row.quantity, figure, std::move(unit), exactly(0));
}

// Judges by cases that are against a claim. In the sentences {0}, {1}, … stand for the counts in
// their order: "7 of 400".
auto by_counts(const std::vector<Counted>& counted, const Sentences& sentences) {
  return [=](const Results& results) {
    std::vector<Evidence> evidence;
    fmt::dynamic_format_arg_store<fmt::format_context> shares;
    bool holds_sometimes = true;
    for (const auto& [quantity, weighs] : counted) {
      const CountRow& row = count(results, quantity);
      evidence.push_back(evidence_of(row, weighs));
      shares.push_back(share_text(row));
      if (weighs == Weighs::always) holds_sometimes = holds_sometimes && row.count == 0;
    }
    const auto filled = [&](const std::string& text) { return fmt::vformat(text, shares); };
    return judged(
        std::move(evidence), holds_sometimes,
        {filled(sentences.confirmed), filled(sentences.conditional), filled(sentences.refuted)});
  };
}

// Evidence of a count that has to be above 0, for a claim that something may happen.
Evidence happens(const CountRow& row) {
  return decided(row.title, row.quantity, static_cast<double>(row.count),
                 fmt::format("of {}", row.cases), above(0));
}

Judgement parts(const Results& results) {
  const CountRow& convex = count(results, "a convex polygon leaves one that is not");
  const CountRow& several = count(results, "a concave polygon leaves several");
  return judged(
      {evidence_of(convex, Weighs::always), happens(several)}, false,
      {fmt::format("Every convex polygon leaves a convex one, and {} concave ones leave several.",
                   share_text(several)),
       "",
       convex.count > 0
           ? fmt::format("In {} cases a convex polygon leaves one that is not.", share_text(convex))
           : fmt::format("None of {} concave polygons leaves several.", several.cases)});
}

Judgement sides_left(const Results& results) {
  using P = guard_band::PointsRow;
  using R = guard_band::PictureRow;
  const double differ = sum(results.figures<P>([](const P& row) { return row.tally.differ; }));
  const double drawn = sum(results.figures<P>([](const P& row) { return row.tally.drawn; }));
  std::vector<Evidence> evidence = {decided("all scenes", "points drawn otherwise", differ,
                                            fmt::format("of {:.0f}", drawn), exactly(0))};
  double most = 0;
  for (const std::string& scene : distinct(results.rows<R>(), &R::scene)) {
    const double unlike = std::ranges::max(
        results.figures<R>([](const R& row) { return std::max(row.holes_px, row.extra_px); },
                           &R::scene, scene, &R::vertices, "float"));
    evidence.push_back(decided(scene, "pixels missed or added in the worst float picture", unlike,
                               "px", exactly(0)));
    most = std::max(most, unlike);
  }
  return judged(
      std::move(evidence), differ == 0,
      {fmt::format(
           "None of {} drawn points differs, and no picture does whose sides are left to scissoring.",
           number_text(drawn)),
       fmt::format("Pixels next to edges may differ, as up to {} of a picture do.",
                   number_text(most)),
       fmt::format("Of {} drawn points {} differ.", number_text(drawn), number_text(differ))});
}

Judgement nine_vertices(const Results& results) {
  const CountRow& nine = count(results, "9 vertices");
  const CountRow& more = count(results, "more than 9 vertices");
  if (more.count == 0 && nine.count == 0) {
    throw MissingFigure("no case reached 9 vertices, so the bound was not tried");
  }
  return judged(
      {evidence_of(nine, Weighs::never), evidence_of(more, Weighs::always)}, false,
      {fmt::format("No triangle leaves more vertices than claimed, and {} reach that many.",
                   share_text(nine)),
       "", fmt::format("More vertices than claimed are left of {} triangles.", share_text(more))});
}

// The largest error of a clipper in float.
double largest_px(const Results& results, std::string_view clipper) {
  using R = accuracy::Row;
  const auto max_px = [](const R& row) {
    return row.figures.px ? std::optional(row.figures.px->max) : std::nullopt;
  };
  return std::ranges::max(results.figures<R>(max_px, &R::clipper, clipper, &R::scalar, "float"));
}

Judgement same_result(const Results& results) {
  std::vector<Evidence> evidence;
  std::int64_t differ = 0;
  for (const char* quantity : {"view space differs", "clip space differs"}) {
    const CountRow& row = count(results, quantity);
    evidence.push_back(evidence_of(row, Weighs::always));
    differ += row.count;
  }
  const double view_px = largest_px(results, kViewSpace);
  const double clip_px = largest_px(results, kClipSpace);
  evidence.push_back(
      decided("view space in float", "largest error, all scenes", view_px, "px", exactly(0)));
  evidence.push_back(
      decided("clip space in float", "largest error, all scenes", clip_px, "px", exactly(0)));
  return judged(
      std::move(evidence), differ == 0,
      {"Both spaces give the exact result, in exact arithmetic and in float.",
       fmt::format(
           "Arithmetic is exact; in float view space is off by up to {} px, clip space by up to {} px.",
           number_text(view_px), number_text(clip_px)),
       fmt::format("Even in exact arithmetic {} triangles differ from the reference.", differ)});
}

Judgement point_at_eye(const Results& results) {
  const CountRow& as_claimed = count(results, "clip coordinates are (1, 1, -20/9, 0)");
  return judged(
      {decided(as_claimed.title, as_claimed.quantity, static_cast<double>(as_claimed.count),
               fmt::format("of {}", as_claimed.cases),
               exactly(static_cast<double>(as_claimed.cases)))},
      false,
      {"The exact matrix gives the coordinates claimed, with w = 0.", "",
       "The exact matrix gives other coordinates than those claimed."});
}

constexpr Weighs kSometimes = Weighs::sometimes, kNever = Weighs::never;

}  // namespace

std::vector<Claim> claims_about_geometry() {
  return {
      {5, "Inside is -w <= x, y, z <= w.", "claims",
       by_counts({{"disagrees, depth [-1, 1]"},
                  {"disagrees, depth [0, 1]", kSometimes},
                  {"disagrees, depth reversed", kSometimes}},
                 {"The test is right for every point, whatever range depth has.",
                  "Depth runs as in OpenGL; as in Direct3D it fails for {1} points.",
                  "The test fails for {0} points."})},
      {6,
       "Cutting edges in order and fanning keeps the winding, so back-face culling is unaffected.",
       "claims",
       by_counts(
           {{"fan triangles wound the other way, cut in clip space"},
            {"fan triangles wound the other way, divided first", kSometimes}},
           {"No fan triangle is wound the other way, cut before the divide or after it.",
            "The cut comes before the divide; after it {1} fan triangles are wound the other way.",
            "Cut in clip space, {0} fan triangles are wound the other way."})},
      {8, "A triangle with one vertex outside one plane becomes two triangles.", "claims",
       by_counts(
           {{"leaves anything else"},
            {"leaves fewer: another vertex is on the plane", kSometimes},
            {"leaves 4 vertices", kNever}},
           {"All such triangles leave a quadrilateral.",
            "No other vertex lies on the plane; one does in {1} cases, and a single triangle is left.",
            "Something else than one or two triangles is left in {0} cases."})},
      {9, "Attributes are interpolated with the same t as positions.", "claims",
       by_counts(
           {{"attribute at t in clip space is wrong"},
            {"attribute at t after the divide is wrong", kSometimes}},
           {"No attribute is wrong, cut before the divide or after it.",
            "The cut comes before the divide; with the t found after it {1} attributes are wrong.",
            "With the t of clip space {0} attributes are wrong."})},
      {10,
       "The side planes of the frustum have normals (-+cos(a/2), 0, sin(a/2)) with the vertical angle a of top and bottom.",
       "claims",
       by_counts(
           {{"corners off the plane, aspect 1"},
            {"corners off the plane, aspect not 1", kSometimes}},
           {"Every corner of the frustum is on such a plane, whatever the aspect.",
            "The picture is a square; else the horizontal angle is needed, and {1} corners are off that plane.",
            "Even of a square picture {0} corners are off that plane."})},
      {12, "Clipping plane after plane, each output the next input, is enough.", "claims",
       by_counts(
           {{"clip space differs"}},
           {"Plane after plane leaves the intersection of all half-spaces, exactly and in every case.",
            "",
            "Plane after plane leaves something else than the intersection of half-spaces in {0} cases."})},
      {16, "A convex polygon clips to at most one convex polygon; a concave one may yield several.",
       "claims", parts},
      {22,
       "For points only near and far are tested; for triangles and segments x and y may be left to the rasteriser.",
       "guard_band", sides_left},
      {24,
       "A straight line stays straight in clip space with the same t, so attributes cut there equal those cut in camera space.",
       "claims",
       by_counts(
           {{"t in clip space is not t in view space"},
            {"t after the divide is not t in view space", kNever}},
           {"The t of clip space is that of view space on every edge, while after the divide {1} differ.",
            "", "The t of clip space differs from that of view space on {0} edges."})},
      {25,
       "With the accept rule x + w >= 0 the denominator of t never vanishes, though x/w = -1 may have no solution.",
       "claims",
       by_counts(
           {{"denominator 0"}, {"denominator overflows", kNever}},
           {"The denominator is never zero, since it is a positive number less a negative one.", "",
            "The denominator is zero on {0} edges that cross the plane."})},
      {26, "Six planes leave at most 9 vertices, 7 triangles.", "claims", nine_vertices},
      {27, "Clip-space and view-space clipping give the same result.", "claims", same_result},
      {28,
       "A point with z_view = 0, such as (1, 1, 0) with l = b = -1, r = t = 1, n = 1, f = 10, has clip coordinates (1, 1, -2.2222, 0) and can't be divided.",
       "claims", point_at_eye}};
}

}  // namespace clipscope::experiments::claims
